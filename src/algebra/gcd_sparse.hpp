#pragma once

#include "exponent_rows.hpp"
#include "random.hpp"
#include "supposed_terms.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// gcd over a finite field by sparse interpolation (Zippel 1979).
///
/// Let h be the gcd of f and g, which are primitive with respect to x₁, and γ a multiple of its leading
/// coefficient in x₁ that divides those of f and g. The result is H = γ/lc(h)·h. Variables are brought in one
/// after the other: when H(x₁, …, x_k−1, α_k, …) is known, then its terms are, with high probability, also
/// those of H(…, β, …) for other values β of x_k; so their coefficients follow from as many univariate gcds
/// as the longest coefficient of a power of x₁ has terms, at points (ω₂ʲ, …, ω_k−1ʲ), by transposed
/// Vandermonde systems. Newton interpolation in x_k makes the next step.
///
/// Every answer is a guess; that it divides f and g proves it (see DenseGcd).
template <class Field>
class SparseGcd {
  public:
    /// Arguments over the same n variables; γ does not contain the first. degrees[i] bounds the degree of H
    /// in variable i; degrees[0] is that of h.
    SparseGcd(const Field& field, const SparseImage& f, const SparseImage& g, const SparseImage& gamma,
              std::vector<std::size_t> degrees, Random& random, base::Run& run);

    /// H; nothing if random choices were unlucky.
    std::optional<SparseImage> operator()();

    /// The coefficients of H on the support that another prime gave; nothing if that fails or it does not
    /// fit.
    std::optional<dense::Vector> on_support(const ExponentRows& rows);

  private:
    class Images;
    /// A polynomial in the first k + 1 variables, values being in the place of the others.
    struct Layer {
        SparseImage image;
        std::vector<std::size_t> ends; ///< where the rows with one prefix, a row of the layer below, end
    };
    using Layers = std::vector<Layer>;

    Layers layers_of(const SparseImage& f, const dense::Vector& point);
    dense::Vector at(const Layer& layer, dense::Element value) const;
    dense::Vector random_point();
    SparseImage led_by(const SparseImage& gamma) const;
    std::optional<SupposedTerms<Field>> separated(const ExponentRows& rows, dense::Vector& omega);
    bool extend(std::size_t k, dense::Element known_point, SparseImage& h, const Layers& f, const Layers& g,
                const Layers& gamma);

    const Field& field_;
    const SparseImage& f_;
    const SparseImage& g_;
    const SparseImage& gamma_;
    std::vector<std::size_t> degrees_;
    Random& random_;
    base::Run& run_;
};

} // namespace eliminant::algebra
