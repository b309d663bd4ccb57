// A rational map modulo a prime, made to be evaluated at many points.
#pragma once

#include "algebra/random.hpp"
#include "algebra/univariate_mod_p.hpp"
#include "eliminant/algebra/prime_field.hpp"
#include "implicit/verify_map.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace eliminant::implicit {

/// The image of a RationalMap over GF(p).
class MapModulo {
  public:
    using Element = algebra::PrimeField::Element;
    using Univariate = algebra::dense::Vector;

    /// \throws DomainError if p divides a denominator of a coefficient
    MapModulo(const RationalMap& map, const algebra::PrimeField& field);

    const algebra::PrimeField& field() const { return field_; }
    std::size_t coordinate_count() const { return numerators_.size(); }

    /// The map with all parameters but one replaced by numbers: univariate numerators, and the denominator.
    struct Line {
        std::vector<Univariate> numerators;
        Univariate denominator;
    };
    /// \param point a value for each variable of the ring of the map; that of `variable` is not used
    Line restricted(std::span<const Element> point, std::size_t variable) const;

    /// The coordinates at a point of a line; nullopt where the denominator is zero.
    std::optional<std::vector<Element>> image(const Line& line, Element parameter) const;
    /// The coordinates at a point of parameter space; nullopt where the denominator is zero.
    std::optional<std::vector<Element>> image(std::span<const Element> point) const;

    bool is_over_denominator(std::size_t coordinate) const { return over_denominator_[coordinate]; }
    /// Values for all variables.
    std::vector<Element> random_point(algebra::Random& random) const;
    /// The coordinates at a random point; nullopt if the denominator is zero at many of them.
    std::optional<std::vector<Element>> random_image(algebra::Random& random) const;

  private:
    /// Coefficients and, row by row, exponents of all variables.
    struct Terms {
        std::vector<Element> coefficients;
        std::vector<std::uint64_t> exponents;
    };
    Terms terms_of(const algebra::Polynomial& f) const;
    void restrict_to(const Terms& f, std::span<const std::vector<Element>> powers, std::size_t variable,
                     Univariate& target) const;
    std::vector<std::vector<Element>> powers_of(std::span<const Element> point) const;

    algebra::PrimeField field_;
    std::size_t variable_count_;
    std::vector<std::uint64_t> degrees_; ///< largest exponent of each variable
    std::vector<Terms> numerators_;
    std::vector<bool> over_denominator_;
    Terms denominator_;
};

} // namespace eliminant::implicit
