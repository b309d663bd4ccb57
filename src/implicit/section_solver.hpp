// The equation of a hypersurface modulo primes from its sections by parallel planes.
#pragma once

#include "implicit/plane_points.hpp"
#include "implicit/vanishing_polynomial.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace eliminant::implicit {

/// A polynomial as the coefficients of the monomials of a support, all coordinates being its variables.
struct SparseImage {
    Support support;
    Coefficients coefficients;
};

/// Where a coordinate z has the value c, the equation f becomes f(…, c), with far fewer coefficients than f
/// has: linear algebra finds them up to a factor, from points of the section. As N unknowns cost N³/3
/// products, this is much cheaper than to find all coefficients of f at once: 19 times 190³ instead of 1330³
/// for a bicubic patch, 17 times less.
///
///     f(…, c₁), f(…, c₂), …  each with its own factor
///     their ratios to one coefficient g(z): rational functions of z with a common denominator, g
///     g from a random combination of them, then every coefficient by interpolation
///
/// Sections have sections: constants are all given values, one after the other, then one coordinate.
///
/// What the sections look like (their monomials, how many are needed) is learned at the first prime and used
/// at the others.
class SectionSolver {
  public:
    /// \param weights of the coordinates: monomials of a section are tried by ascending weighted degree
    /// \param max_terms of a section, before it is given up
    SectionSolver(const RationalMap& map, std::vector<std::uint64_t> weights, std::size_t max_terms);

    /// Whether there is anything that can be given a value.
    bool is_applicable() const { return !fixed_.constants.empty() || fixed_.coordinate.has_value(); }

    /// f modulo p up to a factor; nullopt if the prime, or a random choice, was unlucky. The first call
    /// learns; later ones may be made at the same time.
    std::optional<SparseImage> image(const MapModulo& map, base::Run& run);

    std::string describe() const; ///< What was learned.

    /// Before anything was learned: monomials of a section of an equation of that weighted degree, or `limit`
    /// if they are more.
    std::size_t predicted_terms(std::uint64_t weighted_degree, std::size_t limit) const;
    /// Of the equation that is solved for a point of a section; 0 if none is.
    std::size_t root_degree(const RationalMap& map) const;

  private:
    using Element = MapModulo::Element;
    using Values = std::vector<Element>;

    /// The exponents lo, lo + stride, … of z in one coefficient.
    struct Progression {
        std::uint32_t least;
        std::uint32_t stride;
        std::uint32_t count;
    };
    /// What is known of the polynomials that one level puts together.
    struct Level {
        explicit Level(std::size_t z) : coordinate(z) {}

        std::size_t coordinate;
        Support sections{0}; ///< monomials of the sections
        std::size_t planes = 0;
        std::size_t reference = 0; ///< the coefficient that ratios are taken to
        /// Of the reference, if it is a power of z: no denominator has to be found.
        std::optional<std::uint32_t> reference_exponent;
        std::vector<Progression> exponents; ///< one a section's monomial
        Support result{0};
        std::vector<std::size_t> begin; ///< of the terms of a section's monomial among those of the result
        bool known = false;
    };

    void choose_coordinate(const RationalMap& map);
    std::optional<Coefficients> solve(std::size_t level, const Values& values, const MapModulo& map,
                                      base::Run& run);
    std::optional<Coefficients> solve_section(const Values& values, const MapModulo& map, base::Run& run);
    std::vector<std::size_t> free_coordinates() const;
    std::vector<std::uint64_t> weights_at(std::span<const std::size_t> coordinates) const;
    std::optional<Coefficients> learn_section(const algebra::PrimeField& field, const PointSource& points,
                                              base::Run& run);
    std::optional<Coefficients> learn_level(std::size_t level, const Values& values, const MapModulo& map,
                                            base::Run& run);
    std::vector<std::optional<Coefficients>> sections_at(std::size_t level, const Values& values,
                                                         std::span<const Element> heights,
                                                         const MapModulo& map, base::Run& run);
    Coefficients record(std::size_t level, const std::vector<Coefficients>& columns);
    const Support& support_below(std::size_t level) const;

    std::vector<std::uint64_t> weights_;
    std::size_t max_terms_;
    FixedCoordinates fixed_;
    std::vector<Level> levels_;
    Support section_{0}; ///< monomials of the innermost sections
};

} // namespace eliminant::implicit
