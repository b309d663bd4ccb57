/// \file
/// How the Taylor coefficients of a polynomial at a point are computed.
#pragma once

#include "field/nested_scheme.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::field {

/// f(p + q) as a polynomial in q, by Horner's rule of shifting one variable at a time: for t in w, v, u and
/// each line of coefficients along t, repeated synthetic division by the coordinate of p.
///
/// Entries are the exponents that divide an exponent of f, which are those that can occur; lines along w are
/// contiguous:
///
///     (i, j):  w^0 w^1 … w^K     0 ≤ i ≤ I, 0 ≤ j ≤ J(i)
struct TaylorScheme {
    /// entries[to + k] += t · entries[from + k] for 0 ≤ k < count, t being the coordinate of level 0 or 1.
    struct Step {
        std::uint32_t to = 0;
        std::uint32_t from = 0;
        std::uint32_t count = 0;
        std::uint32_t level = 0;
    };
    /// A line along w as f has it, before anything is shifted.
    struct Line {
        std::uint32_t first = 0; ///< of w^0
        std::uint32_t count = 0;
    };
    /// A line along w as it is afterwards: the entries of u^i v^j w^k for 0 ≤ k < count.
    struct FilledLine {
        std::uint32_t first = 0; ///< of w^0
        std::uint32_t count = 0;
        std::uint32_t i = 0;
        std::uint32_t j = 0;
    };
    /// One entry of a homogeneous part.
    struct Component {
        std::uint32_t entry = 0;
        double weight = 0; ///< α!/k!, rounded
    };
    static constexpr std::uint32_t none = ~std::uint32_t{0};

    bool is_complete = false; ///< else it would be too large, and everything below is empty
    std::array<std::uint8_t, 3> coordinates = {0, 1, 2}; ///< which of x, y, z are u, v, w
    std::size_t size = 0;                                ///< number of entries
    std::vector<std::uint32_t> slots;                    ///< entry of each term
    std::vector<Line> lines;
    std::vector<Step> steps;                   ///< first those along v, then those along u
    std::vector<FilledLine> filled;            ///< all entries
    std::vector<std::vector<Component>> parts; ///< by order k
    /// Entries of 1; x, y, z; x², xy, xz, y², yz, z², or none.
    std::array<std::uint32_t, 10> low = {};
};

/// The scheme of least cost among the six sequences of coordinates; incomplete if one would cost more than
/// about 2^21 operations.
TaylorScheme make_taylor_scheme(std::span<const Exponents> terms);

/// The Taylor coefficients at a point: `entries` has scheme.size elements, those of f in its slots and zeros
/// elsewhere, and is replaced. Any number type with + and ·. `poll` is called before every step.
template <class Number, class Poll>
void shift_to(const TaylorScheme& scheme, const Number* point, Number* entries, const Poll& poll) {
    const Number& w = point[scheme.coordinates[2]];
    for (const TaylorScheme::Line& line : scheme.lines) {
        poll();
        Number* c = entries + line.first;
        for (std::uint32_t done = 0; done + 1 < line.count; ++done)
            for (std::uint32_t k = line.count - 1; k > done; --k) c[k - 1] = c[k - 1] + w * c[k];
    }
    for (const TaylorScheme::Step& step : scheme.steps) {
        poll();
        const Number& t = point[scheme.coordinates[step.level]];
        Number* to = entries + step.to;
        const Number* from = entries + step.from;
        for (std::uint32_t k = 0; k < step.count; ++k) to[k] = to[k] + t * from[k];
    }
}

} // namespace eliminant::field
