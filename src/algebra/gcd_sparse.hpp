#pragma once

#include "univariate_mod_p.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// Exponent vectors as rows of equal length, strictly decreasing in lex.
struct ExponentRows {
    std::size_t variables = 0;
    std::vector<std::uint64_t> entries; ///< row after row
    std::size_t count = 0;

    std::span<const std::uint64_t> row(std::size_t i) const {
        return std::span(entries).subspan(i * variables, variables);
    }
    void push_back(std::span<const std::uint64_t> row) {
        entries.insert(entries.end(), row.begin(), row.end());
        ++count;
    }
};

/// The terms of a polynomial over a finite field.
struct SparseImage {
    ExponentRows exponents;
    dense::Vector coefficients;

    void push_back(std::span<const std::uint64_t> row, dense::Element coefficient) {
        exponents.push_back(row);
        coefficients.push_back(coefficient);
    }
};

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
              std::vector<std::size_t> degrees, std::mt19937_64& random, base::Run& run);

    /// H; nothing if random choices were unlucky.
    std::optional<SparseImage> operator()();

    /// The coefficients of H on the support that another prime gave; nothing if that fails or it does not
    /// fit.
    std::optional<dense::Vector> on_support(const ExponentRows& support);

  private:
    class Support;
    class Images;
    /// A polynomial with its last variables evaluated: layers[k] has the first k + 1 of them left.
    using Layers = std::vector<SparseImage>;

    Layers layers_of(const SparseImage& f, const dense::Vector& point);
    dense::Vector collapsed(const SparseImage& f, const ExponentRows& prefixes, dense::Element value);
    dense::Vector random_point();
    SparseImage led_by(const SparseImage& gamma) const;
    bool extend(std::size_t k, dense::Element known_point, SparseImage& h, const Layers& f, const Layers& g,
                const Layers& gamma);

    const Field& field_;
    const SparseImage& f_;
    const SparseImage& g_;
    const SparseImage& gamma_;
    std::vector<std::size_t> degrees_;
    std::mt19937_64& random_;
    base::Run& run_;
};

} // namespace eliminant::algebra
