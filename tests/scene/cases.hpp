/// \file
/// The surfaces of data/surfaces with their cameras and exact rays.
#pragma once

#include "field/surfaces.hpp"

#include "eliminant/algebra/parse.hpp"
#include "eliminant/scene/algebraic_surface.hpp"

#include <glm/geometric.hpp>

#include <array>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace eliminant::test {

struct Case {
    std::string name;
    Polynomial polynomial;
    double clip_radius;
    glm::dvec3 camera;
};

inline double number(const std::string& text) { return mpq_class(parse_rational({text, "test"})).get_d(); }

inline const std::vector<Case>& cases() {
    static const std::vector<Case> all = [] {
        std::ifstream file(std::string(ELIMINANT_DATA_DIR) + "/surfaces/surfaces.jsonl");
        std::vector<Case> result;
        for (std::string line; std::getline(file, line);) {
            Case entry{string_field(line, "name"), polynomial(string_field(line, "expanded")),
                       number(string_field(line, "sphere_radius")), glm::dvec3(0.0)};
            std::string origin = line.substr(line.find("\"origin\": [") + 11);
            std::istringstream coordinates(origin.substr(0, origin.find(']')));
            for (int axis = 0; axis < 3; ++axis) {
                std::string quoted;
                std::getline(coordinates, quoted, ',');
                const std::size_t begin = quoted.find('"') + 1;
                entry.camera[axis] = number(quoted.substr(begin, quoted.rfind('"') - begin));
            }
            result.push_back(entry);
        }
        if (result.empty()) throw std::runtime_error("surfaces.jsonl is missing or empty");
        return result;
    }();
    return all;
}

inline const Case& case_named(const std::string& name) {
    for (const Case& entry : cases())
        if (entry.name == name) return entry;
    throw std::runtime_error("no case " + name);
}

/// The camera of the cases: at `origin`, towards 0, y upwards, tan(vfov/2) = 27/100.
inline RayGrid pinhole_grid(glm::dvec3 origin, std::size_t size) {
    const glm::dvec3 forward = glm::normalize(-origin);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 1.0, 0.0)));
    const glm::dvec3 up = glm::cross(right, forward);
    const double n = static_cast<double>(size);
    constexpr double tangent = 0.27;
    RayGrid rays;
    rays.width = rays.height = size;
    rays.origin = origin;
    rays.direction = forward + tangent * (1.0 - n) / n * right + tangent * (n - 1.0) / n * up;
    rays.direction_dx = 2.0 * tangent / n * right;
    rays.direction_dy = -2.0 * tangent / n * up;
    return rays;
}

/// The depths of rays/NAME.txt: infinity for a miss, NaN where no answer is expected.
inline std::vector<double> exact_depths(const std::string& name) {
    std::ifstream file(std::string(ELIMINANT_DATA_DIR) + "/surfaces/rays/" + name + ".txt");
    std::string word;
    std::getline(file, word);
    std::vector<double> depths;
    while (file >> word)
        depths.push_back(word == "-"   ? std::numeric_limits<double>::infinity()
                         : word == "?" ? std::numeric_limits<double>::quiet_NaN()
                                       : std::stod(word));
    if (depths.size() != 32 * 32) throw std::runtime_error("rays of " + name + " are missing or incomplete");
    return depths;
}

} // namespace eliminant::test
