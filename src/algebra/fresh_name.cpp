#include "fresh_name.hpp"

namespace eliminant::algebra {

std::string fresh_name(const Ring& ring, std::string_view stem) {
    std::string name(stem);
    for (std::size_t i = 1; ring.index_of(name); ++i) name = std::string(stem) + std::to_string(i);
    return name;
}

} // namespace eliminant::algebra
