#include "systems.hpp"

#include "input.hpp"

#include "eliminant/algebra/parse.hpp"

#include <algorithm>

namespace eliminant::app {

namespace {

/// An argument may hold several polynomials, separated by commas.
void append_pieces(const SourceText& argument, std::vector<SourceText>& pieces) {
    std::size_t begin = 0;
    for (;;) {
        const std::size_t comma = std::min(argument.text().find(',', begin), argument.size());
        pieces.push_back(argument.section(begin, comma));
        if (comma == argument.size()) return;
        begin = comma + 1;
    }
}

/// A system as written, except that no order has been asked for yet: it may name variables of another one.
System read_in_own_order(std::span<const std::string> operands, const SystemOptions& options, Run& run) {
    SystemOverrides overrides = options.overrides;
    overrides.order.reset();
    const Input input = input_of(operands, looks_like_polynomial, run);
    if (!input.is_expressions) {
        const SourceText source(input.parts.front().text, input.parts.front().name);
        System system = parse_system(source, options.format, overrides, run);
        // An empty file is more often a mistake than the zero ideal, which is written `0`.
        if (system.polynomials.empty()) source.fail(source.size(), "a polynomial");
        return system;
    }
    std::vector<SourceText> polynomials;
    for (const Input::Part& part : input.parts) append_pieces(SourceText(part.text, part.name), polynomials);
    return parse_system(polynomials, overrides, run);
}

bool is_standard_input(std::span<const std::string> operands) {
    return operands.size() == 1 && operands.front() == "-";
}

std::vector<std::string> all_names(std::span<const System> systems) {
    std::vector<std::string> names;
    for (const System& system : systems)
        for (const std::string& name : system.ring.names())
            if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    return names;
}

Ring common_ring(std::span<const System> systems, const SystemOptions& options) {
    const Ring& first = systems.front().ring;
    for (const System& system : systems)
        if (system.ring.field() != first.field())
            throw UsageError("expected systems over one field, found " + first.field().to_string() + " and " +
                             system.ring.field().to_string());
    std::vector<std::string> names = all_names(systems);
    if (!options.overrides.order && names == first.names()) return first;
    const std::string order = options.overrides.order.value_or(first.order().to_string(first.names()));
    MonomialOrder parsed_order = parse_order(SourceText(order, "--order"), names);
    return {first.field(), std::move(names), std::move(parsed_order)};
}

} // namespace

void SystemOptions::declare(OptionSet& options) {
    options.value("order", 0, "ORDER",
                  "lex, deglex, degrevlex (default), weight(w1,…;lex|revlex), elim(x,y)\n"
                  "or matrix(1,1;0,-1)",
                  [this](std::string_view text) { overrides.order = text; });
    options.value("field", 0, "FIELD", "QQ or GF(p) for a prime p below 2^31", [this](std::string_view text) {
        overrides.field = parse_field({text, "--field"});
    });
    options.value("variables", 0, "NAMES", "the variables in this order, as x,y,z",
                  [this](std::string_view text) {
                      overrides.variables = parse_names({text, "--variables"});
                  });
    options.choice<SystemFormat>("input-format", "how a file is written (default: seen from its content)",
                                 {{"eliminant", SystemFormat::eliminant},
                                  {"msolve", SystemFormat::msolve},
                                  {"singular", SystemFormat::singular}},
                                 format);
}

std::vector<System> read_systems(std::span<const std::span<const std::string>> groups,
                                 const SystemOptions& options, Run& run) {
    if (std::count_if(groups.begin(), groups.end(), is_standard_input) > 1)
        throw UsageError(
            "input: expected '-' once, found it more often: standard input can be read only once");
    std::vector<System> systems;
    for (const std::span<const std::string> group : groups)
        systems.push_back(read_in_own_order(group, options, run));
    const Ring ring = common_ring(systems, options);
    for (System& system : systems) {
        for (Polynomial& f : system.polynomials) f = f.in_ring(ring);
        system.ring = ring;
    }
    return systems;
}

System read_system(std::span<const std::string> operands, const SystemOptions& options, Run& run) {
    return std::move(read_systems(std::span(&operands, 1), options, run).front());
}

} // namespace eliminant::app
