#include "chinese_remainders.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::algebra {

bool ChineseRemainders::add(const PrimeField& field, const std::vector<std::size_t>& places,
                            const std::vector<std::uint32_t>& residues) {
    if (places != places_) {
        std::vector<std::size_t> all;
        std::ranges::set_union(places_, places, std::back_inserter(all));
        std::vector<Integer> values(all.size());
        for (std::size_t i = 0, k = 0; i < places_.size(); ++i) {
            while (all[k] != places_[i]) ++k;
            values[k] = std::move(values_[i]);
        }
        places_ = std::move(all);
        values_ = std::move(values);
    }
    const std::uint32_t p = field.characteristic();
    const std::uint32_t inverse = field.inverse(field.from_integer(modulus_));
    bool changed = false;
    for (std::size_t i = 0, k = 0; i < places_.size(); ++i) {
        const std::uint32_t residue = k < places.size() && places[k] == places_[i] ? residues[k++] : 0;
        const std::uint32_t gap = field.subtract(residue, field.from_integer(values_[i]));
        if (gap == 0) continue;
        changed = true;
        // |value| ≤ M/2 and |digit| ≤ (p − 1)/2 keep the sum within M·p/2.
        const std::int64_t digit = field.multiply(gap, inverse);
        values_[i].add_product(modulus_, Integer(digit > p / 2 ? digit - p : digit));
    }
    modulus_ *= Integer(p);
    return changed;
}

bool ChineseRemainders::small() const {
    return std::ranges::all_of(
        values_, [this](const Integer& v) { return 2 * v.bit_length() <= modulus_.bit_length(); });
}

} // namespace eliminant::algebra
