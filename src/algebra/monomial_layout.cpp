#include "eliminant/algebra/monomial_layout.hpp"

#include "eliminant/base/wide.hpp"

#include <algorithm>
#include <optional>

namespace eliminant::algebra {

namespace {

/// The variable whose exponent the key is, if it is a single one with weight 1.
std::optional<std::size_t> single_variable(const MonomialOrder::Key& key) {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < key.weights.size(); ++i) {
        if (key.weights[i] == 0) continue;
        if (found || key.weights[i] != 1) return std::nullopt;
        found = i;
    }
    return found;
}

} // namespace

MonomialLayout::MonomialLayout(std::span<const MonomialOrder::Key> keys, std::size_t variable_count, unsigned bits)
    : bits_(bits), words_(0), field_count_(0), field_mask_(~Word{0} >> (64 - bits)), guard_(0) {
    constexpr std::size_t absent = ~std::size_t{0};
    std::vector<std::size_t> field_of(variable_count, absent);
    std::vector<std::size_t> reversed;
    for (const MonomialOrder::Key& key : keys) {
        const auto variable = single_variable(key);
        if (variable && field_of[*variable] != absent) continue; // decided by an earlier key already
        if (key.reversed) reversed.push_back(field_count_);
        if (variable) field_of[*variable] = field_count_;
        else forms_.push_back({place_of(field_count_), key.weights});
        ++field_count_;
    }
    for (std::size_t& field_index : field_of) {
        if (field_index == absent) field_index = field_count_++;
        places_.push_back(place_of(field_index));
    }
    const std::size_t per_word = 64 / bits_;
    words_ = std::max<std::size_t>(1, (field_count_ + per_word - 1) / per_word);
    for (std::size_t i = 0; i < per_word; ++i) guard_ |= Word{1} << (bits_ * (i + 1) - 1);
    flip_.assign(words_, 0);
    for (const std::size_t index : reversed) {
        const Place place = place_of(index);
        flip_[place.word] |= field_mask_ << place.shift;
    }
}

bool MonomialLayout::complete(Word* a) const {
    const std::uint64_t limit = max_field();
    for (const Form& form : forms_) {
        base::UInt128 value = 0; // below 2^8 · 2^31 · 2^63 for any ring that fits in memory
        for (std::size_t i = 0; i < places_.size(); ++i)
            value += static_cast<base::UInt128>(form.weights[i]) * field(a, places_[i]);
        if (value > limit) return false;
        a[form.place.word] |= static_cast<Word>(value) << form.place.shift;
    }
    return true;
}

bool MonomialLayout::lcm(const Word* a, const Word* b, Word* out) const {
    std::fill_n(out, words_, Word{0});
    for (const Place& place : places_) out[place.word] |= std::max(field(a, place), field(b, place)) << place.shift;
    return complete(out);
}

void MonomialLayout::gcd(const Word* a, const Word* b, Word* out) const {
    std::fill_n(out, words_, Word{0});
    for (const Place& place : places_) out[place.word] |= std::min(field(a, place), field(b, place)) << place.shift;
    static_cast<void>(complete(out)); // keys of a divisor cannot overflow
}

bool MonomialLayout::encode(std::span<const std::uint64_t> exponents, Word* out) const {
    std::fill_n(out, words_, Word{0});
    const std::uint64_t limit = max_field();
    for (std::size_t i = 0; i < places_.size(); ++i) {
        if (exponents[i] > limit) return false;
        out[places_[i].word] |= exponents[i] << places_[i].shift;
    }
    return complete(out);
}

void MonomialLayout::decode(const Word* a, std::span<std::uint64_t> exponents) const {
    for (std::size_t i = 0; i < places_.size(); ++i) exponents[i] = field(a, places_[i]);
}

std::uint64_t MonomialLayout::divisibility_mask(const Word* a) const {
    const std::size_t n = places_.size();
    std::uint64_t mask = 0;
    if (n == 0) return mask;
    // Variable i owns 64/n thresholds (at least one; beyond 64 variables they share), 1, 2, 3, … of its exponent.
    const std::size_t per_variable = std::max<std::size_t>(1, 64 / n);
    for (std::size_t i = 0; i < n; ++i) {
        const std::uint64_t e = std::min<std::uint64_t>(field(a, places_[i]), per_variable);
        if (e == 0) continue;
        const std::uint64_t bits = e >= 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << e) - 1;
        mask |= bits << (i * per_variable % 64);
    }
    return mask;
}

void MonomialLayout::update_maxima(const Word* a, std::span<std::uint64_t> maxima) const {
    for (std::size_t i = 0; i < field_count_; ++i) maxima[i] = std::max(maxima[i], field(a, place_of(i)));
}

bool MonomialLayout::repack(const MonomialLayout& from, const Word* a, Word* out) const {
    std::fill_n(out, words_, Word{0});
    const std::uint64_t limit = max_field();
    for (std::size_t i = 0; i < field_count_; ++i) {
        const std::uint64_t value = from.field(a, from.place_of(i));
        if (value > limit) return false;
        const Place place = place_of(i);
        out[place.word] |= value << place.shift;
    }
    return true;
}

} // namespace eliminant::algebra
