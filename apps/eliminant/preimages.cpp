/// \file
/// `eliminant preimages` and `eliminant contains-point`.
#include "command.hpp"
#include "constant_values.hpp"
#include "parametrization_argument.hpp"
#include "results.hpp"

#include "eliminant/algebra/parse.hpp"
#include "eliminant/algebra/print.hpp"
#include "eliminant/implicit/implicitize.hpp"
#include "eliminant/implicit/preimages.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace eliminant::app {

namespace {

constexpr std::string_view input_help =
    "The parametrization is a file, '-', or statements (see 'eliminant implicitize --help'); its symbolic\n"
    "constants get their values by --set. Numbers are exact: 1/3 and 0.1 mean what they say.\n";

constexpr std::string_view owner_of_constants = "the parametrization";

/// The numbers of `--at 'x,y,z'`.
class PointOption {
  public:
    void declare(OptionSet& options) {
        options.value("at", 0, "POINT", "the point, as '1,2/3,0.5'",
                      [this](std::string_view text) { text_ = std::string(text); });
    }

    std::vector<mpq_class> read(std::size_t coordinates) const {
        if (!text_) throw UsageError("expected a point, as --at '1,2/3,0.5', found none");
        const SourceText text(*text_, "--at");
        std::vector<mpq_class> point;
        for (std::size_t begin = 0; begin <= text.size();) {
            const std::size_t end = std::min(text.text().find(',', begin), text.size());
            point.push_back(parse_rational(text.section(begin, end)));
            begin = end + 1;
        }
        if (point.size() != coordinates)
            throw UsageError("--at",
                             "a number for each of the " + std::to_string(coordinates) + " coordinates",
                             std::to_string(point.size()));
        return point;
    }

  private:
    std::optional<std::string> text_;
};

class PreimagesCommand : public Command {
  public:
    std::string_view usage() const override { return "[FILE | - | 'x = …' 'y = …' …] --at 'x,y,…'"; }

    std::string_view description() const override {
        static const std::string text =
            "All parameter values that a parametrization takes to a point, also complex ones. A line a "
            "rational\n"
            "value, as 's = 1/2, t = 3'; the others as the zeros of polynomials, a line with all equations "
            "of a\n"
            "set of them, as 's^2-2 = 0, t-s = 0'; so too if they are infinitely many. Values at which a "
            "coordinate\n"
            "is not defined (base points) reach nothing: where such are among infinitely many zeros, the "
            "line ends\n"
            "with what is not zero, as 's-t = 0, t != 0'. Nothing, and exit status 1, if the point is not "
            "reached;\n"
            "if it is the limit of a curve for t to infinity, standard error says so.\n" +
            std::string(input_help) +
            "\n"
            "Examples:\n"
            "  eliminant preimages 'x = t^2-1' 'y = t^3-t' --at '0,0'\n"
            "  eliminant preimages 'x = s+t' 'y = s*t' 'z = s-t' --at '3,2,-1'\n"
            "  eliminant preimages 'constants r' 'x = r*cos(u)' 'y = r*sin(u)' --set r=5 --at '3,4'\n";
        return text;
    }

    void declare(OptionSet& options) override {
        point_.declare(options);
        constants_.declare(options);
    }

    ExitStatus run(std::span<const std::string> operands, Session& session) override {
        require_text_or_json(session);
        const Parametrization parametrization = constants_.put_into(
            read_parametrization(operands, session.run()), owner_of_constants, session.run());
        const Preimages found =
            preimages(parametrization, point_.read(parametrization.coordinates().size()), session.run());
        if (found.is_limit_at_infinity)
            session.console().warning("the point is the limit for " + found.ring.names().front() +
                                      " to infinity" + (found.dimension < 0 ? ", which is no value" : ""));
        session.write_result(session.format() == ResultFormat::json ? json(found, session.run())
                                                                    : text(found, session.run()));
        return found.dimension < 0 ? exit_negative : exit_done;
    }

  private:
    static std::string text(const Preimages& found, Run& run) {
        std::string result;
        for (const std::vector<mpq_class>& values : found.rational) {
            for (std::size_t i = 0; i < values.size(); ++i)
                result.append(i == 0 ? "" : ", ")
                    .append(found.ring.names()[i])
                    .append(" = ")
                    .append(values[i].get_str());
            result += '\n';
        }
        for (const Ideal& component : found.components) {
            std::string separator;
            for (const Polynomial& f : component.groebner_basis(MonomialOrder::lex(), run)) {
                result.append(separator).append(to_string(f)).append(" = 0");
                separator = ", ";
            }
            // All values reach the point only if it is the whole image.
            if (separator.empty()) result += "0 = 0";
            for (const Polynomial& f : found.excluded)
                result.append(", ").append(to_string(f)).append(" != 0");
            result += '\n';
        }
        return result;
    }

    static std::string json(const Preimages& found, Run& run) {
        Json result;
        result["parameters"] = found.ring.names();
        result["dimension"] = found.dimension;
        result["count"] = nullptr;
        if (found.count) result["count"] = found.count->get_ui();
        result["real_count"] = nullptr;
        if (found.real_count) result["real_count"] = found.real_count->get_ui();
        result["has_real"] = nullptr;
        if (found.has_real) result["has_real"] = *found.has_real;
        result["limit_at_infinity"] = found.is_limit_at_infinity;
        result["rational"] = Json::array();
        for (const std::vector<mpq_class>& values : found.rational) {
            Json numbers = Json::array();
            for (const mpq_class& value : values) numbers.push_back(value.get_str());
            result["rational"].push_back(std::move(numbers));
        }
        result["components"] = Json::array();
        for (const Ideal& component : found.components)
            result["components"].push_back(strings(component.groebner_basis(MonomialOrder::lex(), run), run));
        result["nonzero"] = strings(found.excluded, run);
        return to_text(result);
    }

    PointOption point_;
    ConstantValues constants_;
};

class ContainsPointCommand : public Command {
  public:
    std::string_view usage() const override { return "[FILE | - | 'x = …' 'y = …' …] --at 'x,y,…'"; }

    std::string_view description() const override {
        static const std::string text =
            "Whether a point lies on the closure of the image of a parametrization, where its implicit "
            "equations\n"
            "are zero. That is more than the image: with --image, whether parameters, perhaps complex ones, "
            "reach it;\n"
            "with --real, whether real parameters do. Whitney's umbrella x = s*t, y = s, z = t^2 has the "
            "points\n"
            "(0, 0, z) with z < 0 in its closure and its image, but reaches them with complex t only. Prints "
            "true or\n"
            "false; the exit status is 0 or 1.\n" +
            std::string(input_help) +
            "\n"
            "Examples:\n"
            "  eliminant contains-point 'x = (1-t^2)/(1+t^2)' 'y = 2t/(1+t^2)' --at '3/5,4/5'\n"
            "  eliminant contains-point 'x = (1-t^2)/(1+t^2)' 'y = 2t/(1+t^2)' --at '-1,0' --image\n"
            "  eliminant contains-point 'x = s*t' 'y = s' 'z = t^2' --at '0,0,-1' --real\n";
        return text;
    }

    void declare(OptionSet& options) override {
        point_.declare(options);
        options.flag("image", 0, "the image itself, not its closure", image_);
        options.flag("real", 0, "the image of real parameters", real_);
        constants_.declare(options);
    }

    ExitStatus run(std::span<const std::string> operands, Session& session) override {
        require_text_or_json(session);
        const Parametrization parametrization = constants_.put_into(
            read_parametrization(operands, session.run()), owner_of_constants, session.run());
        const std::vector<mpq_class> point = point_.read(parametrization.coordinates().size());
        const bool contains = this->contains(parametrization, point, session.run());
        const std::string word = contains ? "true" : "false";
        session.write_result(session.format() == ResultFormat::json ? "{\"contains\":" + word + "}\n"
                                                                    : word + "\n");
        return contains ? exit_done : exit_negative;
    }

  private:
    bool contains(const Parametrization& parametrization, std::span<const mpq_class> point, Run& run) const {
        if (!image_ && !real_) return closure_contains(implicitize(parametrization, {}, run), point, run);
        const Preimages found = preimages(parametrization, point, run);
        if (!real_) return found.dimension >= 0;
        if (!found.has_real)
            throw DomainError(
                "contains-point: infinitely many complex parameter values reach the point; whether "
                "real ones do could not be decided");
        return *found.has_real;
    }

    PointOption point_;
    ConstantValues constants_;
    bool image_ = false;
    bool real_ = false;
};

} // namespace

std::unique_ptr<Command> make_preimages() { return std::make_unique<PreimagesCommand>(); }
std::unique_ptr<Command> make_contains_point() { return std::make_unique<ContainsPointCommand>(); }

} // namespace eliminant::app
