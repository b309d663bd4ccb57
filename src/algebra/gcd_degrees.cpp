#include "gcd_degrees.hpp"

#include "term_maps.hpp"
#include "univariate_mod_p.hpp"

#include <algorithm>
#include <optional>

namespace eliminant::algebra {

namespace {

/// A univariate gcd of this degree takes about 100 ms; dense images above it would cost more than they tell.
constexpr std::uint64_t max_cheap_degree = 8192;
/// No dense images at all above this degree.
constexpr std::uint64_t max_image_degree = std::uint64_t{1} << 22;

/// Powers of a nonzero element and of its inverse.
template <class Field>
struct Powers {
    dense::Vector up;
    dense::Vector down;

    Powers(const Field& field, dense::Element base, std::uint64_t max_exponent)
        : up(dense::powers(field, base, static_cast<std::size_t>(max_exponent) + 1)),
          down(dense::powers(field, field.inverse(base), static_cast<std::size_t>(max_exponent) + 1)) {}
};

/// Images of a polynomial, one a variable, with a random point's coordinates in the place of all others.
template <class Field>
class UnivariateImages {
  public:
    /// `variables` occur in both polynomials and have degrees up to max_image_degree.
    UnivariateImages(const Field& field, const std::vector<std::size_t>& variables,
                     const dense::Vector& point)
        : field_(field), variables_(variables), point_(point) {}

    std::vector<dense::Vector> operator()(const Polynomial& f, base::Run& run) const {
        std::vector<dense::Vector> images;
        std::vector<Powers<Field>> powers;
        std::vector<std::size_t> others;
        for (std::size_t v = 0; v < point_.size(); ++v) {
            if (std::ranges::find(variables_, v) == variables_.end()) others.push_back(v);
        }
        for (const std::size_t v : variables_) {
            const auto degree = static_cast<std::uint64_t>(f.degree(v));
            images.emplace_back(degree + 1, 0);
            powers.emplace_back(field_, point_[v], degree);
        }
        visit_terms(f, [&](const auto& terms, const auto& /*domain*/) {
            std::vector<std::uint64_t> exponents(variables_.size());
            for (std::size_t i = 0; i < terms.size(); ++i) {
                if (i % 1024 == 0) run.poll();
                dense::Element value = image_in(field_, terms.coefficients[i]);
                const auto* monomial = terms.monomial(i);
                for (const std::size_t v : others) {
                    const std::uint64_t e = terms.layout->exponent(monomial, v);
                    if (e != 0) value = field_.multiply(value, field_.power(point_[v], e));
                }
                for (std::size_t k = 0; k < variables_.size(); ++k) {
                    exponents[k] = terms.layout->exponent(monomial, variables_[k]);
                    value = field_.multiply(value, powers[k].up[exponents[k]]);
                }
                for (std::size_t k = 0; k < variables_.size(); ++k) {
                    dense::Element& sum = images[k][exponents[k]];
                    sum = field_.add(sum, field_.multiply(value, powers[k].down[exponents[k]]));
                }
            }
        });
        return images;
    }

  private:
    const Field& field_;
    const std::vector<std::size_t>& variables_;
    const dense::Vector& point_;
};

/// Lowers the bounds of the variables by images at one random point.
template <class Field>
void lower_bounds(const Field& field, const Polynomial& f, const Polynomial& g,
                  std::vector<std::size_t> variables, std::vector<std::uint64_t>& bounds, Random& random,
                  base::Run& run) {
    // A second point for those variables where both leading coefficients vanish; after that the degree has to
    // do.
    for (int round = 0; round < 2 && !variables.empty(); ++round) {
        dense::Vector point(bounds.size());
        for (dense::Element& c : point) c = 1 + random.below(field_size(field) - 1);
        const UnivariateImages<Field> images_of(field, variables, point);
        auto images_f = images_of(f, run);
        auto images_g = images_of(g, run);
        std::vector<std::size_t> undecided;
        for (std::size_t k = 0; k < variables.size(); ++k) {
            if (images_f[k].back() == 0 && images_g[k].back() == 0) {
                undecided.push_back(variables[k]);
                continue;
            }
            dense::trim(images_f[k]);
            dense::trim(images_g[k]);
            const dense::Vector h = dense::gcd(field, std::move(images_f[k]), std::move(images_g[k]), run);
            bounds[variables[k]] = std::min<std::uint64_t>(bounds[variables[k]], h.size() - 1);
        }
        variables = std::move(undecided);
    }
}

/// The lower degree in each variable.
std::vector<std::uint64_t> least_degrees(const Polynomial& f, const Polynomial& g) {
    std::vector<std::uint64_t> least(f.ring().variable_count());
    for (std::size_t v = 0; v < least.size(); ++v)
        least[v] = static_cast<std::uint64_t>(std::min(f.degree(v), g.degree(v)));
    return least;
}

/// The variables in which both have positive degrees of at most max_degree.
std::vector<std::size_t> shared_variables(const Polynomial& f, const Polynomial& g,
                                          std::uint64_t max_degree) {
    std::vector<std::size_t> shared;
    for (std::size_t v = 0; v < f.ring().variable_count(); ++v) {
        const std::int64_t degree_f = f.degree(v);
        const std::int64_t degree_g = g.degree(v);
        if (std::min(degree_f, degree_g) > 0 &&
            static_cast<std::uint64_t>(std::max(degree_f, degree_g)) <= max_degree)
            shared.push_back(v);
    }
    return shared;
}

bool in_one_variable(const Polynomial& f, const Polynomial& g) {
    std::size_t occurring = 0;
    for (std::size_t v = 0; v < f.ring().variable_count(); ++v)
        occurring += f.degree(v) > 0 || g.degree(v) > 0 ? 1 : 0;
    return occurring == 1;
}

} // namespace

std::vector<std::uint64_t> gcd_degree_bounds(const Polynomial& f, const Polynomial& g, Random& random,
                                             base::Run& run) {
    std::vector<std::uint64_t> bounds = least_degrees(f, g);
    if (in_one_variable(f, g)) return bounds;
    std::vector<std::size_t> variables = shared_variables(f, g, max_cheap_degree);
    const CoefficientField& field = f.ring().field();
    // Two random univariate polynomials over a field of q elements have a common root in one case of q. The
    // table of a small extension is soon made, and an unlucky image costs time only.
    constexpr std::uint32_t enough = 97;
    constexpr std::uint64_t small_extension = 256;
    if (field.is_rationals()) {
        static const PrimeField largest(PrimeField::max_characteristic); // its primality proved once
        lower_bounds(largest, f, g, std::move(variables), bounds, random, run);
    } else if (field.characteristic() >= enough) {
        lower_bounds(field.prime_field(), f, g, std::move(variables), bounds, random, run);
    } else {
        const std::uint32_t p = field.characteristic();
        const GaloisField extension(p, *GaloisField::degree_for(p, small_extension), run);
        lower_bounds(extension, f, g, std::move(variables), bounds, random, run);
    }
    return bounds;
}

template <class Field>
bool proved_coprime(const Field& field, const Polynomial& f, const Polynomial& g, Random& random,
                    base::Run& run) {
    std::vector<std::uint64_t> bounds = least_degrees(f, g);
    lower_bounds(field, f, g, shared_variables(f, g, max_image_degree), bounds, random, run);
    return std::ranges::all_of(bounds, [](std::uint64_t bound) { return bound == 0; });
}

template bool proved_coprime(const PrimeField&, const Polynomial&, const Polynomial&, Random&, base::Run&);
template bool proved_coprime(const GaloisField&, const Polynomial&, const Polynomial&, Random&, base::Run&);

} // namespace eliminant::algebra
