// Every byte sequence is a batch of shapes or a ParseError; so is each of its shapes, and control nets have
// the number of pieces that their knots tell.
#include "eliminant/implicit/batch.hpp"

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
    const auto check = [](const ParseError& error) {
        if (error.where().line == 0 || error.where().column == 0 || error.expected().empty()) std::abort();
    };
    try {
        const auto sources = shape_sources(SourceText(text, "fuzz"), run);
        if (sources.empty()) std::abort();
        for (const ShapeSource& source : sources) {
            if (sources.size() > 1 && source.name.empty()) std::abort();
            try {
                const auto shapes = parse_shapes(source, run);
                if (shapes.empty()) std::abort();
                for (const Shape& shape : shapes)
                    if (shape.parametrization.coordinates().empty()) std::abort();
            } catch (const ParseError& error) {
                check(error);
            }
        }
    } catch (const ParseError& error) {
        check(error);
    } catch (const Stopped&) {
    }
    return 0;
}
