// Irreducibility, shown by a line modulo a prime.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/implicit/certificate.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace eliminant::implicit {

/// Whether a monic polynomial over GF(p), p below 2^20, is irreducible: the test of Ben-Or (1981), that its
/// gcd with x^(p^k) − x is 1 for k up to half the degree. A polynomial that is not mostly fails for small k.
bool is_irreducible(const std::vector<std::uint32_t>& f, const algebra::PrimeField& field, base::Run& run);

/// A line on which f keeps its degree in the coordinates and is irreducible. It proves that f, if it has no
/// factor in ℤ[constants] alone, is irreducible over ℚ(constants): a factorisation would be one over
/// ℤ[constants] (Gauss), each factor would keep its degree on the line, and be a factor there.
///
/// For an absolutely irreducible f, as the equation of an image of a line, plane or space is, about one line
/// in deg f will do (its sections have the symmetric group as their monodromy; Chebotarev). nullopt after
/// forty times as many.
std::optional<SectionClaim> irreducible_section(const algebra::Polynomial& f, std::size_t coordinates,
                                                base::Run& run);

/// Whether f is what is claimed on the line, and irreducible there.
bool holds(const algebra::Polynomial& f, std::size_t coordinates, const SectionClaim& claim, base::Run& run);

} // namespace eliminant::implicit
