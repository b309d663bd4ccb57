#pragma once

#include "eliminant/algebra/integer.hpp"
#include "eliminant/base/run.hpp"

#include "division_kernel.hpp"
#include "multiply_kronecker.hpp"
#include "multiply_sums.hpp"
#include "residue_rows.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eliminant::algebra {

/// Whether terms with these keys fill so much of the line that arrays of all keys are no waste.
inline bool is_dense(const std::vector<std::uint64_t>& keys) { return keys.front() / 4 < keys.size(); }

/// Emits the terms of a/b, largest first, as long as b divides: division of dense polynomials in one
/// variable, which polynomials in more are by their keys. Time and memory as the keys of a by those of b. For
/// `find_term` see divide_by_window.
template <class FindTerm>
DivisionOutcome divide_dense(const KeyedTerms<std::uint64_t, std::uint32_t>& a,
                             const KeyedTerms<std::uint64_t, std::uint32_t>& b, const PrimeField& field,
                             base::Run& run, FindTerm&& find_term) {
    const auto spread = [](const KeyedTerms<std::uint64_t, std::uint32_t>& terms) {
        std::vector<std::uint32_t> row(terms.keys.front() + 1, 0);
        for (std::size_t i = 0; i < terms.size(); ++i) row[terms.keys[i]] = terms.coefficients[i];
        return row;
    };
    const std::uint32_t p = field.characteristic();
    std::vector<std::uint32_t> rest = spread(a);
    const std::vector<std::uint32_t> divisor = spread(b);
    const std::uint64_t degree = b.keys.front();
    for (std::uint64_t key = a.keys.front(); key >= degree; --key) {
        run.poll();
        if (rest[key] != 0) {
            std::uint32_t q = 0;
            const DivisionOutcome outcome = find_term(key, rest[key], q);
            if (outcome != DivisionOutcome::exact) return outcome;
            residue_rows().add_multiple(rest.data() + (key - degree), divisor.data(), divisor.size(),
                                        ResidueFactor(field.negate(q), p), p);
        }
        if (key == 0) break;
    }
    for (std::uint64_t key = 0; key < degree; ++key) {
        if (rest[key] != 0) return DivisionOutcome::inexact;
    }
    return DivisionOutcome::exact;
}

/// The same over ℤ by one division of integers, a(2^s)/b(2^s): if that leaves a remainder, b does not divide
/// a. If it does not, its quotient q has q·b = a where the slots of s bits hold all coefficients of q·b; else
/// the outcome is overflow. `emit(key, coefficient)` takes keys of a·(1/b) and may find that they are no
/// monomials.
template <class Emit>
DivisionOutcome
divide_by_kronecker(const KeyedTerms<std::uint64_t, Integer>& a, const KeyedTerms<std::uint64_t, Integer>& b,
                    const CoefficientSize& size_b, std::size_t slot_bits, base::Run& run, Emit&& emit) {
    run.poll();
    const auto quotient = SlotInteger::pack(a.keys, a.coefficients, slot_bits)
                              .exact_quotient(SlotInteger::pack(b.keys, b.coefficients, slot_bits));
    if (!quotient) return DivisionOutcome::inexact;
    for (std::uint64_t key = a.keys.front() - b.keys.front() + 1; key-- > 0;) {
        if (key % 1024 == 0) run.poll();
        Integer coefficient = quotient->integer(key);
        if (coefficient.is_zero()) continue;
        if (coefficient.bit_length() + size_b.sum_bits >= slot_bits) return DivisionOutcome::overflow;
        if (!emit(key, std::move(coefficient))) return DivisionOutcome::inexact;
    }
    return DivisionOutcome::exact;
}

} // namespace eliminant::algebra
