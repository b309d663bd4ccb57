// Every text is a system or an error in each format; what is read is printed and read back.
#include "eliminant/algebra/print.hpp"
#include "eliminant/algebra/system.hpp"
#include "eliminant/base/error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>

using namespace eliminant;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 4096) return 0;
    const std::string text(reinterpret_cast<const char*>(data), size);
    for (const SystemFormat format :
         {SystemFormat::guess, SystemFormat::eliminant, SystemFormat::msolve, SystemFormat::singular}) {
        Run run(RunOptions{.time_limit_seconds = 1, .memory_limit_bytes = std::uint64_t{1} << 30});
        try {
            const System system = parse_system(text, format, {}, run);
            const System again = parse_system(to_string(system), SystemFormat::eliminant, {}, run);
            if (again.ring == system.ring && again.polynomials == system.polynomials) continue;
            std::cerr << "round trip fails for: " << text << '\n';
            std::abort();
        } catch (const ParseError&) { // what a wrong text ends in
        } catch (const Stopped&) {
        }
    }
    return 0;
}
