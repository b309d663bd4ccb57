#include "gcd_modular.hpp"

#include "chinese_remainders.hpp"
#include "galois_field.hpp"
#include "gcd_degrees.hpp"
#include "gcd_methods.hpp"
#include "gcd_problem.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/gcd.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::algebra {

namespace {

/// Degree above which univariate images are not kept as dense vectors.
constexpr std::int64_t max_main_degree = std::int64_t{1} << 22;
/// How often unlucky random choices are repeated before a method is given up.
constexpr int max_failures = 6;
constexpr int max_failures_a_field = 3;

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

/// What is asked for, as all methods see it.
struct Question {
    const Polynomial& f;
    const Polynomial& g;
    std::span<const std::uint64_t> bounds; ///< of the degrees of the gcd
    Random& random;
    base::Run& run;
};

bool reaches(const Polynomial& h, std::span<const std::uint64_t> bounds) {
    for (std::size_t v = 0; v < bounds.size(); ++v) {
        if (h.degree(v) != static_cast<std::int64_t>(bounds[v])) return false;
    }
    return true;
}

/// The gcd from a guess h, if h divides both arguments, with the proof that nothing greater does: its degrees
/// reach proved bounds, or its cofactors have coprime images over the field. If neither holds, images were
/// too small by an unlikely accident of interpolation, and h·gcd(f/h, g/h) is the answer. A constant h proves
/// nothing then.
///
/// In one variable nothing is interpolated, and the degree of an image is as good a bound as any.
template <class Field>
std::optional<Polynomial> proved(const Polynomial& h, const Field& field, bool in_one_variable,
                                 const Question& question) {
    const auto& [f, g, bounds, random, run] = question;
    const bool f_first = f.size() <= g.size(); // a wrong guess costs least there
    const auto cofactor = try_divide(f_first ? f : g, h, run);
    if (!cofactor) return std::nullopt;
    const auto other = try_divide(f_first ? g : f, h, run);
    if (!other) return std::nullopt;
    if (reaches(h, bounds) || in_one_variable || proved_coprime(field, *cofactor, *other, random, run))
        return h;
    if (h.is_constant()) return std::nullopt;
    return multiply(h, gcd(*cofactor, *other, run), run).primitive_part();
}

/// More bits than the coefficients of H can have. By Gelfond's inequality factors of a polynomial of degrees
/// d_v have heights whose product is at most e^(Σ d_v) times its own; H divides γ·f, and γ divides leading
/// coefficients.
std::size_t coefficient_bits(const Question& question) {
    std::size_t bits = 64;
    for (const Polynomial* h : {&question.f, &question.g}) {
        std::size_t height = 0;
        for (const Integer& c : h->integer_terms().coefficients) height = std::max(height, c.bit_length());
        std::uint64_t degrees = 0;
        for (std::size_t v = 0; v < h->ring().variable_count(); ++v)
            degrees += static_cast<std::uint64_t>(h->degree(v));
        bits += 2 * height + 6 * static_cast<std::size_t>(degrees) + 64;
    }
    return bits;
}

std::optional<Polynomial> over_rationals(ImageMethod& method, const Question& question) {
    ChineseRemainders sum;
    ModularImage last;
    std::uint64_t prime = PrimeField::max_characteristic + 1;
    const std::size_t enough_bits = coefficient_bits(question);
    const auto start_again = [&] {
        method.reset(); // what was learnt from the first image may be the culprit
        sum = ChineseRemainders();
        last = {};
    };
    for (int failures = 0; failures < max_failures;) {
        question.run.poll();
        prime = previous_prime(prime);
        const PrimeField field(prime);
        auto image = method.image(field);
        const auto order =
            image && !last.places.empty() ? method.compare(*image, last) : std::strong_ordering::equal;
        if (!image || order > 0) { // this prime is unlucky, or what was done before is wrong
            if (++failures % 3 == 0) start_again();
            continue;
        }
        if (order < 0) sum = ChineseRemainders(); // all primes before were unlucky
        const bool changed = sum.add(field, image->places, image->residues);
        last = *std::move(image);
        const bool enough = sum.modulus().bit_length() > enough_bits;
        if (changed && !sum.small() && !enough) continue;
        const Polynomial multiple = assembled(question.f.ring(), method, sum.places(), sum.values());
        if (auto h = proved(method.gcd_from(multiple, question.run), field, method.variables().size() == 1,
                            question))
            return h;
        if (enough) {
            ++failures;
            start_again();
        }
    }
    return std::nullopt;
}

/// The coefficients of an image as integers, if they are in the prime field.
std::optional<std::vector<Integer>> prime_field_values(const PrimeField& /*field*/,
                                                       const ModularImage& image) {
    return std::vector<Integer>(image.residues.begin(), image.residues.end());
}
std::optional<std::vector<Integer>> prime_field_values(const GaloisField& field, const ModularImage& image) {
    std::vector<Integer> values;
    for (const std::uint32_t element : image.residues) {
        const auto residue = field.residue(element);
        if (!residue) return std::nullopt;
        values.emplace_back(*residue);
    }
    return values;
}

template <class Field>
std::optional<Polynomial> over_finite_field(const Field& field, ImageMethod& method,
                                            const Question& question) {
    for (int failures = 0; failures < max_failures_a_field; ++failures) {
        question.run.poll();
        method.reset();
        const auto image = method.image(field);
        // The gcd is the same over an extension, so H has its coefficients in the prime field.
        const auto values = image ? prime_field_values(field, *image) : std::nullopt;
        if (!values) continue;
        const Polynomial multiple = assembled(question.f.ring(), method, image->places, *values);
        if (auto h = proved(method.gcd_from(multiple, question.run), field, method.variables().size() == 1,
                            question))
            return h;
    }
    return std::nullopt;
}

/// Over GF(p) itself, or over extensions, larger and larger, that hold the points that p elements lack.
std::optional<Polynomial> over_prime_field(ImageMethod& method, const Question& question) {
    const PrimeField& field = question.f.ring().field().prime_field();
    std::uint64_t degree_sum = 1;
    for (const std::size_t v : method.variables())
        degree_sum += static_cast<std::uint64_t>(std::max(question.f.degree(v), question.g.degree(v)));
    // Interpolation needs as many points as degrees, and an image is unlucky in one case of about q. Larger
    // fields take longer to set up, so they come when smaller ones fail.
    const std::uint64_t enough = std::max<std::uint64_t>(4 * degree_sum, 4096);
    const std::uint32_t p = field.characteristic();
    if (method.variables().size() == 1 || p >= enough) return over_finite_field(field, method, question);
    for (std::uint64_t size = enough;; size *= 16) {
        const auto k = GaloisField::degree_for(p, size);
        if (!k) return over_finite_field(field, method, question);
        if (auto h = over_finite_field(GaloisField(p, *k, question.run), method, question)) return h;
    }
}

std::optional<Polynomial> by_method(ImageMethod& method, const Question& question) {
    return question.f.ring().field().is_rationals() ? over_rationals(method, question)
                                                    : over_prime_field(method, question);
}

std::optional<Polynomial> by_sparse(GcdProblem problem, const Question& question) {
    const auto& [f, g, bounds, random, run] = question;
    const auto main = std::span(problem.variables).first(1);
    const Polynomial content_f = content(f, main, run);
    const Polynomial content_g = content(g, main, run);
    if (content_f.is_constant() && content_g.is_constant())
        return by_method(*sparse_method(std::move(problem), random, run), question);
    const Polynomial common = gcd(content_f, content_g, run);
    const Polynomial rest = gcd(divide_exactly(f, content_f, run), divide_exactly(g, content_g, run), run);
    return multiply(common, rest, run).primitive_part();
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
    const Question question{f, g, bounds, random, run};
    if (dense_first) {
        if (auto h = by_method(*dense_method(dense, random, run), question)) return h;
    }
    if (can_sparse) {
        if (auto h = by_sparse(std::move(sparse), question)) return h;
    }
    if (!can_dense || dense_first) return std::nullopt;
    return by_method(*dense_method(std::move(dense), random, run), question);
}

} // namespace eliminant::algebra
