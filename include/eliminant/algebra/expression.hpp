/// \file
/// Formulas as written: what is known of a text before one knows what its names and functions stand for.
#pragma once

#include "eliminant/algebra/integer.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/base/source_text.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace eliminant::algebra {

class ExpressionView;

/// The operations of a formula in the sequence in which they are done (postfix notation), each with its place
/// in the text. A flat array: neither its destruction nor its evaluation recurses.
///
///     2*cos(u)^2 - 1      number 2 · call cos, extent 1 [ name u ] · power 2 · multiply · number 1 ·
///     subtract
///
/// A call stands before the operations of its argument and says how many they are, so that an evaluator can
/// look at the argument instead of evaluating it. It refers to the text that it was read from, which outlives
/// it.
class Expression {
  public:
    enum class Kind : std::uint8_t { number, name, call, negate, add, subtract, multiply, divide, power };

    struct Node {
        Kind kind;
        std::size_t offset;   ///< into the source: of the operand's or operator's first character
        std::int64_t payload; ///< exponent of a power; index of a number or name
        std::size_t extent;   ///< of a call: number of nodes of its argument, which follow it
    };
    /// A literal, numerator/denominator in lowest terms, the denominator positive.
    struct Number {
        Integer numerator;
        Integer denominator;
    };

    explicit Expression(base::SourceText source) : source_(std::move(source)) {}

    const base::SourceText& source() const { return source_; }
    ExpressionView view() const;

    /// Deepest nesting of parentheses and function calls; deeper is a ParseError.
    static constexpr std::size_t max_nesting = 1000;

  private:
    friend class ExpressionView;
    friend class ExpressionParser;

    base::SourceText source_;
    std::vector<Node> nodes_;
    std::vector<Number> numbers_;
    std::vector<std::string> names_;
};

/// An expression or one of its arguments; valid while the Expression is neither changed nor destroyed.
class ExpressionView {
  public:
    ExpressionView(const Expression& owner, std::span<const Expression::Node> nodes)
        : owner_(&owner), nodes_(nodes) {}

    std::span<const Expression::Node> nodes() const { return nodes_; }
    const base::SourceText& source() const { return owner_->source_; }
    /// Of a node of kind number.
    const Expression::Number& number(const Expression::Node& node) const {
        return owner_->numbers_[static_cast<std::size_t>(node.payload)];
    }
    /// Of a node of kind name, or the function of a call.
    std::string_view name(const Expression::Node& node) const {
        return owner_->names_[static_cast<std::size_t>(node.payload)];
    }
    /// The argument of the call nodes()[index].
    ExpressionView argument(std::size_t index) const {
        return {*owner_, nodes_.subspan(index + 1, nodes_[index].extent)};
    }

  private:
    const Expression* owner_;
    std::span<const Expression::Node> nodes_;
};

inline ExpressionView Expression::view() const { return {*this, nodes_}; }

/// What a formula may contain besides arithmetic.
struct Vocabulary {
    /// Names that must be followed by one argument in parentheses, as `cos`. Any other name before a
    /// parenthesis is an error, not a product.
    std::vector<std::string> functions = {};
    /// Whether a name is known. Only asked to reject `2e3` where `e3` is a variable; without it 2e3 is 2000.
    std::function<bool(std::string_view)> is_variable = {};
};

/// Reads a whole text as one formula in the grammar of parse.hpp, with functions. Linear.
/// \throws ParseError where the text is not a formula, Stopped
Expression parse_expression(const base::SourceText& source, const Vocabulary& vocabulary, base::Run& run);

/// Evaluates a formula in any domain. Environment has a movable type Value and
///
///     Value number(const Expression::Number&, std::size_t offset);
///     Value name(std::string_view, std::size_t offset);
///     Value call(std::string_view function, ExpressionView argument, std::size_t offset);
///     void negate(Value&);
///     void add(Value& a, Value b, offset), subtract, multiply, divide;      // a becomes a + b, …
///     void power(Value& a, std::int64_t exponent, std::size_t offset);
///
/// add and subtract are called from left to right with the growing sum as a, so a Value that collects terms
/// makes long sums linear. Offsets are of the operator, for error messages.
template <class Environment>
typename Environment::Value evaluate(const ExpressionView& expression, Environment& environment) {
    using Kind = Expression::Kind;
    std::vector<typename Environment::Value> stack;
    const auto apply = [&](auto&& operation) {
        auto right = std::move(stack.back());
        stack.pop_back();
        operation(stack.back(), std::move(right));
    };
    const auto nodes = expression.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Expression::Node& node = nodes[i];
        const std::size_t at = node.offset;
        using Value = typename Environment::Value;
        switch (node.kind) {
        case Kind::number:
            stack.push_back(environment.number(expression.number(node), at));
            break;
        case Kind::name:
            stack.push_back(environment.name(expression.name(node), at));
            break;
        case Kind::call:
            stack.push_back(environment.call(expression.name(node), expression.argument(i), at));
            i += node.extent;
            break;
        case Kind::negate:
            environment.negate(stack.back());
            break;
        case Kind::add:
            apply([&](Value& a, Value b) { environment.add(a, std::move(b), at); });
            break;
        case Kind::subtract:
            apply([&](Value& a, Value b) { environment.subtract(a, std::move(b), at); });
            break;
        case Kind::multiply:
            apply([&](Value& a, Value b) { environment.multiply(a, std::move(b), at); });
            break;
        case Kind::divide:
            apply([&](Value& a, Value b) { environment.divide(a, std::move(b), at); });
            break;
        case Kind::power:
            environment.power(stack.back(), node.payload, at);
            break;
        }
    }
    return std::move(stack.back());
}

} // namespace eliminant::algebra

namespace eliminant {
using algebra::Expression;
using algebra::ExpressionView;
using algebra::parse_expression;
using algebra::Vocabulary;
} // namespace eliminant
