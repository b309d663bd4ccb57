// An equation on a rational map, evaluated modulo a prime at enough points to be zero.
#pragma once

#include "implicit/verify_map.hpp"
#include "implicit/verify_values.hpp"
#include "implicit/verify_vanishing.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace eliminant::implicit {

/// How the points of a grid are gone through: on lines in the direction of one parameter. Map and equation
/// are first evaluated in what is constant on a line, and only the rest of them at its points; on ES_8 of
/// Abbott, Bigatti and Robbiano (five coordinates, two of which contain the fourth parameter) that leaves
/// one term in seventy for each point.
struct GridLines {
    /// \param degrees bounds in the parameters
    GridLines(const RationalMap& map, const algebra::Polynomial& f,
              const std::vector<std::uint64_t>& degrees);

    std::size_t direction;      ///< the parameter; their number if there are no lines but single points
    std::vector<bool> constant; ///< whether a coordinate is so on each line
    ExponentTree equation;      ///< these coordinates are fixed
    ExponentTree denominator;   ///< all parameters but the direction are fixed
    std::vector<ExponentTree> numerators;
};

/// Whether G, as in vanishing_claim(), is zero modulo p. Proved by values: a polynomial whose exponents lie
/// in a set L with each e also all smaller exponent vectors is zero if it vanishes at the points (a_e₁, b_e₂,
/// …) for e ∈ L, where the a, the b, … are distinct (by induction over the variables, the coefficients of the
/// last one being polynomials with smaller sets; Lorentz, Multivariate Birkhoff Interpolation, 1992). L is
/// given by the bounds of the claim; a few points more do no harm.
class Grid {
  public:
    using Lanes = ValuesModulo::Lanes;

    /// \param field of a prime of the claim
    Grid(const GridLines& lines, const RationalMap& map, const algebra::Polynomial& f,
         const VanishingClaim& bounds, const algebra::PrimeField& field, base::Run& run);

    /// As many evaluations of f as L has elements.
    bool is_zero();

  private:
    enum class Found { zero, not_zero, pole };

    Found values_from(std::uint32_t start);
    Found visit_lines(std::size_t index, std::uint64_t sum);
    Found values_on_waiting_lines();
    bool invert_denominators(std::uint64_t degree);
    void set_coordinates(std::size_t position);

    const GridLines& lines_;
    const VanishingClaim& bounds_;
    algebra::PrimeField field_;
    base::Run& run_;
    bool has_denominator_;
    std::vector<bool> over_denominator_;
    ValuesModulo equation_;
    ValuesModulo denominator_;
    std::vector<ValuesModulo> numerators_;

    std::vector<std::size_t> across_;     ///< the parameters that tell lines apart
    std::vector<std::uint64_t> capacity_; ///< Σ of the bounds of this one of them and those behind it
    std::vector<std::uint32_t> exponents_;
    std::uint32_t start_ = 0;
    std::vector<Lanes> points_;   ///< values of the parameters on the lines that wait for treatment
    std::size_t waiting_ = 0;     ///< their number
    std::uint64_t least_sum_ = 0; ///< of the exponents of the first of them
    std::vector<Lanes> inverse_denominators_; ///< along the lines
    std::vector<Lanes> coordinates_;
};

} // namespace eliminant::implicit
