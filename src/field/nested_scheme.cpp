#include "field/nested_scheme.hpp"

#include "eliminant/base/error.hpp"

#include <algorithm>
#include <numeric>

namespace eliminant::field {

namespace {

constexpr std::size_t max_size = std::size_t{1} << 24;

/// What the levels u, v, w stand for: the gcd of all exponents, 1 for a coordinate that does not occur.
std::uint32_t common_power(std::span<const Exponents> terms, std::size_t coordinate) {
    std::uint32_t divisor = 0;
    for (const Exponents& exponents : terms) divisor = std::gcd(divisor, exponents[coordinate]);
    return std::max(divisor, 1U);
}

void check_size(std::size_t size) {
    if (size > max_size)
        throw base::OverflowError("compiling a polynomial: expected at most 2^24 coefficients in its scheme "
                                  "of evaluation, found more");
}

/// The terms as exponents of u, v, w.
std::vector<Exponents> in_levels(std::span<const Exponents> terms, const NestedScheme& scheme) {
    std::vector<Exponents> result(terms.begin(), terms.end());
    for (std::size_t t = 0; t < terms.size(); ++t)
        for (std::size_t level = 0; level < 3; ++level)
            result[t][level] = terms[t][scheme.coordinates[level]] / scheme.powers[level];
    return result;
}

/// Lays out rows and lines so that each is as short as its terms allow.
void lay_out(NestedScheme& scheme, std::span<const Exponents> terms) {
    const auto degree = [&](std::size_t level) {
        std::uint32_t most = 0;
        for (const Exponents& e : terms) most = std::max(most, e[level]);
        return most;
    };
    const std::uint32_t top = degree(0);
    check_size(top);
    scheme.rows.assign(terms.empty() ? 0 : top + 1, {});
    std::vector<bool> is_constant(scheme.rows.size(), true);
    for (const Exponents& e : terms) {
        std::uint32_t& count = scheme.rows[top - e[0]].count;
        count = std::max(count, e[1] + 1);
        if (e[1] > 0 || e[2] > 0) is_constant[top - e[0]] = false;
    }
    while (scheme.constants < scheme.rows.size() && is_constant[scheme.constants])
        scheme.rows[scheme.constants++].count = 1;
    std::size_t lines = 0;
    for (NestedScheme::Row& row : scheme.rows) {
        row.first = static_cast<std::uint32_t>(lines);
        lines += row.count;
        check_size(lines);
    }
    scheme.lines.assign(lines, {});
    const auto line_of = [&](const Exponents& e) -> NestedScheme::Line& {
        const NestedScheme::Row& row = scheme.rows[top - e[0]];
        return scheme.lines[row.first + row.count - 1 - e[1]];
    };
    for (const Exponents& e : terms) {
        std::uint32_t& count = line_of(e).count;
        count = std::max(count, e[2] + 1);
    }
    for (NestedScheme::Row& row : scheme.rows) {
        const std::span in_row(scheme.lines.data() + row.first, row.count);
        while (row.constants < row.count && in_row[row.constants].count <= 1)
            in_row[row.constants++].count = 1;
    }
    for (NestedScheme::Line& line : scheme.lines) {
        line.first = static_cast<std::uint32_t>(scheme.size);
        scheme.size += line.count;
        check_size(scheme.size);
    }
    for (const Exponents& e : terms) {
        const NestedScheme::Line& line = line_of(e);
        scheme.slots.push_back(line.first + line.count - 1 - e[2]);
    }
}

/// Notes what the partial sums depend on: derivatives that are still zero are not carried along.
void note_dependence(NestedScheme& scheme) {
    bool v = false;
    bool w = false;
    for (NestedScheme::Row& row : scheme.rows) {
        row.v_before = v;
        row.w_before = w;
        v = v || row.count > 1;
        w = w || row.constants < row.count;
    }
}

/// JetComponent of ∂²/∂a∂b, a and b being 0, 1, 2 for x, y, z.
std::uint32_t hessian_component(std::uint32_t a, std::uint32_t b) {
    const std::uint32_t low = std::min(a, b);
    return at_xx + low * (5 - low) / 2 + std::max(a, b);
}

} // namespace

SchemeView NestedScheme::view() const {
    SchemeView result{rows.data(), rows.data() + rows.size(), lines.data(), constants, {}, {}, {}};
    std::uint32_t component = at_xx;
    result.components[0] = at_value;
    for (std::size_t level = 0; level < 3; ++level) {
        result.coordinates[level] = coordinates[level];
        result.powers[level] = powers[level];
        result.components[1 + level] = at_x + coordinates[level];
        for (std::size_t other = level; other < 3; ++other)
            result.components[component++] = hessian_component(coordinates[level], coordinates[other]);
    }
    return result;
}

std::size_t NestedScheme::cost() const {
    std::size_t steps = 3 * std::size_t{constants};
    for (std::size_t r = constants; r < rows.size(); ++r) {
        const Row& row = rows[r];
        steps += 8U + (row.v_before ? 1U : 0U) + (row.w_before ? 1U : 0U) + 3U * row.constants;
        for (std::uint32_t i = row.constants; i < row.count; ++i)
            steps += 6U + 3U * lines[row.first + i].count;
    }
    for (const std::uint32_t power : powers)
        if (power > 1) steps += 5U + power;
    return steps;
}

std::size_t NestedScheme::roundings() const {
    Exponents longest = {};
    longest[0] = static_cast<std::uint32_t>(rows.size());
    for (const Row& row : rows) longest[1] = std::max(longest[1], row.count);
    for (const Line& line : lines) longest[2] = std::max(longest[2], line.count);
    std::size_t sum = 16; // the coefficient, the products of the chain rule
    for (std::size_t level = 0; level < 3; ++level)
        sum += longest[level] * (2U + (powers[level] - 1U)) + 2U * powers[level];
    return sum;
}

NestedScheme make_nested_scheme(std::span<const Exponents> terms) {
    NestedScheme best;
    std::array<std::uint8_t, 3> sequence = {0, 1, 2};
    bool first = true;
    do {
        NestedScheme scheme;
        scheme.coordinates = sequence;
        for (std::size_t level = 0; level < 3; ++level)
            scheme.powers[level] = common_power(terms, sequence[level]);
        lay_out(scheme, in_levels(terms, scheme));
        note_dependence(scheme);
        if (first || scheme.cost() < best.cost()) best = std::move(scheme);
        first = false;
    } while (std::ranges::next_permutation(sequence).found);
    return best;
}

} // namespace eliminant::field
