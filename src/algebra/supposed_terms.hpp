#pragma once

#include "exponent_rows.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace eliminant::algebra {

/// The terms that a polynomial H is supposed to have, and what it takes to find their coefficients from
/// univariate images of H at the points ω, ω², … of all variables but the first.
///
/// Terms are grouped by their power of the first variable. In a group with monomials of values m₁, …, m_t at
/// ω, the images at ωʲ show s_j = Σ y_l·m_lʲ, a transposed Vandermonde system for the coefficients y_l. With
/// M = ∏ (z − m_l) and M/(z − m_i) = Σ q_j·zʲ, Σ q_j·s_{j+1} = Σ y_l·m_l·(M/(z − m_i))(m_l) has one term
/// left, that of y_i. So a group of t terms takes O(t²) operations and O(t) memory (Zippel 1990).
///
/// The leading group is known beforehand: it is that of H's leading coefficient γ.
template <class Field>
class SupposedTerms {
  public:
    /// Ready only if the monomials of each group have distinct values at ω.
    SupposedTerms(const Field& field, const ExponentRows& rows, const dense::Vector& omega);

    bool ready() const { return ready_; }
    /// Images that determine the coefficients.
    std::size_t images_needed() const;

    /// The coefficients from as many images, given those of the leading group. Further images serve as tests
    /// of the supposed terms: nothing if one fails, or if the images have terms of other powers.
    std::optional<dense::Vector> solve(const std::vector<dense::Vector>& images,
                                       const dense::Vector& gamma) const;

  private:
    struct Group {
        std::size_t power; ///< of the first variable
        std::size_t first; ///< row
        std::size_t length;
        dense::Vector master; ///< M
    };

    void prepare(Group& group);
    dense::Vector quotient(const Group& group, dense::Element node) const;
    bool solve_group(const Group& group, const dense::Vector& samples, dense::Vector& result) const;

    const Field& field_;
    dense::Vector nodes_;        ///< m of each row
    dense::Vector denominators_; ///< 1/(m·(M/(z − m))(m)) of each row
    std::vector<Group> groups_;
    bool ready_ = true;
};

} // namespace eliminant::algebra
