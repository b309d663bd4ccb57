// What the tests of implicitization share: input as text, and checks that know nothing of how an answer was
// found.
#pragma once

#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/algebra/parse.hpp"
#include "eliminant/algebra/print.hpp"
#include "eliminant/implicit/implicitize.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace eliminant::implicit {

inline Parametrization parametrization_of(const std::string& text) {
    Run run;
    return parse_parametrization(SourceText(text, "test"), run);
}

inline ImplicitResult implicitized(const std::string& text, const ImplicitizeOptions& options = {}) {
    Run run;
    return implicitize(parametrization_of(text), options, run);
}

inline std::string joined(const std::vector<Polynomial>& polynomials) {
    if (polynomials.empty()) return "0";
    std::string text;
    for (const Polynomial& f : polynomials) {
        if (!text.empty()) text += '\n';
        text += to_string(f);
    }
    return text;
}

/// The equations as the command line prints them.
inline std::string equations_of(const std::string& text, const ImplicitizeOptions& options = {}) {
    return joined(implicitized(text, options).equations);
}

/// Whether f vanishes at images of random points modulo a prime; a parametrization without relations.
inline bool vanishes_on_image(const Polynomial& f, const Parametrization& parametrization,
                              std::mt19937_64& random) {
    Run run;
    const PrimeField field(2147483629);
    int points = 0;
    while (points < 10) {
        std::vector<std::uint32_t> point(parametrization.ring().variable_count());
        for (auto& value : point) value = static_cast<std::uint32_t>(random() % field.characteristic());
        for (const auto& [cosine, sine] : parametrization.rotations()) {
            const auto w = static_cast<std::uint32_t>(random() % field.characteristic());
            const auto w2 = field.multiply(w, w);
            const auto inverse = field.inverse(field.add(1, w2));
            point[cosine] = field.multiply(field.subtract(1, w2), inverse);
            point[sine] = field.multiply(field.add(w, w), inverse);
        }
        std::vector<std::uint32_t> image;
        bool defined = true;
        for (const Coordinate& coordinate : parametrization.coordinates()) {
            const auto n = evaluate(coordinate.value.numerator, field, point, run);
            const auto d = evaluate(coordinate.value.denominator, field, point, run);
            defined = defined && d != 0;
            image.push_back(defined ? field.multiply(n, field.inverse(d)) : 0);
        }
        if (!defined) continue;
        for (const std::size_t i : parametrization.constants()) image.push_back(point[i]);
        if (evaluate(f, field, image, run) != 0) return false;
        ++points;
    }
    return true;
}

} // namespace eliminant::implicit
