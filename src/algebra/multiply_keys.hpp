#pragma once

#include "eliminant/algebra/monomial_layout.hpp"
#include "eliminant/algebra/term_list.hpp"
#include "eliminant/base/wide.hpp"

#include <algorithm>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace eliminant::algebra {

/// The values that one field of a layout takes in a polynomial: low, low + stride, …, high.
struct FieldSpan {
    std::uint64_t low = ~std::uint64_t{0};
    std::uint64_t high = 0;
    std::uint64_t stride = 0; ///< gcd of the differences; 0 if there is one value only
    std::uint64_t length() const { return high - low; }
};

/// The spans of all fields of a polynomial that is not 0.
std::vector<FieldSpan> field_spans(const MonomialLayout& layout,
                                   std::span<const MonomialLayout::Word> monomials);

/// The largest value of any field in a product.
inline std::uint64_t widest_field(std::span<const FieldSpan> a, std::span<const FieldSpan> b) {
    std::uint64_t widest = 0;
    for (std::size_t f = 0; f < a.size(); ++f) widest = std::max(widest, a[f].high + b[f].high);
    return widest;
}

/// A monomial of a product as a number: the deciding fields, each shifted to start at 0 and divided by its
/// stride, as digits in a mixed radix that the product's fields never exceed (Kronecker's substitution).
///
/// So key(a·b) = key(a) + key(b), and larger monomials have larger keys. Fields in which all terms agree take
/// no room, and a field that compares reversed counts down from its maximum. Digits fill 64-bit words; a key
/// has as few words as possible, nearly always one.
class KeyLine {
  public:
    using Word = MonomialLayout::Word;

    /// For products of a polynomial with spans a by one with spans b, unpacked into `target`, which must be
    /// able to hold them.
    KeyLine(const MonomialLayout& target, std::span<const FieldSpan> a, std::span<const FieldSpan> b);

    const MonomialLayout& target() const { return *target_; }
    /// Words of a key, at least one.
    std::size_t words() const { return words_; }
    /// Keys of the terms of an operand with the given spans, words() words each, most significant first.
    std::vector<std::uint64_t> encode(const MonomialLayout& layout, std::span<const Word> monomials,
                                      std::span<const FieldSpan> spans) const;

  private:
    friend class KeyDecoder;
    struct Digit {
        std::size_t field;
        std::size_t word; ///< of the key, 0 the most significant
        std::uint64_t weight;
        std::uint64_t radix;
        std::uint64_t stride;
        bool reversed;
    };
    const MonomialLayout* target_;
    std::size_t words_ = 1;
    std::vector<Digit> digits_; ///< least significant first
    std::vector<Word> steps_;   ///< what one unit of each digit adds to a packed monomial
    std::vector<Word> base_;    ///< the packed monomial with key 0
};

/// Unpacks keys of a KeyLine into monomials of its target layout.
class KeyDecoder {
  public:
    explicit KeyDecoder(const KeyLine& line);
    void decode(const std::uint64_t* key, MonomialLayout::Word* out) {
        const std::uint64_t row = key[last_] / radix_;
        const std::uint64_t digit = key[last_] - row * radix_;
        // Results come in decreasing order, so most share all digits but the last with their predecessor.
        if (row != row_ || last_ != 0) enter_row(key, row);
        for (std::size_t w = 0; w < base_.size(); ++w) out[w] = base_[w] + digit * step_[w];
    }

  private:
    void enter_row(const std::uint64_t* key, std::uint64_t row);

    const KeyLine* line_;
    std::size_t last_;
    std::uint64_t radix_;
    std::uint64_t row_;
    std::vector<MonomialLayout::Word> step_;
    std::vector<MonomialLayout::Word> base_; ///< of the current row
};

/// A key of three or more words, for polynomials in many variables with huge exponents.
struct LongKey {
    std::vector<std::uint64_t> words; ///< most significant first

    friend LongKey operator+(const LongKey& a, const LongKey& b) {
        LongKey sum(a);
        for (std::size_t w = 0; w < sum.words.size(); ++w)
            sum.words[w] += b.words[w]; // digits leave no carry
        return sum;
    }
    friend bool operator==(const LongKey&, const LongKey&) = default;
    friend auto operator<=>(const LongKey&, const LongKey&) = default;
};

/// The words of KeyLine::encode as values of one of the three key types.
template <class Key>
std::vector<Key> as_keys(std::vector<std::uint64_t> words, std::size_t per_key);

template <>
inline std::vector<std::uint64_t> as_keys(std::vector<std::uint64_t> words, std::size_t) {
    return words;
}
template <>
inline std::vector<base::UInt128> as_keys(std::vector<std::uint64_t> words, std::size_t) {
    std::vector<base::UInt128> keys(words.size() / 2);
    for (std::size_t i = 0; i < keys.size(); ++i)
        keys[i] = static_cast<base::UInt128>(words[2 * i]) << 64 | words[2 * i + 1];
    return keys;
}
template <>
inline std::vector<LongKey> as_keys(std::vector<std::uint64_t> words, std::size_t per_key) {
    std::vector<LongKey> keys(words.size() / per_key);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const auto first = words.begin() + static_cast<std::ptrdiff_t>(i * per_key);
        keys[i].words.assign(first, first + static_cast<std::ptrdiff_t>(per_key));
    }
    return keys;
}

inline void decode_key(KeyDecoder& decoder, std::uint64_t key, MonomialLayout::Word* out) {
    decoder.decode(&key, out);
}
inline void decode_key(KeyDecoder& decoder, base::UInt128 key, MonomialLayout::Word* out) {
    const std::uint64_t words[2] = {static_cast<std::uint64_t>(key >> 64), static_cast<std::uint64_t>(key)};
    decoder.decode(words, out);
}
inline void decode_key(KeyDecoder& decoder, const LongKey& key, MonomialLayout::Word* out) {
    decoder.decode(key.words.data(), out);
}

} // namespace eliminant::algebra
