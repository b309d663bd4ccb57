#include "row_sums.hpp"

#include <utility>

namespace eliminant::groebner {

using algebra::Integer;

namespace {

/// From 32 to 1024 the times of cyclic-6, chandra-8 and -9, katsura-7 and eco-9 differ by no more than their
/// noise.
constexpr std::size_t first_collapse_bits = 128;

void divide_all(std::vector<Integer>& values, const Integer& divisor, const base::Run& run) {
    for (Integer& c : values) {
        run.poll();
        c.divide_exactly(divisor);
    }
}

/// gcd(start, values), from the last one on, as later coefficients of a reduction tend to be shorter.
Integer content_of(const std::vector<Integer>& values, const base::Run& run, Integer start = Integer()) {
    for (std::size_t k = values.size(); k-- > 0 && !start.is_one();) {
        run.poll();
        start = gcd(start, values[k]);
    }
    return start;
}

} // namespace

void RowSums<algebra::IntegerDomain>::begin() {
    nodes_.clear();
    free_ = 0;
    rows_.clear();
    result_.clear();
    rescalings_.clear();
    scale_bits_ = 0;
    collapse_bits_ = first_collapse_bits;
}

void RowSums<algebra::IntegerDomain>::add_term(Cell& cell, std::size_t term) {
    Row& row = rows_.back();
    ++row.pending;
    const Node node{static_cast<std::uint32_t>(rows_.size() - 1), static_cast<std::uint32_t>(term),
                    cell.head};
    if (free_ != 0) {
        cell.head = free_;
        free_ = std::exchange(nodes_[cell.head - 1], node).next;
    } else {
        nodes_.push_back(node);
        cell.head = static_cast<std::uint32_t>(nodes_.size());
    }
}

Integer RowSums<algebra::IntegerDomain>::collect(Cell& cell) {
    base::Int128 small_sum = 0;
    bool large = false;
    std::uint32_t last = 0;
    for (std::uint32_t i = cell.head; i != 0; i = nodes_[i - 1].next) {
        last = i;
        const Node& node = nodes_[i - 1];
        Row& row = rows_[node.row];
        --row.pending;
        const Integer& c = row.coefficients[node.term];
        if (row.q.is_small() && c.is_small()) {
            const base::Int128 product = static_cast<base::Int128>(row.q.small_value()) * c.small_value();
            if (!__builtin_add_overflow(small_sum, product, &small_sum)) continue;
        }
        if (!large) large_sum_ = 0;
        large = true;
        run_.poll();
        mpz_addmul(large_sum_.get_mpz_t(), Integer::View(row.q), Integer::View(c));
    }
    if (last != 0) { // the whole list becomes free at once
        nodes_[last - 1].next = free_;
        free_ = cell.head;
        cell.head = 0;
    }
    if (!large) return Integer::from_wide(small_sum);
    if (small_sum != 0) {
        const Integer rest = Integer::from_wide(small_sum);
        mpz_add(large_sum_.get_mpz_t(), large_sum_.get_mpz_t(), Integer::View(rest));
    }
    return Integer(large_sum_);
}

Integer RowSums<algebra::IntegerDomain>::eliminate(const Integer& value,
                                                   const BasisElement<Integer>& element) {
    const Integer& lc = element.terms.coefficients.front(); // positive
    Integer q = -value;
    if (lc.is_one()) return q;
    const Integer common = gcd(value, lc);
    q.divide_exactly(common);
    Integer factor = lc;
    factor.divide_exactly(common);
    if (factor.is_one()) return q;
    for (Row& row : rows_) {
        if (row.pending == 0) continue;
        run_.poll();
        row.q *= factor;
    }
    scale_bits_ += factor.bit_length();
    rescalings_.push_back({result_.size(), std::move(factor)});
    return q;
}

void RowSums<algebra::IntegerDomain>::settle_result() {
    Integer scale(1);
    std::size_t end = result_.size();
    for (std::size_t k = rescalings_.size(); k-- > 0;) {
        const Rescaling& rescaling = rescalings_[k];
        for (std::size_t i = rescaling.emitted_before; i < end && !scale.is_one(); ++i) {
            run_.poll();
            result_[i] *= scale;
        }
        end = rescaling.emitted_before;
        scale *= rescaling.factor;
    }
    for (std::size_t i = 0; i < end && !scale.is_one(); ++i) {
        run_.poll();
        result_[i] *= scale;
    }
    rescalings_.clear();
}

void RowSums<algebra::IntegerDomain>::collapse(std::vector<Integer> values) {
    settle_result();
    const Integer content = content_of(result_, run_, content_of(values, run_));
    const std::size_t content_bits = content.bit_length();
    if (content_bits > 1) {
        divide_all(values, content, run_);
        divide_all(result_, content, run_);
    }
    // Little gained: the growth is genuine, so look again only when as much has come once more.
    if (2 * content_bits < scale_bits_) collapse_bits_ *= 2;
    scale_bits_ = 0;
    rows_.clear();
    nodes_.clear();
    free_ = 0;
    collapsed_ = std::move(values);
    rows_.push_back({collapsed_.data(), Integer(1), 0});
}

void RowSums<algebra::IntegerDomain>::finish(std::vector<Integer>& coefficients) {
    settle_result();
    if (!result_.empty()) {
        Integer content = content_of(result_, run_);
        if (result_.front().sign() < 0) content.negate();
        if (!content.is_one()) divide_all(result_, content, run_);
    }
    coefficients.swap(result_);
}

std::uint64_t RowSums<algebra::IntegerDomain>::cost(const std::vector<Integer>& coefficients) {
    std::uint64_t limbs = 0;
    for (const Integer& c : coefficients) limbs += c.is_small() ? 1 : 1 + c.bit_length() / 64;
    return limbs;
}

} // namespace eliminant::groebner
