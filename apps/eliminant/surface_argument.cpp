#include "surface_argument.hpp"

#include "input.hpp"
#include "parametrization_argument.hpp"

#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/algebra/parse.hpp"
#include "eliminant/implicit/implicitize.hpp"

#include <algorithm>
#include <array>

namespace eliminant::app {

const std::string_view surface_help =
    "SURFACE is a polynomial or an equation in x, y, z, or a file with one; or a file with a "
    "parametrization\n"
    "or a control net (see 'eliminant implicitize --help'), which is implicitized first, or its statements\n"
    "as several arguments. Other names are constants and get their values by --set.\n";

namespace {

const std::array<std::string, 3> coordinate_names = {"x", "y", "z"};

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\r");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r") + 1 - first);
}

enum class SurfaceText { polynomial, formulas, control_net };

SurfaceText kind_of(std::string_view text) {
    constexpr std::array<std::string_view, 5> net_words{"rational", "bezier", "triangle", "bspline", "nurbs"};
    int equations = 0;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = trimmed(text.substr(0, std::min(end, text.find('#'))));
        const std::string_view word = line.substr(0, line.find_first_of(" \t"));
        if (word == "parameters" || word == "constants" || word == "relation") return SurfaceText::formulas;
        if (word.size() < line.size() && std::ranges::find(net_words, word) != net_words.end() &&
            line.find('=') == std::string_view::npos)
            return SurfaceText::control_net;
        if (line.find('=') != std::string_view::npos) ++equations;
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return equations > 1 ? SurfaceText::formulas : SurfaceText::polynomial;
}

constexpr std::string_view owner_of_constants = "the surface";

/// The polynomial in the ring QQ[x, y, z], its variables being mapped in their sequence.
Polynomial in_coordinates(const Polynomial& f, std::size_t coordinates) {
    std::vector<std::size_t> map(f.ring().variable_count(), Polynomial::dropped);
    for (std::size_t i = 0; i < coordinates; ++i) map[i] = i;
    return f.in_ring(Ring(CoefficientField::rationals(), {"x", "y", "z"}), map);
}

SurfaceArgument read_polynomial(const SourceText& source, const ConstantValues& given, Run& run) {
    std::vector<std::string> names(coordinate_names.begin(), coordinate_names.end());
    std::vector<std::size_t> constants;
    for (const std::string& name : names_in(source)) {
        if (std::ranges::find(coordinate_names, name) != coordinate_names.end()) continue;
        constants.push_back(names.size());
        names.push_back(name);
    }
    const Ring ring(CoefficientField::rationals(), std::move(names));
    Polynomial f = parse_equation(ring, source, run); // first, so that a text which is no formula is told so
    const std::vector<mpq_class> values = given.of(ring, constants, owner_of_constants);
    return {.polynomial = in_coordinates(evaluate(f, constants, values, run), 3),
            .formula = std::string(constants.empty() ? source.text() : std::string_view())};
}

SurfaceArgument implicit_surface(const Parametrization& general, ParameterRange range,
                                 const ConstantValues& given, Session& session) {
    const std::size_t coordinates = general.coordinates().size();
    if (coordinates < 2 || coordinates > 3)
        throw UsageError("SURFACE: expected a parametrization of 2 or 3 coordinates, found " +
                         std::to_string(coordinates));
    const Parametrization map = given.put_into(general, owner_of_constants, session.run());
    const ImplicitResult result = implicitize(map, {}, session.run());
    for (const std::string& warning : result.warnings) session.console().warning(warning);
    if (result.equations.size() != 1 || result.codimension != 1)
        throw UsageError("SURFACE: expected a parametrization whose image has one equation, found one of "
                         "codimension " +
                         std::to_string(result.codimension));
    return {in_coordinates(result.equations.front(), coordinates), map, range};
}

} // namespace

SurfaceArgument read_surface(std::span<const std::string> operands, const ConstantValues& constants,
                             Session& session) {
    Run& run = session.run();
    if (operands.size() > 1)
        return implicit_surface(read_parametrization(operands, run), ParameterRange::chosen, constants,
                                session);
    const Input input = input_of(operands, looks_like_polynomial, run);
    const SourceText source(input.parts.front().text, input.parts.front().name);
    const SurfaceText kind = kind_of(source.text());
    if (kind == SurfaceText::polynomial) return read_polynomial(source, constants, run);
    return implicit_surface(parse_parametrization(source, run),
                            kind == SurfaceText::control_net ? ParameterRange::unit : ParameterRange::chosen,
                            constants, session);
}

} // namespace eliminant::app
