#include "gcd_modular.hpp"

#include "chinese_remainders.hpp"
#include "galois_field.hpp"
#include "gcd_methods.hpp"
#include "gcd_problem.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/gcd.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

namespace eliminant::algebra {

namespace {

/// Degree above which univariate images are not kept as dense vectors.
constexpr std::int64_t max_main_degree = std::int64_t{1} << 22;
/// How often unlucky random choices are repeated before a method is given up.
constexpr int max_failures = 6;

/// H from its coefficients.
Polynomial assembled(const Ring& ring, const ImageMethod& method, const std::vector<std::size_t>& places,
                     const std::vector<Integer>& values) {
    PolynomialBuilder builder(ring);
    std::vector<std::uint64_t> row(method.variables().size());
    std::vector<std::uint64_t> exponents(ring.variable_count(), 0);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (values[i].is_zero()) continue;
        method.exponents_of(places[i], row);
        for (std::size_t k = 0; k < row.size(); ++k) exponents[method.variables()[k]] = row[k];
        builder.add(values[i], exponents);
    }
    return builder.build();
}

/// The proof. The degrees of a candidate are those of a gcd of images, so at least those of the gcd; if it
/// divides both arguments, it is the gcd.
bool divides_both(const Polynomial& h, const Polynomial& f, const Polynomial& g, base::Run& run) {
    return f.size() <= g.size() ? try_divide(f, h, run) && try_divide(g, h, run)
                                : try_divide(g, h, run) && try_divide(f, h, run);
}

std::optional<Polynomial> over_rationals(ImageMethod& method, const Polynomial& f, const Polynomial& g,
                                         base::Run& run) {
    ChineseRemainders sum;
    ModularImage last;
    std::uint64_t prime = PrimeField::max_characteristic + 1;
    for (int failures = 0; failures < max_failures;) {
        run.poll();
        prime = previous_prime(prime);
        const PrimeField field(prime);
        auto image = method.image(field);
        if (!image) {
            ++failures;
            // The support that was learnt may be the culprit.
            if (failures % 3 == 0) {
                method.reset();
                sum = ChineseRemainders();
                last = {};
            }
            continue;
        }
        if (!last.places.empty()) {
            const auto [earlier_wrong, this_wrong] = method.compare(last, *image);
            if (this_wrong) continue;
            if (earlier_wrong) sum = ChineseRemainders();
        }
        const bool changed = sum.add(field, image->places, image->residues);
        last = *std::move(image);
        if (changed && !sum.small()) continue;
        const Polynomial multiple = assembled(f.ring(), method, sum.places(), sum.values());
        Polynomial h = method.gcd_from(multiple, run);
        if (divides_both(h, f, g, run)) return h;
    }
    return std::nullopt;
}

template <class Field>
std::optional<Polynomial> over_finite_field(const Field& field, ImageMethod& method, const Polynomial& f,
                                            const Polynomial& g, base::Run& run) {
    for (int failures = 0; failures < max_failures; ++failures) {
        run.poll();
        method.reset();
        const auto image = method.image(field);
        if (!image) continue;
        std::vector<Integer> values;
        for (const std::uint32_t residue : image->residues) {
            // The gcd is the same over any extension, so a monic one has its coefficients in GF(p).
            if constexpr (std::is_same_v<Field, GaloisField>) {
                const auto value = field.residue(residue);
                if (!value) break;
                values.emplace_back(*value);
            } else {
                values.emplace_back(residue);
            }
        }
        if (values.size() != image->residues.size()) continue;
        Polynomial h = method.gcd_from(assembled(f.ring(), method, image->places, values), run);
        if (divides_both(h, f, g, run)) return h;
    }
    return std::nullopt;
}

/// Over GF(p) itself, or over the extension that holds the points that p elements lack.
std::optional<Polynomial> over_prime_field(ImageMethod& method, const Polynomial& f, const Polynomial& g,
                                           base::Run& run) {
    const PrimeField& field = f.ring().field().prime_field();
    std::uint64_t degree_sum = 1;
    for (const std::size_t v : method.variables())
        degree_sum += static_cast<std::uint64_t>(std::max(f.degree(v), g.degree(v)));
    // An image is unlucky with a probability of about degree²/size; points must also be distinct.
    const std::uint64_t wanted =
        std::min<std::uint64_t>(64 * degree_sum * degree_sum, std::uint64_t{1} << 20);
    const std::uint64_t enough = std::max<std::uint64_t>(4 * degree_sum, 4096);
    const std::uint32_t p = field.characteristic();
    if (method.variables().size() > 1 && p < enough) {
        if (const auto k = GaloisField::degree_for(p, std::max(wanted, enough)))
            return over_finite_field(GaloisField(p, *k, run), method, f, g, run);
    }
    return over_finite_field(field, method, f, g, run);
}

std::optional<Polynomial> by_method(ImageMethod& method, const Polynomial& f, const Polynomial& g,
                                    base::Run& run) {
    return f.ring().field().is_rationals() ? over_rationals(method, f, g, run)
                                           : over_prime_field(method, f, g, run);
}

std::optional<Polynomial> by_dense(GcdProblem problem, Random& random, base::Run& run) {
    const Polynomial& f = problem.f;
    const Polynomial& g = problem.g;
    return by_method(*dense_method(std::move(problem), random, run), f, g, run);
}

std::optional<Polynomial> by_sparse(GcdProblem problem, Random& random, base::Run& run) {
    const Polynomial& f = problem.f;
    const Polynomial& g = problem.g;
    const auto main = std::span(problem.variables).first(1);
    const Polynomial content_f = content(f, main, run);
    const Polynomial content_g = content(g, main, run);
    if (!content_f.is_constant() || !content_g.is_constant()) {
        const Polynomial common = gcd(content_f, content_g, run);
        const Polynomial primitive =
            gcd(divide_exactly(f, content_f, run), divide_exactly(g, content_g, run), run);
        return multiply(common, primitive, run).primitive_part();
    }
    return by_method(*sparse_method(std::move(problem), random, run), f, g, run);
}

} // namespace

std::optional<Polynomial> gcd_by_images(const Polynomial& f, const Polynomial& g,
                                        std::span<const std::uint64_t> bounds, Random& random, base::Run& run,
                                        Interpolation method) {
    GcdProblem problem{f, g, {}, {}};
    for (std::size_t v = 0; v < bounds.size(); ++v) {
        if (f.degree(v) <= 0) continue;
        problem.variables.push_back(v);
        problem.bounds.push_back(static_cast<std::size_t>(bounds[v]));
    }
    GcdProblem dense = sorted_for_dense(problem);
    GcdProblem sparse = sorted_for_sparse(std::move(problem));
    const auto fits = [&](const GcdProblem& p) {
        return std::max(f.degree(p.variables[0]), g.degree(p.variables[0])) <= max_main_degree;
    };
    const bool can_dense = method != Interpolation::sparse && dense_fits(dense);
    const bool can_sparse = method != Interpolation::dense && sparse.variables.size() > 1 && fits(sparse);
    const bool dense_first = can_dense && (!can_sparse || dense_cost(dense) <= sparse_cost(sparse));
    if (dense_first) {
        if (auto h = by_dense(dense, random, run)) return h;
    }
    if (can_sparse) {
        if (auto h = by_sparse(std::move(sparse), random, run)) return h;
    }
    return can_dense && !dense_first ? by_dense(std::move(dense), random, run) : std::nullopt;
}

} // namespace eliminant::algebra
