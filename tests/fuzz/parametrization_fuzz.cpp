// Every byte sequence is a parametrization or a ParseError; a parametrization has what its type promises.
#include "eliminant/implicit/parametrization.hpp"

#include <cstdint>
#include <cstdlib>
#include <string_view>

using namespace eliminant;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 4096) return 0;
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    RunOptions options;
    options.time_limit_seconds = 5; // an expansion may be long; the parser itself is not
    Run run(std::move(options));
    try {
        const Parametrization p = parse_parametrization(SourceText(text, "fuzz"), run);
        const std::size_t variables = p.parameters().size() + p.constants().size();
        if (p.coordinates().empty() || variables != p.ring().variable_count()) std::abort();
        for (const Coordinate& coordinate : p.coordinates())
            if (coordinate.value.denominator.is_zero()) std::abort();
    } catch (const ParseError& error) {
        if (error.where().line == 0 || error.where().column == 0 || error.expected().empty()) std::abort();
    } catch (const Stopped&) {
    }
    return 0;
}
