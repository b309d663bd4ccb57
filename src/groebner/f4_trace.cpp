#include "f4_trace.hpp"

#include "f4_computation.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::groebner {

using algebra::Polynomial;

std::optional<F4Trace> F4Trace::learn(const algebra::Ring& ring, std::span<const Polynomial> generators,
                                      std::uint64_t p, const BuchbergerOptions& options, base::Run& run,
                                      const SparseSeries* hilbert_numerator) {
    if (options.stop_at || options.degree_bound)
        throw DomainError("trace of F4: the computation must not be stopped early");
    check_grading(ring, options);
    F4Trace trace(ring.with_field(algebra::CoefficientField::prime(p)));
    std::vector<Polynomial> images;
    for (const Polynomial& f : generators) {
        algebra::require_same_ring(ring, f.ring(), "trace of F4");
        if (f.is_zero()) continue;
        const Polynomial primitive = f.primitive_part();
        trace.generators_.push_back(primitive.integer_terms().coefficients);
        images.push_back(primitive.in_ring(trace.ring_));
        if (images.back().size() != primitive.size()) return std::nullopt;
    }
    trace.basis_ = F4Computation(trace.ring_, images, options, run, &trace.rounds_, hilbert_numerator).run();
    for (const Polynomial& f : trace.basis_.elements) trace.coefficient_count_ += f.size();
    trace.number_elements();
    return trace;
}

void F4Trace::number_elements() {
    for (const F4Round& round : rounds_) {
        std::vector<std::size_t> row_with_lead(round.column_count, 0);
        for (std::size_t i = 0; i < round.rows.size(); ++i) row_with_lead[round.leads[i]] = i;
        for (std::size_t i = 0; i < round.found_count(); ++i) {
            const std::span<const std::uint32_t> support(round.support.data() + round.found[i],
                                                         round.found[i + 1] - round.found[i]);
            const auto copied = copied_element(round, row_with_lead[support.front()], support);
            copies_.push_back(copied.has_value());
            element_numbers_.push_back(copied ? *copied : static_cast<std::uint32_t>(element_sizes_.size()));
            if (!copied) element_sizes_.push_back(support.size());
        }
    }
}

/// The number of the element that the row is, if nothing was subtracted from it: if what was found has its
/// columns. These are neither leading columns of pivots nor, but for the first, of elements found, so nothing
/// is subtracted modulo other primes either.
std::optional<std::uint32_t> F4Trace::copied_element(const F4Round& round, std::size_t row,
                                                     std::span<const std::uint32_t> support) const {
    const F4Round::Row& r = round.rows[row];
    if (r.operand < generators_.size()) return std::nullopt; // not monic
    const std::uint32_t number = element_numbers_[r.operand - generators_.size()];
    if (element_sizes_[number] != support.size()) return std::nullopt;
    const std::span<const std::uint32_t> columns(round.columns_of_rows.data() + r.begin, support.size());
    if (!std::ranges::equal(columns, support)) return std::nullopt;
    return number;
}

std::size_t F4Trace::size_in_bytes() const {
    std::size_t bytes = 0;
    for (const F4Round& round : rounds_) {
        bytes += (round.columns_of_rows.capacity() + round.support.capacity()) * sizeof(std::uint32_t);
        bytes += (round.pivots.capacity() + round.rows.capacity()) * sizeof(F4Round::Row);
        bytes += round.found.capacity() * sizeof(std::size_t);
    }
    return bytes;
}

} // namespace eliminant::groebner
