#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/evaluation.hpp"

#include "integer_power.hpp"
#include "term_maps.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

namespace eliminant::algebra {

namespace {

/// One composition f(images).
///
/// Variables whose image has one term are `light`: they are mapped term by term. The others are `heavy`: f is
/// sorted lexicographically by their exponents, and Horner's scheme runs over the groups of equal leading
/// exponents,
///
///     f = (… (c₁·x^(e₁−e₂) + c₂)·x^(e₂−e₃) + …)·x^(e_k),   c_i composed recursively in the remaining
///     variables.
class Composition {
  public:
    Composition(const Polynomial& f, const Ring& target, std::span<const Polynomial> images, base::Run& run)
        : f_(f), target_(target), images_(images), run_(run), sequence_(f.size()), powers_(images.size()) {
        for (std::size_t v = 0; v < images.size(); ++v) (images[v].size() > 1 ? heavy_ : light_).push_back(v);
        std::ranges::stable_sort(heavy_, std::greater<>{}, [&](std::size_t v) { return images[v].size(); });
        std::iota(sequence_.begin(), sequence_.end(), std::size_t{0});
        if (heavy_.empty()) return;
        std::ranges::sort(sequence_, [this](std::size_t i, std::size_t j) {
            for (const std::size_t v : heavy_) {
                const std::uint64_t ei = f_.exponent(i, v);
                const std::uint64_t ej = f_.exponent(j, v);
                if (ei != ej) return ei > ej;
            }
            return false;
        });
    }

    Polynomial result() { return horner(sequence_, 0); }

  private:
    /// The image of the terms listed, without their powers of the first `depth` heavy variables.
    Polynomial horner(std::span<const std::size_t> terms, std::size_t depth) {
        run_.poll();
        if (depth == heavy_.size()) return light_image(terms);
        const std::size_t variable = heavy_[depth];
        Polynomial sum(target_);
        while (!terms.empty()) {
            const std::uint64_t exponent = f_.exponent(terms.front(), variable);
            const auto end = std::ranges::find_if(
                terms, [&](std::size_t i) { return f_.exponent(i, variable) != exponent; });
            const auto length = static_cast<std::size_t>(end - terms.begin());
            sum += horner(terms.first(length), depth + 1);
            terms = terms.subspan(length);
            const std::uint64_t gap = exponent - (terms.empty() ? 0 : f_.exponent(terms.front(), variable));
            if (gap != 0) sum = multiply(sum, power(variable, gap), run_);
        }
        return sum;
    }

    const Polynomial& power(std::size_t variable, std::uint64_t exponent) {
        if (exponent == 1) return images_[variable];
        const auto [entry, missing] = powers_[variable].try_emplace(exponent, target_);
        if (missing) entry->second = pow(images_[variable], exponent, run_);
        return entry->second;
    }

    Polynomial light_image(std::span<const std::size_t> terms) {
        PolynomialBuilder builder(target_);
        std::vector<std::uint64_t> exponents(target_.variable_count());
        for (const std::size_t i : terms) {
            run_.poll();
            std::ranges::fill(exponents, 0);
            Integer numerator = f_.ring().field().is_rationals()
                                    ? f_.integer_terms().coefficients[i]
                                    : Integer(f_.residue_terms().coefficients[i]);
            Integer denominator = f_.denominator();
            for (const std::size_t v : light_) {
                if (f_.exponent(i, v) != 0)
                    multiply_by_light_power(v, f_.exponent(i, v), numerator, denominator, exponents);
            }
            if (!numerator.is_zero()) builder.add(numerator, denominator, exponents);
        }
        return builder.build();
    }

    void multiply_by_light_power(std::size_t variable, std::uint64_t exponent, Integer& numerator,
                                 Integer& denominator, std::span<std::uint64_t> exponents) {
        const Polynomial& image = images_[variable];
        if (image.is_zero()) {
            numerator = Integer(0);
            return;
        }
        for (std::size_t w = 0; w < exponents.size(); ++w) {
            std::uint64_t product = 0;
            if (__builtin_mul_overflow(image.exponent(0, w), exponent, &product) ||
                __builtin_add_overflow(exponents[w], product, &exponents[w]))
                throw OverflowError("an exponent exceeds 2^63 - 1");
        }
        const mpq_class coefficient = image.coefficient(0);
        if (coefficient == 1) return;
        numerator *= light_power(Integer(coefficient.get_num()), exponent);
        denominator *= light_power(Integer(coefficient.get_den()), exponent);
    }

    Integer light_power(const Integer& base, std::uint64_t exponent) const {
        if (target_.field().is_rationals()) return checked_power(base, exponent);
        const PrimeField& field = target_.field().prime_field();
        return Integer(field.power(field.from_integer(base), exponent));
    }

    const Polynomial& f_;
    const Ring& target_;
    std::span<const Polynomial> images_;
    base::Run& run_;
    std::vector<std::size_t> sequence_; ///< terms of f, lexicographically decreasing in the heavy variables
    std::vector<std::size_t> heavy_;
    std::vector<std::size_t> light_;
    std::vector<std::map<std::uint64_t, Polynomial>> powers_; ///< of the heavy images, by exponent
};

} // namespace

Polynomial compose(const Polynomial& f, const Ring& target, std::span<const Polynomial> images,
                   base::Run& run) {
    const CoefficientField& from = f.ring().field();
    if (images.size() != f.ring().variable_count())
        throw DomainError(std::to_string(images.size()) + " images for the variables of " +
                          f.ring().to_string());
    if (!from.is_rationals() && !(from == target.field()))
        throw DomainError("coefficients of " + from.to_string() + " have no image in " +
                          target.field().to_string());
    for (const Polynomial& image : images)
        require_same_ring(target, image.ring(), "composition of polynomials");
    return Composition(f, target, images, run).result();
}

Polynomial substitute(const Polynomial& f, std::size_t variable, const Polynomial& g, base::Run& run) {
    require_variable(f.ring(), variable);
    require_same_ring(f.ring(), g.ring(), "substitution in a polynomial");
    std::vector<Polynomial> images;
    for (std::size_t v = 0; v < f.ring().variable_count(); ++v)
        images.push_back(v == variable ? g : Polynomial::variable(f.ring(), v));
    return compose(f, f.ring(), images, run);
}

} // namespace eliminant::algebra
