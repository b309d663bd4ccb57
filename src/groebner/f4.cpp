#include "eliminant/groebner/f4.hpp"

#include "f4_computation.hpp"

namespace eliminant::groebner {

GroebnerBasis f4(const algebra::Ring& ring, std::span<const algebra::Polynomial> generators,
                 const BuchbergerOptions& options, base::Run& run) {
    if (ring.field().is_rationals())
        throw DomainError("F4 works over GF(p), the ring is " + ring.to_string());
    check_grading(ring, options);
    return F4Computation(ring, generators, options, run, nullptr).run();
}

} // namespace eliminant::groebner
