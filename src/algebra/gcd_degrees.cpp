#include "gcd_degrees.hpp"

#include "term_maps.hpp"
#include "univariate_mod_p.hpp"

#include <algorithm>
#include <optional>

namespace eliminant::algebra {

namespace {

/// A univariate gcd of this degree takes about 100 ms; dense images above it would cost more than they tell.
constexpr std::uint64_t max_image_degree = 8192;

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

} // namespace

std::vector<std::uint64_t> gcd_degree_bounds(const Polynomial& f, const Polynomial& g, Random& random,
                                             base::Run& run) {
    const std::size_t n = f.ring().variable_count();
    std::vector<std::uint64_t> bounds(n);
    std::vector<std::size_t> variables;
    std::uint64_t degree_sum = 1;
    std::size_t occurring = 0;
    for (std::size_t v = 0; v < n; ++v) {
        const auto degree_f = static_cast<std::uint64_t>(f.degree(v));
        const auto degree_g = static_cast<std::uint64_t>(g.degree(v));
        bounds[v] = std::min(degree_f, degree_g);
        if (std::max(degree_f, degree_g) > 0) ++occurring;
        if (bounds[v] == 0 || std::max(degree_f, degree_g) > max_image_degree) continue;
        variables.push_back(v);
        degree_sum += std::max(degree_f, degree_g);
    }
    if (occurring == 1) return bounds;
    const CoefficientField& field = f.ring().field();
    if (field.is_rationals()) {
        lower_bounds(PrimeField(PrimeField::max_characteristic), f, g, std::move(variables), bounds, random,
                     run);
        return bounds;
    }
    // The larger the field beside the degrees, the rarer unlucky points are.
    const std::uint64_t wanted = 16 * degree_sum;
    const std::uint32_t p = field.characteristic();
    const auto extension = GaloisField::degree_for(p, wanted);
    if (p >= wanted || !extension)
        lower_bounds(field.prime_field(), f, g, std::move(variables), bounds, random, run);
    else
        lower_bounds(GaloisField(p, *extension, run), f, g, std::move(variables), bounds, random, run);
    return bounds;
}

} // namespace eliminant::algebra
