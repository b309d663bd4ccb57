#include "implicit/verify_values.hpp"

#include <algorithm>
#include <numeric>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::PrimeField;

namespace {

std::vector<std::size_t> by_ascending_degree(const Polynomial& f) {
    std::vector<std::size_t> variables(f.ring().variable_count());
    std::iota(variables.begin(), variables.end(), std::size_t{0});
    std::ranges::stable_sort(variables, {}, [&](std::size_t i) { return f.degree(i); });
    return variables;
}

/// Terms in decreasing lexicographic order, the variables being compared in the given sequence.
std::vector<std::size_t> lexicographic(const Polynomial& f, const std::vector<std::size_t>& variables) {
    std::vector<std::size_t> terms(f.size());
    std::iota(terms.begin(), terms.end(), std::size_t{0});
    std::ranges::sort(terms, [&](std::size_t a, std::size_t b) {
        for (const std::size_t i : variables)
            if (f.exponent(a, i) != f.exponent(b, i)) return f.exponent(a, i) > f.exponent(b, i);
        return false;
    });
    return terms;
}

/// The first level at which exponents differ.
std::size_t difference(const Polynomial& f, const std::vector<std::size_t>& variables, std::size_t a,
                       std::size_t b) {
    std::size_t level = 0;
    while (f.exponent(a, variables[level]) == f.exponent(b, variables[level])) ++level;
    return level;
}

} // namespace

ValuesModulo::ValuesModulo(const Polynomial& f, const PrimeField& field)
    : field_(field), order_(by_ascending_degree(f)), levels_(order_.size() + 1), degrees_(order_.size(), 0) {
    const std::size_t n = degrees_.size();
    const std::vector<std::size_t> terms = lexicographic(f, order_);
    levels_[0].exponents = {0};
    for (std::size_t i = 0; i < terms.size(); ++i) {
        // A term opens new nodes from the level on where it differs from the one before.
        const std::size_t common = i == 0 ? 0 : difference(f, order_, terms[i - 1], terms[i]);
        for (std::size_t level = common; level < n; ++level) {
            const auto exponent = static_cast<std::uint32_t>(f.exponent(terms[i], order_[level]));
            degrees_[level] = std::max(degrees_[level], exponent);
            levels_[level + 1].exponents.push_back(exponent);
            levels_[level].first_child.resize(levels_[level].exponents.size(),
                                              levels_[level + 1].exponents.size() - 1);
        }
        coefficients_.push_back(
            field.from_fraction(f.integer_terms().coefficients[terms[i]], f.denominator()));
    }
    for (std::size_t level = 0; level < n; ++level)
        levels_[level].first_child.resize(levels_[level].exponents.size() + 1,
                                          levels_[level + 1].exponents.size());
}

ValuesModulo::Lanes ValuesModulo::operator()(std::span<const Lanes> points) {
    values_.resize(coefficients_.size());
    for (std::size_t i = 0; i < coefficients_.size(); ++i) values_[i].fill(coefficients_[i]);
    for (std::size_t level = degrees_.size(); level-- > 0;) {
        powers_.resize(degrees_[level] + std::size_t{1});
        powers_[0].fill(1);
        for (std::size_t e = 1; e < powers_.size(); ++e)
            for (std::size_t lane = 0; lane < lanes; ++lane)
                powers_[e][lane] = field_.multiply(powers_[e - 1][lane], points[order_[level]][lane]);
        sum_children(levels_[level], levels_[level + 1], powers_, values_, sums_);
        std::swap(values_, sums_);
    }
    return values_.empty() ? Lanes{} : values_.front();
}

void ValuesModulo::sum_children(const Level& parents, const Level& children, const std::vector<Lanes>& powers,
                                const std::vector<Lanes>& values, std::vector<Lanes>& sums) const {
    constexpr std::size_t summands = 15; // products below 2^60, and a residue, in 64 bits
    sums.resize(parents.exponents.size());
    for (std::size_t node = 0; node < sums.size(); ++node) {
        std::array<std::uint64_t, lanes> sum = {};
        const std::size_t last = parents.first_child[node + 1];
        for (std::size_t child = parents.first_child[node]; child < last;) {
            const std::size_t stop = std::min(last, child + summands);
            sum_(sum.data(), powers.front().data(), &children.exponents[child], values[child].data(),
                 stop - child);
            child = stop;
            for (std::uint64_t& s : sum) s = field_.reduce(s);
        }
        for (std::size_t lane = 0; lane < lanes; ++lane) sums[node][lane] = static_cast<Element>(sum[lane]);
    }
}

} // namespace eliminant::implicit
