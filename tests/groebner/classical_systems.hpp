// The systems of data/groebner.
#pragma once

#include "eliminant/algebra/system.hpp"

#include <fstream>
#include <sstream>
#include <string>

namespace eliminant::testing {

inline System classical_system(const std::string& name, const CoefficientField& field, base::Run& run) {
    std::ostringstream text;
    text << std::ifstream(ELIMINANT_DATA_DIR "/groebner/" + name + ".qq.ms").rdbuf();
    const std::string content = text.str();
    SystemOverrides overrides;
    overrides.field = field;
    return parse_system({content, name}, SystemFormat::msolve, overrides, run);
}

} // namespace eliminant::testing
