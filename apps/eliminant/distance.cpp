/// \file
/// `eliminant distance`.
#include "command.hpp"
#include "results.hpp"
#include "surface_argument.hpp"

#include "eliminant/algebra/parse.hpp"
#include "eliminant/field/distance.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

namespace eliminant::app {

namespace {

enum class Levels { first, second, guaranteed, all };

std::vector<DistanceLevel> levels_of(Levels levels) {
    switch (levels) {
    case Levels::first:
        return {DistanceLevel::first_order};
    case Levels::second:
        return {DistanceLevel::second_order};
    case Levels::guaranteed:
        return {DistanceLevel::guaranteed};
    case Levels::all:
        break;
    }
    return {DistanceLevel::first_order, DistanceLevel::second_order, DistanceLevel::guaranteed};
}

/// 17 significant digits, which determine a double; `inf` for infinity.
std::string digits(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.17g", value);
    return text.data();
}

/// `x,y,z`; for a surface without z also `x,y`.
std::array<mpq_class, 3> read_point(const std::string& text, const Polynomial& f) {
    std::array<mpq_class, 3> point;
    std::size_t count = 0;
    std::string_view rest = text;
    for (bool more = true; more; ++count) {
        const std::size_t comma = rest.find(',');
        more = comma != std::string_view::npos;
        if (count < 3) {
            const auto begin = static_cast<std::size_t>(rest.data() - text.data());
            const std::size_t end = more ? begin + comma : text.size();
            point[count] = parse_rational(SourceText(text, "--at").section(begin, end));
        }
        if (more) rest.remove_prefix(comma + 1);
    }
    if (count == 3 || (count == 2 && f.degree(2) <= 0)) return point;
    throw UsageError("--at", "three coordinates, as '1,2/3,0.5'", std::to_string(count));
}

/// How doubles would evaluate the surface, and what was decided against.
void report_schemes(const SurfaceArgument& surface, Session& session) {
    if (!session.console().is_verbose()) return;
    const CompiledPolynomial f = surface.formula.empty()
                                     ? CompiledPolynomial(surface.polynomial, session.run())
                                     : CompiledPolynomial::of_formula(surface.formula, session.run());
    const char* prefix = "scheme: ";
    for (const EvaluationScheme& scheme : f.schemes()) {
        std::array<char, 120> numbers{};
        std::snprintf(numbers.data(), numbers.size(),
                      ": %.0f operations, uncertainty %.2g, expected cost %.0f", scheme.operations,
                      scheme.uncertainty, scheme.expected_cost());
        session.console().detail(std::string(prefix)
                                     .append(to_string(scheme.kind))
                                     .append(", ")
                                     .append(scheme.description)
                                     .append(numbers.data()));
        prefix = "not ";
    }
}

class DistanceCommand : public Command {
  public:
    std::string_view usage() const override { return "SURFACE --at 'x,y,z'"; }

    std::string_view description() const override {
        static const std::string text =
            "How far a point is from the surface f = 0: a line a level, and the sign of f there.\n"
            "  first_order    |f| / |grad f|, an estimate\n"
            "  second_order   the same with the Hessian (its spectral norm), a more cautious estimate\n"
            "  guaranteed     a lower bound, proven by Taylor's theorem with all derivatives: no point of "
            "the\n"
            "                 surface is nearer\n"
            "Coordinates are exact: 1/3 and 0.1 mean these numbers. Estimates are correctly rounded, the "
            "bound\n"
            "is rounded down. On the surface all are 0; 'inf' is an estimate where derivatives vanish or "
            "that is\n"
            "beyond 1.8e308, and a bound where there is no surface. --verbose tells how doubles evaluate f,\n"
            "and why so.\n"
            "\n" +
            std::string(surface_help) +
            "\n"
            "Examples:\n"
            "  eliminant distance 'x^2+y^2+z^2 = r^2' --set r=2 --at '1,2,1/3'\n"
            "  eliminant distance 'x = s' 'y = t' 'z = s*t' --at '0,0,1' --level guaranteed\n";
        return text;
    }

    void declare(OptionSet& options) override {
        options.value("at", 0, "POINT", "the point, as '1,2/3,0.5'",
                      [this](std::string_view text) { at_ = std::string(text); });
        options.choice<Levels>("level", "which of them (default all)",
                               {{"first", Levels::first},
                                {"second", Levels::second},
                                {"guaranteed", Levels::guaranteed},
                                {"all", Levels::all}},
                               levels_);
        constants_.declare(options);
    }

    ExitStatus run(std::span<const std::string> operands, Session& session) override {
        if (!at_) throw UsageError("expected a point, as --at '1,2/3,0.5', found none");
        require_text_or_json(session);
        const SurfaceArgument surface = read_surface(operands, constants_, session);
        const Polynomial& f = surface.polynomial;
        const std::array<mpq_class, 3> point = read_point(*at_, f);
        report_schemes(surface, session);
        if (f.is_zero()) session.console().warning("the polynomial is 0: every point is on its surface");

        std::string text;
        Json json;
        const std::vector<DistanceLevel> levels = levels_of(levels_);
        const std::vector<Distance> found = distances(f, point, levels, session.run());
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const std::string name(to_string(levels[i]));
            text += name + " " + digits(found[i].value) + "\n";
            if (std::isinf(found[i].value)) // JSON has no number for it
                json[name] = digits(found[i].value);
            else
                json[name] = found[i].value;
        }
        const int sign = found.front().sign;
        json["sign"] = sign;
        session.write_result(session.format() == ResultFormat::json
                                 ? to_text(json)
                                 : text + "sign " + std::to_string(sign) + "\n");
        return exit_done;
    }

  private:
    std::optional<std::string> at_;
    Levels levels_ = Levels::all;
    ConstantValues constants_;
};

} // namespace

std::unique_ptr<Command> make_distance() { return std::make_unique<DistanceCommand>(); }

} // namespace eliminant::app
