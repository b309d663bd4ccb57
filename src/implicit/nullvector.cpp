#include "implicit/nullvector.hpp"

#include <algorithm>

namespace eliminant::implicit {

namespace {

constexpr std::size_t group = 4; // rows that are combined at a time
/// Groups between two reductions: 60 products below 2^58 and a residue are less than 2^64.
constexpr std::size_t groups_per_reduction = 15;

} // namespace

Echelon::Echelon(const algebra::PrimeField& field, std::size_t columns)
    : field_(field), columns_(columns), sums_(columns), combine_(row_combination(base::best_vector_unit())) {}

bool Echelon::add(std::span<const Element> row_values) {
    std::ranges::copy(row_values, sums_.begin());
    std::size_t since_reduction = 0;
    for (std::size_t k = 0; k < rank_; k += group) {
        // Inside a group the factors depend on each other: a triangle of at most four columns comes first.
        const std::size_t count = std::min(group, rank_ - k);
        const std::uint32_t* rows[group] = {row(k), row(k), row(k), row(k)};
        Element factors[group] = {};
        for (std::size_t i = 0; i < count; ++i) {
            rows[i] = row(k + i);
            std::uint64_t sum = sums_[k + i];
            for (std::size_t j = 0; j < i; ++j) sum += std::uint64_t{factors[j]} * rows[j][k + i];
            factors[i] = field_.negate(field_.reduce(sum));
        }
        for (auto& pointer : rows) pointer += k + count;
        combine_(&sums_[k + count], rows, factors, columns_ - k - count);
        if (++since_reduction == groups_per_reduction) {
            since_reduction = 0;
            for (std::size_t j = k + count; j < columns_; ++j) sums_[j] = field_.reduce(sums_[j]);
        }
    }
    if (rank_ == columns_) return false;
    const Element pivot = field_.reduce(sums_[rank_]);
    if (pivot == 0) return false;
    const Element inverse = field_.inverse(pivot);
    rows_.resize((rank_ + 1) * columns_, 0);
    Element* target = &rows_[rank_ * columns_];
    for (std::size_t j = rank_; j < columns_; ++j)
        target[j] = field_.multiply(field_.reduce(sums_[j]), inverse);
    ++rank_;
    return true;
}

std::vector<Echelon::Element> Echelon::dependence() const {
    std::vector<Element> v(rank_ + 1, 0);
    v[rank_] = 1;
    for (std::size_t i = rank_; i-- > 0;) {
        std::uint64_t sum = 0;
        for (std::size_t j = i + 1; j <= rank_; ++j)
            sum = field_.reduce(sum + std::uint64_t{row(i)[j]} * v[j]);
        v[i] = field_.negate(static_cast<Element>(sum));
    }
    return v;
}

} // namespace eliminant::implicit
