#include "implicit/verify_sums.hpp"

namespace eliminant::implicit {

MontgomeryModulus::MontgomeryModulus(std::uint32_t characteristic)
    : p(characteristic), negative_inverse(1),
      one(static_cast<std::uint32_t>((std::uint64_t{1} << 32) % characteristic)),
      square_of_one(static_cast<std::uint32_t>(std::uint64_t{one} * one % characteristic)) {
    // Newton: each step doubles the number of bits that are right, starting with one.
    for (int step = 0; step < 5; ++step) negative_inverse *= 2 + p * negative_inverse;
}

} // namespace eliminant::implicit
