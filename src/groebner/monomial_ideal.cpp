#include "groebner/monomial_ideal.hpp"

#include "eliminant/base/error.hpp"

#include <algorithm>
#include <numeric>
#include <optional>

namespace eliminant::groebner {

using algebra::Integer;

std::vector<Exponents> leading_exponents(std::span<const algebra::Polynomial> polynomials) {
    std::vector<Exponents> result;
    result.reserve(polynomials.size());
    for (const algebra::Polynomial& f : polynomials) result.push_back(f.leading_monomial().exponents());
    return result;
}

bool divides(const Exponents& a, const Exponents& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] > b[i]) return false;
    }
    return true;
}

namespace {

std::uint64_t checked_sum(std::uint64_t a, std::uint64_t b) {
    std::uint64_t sum = 0;
    if (__builtin_add_overflow(a, b, &sum))
        throw OverflowError("a degree in a Hilbert series exceeds 2^64 - 1");
    return sum;
}

std::uint64_t degree_of(const Exponents& m) {
    std::uint64_t degree = 0;
    for (const std::uint64_t e : m) degree = checked_sum(degree, e);
    return degree;
}

/// Leaves the generators that no other one divides.
void make_minimal(std::vector<Exponents>& generators, base::Run& run) {
    std::vector<std::pair<std::uint64_t, Exponents>> by_degree;
    for (Exponents& m : generators) {
        const std::uint64_t degree = degree_of(m);
        by_degree.emplace_back(degree, std::move(m));
    }
    std::ranges::sort(by_degree);
    generators.clear();
    for (auto& [degree, m] : by_degree) {
        run.poll();
        const auto is_divisor = [&m = m](const Exponents& smaller) { return divides(smaller, m); };
        if (std::ranges::none_of(generators, is_divisor)) generators.push_back(std::move(m));
    }
}

/// f ± t^shift·g
SparseSeries combined(const SparseSeries& f, const SparseSeries& g, std::uint64_t shift, bool subtract) {
    SparseSeries result;
    result.reserve(f.size() + g.size());
    auto i = f.begin();
    for (const auto& [exponent, coefficient] : g) {
        const std::uint64_t e = checked_sum(exponent, shift);
        while (i != f.end() && i->first < e) result.push_back(*i++);
        Integer c = subtract ? -coefficient : coefficient;
        if (i != f.end() && i->first == e) c += (i++)->second;
        if (!c.is_zero()) result.emplace_back(e, std::move(c));
    }
    result.insert(result.end(), i, f.end());
    return result;
}

/// x_variable^exponent
struct Pivot {
    std::size_t variable;
    std::uint64_t exponent;
};

/// A power of the variable that occurs in most generators, if one occurs in two: the median of its exponents
/// where it is not alone. No generator divides it: a generator that is a power of the variable, being
/// minimal, has a larger exponent than all the others. So both ideals of the recursion are larger.
std::optional<Pivot> choose_pivot(const std::vector<Exponents>& generators) {
    const std::size_t n = generators.front().size();
    std::vector<std::size_t> occurrences(n, 0);
    for (const Exponents& m : generators) {
        for (std::size_t i = 0; i < n; ++i) occurrences[i] += m[i] != 0 ? 1 : 0;
    }
    const auto most = std::ranges::max_element(occurrences);
    if (most == occurrences.end() || *most < 2) return std::nullopt;
    const auto variable = static_cast<std::size_t>(most - occurrences.begin());
    std::vector<std::uint64_t> exponents;
    for (const Exponents& m : generators) {
        const auto is_other = [&](std::size_t i) { return i != variable && m[i] != 0; };
        bool alone = true;
        for (std::size_t i = 0; i < n && alone; ++i) alone = !is_other(i);
        if (m[variable] != 0 && !alone) exponents.push_back(m[variable]);
    }
    const auto median = exponents.begin() + static_cast<std::ptrdiff_t>(exponents.size() / 2);
    std::ranges::nth_element(exponents, median);
    return Pivot{variable, *median};
}

/// `generators` are minimal.
SparseSeries numerator_of(const std::vector<Exponents>& generators, base::Run& run) {
    run.poll();
    SparseSeries one{{0, Integer(1)}};
    if (generators.empty()) return one;
    const std::optional<Pivot> pivot = choose_pivot(generators);
    if (!pivot) { // no two generators have a variable in common: a complete intersection
        SparseSeries product = std::move(one);
        for (const Exponents& m : generators) product = combined(product, product, degree_of(m), true);
        return product;
    }
    const auto [variable, exponent] = *pivot;
    std::vector<Exponents> with_pivot;
    std::vector<Exponents> colon = generators;
    for (const Exponents& m : generators) {
        if (m[variable] < exponent) with_pivot.push_back(m);
    }
    with_pivot.emplace_back(generators.front().size(), 0)[variable] = exponent;
    for (Exponents& m : colon) m[variable] -= std::min(m[variable], exponent);
    make_minimal(colon, run);
    return combined(numerator_of(with_pivot, run), numerator_of(colon, run), exponent, false);
}

} // namespace

SparseSeries hilbert_numerator(std::vector<Exponents> generators, base::Run& run) {
    make_minimal(generators, run);
    return numerator_of(generators, run);
}

std::optional<std::pair<std::uint64_t, algebra::Integer>> lowest_difference(const SparseSeries& f,
                                                                            const SparseSeries& g) {
    const std::size_t common = std::min(f.size(), g.size());
    std::size_t i = 0;
    while (i < common && f[i] == g[i]) ++i;
    if (i == f.size() && i == g.size()) return std::nullopt;
    if (i == g.size() || (i < f.size() && f[i].first < g[i].first)) return f[i];
    if (i == f.size() || g[i].first < f[i].first) return std::pair(g[i].first, -g[i].second);
    return std::pair(f[i].first, f[i].second - g[i].second);
}

} // namespace eliminant::groebner
