#pragma once

#include "field/beam_layout.hpp"
#include "field/double_double.hpp"
#include "field/sparse_ray.hpp"

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/field/ray_roots.hpp"

#include <array>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace eliminant::field {

/// The coefficients of f in floating point, by exponents (i, j, k) of x, y, z at layout.start(i, j) + k,
/// divided by a power of two that makes the largest about 1.
struct RayRootsData {
    explicit RayRootsData(algebra::Polynomial polynomial, std::size_t degree)
        : f(std::move(polynomial)), layout(degree, false), coefficients(layout.size()), majorant(degree + 1) {
    }

    algebra::Polynomial f;
    BeamLayout layout; ///< of degree 0 if f is constant, or too large for floating point
    std::vector<DoubleDouble> coefficients;
    std::vector<double> majorant;    ///< [m] ≥ Σ |c| over the terms of degree m
    std::optional<SparseRay> sparse; ///< if f has few terms for its degree
    bool is_zero = false;
};

/// A ray whose numbers need not be doubles. They may be rounded sums, to 2^-102 of the sums of absolute
/// values that are given with them.
struct WideRay {
    std::array<DoubleDouble, 3> origin;
    std::array<DoubleDouble, 3> direction;
    std::array<double, 3> origin_size{};
    std::array<double, 3> direction_size{};
};

/// The first root in [lower, upper] as floating point finds it, in doubles or in 106 bits: certain, or
/// nothing.
std::optional<RayRoot> first_root_on_ray(const RayRootsData& data, const WideRay& ray, double lower,
                                         double upper);

} // namespace eliminant::field
