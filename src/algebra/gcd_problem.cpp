#include "gcd_problem.hpp"

#include "term_maps.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace eliminant::algebra {

namespace {

double degree(const Polynomial& f, std::size_t variable) { return static_cast<double>(f.degree(variable)); }

double volume(const Polynomial& f, const std::vector<std::size_t>& variables) {
    double product = 1;
    for (const std::size_t v : variables) product *= degree(f, v) + 1;
    return product;
}

/// Number of terms with the highest power of a variable.
std::size_t leading_length(const Polynomial& f, std::size_t variable) {
    const auto highest = static_cast<std::uint64_t>(f.degree(variable));
    std::size_t length = 0;
    for (std::size_t i = 0; i < f.size(); ++i) length += f.exponent(i, variable) == highest ? 1 : 0;
    return length;
}

/// Of one univariate gcd with what surrounds it.
double univariate_cost(const GcdProblem& problem) {
    const double degrees = degree(problem.f, problem.variables[0]) + degree(problem.g, problem.variables[0]);
    return 500 + degrees * degrees / 3;
}

GcdProblem resorted(GcdProblem problem, const std::vector<std::size_t>& sequence) {
    const auto variables = problem.variables;
    const auto bounds = problem.bounds;
    for (std::size_t k = 0; k < sequence.size(); ++k) {
        problem.variables[k] = variables[sequence[k]];
        problem.bounds[k] = bounds[sequence[k]];
    }
    return problem;
}

} // namespace

TermRows term_rows(const Polynomial& f, std::span<const std::size_t> variables, base::Run& run) {
    const std::size_t n = variables.size();
    std::vector<std::uint64_t> exponents(f.size() * n);
    for (std::size_t i = 0; i < f.size(); ++i) {
        for (std::size_t k = 0; k < n; ++k) exponents[i * n + k] = f.exponent(i, variables[k]);
    }
    const auto row = [&](std::size_t i) {
        return std::span<const std::uint64_t>(exponents).subspan(i * n, n);
    };
    std::vector<std::size_t> sequence(f.size());
    std::iota(sequence.begin(), sequence.end(), std::size_t{0});
    run.poll();
    std::ranges::sort(sequence, [&](std::size_t i, std::size_t j) {
        return std::ranges::lexicographical_compare(row(j), row(i));
    });
    run.poll();
    TermRows result{{n, {}, 0}, {}, {}};
    result.exponents.entries.reserve(exponents.size());
    for (const std::size_t i : sequence) {
        result.exponents.push_back(row(i));
        if (f.ring().field().is_rationals())
            result.integers.push_back(f.integer_terms().coefficients[i]);
        else
            result.residues.push_back(f.residue_terms().coefficients[i]);
    }
    return result;
}

// Costs are in nanoseconds on a machine of 2023; only their ratios matter.

double dense_cost(const GcdProblem& problem) {
    // Going down the levels, `nodes` pairs of boxes of `box` entries are evaluated each: a dot product a
    // column.
    constexpr double per_node = 500;
    constexpr double per_column = 5;
    double box = volume(problem.f, problem.variables) + volume(problem.g, problem.variables);
    double nodes = 1;
    double cost = 0;
    for (std::size_t k = problem.variables.size(); k-- > 1;) {
        const std::size_t v = problem.variables[k];
        const double extent = std::max(degree(problem.f, v), degree(problem.g, v)) + 1;
        nodes *= static_cast<double>(problem.bounds[k]) + 1;
        cost += nodes * (per_node + box + per_column * box / extent);
        box /= extent;
    }
    return cost + nodes * univariate_cost(problem);
}

double sparse_cost(const GcdProblem& problem) {
    // The longest coefficient of the gcd is unknown. A product of two polynomials has about as many terms as
    // the product of their lengths, and the guess is that gcd and cofactors are equally long.
    const auto terms = static_cast<double>(problem.f.size() + problem.g.size());
    const auto shorter = static_cast<double>(std::min(problem.f.size(), problem.g.size()));
    const double longest = 1 + 4 * std::sqrt(shorter) / (static_cast<double>(problem.bounds[0]) + 1);
    double most = 1; // images that the terms found so far can need
    double cost = 0;
    for (std::size_t k = 1; k < problem.variables.size(); ++k) {
        const double points = static_cast<double>(problem.bounds[k]) + 1;
        const double images = std::min(most, longest);
        cost += points * (5 * terms + images * (1.5 * terms + univariate_cost(problem)));
        most *= points;
    }
    return cost;
}

bool dense_fits(const GcdProblem& problem) {
    constexpr double max_entries = 1 << 26; // 256 MB
    return volume(problem.f, problem.variables) + volume(problem.g, problem.variables) <= max_entries;
}

GcdProblem sorted_for_dense(GcdProblem problem) {
    std::vector<std::size_t> sequence(problem.variables.size());
    std::iota(sequence.begin(), sequence.end(), std::size_t{0});
    std::ranges::stable_sort(sequence, std::greater<>{}, [&](std::size_t k) { return problem.bounds[k]; });
    return resorted(std::move(problem), sequence);
}

GcdProblem sorted_for_sparse(GcdProblem problem) {
    std::vector<std::size_t> sequence(problem.variables.size());
    std::iota(sequence.begin(), sequence.end(), std::size_t{0});
    std::ranges::stable_sort(sequence, {}, [&](std::size_t k) { return problem.bounds[k]; });
    const auto length = [&](std::size_t k) {
        return std::min(leading_length(problem.f, problem.variables[k]),
                        leading_length(problem.g, problem.variables[k]));
    };
    // Among equals the highest degree, which splits the gcd into the most coefficients.
    std::size_t best = 0;
    for (std::size_t k = 1; k < sequence.size(); ++k) {
        if (length(sequence[k]) <= length(sequence[best])) best = k;
    }
    std::rotate(sequence.begin(), sequence.begin() + static_cast<std::ptrdiff_t>(best),
                sequence.begin() + static_cast<std::ptrdiff_t>(best) + 1);
    return resorted(std::move(problem), sequence);
}

} // namespace eliminant::algebra
