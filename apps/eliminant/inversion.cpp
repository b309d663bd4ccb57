/// \file
/// `eliminant inversion`.
#include "command.hpp"
#include "parametrization_argument.hpp"
#include "results.hpp"

#include "eliminant/algebra/print.hpp"
#include "eliminant/implicit/inversion.hpp"

#include <string>

namespace eliminant::app {

namespace {

class InversionCommand : public Command {
  public:
    std::string_view usage() const override { return "[FILE | - | 'x = …' 'y = …' …]"; }

    std::string_view description() const override {
        return "The parameters as rational functions of the coordinates, and of constants if there are any: "
               "a\n"
               "line 't = (N)/(D)' a parameter, of least degree, proved by substitution. It holds at the "
               "points\n"
               "of the image at which D is not zero. There are such formulas if a general point is reached "
               "by one\n"
               "parameter value only; otherwise the exit status is 1.\n"
               "The parametrization is a file, '-', or statements (see 'eliminant implicitize --help'), "
               "without\n"
               "relations.\n"
               "\n"
               "Examples:\n"
               "  eliminant inversion 'x = t^2-1' 'y = t^3-t'\n"
               "  eliminant inversion 'x = s*t' 'y = s+t^2' 'z = s^2'\n";
    }

    void declare(OptionSet& /*options*/) override {}

    ExitStatus run(std::span<const std::string> operands, Session& session) override {
        require_text_or_json(session);
        const Inversion found = inversion(read_parametrization(operands, session.run()), session.run());
        const bool exists = found.parametrization_degree == 1U;
        if (!exists)
            session.console().error("no such formula: " +
                                    (found.parametrization_degree
                                         ? std::to_string(*found.parametrization_degree)
                                         : "infinitely many") +
                                    " parameter values reach a general point");
        if (session.format() == ResultFormat::json)
            session.write_result(json(found));
        else if (exists)
            session.write_result(text(found));
        return exists ? exit_done : exit_negative;
    }

  private:
    static std::string text(const Inversion& found) {
        std::string result;
        for (const auto& [name, value] : found.parameters)
            result.append(name).append(" = ").append(to_string(value)).append("\n");
        return result;
    }

    static std::string json(const Inversion& found) {
        Json result;
        result["variables"] = found.ring.names();
        result["parametrization_degree"] = nullptr;
        if (found.parametrization_degree) result["parametrization_degree"] = *found.parametrization_degree;
        result["parameters"] = Json::array();
        for (const auto& [name, value] : found.parameters) {
            Json parameter;
            parameter["name"] = name;
            parameter["numerator"] = to_string(value.numerator);
            parameter["denominator"] = to_string(value.denominator);
            result["parameters"].push_back(std::move(parameter));
        }
        return to_text(result);
    }
};

} // namespace

std::unique_ptr<Command> make_inversion() { return std::make_unique<InversionCommand>(); }

} // namespace eliminant::app
