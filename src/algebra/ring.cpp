#include "eliminant/algebra/ring.hpp"

#include "eliminant/base/error.hpp"

#include <algorithm>
#include <bit>
#include <unordered_map>
#include <utility>

namespace eliminant::algebra {

struct Ring::Data {
    CoefficientField field;
    std::vector<std::string> names;
    MonomialOrder order;
    std::unordered_map<std::string_view, std::size_t> indices; ///< views into names
    std::array<MonomialLayout, 4> layouts;                     ///< 8, 16, 32, 64 bits a field

    Data(CoefficientField f, std::vector<std::string> n, MonomialOrder o,
         const std::vector<MonomialOrder::Key>& keys)
        : field(std::move(f)), names(std::move(n)),
          order(std::move(o)), layouts{MonomialLayout(keys, names.size(), 8),
                                       MonomialLayout(keys, names.size(), 16),
                                       MonomialLayout(keys, names.size(), 32),
                                       MonomialLayout(keys, names.size(), 64)} {
        for (std::size_t i = 0; i < names.size(); ++i) {
            if (!is_identifier(names[i]))
                throw DomainError(
                    "a variable name is a letter followed by letters, digits and underscores, found '" +
                    names[i] + "'");
            if (!indices.emplace(names[i], i).second)
                throw DomainError("the variable name '" + names[i] + "' occurs twice");
        }
    }
};

std::string CoefficientField::to_string() const {
    return is_rationals() ? "QQ" : "GF(" + std::to_string(characteristic()) + ")";
}

bool is_identifier(std::string_view text) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto continues = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '_'; };
    return !text.empty() && is_letter(text.front()) && std::ranges::all_of(text, continues);
}

Ring::Ring(CoefficientField field, std::vector<std::string> names, MonomialOrder order) {
    const auto keys = order.keys(names.size());
    data_ = std::make_shared<const Data>(std::move(field), std::move(names), std::move(order), keys);
}

const CoefficientField& Ring::field() const { return data_->field; }
const MonomialOrder& Ring::order() const { return data_->order; }
std::size_t Ring::variable_count() const { return data_->names.size(); }
const std::vector<std::string>& Ring::names() const { return data_->names; }

std::optional<std::size_t> Ring::index_of(std::string_view name) const {
    const auto found = data_->indices.find(name);
    if (found == data_->indices.end()) return std::nullopt;
    return found->second;
}

Ring Ring::with_order(MonomialOrder order) const { return {field(), names(), std::move(order)}; }
Ring Ring::with_field(CoefficientField field) const { return {std::move(field), names(), order()}; }

const MonomialLayout& Ring::layout(unsigned bits) const {
    return data_->layouts[static_cast<std::size_t>(std::countr_zero(bits)) - 3];
}

const MonomialLayout& Ring::layout_for(std::uint64_t max_field) const {
    for (const MonomialLayout& layout : data_->layouts) {
        if (max_field <= layout.max_field()) return layout;
    }
    throw OverflowError("an exponent or weighted degree exceeds 2^63 - 1");
}

std::string Ring::to_string() const {
    std::string text = field().to_string() + "[";
    for (std::size_t i = 0; i < variable_count(); ++i) text += (i == 0 ? "" : ", ") + names()[i];
    return text + "], " + order().to_string(names());
}

bool operator==(const Ring& a, const Ring& b) {
    return a.data_ == b.data_ || (a.field() == b.field() && a.names() == b.names() && a.order() == b.order());
}

void require_same_ring(const Ring& a, const Ring& b, std::string_view doing) {
    if (a == b) return;
    throw RingMismatchError(std::string(doing) + ": the operands are of different rings, " + a.to_string() +
                            " and " + b.to_string());
}

} // namespace eliminant::algebra
