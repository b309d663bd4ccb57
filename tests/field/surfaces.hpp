/// \file
/// The surfaces of data/surfaces.
#pragma once

#include "eliminant/algebra/parse.hpp"

#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace eliminant::test {

struct Surface {
    std::string name;
    Polynomial polynomial;
};

inline Ring xyz() { return Ring(CoefficientField::rationals(), {"x", "y", "z"}); }
inline Polynomial polynomial(const std::string& text) { return parse_polynomial(xyz(), {text, "test"}); }

/// The value of `"key": "…"` in a line of JSON whose strings contain no quotes.
inline std::string string_field(const std::string& line, const std::string& key) {
    const std::string begin = "\"" + key + "\": \"";
    const std::size_t from = line.find(begin);
    if (from == std::string::npos) throw std::runtime_error("surfaces.jsonl: no " + key);
    return line.substr(from + begin.size(), line.find('"', from + begin.size()) - from - begin.size());
}

/// All surfaces of surfaces.jsonl, expanded.
inline const std::vector<Surface>& surfaces() {
    static const std::vector<Surface> all = [] {
        std::ifstream file(std::string(ELIMINANT_DATA_DIR) + "/surfaces/surfaces.jsonl");
        std::vector<Surface> result;
        for (std::string line; std::getline(file, line);)
            result.push_back({string_field(line, "name"), polynomial(string_field(line, "poly"))});
        if (result.empty()) throw std::runtime_error("surfaces.jsonl is missing or empty");
        return result;
    }();
    return all;
}

inline const Polynomial& surface(const std::string& name) {
    for (const Surface& entry : surfaces())
        if (entry.name == name) return entry.polynomial;
    throw std::runtime_error("no surface " + name);
}

} // namespace eliminant::test
