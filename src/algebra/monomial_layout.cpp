#include "eliminant/algebra/monomial_layout.hpp"

#include "eliminant/base/wide.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <utility>

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

MonomialLayout::MonomialLayout(std::span<const MonomialOrder::Key> keys, std::size_t variable_count,
                               unsigned bits)
    : bits_(bits), words_(0), field_count_(0), field_mask_(~Word{0} >> (64 - bits)), guard_(0) {
    constexpr std::size_t absent = ~std::size_t{0};
    std::vector<std::size_t> field_of(variable_count, absent);
    std::vector<std::size_t> reversed;
    for (const MonomialOrder::Key& key : keys) {
        const auto variable = single_variable(key);
        if (variable && field_of[*variable] != absent) continue; // decided by an earlier key already
        if (key.reversed) reversed.push_back(field_count_);
        if (variable)
            field_of[*variable] = field_count_;
        else
            forms_.push_back({place_of(field_count_), key.weights});
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
    find_deciding_fields();
}

namespace {

/// A linear form of few variables, as most fields are: its coefficients that are not zero.
using SparseForm = std::map<std::size_t, MonomialLayout::Word>;

void subtract_multiple(SparseForm& from, MonomialLayout::Word factor, const SparseForm& what) {
    for (const auto& [index, value] : what) {
        MonomialLayout::Word& entry = from[index];
        entry -= factor * value;
        if (entry == 0) from.erase(index);
    }
}

} // namespace

void MonomialLayout::find_deciding_fields() {
    // Gaussian elimination on the fields as linear forms of the exponents, over the integers modulo 2^64 with
    // odd pivots only. A field that reduces to 0 is a combination of earlier ones modulo 2^64; its value is
    // below 2^63, so they determine it. (Over the rationals more fields would, as x by 2x + y and y, but not
    // by wrapping arithmetic.) A remainder without odd entry decides too but reduces nothing.
    struct Pivot {
        SparseForm form;        ///< 1 at its variable, 0 at the variables of the pivots before
        SparseForm combination; ///< of the deciding fields, which gives the form
        std::size_t variable;
    };
    std::vector<SparseForm> fields(field_count_);
    const auto index_of = [this](Place place) { // the inverse of place_of
        return std::size_t{place.word} * (64 / bits_) + (64 - place.shift) / bits_ - 1;
    };
    for (const Form& known : forms_) {
        SparseForm& form = fields[index_of(known.place)];
        for (std::size_t v = 0; v < known.weights.size(); ++v)
            if (known.weights[v] != 0) form[v] = known.weights[v];
    }
    for (std::size_t v = 0; v < places_.size(); ++v) fields[index_of(places_[v])] = {{v, 1}};

    std::vector<Pivot> pivots;
    std::vector<std::size_t> pivot_of(places_.size(), field_count_); // of a variable; field_count_: none
    for (std::size_t index = 0; index < field_count_; ++index) {
        const Place place = place_of(index);
        SparseForm form = std::move(fields[index]);
        SparseForm combination; // the form as reduced so far
        // A pivot brings in variables of later ones only.
        std::set<std::size_t> reducing;
        const auto note = [&](const SparseForm& entries) {
            for (const auto& [variable, value] : entries)
                if (pivot_of[variable] != field_count_) reducing.insert(pivot_of[variable]);
        };
        note(form);
        while (!reducing.empty()) {
            const Pivot& pivot = pivots[reducing.extract(reducing.begin()).value()];
            const auto entry = form.find(pivot.variable);
            if (entry == form.end()) continue;
            const Word factor = entry->second;
            subtract_multiple(form, factor, pivot.form);
            subtract_multiple(combination, factor, pivot.combination);
            note(pivot.form);
        }
        if (form.empty()) {
            for (const auto& [i, value] : combination)
                columns_[i * words_ + place.word] -= value << place.shift;
            continue;
        }
        const std::size_t decider = deciding_.size();
        deciding_.push_back(index);
        columns_.resize(deciding_.size() * words_, 0);
        columns_[decider * words_ + place.word] = Word{1} << place.shift;
        combination[decider] = 1;
        const auto odd =
            std::ranges::find_if(form, [](const auto& entry) { return (entry.second & 1) != 0; });
        if (odd == form.end()) continue;
        const std::size_t variable = odd->first;
        const Word leading = odd->second;
        Word inverse = leading; // Newton's iteration doubles the correct bits, 3 to begin with
        for (int i = 0; i < 5; ++i) inverse *= 2 - leading * inverse;
        for (auto& [v, value] : form) value *= inverse;
        for (auto& [i, value] : combination) value *= inverse;
        pivot_of[variable] = pivots.size();
        pivots.push_back({std::move(form), std::move(combination), variable});
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
    for (const Place& place : places_)
        out[place.word] |= std::max(field(a, place), field(b, place)) << place.shift;
    return complete(out);
}

void MonomialLayout::gcd(const Word* a, const Word* b, Word* out) const {
    std::fill_n(out, words_, Word{0});
    for (const Place& place : places_)
        out[place.word] |= std::min(field(a, place), field(b, place)) << place.shift;
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
    // Variable i owns 64/n thresholds (at least one; beyond 64 variables they share), 1, 2, 3, … of its
    // exponent.
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

void MonomialLayout::pack_fields(std::span<const std::uint64_t> values, Word* out) const {
    std::fill_n(out, words_, Word{0});
    for (std::size_t i = 0; i < field_count_; ++i) {
        const Place place = place_of(i);
        out[place.word] |= values[i] << place.shift;
    }
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
