// Identities over ℚ between multiples of polynomials, from their images modulo primes.
#pragma once

#include "prime_pack.hpp"
#include "prime_sequence.hpp"

#include "eliminant/base/run.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// Polynomials whose multiples are the rows of matrices: their integer coefficients.
using Operands = std::vector<DigitVector>;

/// Rows that are said to be combinations over ℚ of others.
struct RowIdentities {
    struct Row {
        std::size_t operand;
        std::span<const std::uint32_t> columns; ///< of its coefficients, ascending
    };
    std::size_t column_count = 0;
    std::vector<Row> basis; ///< no two have the same leading column
    std::vector<Row> rows;
    /// So many of the basis, the last ones, are said to be combinations of the rows and the others of the
    /// basis as well: as many as rows, or 0.
    std::size_t generated = 0;
};

/// Proves such statements.
///
/// For a row uᵢ·Eₐ₍ᵢ₎ there shall be a positive integer d and integers c with
///
///     d·uᵢ·Eₐ₍ᵢ₎ = Σⱼ cⱼ·vⱼ·E_b₍ⱼ₎                                                               (1)
///
/// summed over the basis. The multipliers c/d are those of the elimination of the row; they are found modulo
/// primes and lifted. (1) then holds modulo each of these primes. Both sides have integer coefficients, of
/// size at most d·‖Eₐ‖ + Σ|c|·‖E_b‖; as soon as the product of the primes exceeds twice that, (1) holds over
/// ℤ. This is checked with the numbers as they came out; nothing is assumed about their size.
///
/// Where basis elements shall be generated: the square matrix of their multipliers, row by row, is invertible
/// modulo a prime, which is checked; so it is over ℚ.
class IdentityProver {
  public:
    /// Refers to all arguments.
    IdentityProver(const Operands& operands, PrimeSequence& primes, base::Run& run)
        : operands_(operands), primes_(primes), run_(run) {}

    /// False if the statement is wrong. If it is true it is found to be, unless a multiplier vanishes by
    /// accident modulo the first primes. The threads of the run are used.
    bool holds(const RowIdentities& identities);

  private:
    class Statement;

    std::uint32_t next_prime();
    /// Eight primes; the same ones for each statement.
    const LaneEntry& pack(std::size_t i);

    const Operands& operands_;
    PrimeSequence& primes_;
    base::Run& run_;
    std::vector<LaneEntry> packs_;
    std::size_t expected_packs_ = 1;
};

} // namespace eliminant::groebner
