// Every text is a polynomial, a rational function, an order, a field, a list of names, or an error; what is
// read is printed and read back; the fast reader of monomials and the grammar agree.
#include "eliminant/algebra/parse.hpp"
#include "eliminant/algebra/print.hpp"
#include "eliminant/base/error.hpp"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <optional>

using namespace eliminant;

namespace {

void require(bool holds, const char* property, std::string_view text) {
    if (holds) return;
    std::cerr << property << " fails for: " << text << '\n';
    std::abort();
}

Run limited_run() {
    return Run(RunOptions{.time_limit_seconds = 1, .memory_limit_bytes = std::uint64_t{1} << 30});
}

/// The value, nullopt for a text that is refused. A text that only takes too long is no counterexample.
template <class Read>
auto attempt(Read&& read, bool& stopped) -> std::optional<decltype(read())> {
    try {
        return read();
    } catch (const Stopped&) {
        stopped = true;
    } catch (const ParseError& error) {
        require(error.where().line >= 1 && error.where().column >= 1 && !error.expected().empty(), "a place",
                "");
    }
    return std::nullopt;
}

void check_polynomial(const Ring& ring, const std::string& text) {
    bool stopped = false;
    Run run = limited_run();
    const auto f = attempt([&] { return parse_polynomial(ring, text, run); }, stopped);
    if (stopped) return;
    if (f) require(parse_polynomial(ring, to_string(*f)) == *f, "round trip", text);
    // Between parentheses the grammar reads every term itself.
    std::string enclosed = "(";
    enclosed += text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
    enclosed += "\n)";
    const auto g = attempt([&] { return parse_polynomial(ring, enclosed, run); }, stopped);
    if (stopped) return;
    require(f.has_value() == g.has_value() || text.find(')') != std::string::npos, "agreement on errors",
            text);
    if (f && g) require(*f == *g, "agreement of the readers", text);

    const auto q = attempt([&] { return parse_rational_function(ring, text, run); }, stopped);
    if (stopped) return;
    if (f) require(q && q->is_polynomial() && q->numerator == *f, "polynomials as rational functions", text);
    const auto again =
        q ? attempt([&] { return parse_rational_function(ring, to_string(*q), run); }, stopped) : q;
    if (stopped || !q) return;
    require(again && again->numerator == q->numerator && again->denominator == q->denominator,
            "round trip of quotients", text);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size > 4096) return 0;
    static const std::vector<std::string> names = {"x", "y", "alpha_1", "e3"};
    static const Ring rings[] = {Ring(CoefficientField::rationals(), names),
                                 Ring(CoefficientField::prime(7), names,
                                      MonomialOrder::weighted({1, 2, 3, 4}, MonomialOrder::TieBreak::lex)),
                                 Ring(CoefficientField::prime(2147483647), names, MonomialOrder::lex())};
    const std::string text(reinterpret_cast<const char*>(data), size);
    for (const Ring& ring : rings) check_polynomial(ring, text);

    bool stopped = false;
    const auto order = attempt([&] { return parse_order(text, names); }, stopped);
    if (order) require(parse_order(order->to_string(names), names) == *order, "round trip of orders", text);
    const auto field = attempt([&] { return parse_field(text); }, stopped);
    if (field) require(parse_field(field->to_string()) == *field, "round trip of fields", text);
    attempt([&] { return parse_names(text); }, stopped);
    attempt([&] { return names_in(text); }, stopped);
    attempt([&] { return parse_rational(text); }, stopped);
    return 0;
}
