#include "supposed_terms.hpp"

#include <algorithm>

namespace eliminant::algebra {

using dense::Element;
using dense::Vector;

template <class Field>
SupposedTerms<Field>::SupposedTerms(const Field& field, const ExponentRows& rows, const Vector& omega)
    : field_(field), nodes_(monomial_values(field, rows, omega)), denominators_(rows.count, 1) {
    for (std::size_t first = 0; first < rows.count;) {
        std::size_t last = first;
        while (last < rows.count && rows.row(last)[0] == rows.row(first)[0]) ++last;
        groups_.push_back({static_cast<std::size_t>(rows.row(first)[0]), first, last - first, {1}});
        first = last;
    }
    for (std::size_t i = 1; i < groups_.size() && ready_; ++i) prepare(groups_[i]);
}

template <class Field>
std::size_t SupposedTerms<Field>::images_needed() const {
    std::size_t most = 1;
    for (std::size_t i = 1; i < groups_.size(); ++i) most = std::max(most, groups_[i].length);
    return most;
}

template <class Field>
void SupposedTerms<Field>::prepare(Group& group) {
    const auto nodes = std::span(nodes_).subspan(group.first, group.length);
    Vector sorted(nodes.begin(), nodes.end());
    std::ranges::sort(sorted);
    ready_ = std::ranges::adjacent_find(sorted) == sorted.end();
    if (!ready_) return;
    for (const Element node : nodes) dense::multiply_by_root(field_, group.master, node);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Element value = dense::evaluate<Field>(field_, quotient(group, nodes[i]), nodes[i]);
        denominators_[group.first + i] = field_.inverse(field_.multiply(nodes[i], value));
    }
}

/// M/(z − node) by Horner's scheme.
template <class Field>
Vector SupposedTerms<Field>::quotient(const Group& group, Element node) const {
    Vector result(group.length);
    Element carry = 0;
    for (std::size_t j = group.length; j-- > 0;) {
        carry = field_.add(group.master[j + 1], field_.multiply(node, carry));
        result[j] = carry;
    }
    return result;
}

/// Whether all samples are explained.
template <class Field>
bool SupposedTerms<Field>::solve_group(const Group& group, const Vector& samples, Vector& result) const {
    for (std::size_t i = group.first; i < group.first + group.length; ++i) {
        const Vector row = quotient(group, nodes_[i]);
        result[i] = field_.multiply(dense::dot(field_, row, samples), denominators_[i]);
    }
    for (std::size_t j = images_needed(); j < samples.size(); ++j) {
        Element value = 0;
        for (std::size_t i = group.first; i < group.first + group.length; ++i)
            value = field_.add(value, field_.multiply(result[i], field_.power(nodes_[i], j + 1)));
        if (value != samples[j]) return false;
    }
    return true;
}

template <class Field>
std::optional<Vector> SupposedTerms<Field>::solve(const std::vector<Vector>& images,
                                                  const Vector& gamma) const {
    if (images.front().size() != groups_.front().power + 1) return std::nullopt;
    Vector result(nodes_.size(), 0);
    std::ranges::copy(gamma, result.begin());
    std::size_t next = 1;
    Vector samples(images.size());
    for (std::size_t power = groups_.front().power; power-- > 0;) {
        for (std::size_t j = 0; j < images.size(); ++j) samples[j] = images[j][power];
        if (next < groups_.size() && groups_[next].power == power) {
            if (!solve_group(groups_[next++], samples, result)) return std::nullopt;
        } else if (std::ranges::any_of(samples, [](Element s) { return s != 0; })) {
            return std::nullopt;
        }
    }
    return result;
}

template class SupposedTerms<PrimeField>;
template class SupposedTerms<GaloisField>;

} // namespace eliminant::algebra
