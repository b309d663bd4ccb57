#pragma once

#include "exponent_rows.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eliminant::algebra {

/// Multiplication of many elements by the same factors again and again.
template <class Field>
class RepeatedFactors {
  public:
    RepeatedFactors(const Field& field, dense::Vector factors)
        : field_(field), factors_(std::move(factors)) {}

    /// values[i] *= factors[i] for first ≤ i < last; returns the sum of the products.
    dense::Element multiply(dense::Vector& values, std::size_t first, std::size_t last) const {
        dense::Element sum = 0;
        for (std::size_t i = first; i < last; ++i) {
            values[i] = field_.multiply(values[i], factors_[i]);
            sum = field_.add(sum, values[i]);
        }
        return sum;
    }

  private:
    const Field& field_;
    dense::Vector factors_;
};

/// Modulo p by Shoup's method: with w' = ⌊w·2³²/p⌋ and any v < 2³², w·v − ⌊w'·v/2³²⌋·p lies in [0, 2p). So
/// values may stay in that range, a product is three multiplications of words without a carry or a
/// comparison, and sums need one reduction in the end. Half the time of Barrett's reduction.
template <>
class RepeatedFactors<PrimeField> {
  public:
    RepeatedFactors(const PrimeField& field, dense::Vector factors)
        : field_(field), factors_(std::move(factors)) {
        quotients_.reserve(factors_.size());
        for (const dense::Element w : factors_)
            quotients_.push_back(
                static_cast<std::uint32_t>((std::uint64_t{w} << 32) / field.characteristic()));
    }

    dense::Element multiply(dense::Vector& values, std::size_t first, std::size_t last) const {
        const std::uint32_t p = field_.characteristic();
        std::uint64_t sum = 0;
        for (std::size_t i = first; i < last; ++i) {
            const auto q = static_cast<std::uint32_t>((std::uint64_t{quotients_[i]} * values[i]) >> 32);
            values[i] = factors_[i] * values[i] - q * p; // modulo 2^32, where the result fits
            sum += values[i];
        }
        return field_.reduce(sum);
    }

  private:
    const PrimeField& field_;
    dense::Vector factors_;
    dense::Vector quotients_;
};

/// Univariate images of a polynomial at the points ω, ω², ω³, … of all its variables but the first: a
/// multiplication and an addition a term.
template <class Field>
class GeometricImages {
  public:
    /// `rows` outlives this.
    GeometricImages(const Field& field, const ExponentRows& rows, const dense::Vector& omega)
        : ratios_(field, monomial_values(field, rows, omega)),
          extent_(static_cast<std::size_t>(rows.row(0)[0]) + 1) {
        for (std::size_t first = 0; first < rows.count;) {
            const std::uint64_t power = rows.row(first)[0];
            std::size_t last = first;
            while (last < rows.count && rows.entries[last * rows.variables] == power) ++last;
            groups_.push_back({static_cast<std::size_t>(power), last});
            first = last;
        }
    }

    /// The next image of the polynomial whose coefficients `values` were before the first call.
    void next(dense::Vector& values, dense::Vector& image) const {
        image.assign(extent_, 0);
        std::size_t first = 0;
        for (const Group& group : groups_) {
            image[group.power] = ratios_.multiply(values, first, group.last);
            first = group.last;
        }
    }

  private:
    /// Consecutive rows with one power of the first variable; rows decrease in lex.
    struct Group {
        std::size_t power;
        std::size_t last;
    };

    RepeatedFactors<Field> ratios_;
    std::vector<Group> groups_;
    std::size_t extent_;
};

} // namespace eliminant::algebra
