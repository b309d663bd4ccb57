#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/expression.hpp"
#include "eliminant/algebra/parse.hpp"
#include "eliminant/implicit/batch.hpp"
#include "eliminant/implicit/parametrization.hpp"
#include "implicit/angles.hpp"
#include "implicit/text_lines.hpp"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace eliminant::implicit {

using algebra::Expression;
using algebra::ExpressionView;
using algebra::Polynomial;
using algebra::RationalFunction;
using base::SourceText;

namespace {

/// What a name stands for.
enum class Role { parameter, constant, coordinate };

const char* describe(Role role) {
    switch (role) {
    case Role::parameter:
        return "a parameter";
    case Role::constant:
        return "a constant";
    case Role::coordinate:
        return "a coordinate";
    }
    return "";
}

/// A coordinate or a relation as it was read; `right` is missing for a coordinate.
struct Formula {
    std::string name;
    Expression left;
    std::optional<Expression> right;
};

std::size_t offset_of_word(const SourceText& text, std::string_view word) {
    std::size_t offset = 0;
    while (offset < text.size()) {
        const std::size_t end = skip_word(text, offset);
        if (text.text().substr(offset, end - offset) == word) return offset;
        offset = std::max(end, offset + 1);
    }
    return 0;
}

/// First the statements are taken apart and all names get their roles, then the formulas get their values.
class Reader {
  public:
    explicit Reader(base::Run& run) : run_(run) {}

    void read(const SourceText& source) {
        for_each_line(source, run_, [this](const SourceText& line) { read_statement(line); });
    }

    Parametrization finish(const SourceText& last) {
        if (coordinates_.empty()) last.fail(last.size(), "a coordinate, as x = s*t");
        for (const Formula& formula : coordinates_) find_names(formula.left);
        for (const Formula& formula : relations_) {
            find_names(formula.left);
            find_names(*formula.right);
        }
        make_ring();
        return evaluate_all();
    }

  private:
    void read_statement(const SourceText& line) {
        const std::size_t begin = skip_blanks(line, 0);
        const std::size_t end = skip_word(line, begin);
        const std::string name(line.text().substr(begin, end - begin));
        const std::size_t next = skip_blanks(line, end);
        const bool equals = next < line.size() && line.text()[next] == '=';
        const SourceText rest = line.section(end, line.size());
        if (!equals && name == "parameters")
            read_names(rest, Role::parameter);
        else if (!equals && name == "constants")
            read_names(rest, Role::constant);
        else if (!equals && name == "relation")
            read_relation(rest);
        else
            read_coordinate(line, begin, name, next);
    }

    void read_names(const SourceText& list, Role role) {
        if (role == Role::parameter) parameters_declared_ = true;
        for (const std::string& name : algebra::parse_names(list))
            declare(name, role, list, offset_of_word(list, name));
    }

    void declare(const std::string& name, Role role, const SourceText& text, std::size_t offset) {
        if (name == "cos" || name == "sin") text.fail(offset, std::string("the name of ") + describe(role));
        const auto [entry, is_new] = roles_.try_emplace(name, role);
        if (!is_new)
            text.fail(offset, "a name that has no meaning yet",
                      "'" + name + "', which is already " + describe(entry->second));
        if (role == Role::parameter) parameters_.push_back(name);
        if (role == Role::constant) constants_.push_back(name);
    }

    void read_coordinate(const SourceText& line, std::size_t begin, const std::string& name,
                         std::size_t next) {
        if (!algebra::is_identifier(name)) line.fail(begin, "the name of a coordinate");
        if (next == line.size() || line.text()[next] != '=') line.fail(next, "'='");
        declare(name, Role::coordinate, line, begin);
        coordinates_.push_back({name, parse(line.section(next + 1, line.size())), std::nullopt});
    }

    void read_relation(const SourceText& rest) {
        const std::size_t equals = rest.text().find('=');
        if (equals == std::string_view::npos) rest.fail(rest.size(), "'=', as in s^2 + t^2 = 0");
        relations_.push_back(
            {"", parse(rest.section(0, equals)), parse(rest.section(equals + 1, rest.size()))});
    }

    Expression parse(const SourceText& text) {
        // Names are known only at the end, so whether 2e3 is a number or 2·e3 cannot be asked here.
        return algebra::parse_expression(text, {{"cos", "sin"}, {}}, run_);
    }

    bool is_parameter(std::string_view name) const {
        const auto found = roles_.find(name);
        return found != roles_.end() && found->second == Role::parameter;
    }

    /// Gives names in a formula their roles, and notes which parameters occur where.
    void find_names(const Expression& expression) {
        const ExpressionView view = expression.view();
        for (std::size_t i = 0; i < view.nodes().size(); ++i) {
            const Expression::Node& node = view.nodes()[i];
            if (node.kind == Expression::Kind::call) {
                const ExpressionView argument = view.argument(i);
                for (const Expression::Node& inner : argument.nodes())
                    if (inner.kind == Expression::Kind::name)
                        require_value(argument.name(inner), view, inner.offset);
                const Angle angle = read_angle(
                    argument, node.offset, [this](std::string_view name) { return is_parameter(name); },
                    run_);
                std::int64_t& unit = angle_units_[angle.parameter];
                unit = std::gcd(unit, angle.multiple);
                i += node.extent;
            } else if (node.kind == Expression::Kind::name) {
                require_value(view.name(node), view, node.offset);
                outside_.emplace(view.name(node));
            }
        }
    }

    /// Whether a name may stand in a formula; without a list of parameters new names become some.
    void require_value(std::string_view name, const ExpressionView& view, std::size_t offset) {
        const auto role = roles_.find(name);
        if (role == roles_.end() && !parameters_declared_) {
            declare(std::string(name), Role::parameter, view.source(), offset);
            return;
        }
        const std::string expected = "a parameter or a constant";
        if (role == roles_.end())
            view.source().fail(offset, expected, "'" + std::string(name) + "', which is neither");
        if (role->second == Role::coordinate)
            view.source().fail(offset, expected, "'" + std::string(name) + "', which is a coordinate");
    }

    std::string fresh_name(std::string name) {
        while (!roles_.try_emplace(name, Role::parameter).second) name += '_';
        return name;
    }

    /// Parameters in sequence, one that is an angle as two variables, then the constants.
    void make_ring() {
        std::vector<std::string> names;
        for (const std::string& name : parameters_) {
            const bool is_angle = angle_units_.contains(name);
            if (!is_angle || outside_.contains(name)) names.push_back(name);
            if (!is_angle) continue;
            rotations_[name] = {names.size(), names.size() + 1};
            const std::int64_t unit = angle_units_.at(name);
            const std::string angle = (unit == 1 ? "" : std::to_string(unit)) + name;
            names.push_back(fresh_name("cos_" + angle)); // cos_2u for cos(2u)
            names.push_back(fresh_name("sin_" + angle));
            if (outside_.contains(name))
                warnings_.push_back(
                    "the parameter " + name +
                    " occurs both inside and outside of cos and sin; there it is treated as an "
                    "independent parameter");
        }
        for (const std::string& name : constants_) {
            constant_indices_.push_back(names.size());
            names.push_back(name);
        }
        ring_.emplace(algebra::CoefficientField::rationals(), std::move(names));
    }

    RationalFunction value_of(const Expression& expression) {
        const algebra::Meaning meaning{
            [this](std::string_view name, std::size_t) {
                return RationalFunction(Polynomial::variable(*ring_, name));
            },
            [this](std::string_view function, ExpressionView argument, std::size_t offset) {
                return RationalFunction(value_of_call(function, argument, offset));
            }};
        return evaluate(expression.view(), *ring_, meaning, run_);
    }

    /// All multiples of an angle are expanded in the greatest common one, so that cos(4u), sin(6u) are in 2u.
    Polynomial value_of_call(std::string_view function, ExpressionView argument, std::size_t offset) {
        const Angle angle = read_angle(
            argument, offset, [this](std::string_view name) { return is_parameter(name); }, run_);
        const std::int64_t multiple = angle.multiple / angle_units_.at(angle.parameter);
        if (multiple > max_multiple || multiple < -max_multiple)
            argument.source().fail(offset,
                                   "at most " + std::to_string(max_multiple) +
                                       " times the greatest common divisor of the angles",
                                   std::to_string(multiple) + " times");
        const std::int64_t size = std::abs(multiple);
        const auto key = std::pair(angle.parameter, size);
        auto known = expansions_.find(key);
        if (known == expansions_.end()) {
            const Rotation& rotation = rotations_.at(angle.parameter);
            known = expansions_
                        .emplace(key, multiple_angle(Polynomial::variable(*ring_, rotation.cosine),
                                                     Polynomial::variable(*ring_, rotation.sine), size, run_))
                        .first;
        }
        if (function == "cos") return known->second.cosine;
        return multiple < 0 ? -known->second.sine : known->second.sine;
    }

    Parametrization evaluate_all() {
        std::vector<Rotation> rotations;
        std::vector<Polynomial> circles;
        for (const auto& [name, rotation] : rotations_) {
            rotations.push_back(rotation);
            const Polynomial c = Polynomial::variable(*ring_, rotation.cosine);
            const Polynomial s = Polynomial::variable(*ring_, rotation.sine);
            circles.push_back(c * c + s * s - Polynomial::constant(*ring_, 1));
        }
        std::vector<Coordinate> coordinates;
        for (const Formula& formula : coordinates_) {
            coordinates.push_back({formula.name, value_of(formula.left)});
            // As cos² + sin² − 1, a denominator may be zero without looking it.
            if (normal_form(coordinates.back().value.denominator, circles, run_).is_zero()) {
                const SourceText& text = formula.left.source();
                text.fail(skip_blanks(text, 0), "a denominator that is not zero", "one that is");
            }
        }
        std::vector<Polynomial> relations;
        for (const Formula& formula : relations_)
            relations.push_back(polynomial_of(formula.left) - polynomial_of(*formula.right));
        return {*ring_,    constant_indices_, std::move(coordinates), std::move(rotations),
                relations, warnings_};
    }

    Polynomial polynomial_of(const Expression& expression) {
        const RationalFunction value = value_of(expression);
        if (!value.is_polynomial()) {
            const SourceText& text = expression.source();
            text.fail(skip_blanks(text, 0), "a polynomial", "a quotient");
        }
        return value.numerator;
    }

    base::Run& run_;
    std::map<std::string, Role, std::less<>> roles_;
    std::vector<std::string> parameters_;
    std::vector<std::string> constants_;
    bool parameters_declared_ = false;
    std::vector<Formula> coordinates_;
    std::vector<Formula> relations_;
    std::set<std::string, std::less<>> outside_;      ///< names that occur outside of functions
    std::map<std::string, std::int64_t> angle_units_; ///< per angle, the gcd of its multiples
    std::optional<algebra::Ring> ring_;
    std::map<std::string, Rotation> rotations_;
    std::vector<std::size_t> constant_indices_;
    std::map<std::pair<std::string, std::int64_t>, CosineAndSine> expansions_;
    std::vector<std::string> warnings_;
};

} // namespace

Parametrization parse_parametrization(std::span<const SourceText> statements, base::Run& run) {
    Reader reader(run);
    for (const SourceText& statement : statements) reader.read(statement);
    return reader.finish(statements.empty() ? SourceText("") : statements.back());
}

Parametrization parse_parametrization(const SourceText& source, base::Run& run) {
    const std::vector<ShapeSource> sources = shape_sources(source, run);
    if (sources.size() > 1) source.fail(0, "a single shape", std::to_string(sources.size()) + " shapes");
    std::vector<Shape> shapes = parse_shapes(sources.front(), run);
    if (shapes.size() > 1)
        source.fail(0, "a single shape", "a spline of " + std::to_string(shapes.size()) + " pieces");
    return std::move(shapes.front().parametrization);
}

} // namespace eliminant::implicit
