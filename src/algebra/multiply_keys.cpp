#include "multiply_keys.hpp"

#include <algorithm>
#include <limits>

namespace eliminant::algebra {

std::vector<FieldSpan> field_spans(const MonomialLayout& layout,
                                   std::span<const MonomialLayout::Word> monomials) {
    const std::size_t words = layout.words();
    const std::uint64_t mask = layout.max_field();
    std::vector<FieldSpan> spans(layout.field_count());
    for (std::size_t f = 0; f < spans.size(); ++f) {
        const auto place = layout.place_of(f);
        FieldSpan span;
        for (std::size_t i = place.word; i < monomials.size(); i += words) {
            const std::uint64_t value = (monomials[i] >> place.shift) & mask;
            span.low = std::min(span.low, value);
            span.high = std::max(span.high, value);
        }
        for (std::size_t i = place.word; i < monomials.size() && span.stride != 1; i += words)
            span.stride = std::gcd(span.stride, ((monomials[i] >> place.shift) & mask) - span.low);
        spans[f] = span;
    }
    return spans;
}

KeyLine::KeyLine(const MonomialLayout& target, std::span<const FieldSpan> a, std::span<const FieldSpan> b)
    : target_(&target), base_(target.words(), 0) {
    const auto deciding = target.deciding_fields();
    const std::size_t n = target.words();
    std::uint64_t weight = 1;
    std::size_t word_from_last = 0;
    for (std::size_t i = deciding.size(); i-- > 0;) {
        const std::size_t f = deciding[i];
        const bool reversed = target.is_reversed(f);
        const std::uint64_t start = reversed ? a[f].high + b[f].high : a[f].low + b[f].low;
        for (std::size_t w = 0; w < n; ++w) base_[w] += start * target.column(i)[w];
        const std::uint64_t stride = std::gcd(a[f].stride, b[f].stride);
        if (stride == 0) continue;
        const std::uint64_t radix = (a[f].length() + b[f].length()) / stride + 1;
        if (weight > std::numeric_limits<std::uint64_t>::max() / radix) {
            weight = 1;
            ++word_from_last;
        }
        digits_.push_back({f, word_from_last, weight, radix, stride, reversed});
        for (std::size_t w = 0; w < n; ++w)
            steps_.push_back((reversed ? 0 - stride : stride) * target.column(i)[w]);
        weight *= radix;
    }
    words_ = word_from_last + 1;
    for (Digit& digit : digits_) digit.word = words_ - 1 - digit.word;
}

std::vector<std::uint64_t> KeyLine::encode(const MonomialLayout& layout, std::span<const Word> monomials,
                                           std::span<const FieldSpan> spans) const {
    const std::size_t n = layout.words();
    const std::uint64_t mask = layout.max_field();
    const std::size_t terms = monomials.size() / n;
    std::vector<std::uint64_t> keys(terms * words_, 0);
    for (const Digit& digit : digits_) {
        const auto place = layout.place_of(digit.field);
        const Word* source = monomials.data() + place.word;
        std::uint64_t* out = keys.data() + digit.word;
        const FieldSpan& span = spans[digit.field];
        const std::uint64_t start = digit.reversed ? span.high : span.low;
        const std::uint64_t sign = digit.reversed ? ~std::uint64_t{0} : 1;
        if (digit.stride == 1) {
            for (std::size_t i = 0; i < terms; ++i)
                out[i * words_] += sign * (((source[i * n] >> place.shift) & mask) - start) * digit.weight;
        } else {
            for (std::size_t i = 0; i < terms; ++i)
                out[i * words_] +=
                    sign * (((source[i * n] >> place.shift) & mask) - start) / digit.stride * digit.weight;
        }
    }
    return keys;
}

KeyDecoder::KeyDecoder(const KeyLine& line)
    : line_(&line), last_(line.words_ - 1), radix_(1), row_(~std::uint64_t{0}),
      step_(line.target_->words(), 0), base_(line.base_) {
    if (line.digits_.empty()) return;
    radix_ = line.digits_.front().radix;
    std::copy_n(line.steps_.begin(), step_.size(), step_.begin());
}

void KeyDecoder::enter_row(const std::uint64_t* key, std::uint64_t row) {
    row_ = row;
    base_ = line_->base_;
    const auto& digits = line_->digits_;
    const std::size_t n = base_.size();
    std::uint64_t rest = row;
    for (std::size_t d = 1; d < digits.size(); ++d) {
        if (digits[d].word != digits[d - 1].word) rest = key[digits[d].word];
        const std::uint64_t quotient = rest / digits[d].radix;
        const std::uint64_t digit = rest - quotient * digits[d].radix;
        rest = quotient;
        for (std::size_t w = 0; w < n; ++w) base_[w] += digit * line_->steps_[d * n + w];
    }
}

} // namespace eliminant::algebra
