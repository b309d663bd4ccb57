#include "product_box.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace eliminant::algebra {

namespace {

/// The exponents of a factor, one row a term, and what those of each variable have in common.
struct ExponentTable {
    std::size_t variables;
    std::vector<std::uint64_t> rows;
    std::vector<std::uint64_t> low;
    std::vector<std::uint64_t> high;
    std::vector<std::uint64_t> stride; ///< gcd of the differences; 0 if there are none
    std::uint64_t degree = 0;          ///< of the first term
    bool homogeneous = true;

    ExponentTable(const MonomialLayout& layout, std::span<const MonomialLayout::Word> monomials)
        : variables(layout.variable_count()), rows(monomials.size() / layout.words() * variables),
          low(variables, std::numeric_limits<std::uint64_t>::max()), high(variables, 0),
          stride(variables, 0) {
        for (std::size_t begin = 0, m = 0; begin < rows.size(); begin += variables, m += layout.words()) {
            const auto row = std::span(rows).subspan(begin, variables);
            layout.decode(monomials.data() + m, row);
            for (std::size_t v = 0; v < variables; ++v) {
                low[v] = std::min(low[v], row[v]);
                high[v] = std::max(high[v], row[v]);
                const std::uint64_t gap = row[v] > rows[v] ? row[v] - rows[v] : rows[v] - row[v];
                if (gap != 0 && stride[v] != 1) stride[v] = std::gcd(stride[v], gap);
            }
            const std::uint64_t sum = std::accumulate(row.begin(), row.end(), std::uint64_t{0});
            if (begin == 0) degree = sum;
            if (sum != degree) homogeneous = false;
        }
    }
};

/// A variable whose exponents are low + stride·coordinate.
struct Axis {
    std::size_t variable;
    std::uint64_t stride;
    std::uint64_t length; ///< of the product
};

std::vector<Axis> axes_of(const ExponentTable& a, const ExponentTable& b) {
    std::vector<Axis> axes;
    for (std::size_t v = 0; v < a.variables; ++v) {
        const std::uint64_t stride = std::gcd(a.stride[v], b.stride[v]);
        if (stride != 0) axes.push_back({v, stride, (a.high[v] - a.low[v] + b.high[v] - b.low[v]) / stride});
    }
    return axes;
}

/// nullopt if a sum of coordinates is above max_degree.
std::optional<ProductBox::Factor> points_of(const ExponentTable& table, std::span<const Axis> axes,
                                            std::uint32_t max_degree) {
    ProductBox::Factor factor;
    factor.bounds.assign(axes.size(), 0);
    factor.points.reserve(table.rows.size() / table.variables * axes.size());
    for (std::size_t row = 0; row < table.rows.size(); row += table.variables) {
        std::uint64_t sum = 0;
        for (std::size_t i = 0; i < axes.size(); ++i) {
            const std::size_t v = axes[i].variable;
            const auto x = static_cast<std::uint32_t>((table.rows[row + v] - table.low[v]) / axes[i].stride);
            factor.points.push_back(x);
            factor.bounds[i] = std::max(factor.bounds[i], x);
            sum += x;
        }
        if (sum > max_degree) return std::nullopt;
        factor.degree = std::max(factor.degree, static_cast<std::uint32_t>(sum));
    }
    return factor;
}

} // namespace

std::optional<ProductBox> ProductBox::of(const MonomialLayout& target, std::uint32_t max_degree,
                                         const MonomialLayout& layout_a, std::span<const Word> a,
                                         const MonomialLayout& layout_b, std::span<const Word> b) {
    const ExponentTable table_a(layout_a, a);
    const ExponentTable table_b(layout_b, b);
    std::vector<Axis> axes = axes_of(table_a, table_b);
    std::vector<std::uint64_t> lowest(table_a.variables);
    for (std::size_t v = 0; v < lowest.size(); ++v) lowest[v] = table_a.low[v] + table_b.low[v];

    const std::size_t words = target.words();
    std::vector<Word> dropped(words, 0); // one unit of the variable that the others determine
    if (table_a.homogeneous && table_b.homogeneous && axes.size() > 1) {
        const auto longest = std::ranges::max_element(axes, {}, &Axis::length);
        const std::size_t v = longest->variable;
        lowest[v] = 0;
        lowest[v] =
            table_a.degree + table_b.degree - std::accumulate(lowest.begin(), lowest.end(), std::uint64_t{0});
        std::vector<std::uint64_t> unit(lowest.size(), 0);
        unit[v] = 1;
        if (!target.encode(unit, dropped.data())) return std::nullopt;
        axes.erase(longest);
    }
    if (axes.empty()) return std::nullopt;

    ProductBox box(target);
    if (!target.encode(lowest, box.origin_.data())) return std::nullopt;
    box.steps_.resize(axes.size() * words);
    for (std::size_t i = 0; i < axes.size(); ++i) {
        if (axes[i].length > max_degree) return std::nullopt;
        box.bounds_.push_back(static_cast<std::uint32_t>(axes[i].length));
        std::vector<std::uint64_t> unit(lowest.size(), 0);
        unit[axes[i].variable] = axes[i].stride;
        Word* const step = box.steps_.data() + i * words;
        if (!target.encode(unit, step)) return std::nullopt;
        for (std::size_t w = 0; w < words; ++w) step[w] -= axes[i].stride * dropped[w];
    }
    auto points_a = points_of(table_a, axes, max_degree);
    auto points_b = points_of(table_b, axes, max_degree);
    if (!points_a || !points_b || points_a->degree + points_b->degree > max_degree) return std::nullopt;
    box.a_ = *std::move(points_a);
    box.b_ = *std::move(points_b);
    return box;
}

} // namespace eliminant::algebra
