#include "f4_trace.hpp"

#include "f4_computation.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::groebner {

using algebra::Polynomial;

std::optional<F4Trace> F4Trace::learn(const algebra::Ring& ring, std::span<const Polynomial> generators,
                                      std::uint64_t p, const BuchbergerOptions& options, base::Run& run) {
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
    trace.basis_ = F4Computation(trace.ring_, images, options, run, &trace.rounds_).run();
    for (const Polynomial& f : trace.basis_.elements) trace.coefficient_count_ += f.size();
    return trace;
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

std::vector<F4Trace::Image> F4Trace::replay(std::span<const std::uint32_t> primes, base::Run& run,
                                            Extent extent) const {
    const LaneKernels& kernels = lane_kernels(base::best_vector_unit());
    std::vector<Image> images(primes.size());
    const std::size_t packs = (primes.size() + lane_count - 1) / lane_count;
    base::parallel_for(run, packs, [&](std::size_t pack, std::size_t) {
        const std::size_t begin = pack * lane_count;
        const std::size_t size = std::min(lane_count, primes.size() - begin);
        std::ranges::move(replay_pack(primes.subspan(begin, size), kernels, run, extent),
                          images.begin() + static_cast<std::ptrdiff_t>(begin));
    });
    return images;
}

} // namespace eliminant::groebner
