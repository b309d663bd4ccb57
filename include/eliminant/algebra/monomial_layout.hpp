#pragma once

#include "eliminant/algebra/monomial_order.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// How monomials of one ring are packed in machine words at one field width, and the kernels on packed
/// monomials.
///
/// A packed monomial is a row of equally wide fields, most significant first: the sort keys of the order
/// (those that are the exponent of a single variable serve as that exponent), then the exponents not yet
/// present. Each field keeps its top bit free, the guard. degrevlex in x, y, z at 16 bits:
///
///     word 0   | 0 degree | 0 z | 0 y | 0 x |       flip = | 0000 | ffff | ffff | 0000 |
///
/// * product = word-wise sum; a set guard bit afterwards is an overflow, which never reaches the next field;
/// * quotient = word-wise difference; a divides b iff (b | guard) − a leaves every guard set;
/// * order = first differing word, compared as unsigned after XOR with `flip` (fields that compare reversed).
///
/// All keys are non-negative linear forms (MonomialOrder::keys), so the rules hold for keys and exponents
/// alike. Following Monagan and Pearce (2007) and Roune and Stillman (2012).
class MonomialLayout {
  public:
    using Word = std::uint64_t;

    /// bits is 8, 16, 32 or 64.
    MonomialLayout(std::span<const MonomialOrder::Key> keys, std::size_t variable_count, unsigned bits);

    unsigned bits() const { return bits_; }
    std::size_t words() const { return words_; }
    std::size_t variable_count() const { return places_.size(); }
    std::size_t field_count() const { return field_count_; }
    /// Largest value that a field can hold.
    std::uint64_t max_field() const { return field_mask_ >> 1; }
    /// Masks per word; see the class comment.
    const Word* flip() const { return flip_.data(); }
    Word guard() const { return guard_; }

    /// −1, 0 or 1 as a is less than, equal to or greater than b in the order.
    int compare(const Word* a, const Word* b) const {
        for (std::size_t w = 0; w < words_; ++w) {
            if (a[w] != b[w]) return (a[w] ^ flip_[w]) > (b[w] ^ flip_[w]) ? 1 : -1;
        }
        return 0;
    }
    bool equal(const Word* a, const Word* b) const {
        for (std::size_t w = 0; w < words_; ++w) {
            if (a[w] != b[w]) return false;
        }
        return true;
    }
    bool divides(const Word* a, const Word* b) const {
        for (std::size_t w = 0; w < words_; ++w) {
            if ((((b[w] | guard_) - a[w]) & guard_) != guard_) return false;
        }
        return true;
    }
    /// out = a·b; false if a field overflows (out is then unusable). out may be a or b.
    [[nodiscard]] bool multiply(const Word* a, const Word* b, Word* out) const {
        Word overflow = 0;
        for (std::size_t w = 0; w < words_; ++w) {
            out[w] = a[w] + b[w];
            overflow |= out[w];
        }
        return (overflow & guard_) == 0;
    }
    /// out = b/a for a that divides b.
    void divide(const Word* b, const Word* a, Word* out) const {
        for (std::size_t w = 0; w < words_; ++w) out[w] = b[w] - a[w];
    }
    bool is_one(const Word* a) const {
        for (std::size_t w = 0; w < words_; ++w) {
            if (a[w] != 0) return false;
        }
        return true;
    }
    /// out = lcm(a, b); false if a key overflows.
    [[nodiscard]] bool lcm(const Word* a, const Word* b, Word* out) const;
    void gcd(const Word* a, const Word* b, Word* out) const;
    bool coprime(const Word* a, const Word* b) const {
        for (const Place& place : places_) {
            if (field(a, place) != 0 && field(b, place) != 0) return false;
        }
        return true;
    }

    std::uint64_t exponent(const Word* a, std::size_t variable) const { return field(a, places_[variable]); }
    /// Value of field `index`, keys first.
    std::uint64_t field_value(const Word* a, std::size_t index) const { return field(a, place_of(index)); }
    /// Sum of all exponents.
    std::uint64_t total_degree(const Word* a) const {
        std::uint64_t sum = 0;
        for (const Place& place : places_) sum += field(a, place);
        return sum;
    }
    /// Packs exponents (one a variable); false if an exponent or a key does not fit.
    [[nodiscard]] bool encode(std::span<const std::uint64_t> exponents, Word* out) const;
    void decode(const Word* a, std::span<std::uint64_t> exponents) const;

    /// One bit for each of 64 threshold tests on exponents, such that a | b implies mask(a) ⊆ mask(b): one
    /// AND rejects most non-divisors.
    std::uint64_t divisibility_mask(const Word* a) const;

    /// Raises each of field_count() maxima to the fields of a.
    void update_maxima(const Word* a, std::span<std::uint64_t> maxima) const;
    /// Packs one value a field, each at most max_field(): a bound for monomials rather than a monomial.
    void pack_fields(std::span<const std::uint64_t> values, Word* out) const;
    /// Copies a monomial of a layout of the same ring with another width; false if it does not fit.
    [[nodiscard]] bool repack(const MonomialLayout& from, const Word* a, Word* out) const;

    /// Where a field lies.
    struct Place {
        std::uint32_t word;
        std::uint32_t shift;
    };
    /// Place of field `index`, keys first.
    Place place_of(std::size_t index) const {
        const std::size_t per_word = 64 / bits_;
        return {static_cast<std::uint32_t>(index / per_word),
                static_cast<std::uint32_t>(64 - bits_ * (index % per_word + 1))};
    }
    /// Whether the smaller value of field `index` is the larger monomial.
    bool is_reversed(std::size_t index) const {
        const Place place = place_of(index);
        return ((flip_[place.word] >> place.shift) & 1) != 0;
    }
    /// Fields that determine every field after them which is not listed, and so decide the order: in
    /// degrevlex all but the exponent of the first variable. Most significant first.
    std::span<const std::size_t> deciding_fields() const { return deciding_; }
    /// words() words for the i-th deciding field, so that, word by word and modulo 2^64,
    /// monomial = Σ (value of the i-th deciding field) · column(i).
    const Word* column(std::size_t i) const { return columns_.data() + i * words_; }

  private:
    /// A key that is not a single exponent, recomputed when exponents are given.
    struct Form {
        Place place;
        std::vector<std::uint64_t> weights;
    };

    std::uint64_t field(const Word* a, Place place) const {
        return (a[place.word] >> place.shift) & field_mask_;
    }
    /// Fills in all forms of a monomial whose exponents are set and whose forms are 0.
    [[nodiscard]] bool complete(Word* a) const;
    void find_deciding_fields();

    unsigned bits_;
    std::size_t words_;
    std::size_t field_count_;
    Word field_mask_;
    Word guard_;
    std::vector<Word> flip_;
    std::vector<Place> places_; ///< of each variable's exponent
    std::vector<Form> forms_;
    std::vector<std::size_t> deciding_;
    std::vector<Word> columns_; ///< words_ words for each deciding field
};

} // namespace eliminant::algebra
