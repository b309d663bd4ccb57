// A renderer in thirty lines. It walks along each ray by the guaranteed distance, so it cannot step through a
// surface.
#include <eliminant/algebra/parse.hpp>
#include <eliminant/field/distance.hpp>

#include <glm/geometric.hpp>

#include <algorithm>
#include <iostream>

int main() {
    const eliminant::Ring space(eliminant::CoefficientField::rationals(), {"x", "y", "z"});
    const auto torus = eliminant::parse_polynomial(space, "(x^2+y^2+z^2+21/25)^2 - 4*(x^2+y^2)");
    const eliminant::DistanceField field(torus);

    const glm::dvec3 eye(0, -2, 4);
    const glm::dvec3 light = glm::normalize(glm::dvec3(-1, -1, 2));
    for (int row = 0; row < 24; ++row) {
        for (int column = 0; column < 60; ++column) {
            const glm::dvec3 right(1, 0, 0);
            const glm::dvec3 up = glm::cross(right, glm::normalize(-eye));
            const glm::dvec3 ray =
                glm::normalize(glm::normalize(-eye) + (column - 29.5) / 80 * right + (11.5 - row) / 40 * up);
            char pixel = ' ';
            for (double t = 0; t < 8 && pixel == ' ';) {
                const glm::dvec3 p = eye + t * ray;
                const double step = distance(field, p, eliminant::DistanceLevel::guaranteed).value;
                const double shade = glm::dot(glm::normalize(field.polynomial().jet(p).gradient), light);
                if (step < 1e-4) pixel = ".:-=+*#%@@"[std::max(0, static_cast<int>(9 * shade))];
                t += step;
            }
            std::cout << pixel;
        }
        std::cout << '\n';
    }
}
