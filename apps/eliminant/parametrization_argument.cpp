#include "parametrization_argument.hpp"

#include "input.hpp"

namespace eliminant::app {

Parametrization read_parametrization(std::span<const std::string> operands, Run& run) {
    const Input input = input_of(operands, looks_like_equation, run);
    if (input.parts.size() == 1)
        return parse_parametrization(SourceText(input.parts.front().text, input.parts.front().name), run);
    std::vector<SourceText> statements;
    for (const Input::Part& part : input.parts) statements.emplace_back(part.text, part.name);
    return parse_parametrization(statements, run);
}

} // namespace eliminant::app
