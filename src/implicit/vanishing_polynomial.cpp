#include "implicit/vanishing_polynomial.hpp"

#include "implicit/nullvector.hpp"

#include <algorithm>
#include <array>

namespace eliminant::implicit {

using algebra::PrimeField;

void Support::add(std::span<const std::uint32_t> exponents) {
    exponents_.insert(exponents_.end(), exponents.begin(), exponents.end());
    ++size_;
}

Support Support::where_nonzero(std::span<const std::uint32_t> coefficients) const {
    Support result(coordinates_);
    for (std::size_t i = 0; i < coefficients.size(); ++i)
        if (coefficients[i] != 0) result.add((*this)[i]);
    return result;
}

Support Support::embedded(std::size_t coordinates, std::span<const std::size_t> places) const {
    Support result(coordinates);
    std::vector<std::uint32_t> exponents(coordinates, 0);
    for (std::size_t i = 0; i < size_; ++i) {
        for (std::size_t j = 0; j < places.size(); ++j) exponents[places[j]] = (*this)[i][j];
        result.add(exponents);
    }
    return result;
}

namespace {

/// Calls `visit` for each exponent vector of exactly this weighted degree until it returns false.
bool for_each_of_degree(std::span<const std::uint64_t> weights, std::uint64_t degree,
                        std::vector<std::uint32_t>& exponents, std::size_t first,
                        const std::function<bool(std::span<const std::uint32_t>)>& visit) {
    if (first + 1 == weights.size()) {
        if (degree % weights[first] != 0) return true;
        exponents[first] = static_cast<std::uint32_t>(degree / weights[first]);
        return visit(exponents);
    }
    for (std::uint64_t e = 0; e * weights[first] <= degree; ++e) {
        exponents[first] = static_cast<std::uint32_t>(e);
        if (!for_each_of_degree(weights, degree - e * weights[first], exponents, first + 1, visit))
            return false;
    }
    return true;
}

} // namespace

Support Support::up_to(std::span<const std::uint64_t> weights, std::uint64_t degree) {
    Support result(weights.size());
    std::vector<std::uint32_t> exponents(weights.size());
    for (std::uint64_t d = 0; d <= degree; ++d)
        for_each_of_degree(weights, d, exponents, 0, [&](std::span<const std::uint32_t> e) {
            result.add(e);
            return true;
        });
    return result;
}

std::size_t Support::count_up_to(std::span<const std::uint64_t> weights, std::uint64_t degree,
                                 std::size_t limit) {
    std::size_t count = 0;
    std::vector<std::uint32_t> exponents(weights.size());
    for (std::uint64_t d = 0; d <= degree && count < limit; ++d)
        for_each_of_degree(weights, d, exponents, 0,
                           [&](std::span<const std::uint32_t>) { return ++count < limit; });
    return count;
}

void Support::evaluate(const PrimeField& field, std::span<const std::uint32_t> point,
                       std::span<std::uint32_t> values) const {
    std::vector<std::vector<std::uint32_t>> powers(coordinates_, {1});
    const auto power = [&](std::size_t coordinate, std::uint32_t exponent) {
        std::vector<std::uint32_t>& known = powers[coordinate];
        while (known.size() <= exponent) known.push_back(field.multiply(known.back(), point[coordinate]));
        return known[exponent];
    };
    for (std::size_t i = 0; i < size_; ++i) {
        const std::span<const std::uint32_t> exponents = (*this)[i];
        std::uint32_t value = power(0, exponents[0]);
        for (std::size_t j = 1; j < coordinates_; ++j)
            if (exponents[j] != 0) value = field.multiply(value, power(j, exponents[j]));
        values[i] = value;
    }
}

algebra::Polynomial monic_polynomial(const algebra::Ring& ring, const Support& support,
                                     const Coefficients& coefficients) {
    algebra::PolynomialBuilder builder(ring);
    std::vector<std::uint64_t> exponents(support.coordinates());
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        if (coefficients[i] == 0) continue;
        std::ranges::copy(support[i], exponents.begin());
        builder.add(algebra::Integer(coefficients[i]), exponents);
    }
    return builder.build().monic();
}

std::optional<Coefficients> first_vanishing(const PrimeField& field, const Support& support,
                                            const PointSource& points, base::Run& run) {
    // A row that adds no pivot shows a dependence; two further points must agree with it. Random values agree
    // once in p² times. A coincidence of the first rows costs another row.
    constexpr int confirmations = 2;
    constexpr int max_coincidences = 5;
    Echelon echelon(field, support.size());
    std::vector<std::uint32_t> row(support.size());
    const auto next_row = [&] {
        const auto point = points();
        if (point) support.evaluate(field, *point, row);
        return point.has_value();
    };
    int coincidences = 0;
    while (echelon.rank() < support.size()) {
        run.poll();
        if (!next_row()) return std::nullopt;
        if (echelon.add(row)) continue;
        Coefficients v = echelon.dependence();
        const auto vanishes = [&] {
            std::uint64_t sum = 0;
            for (std::size_t j = 0; j < v.size(); ++j) sum = field.reduce(sum + std::uint64_t{v[j]} * row[j]);
            return sum == 0;
        };
        int confirmed = 0;
        while (confirmed < confirmations && next_row() && vanishes()) ++confirmed;
        if (confirmed == confirmations) return v;
        if (++coincidences == max_coincidences) return std::nullopt;
    }
    return std::nullopt;
}

} // namespace eliminant::implicit
