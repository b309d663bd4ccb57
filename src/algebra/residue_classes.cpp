#include "algebra/residue_classes.hpp"

#include <algorithm>
#include <limits>

namespace eliminant::algebra::dense {

ResidueClasses::ResidueClasses(const PrimeField& field, const Vector& f)
    : field_(field), f_(f), sums_(2 * f.size()) {
    const std::uint64_t largest = std::uint64_t{field.characteristic()} - 1;
    capacity_ = std::numeric_limits<std::uint64_t>::max() / (largest * largest); // 4 at least
}

Vector ResidueClasses::power(const Vector& base, std::uint64_t exponent) {
    Vector result = base;
    for (auto bit = 63U - static_cast<unsigned>(__builtin_clzll(exponent)); bit-- > 0;) {
        multiply(result, result);
        if ((exponent >> bit & 1) != 0) multiply(result, base);
    }
    return result;
}

Vector ResidueClasses::power_of_linear(Element a, std::uint64_t exponent) {
    Vector result = {1};
    for (auto bit = 64U - static_cast<unsigned>(__builtin_clzll(exponent)); bit-- > 0;) {
        multiply(result, result);
        if ((exponent >> bit & 1) != 0) multiply_by_linear(result, a);
    }
    return result;
}

/// a becomes (x + constant)·a.
void ResidueClasses::multiply_by_linear(Vector& a, Element constant) {
    if (a.empty()) return;
    multiply_by_root(field_, a, field_.negate(constant));
    const std::size_t degree = f_.size() - 1;
    if (a.size() <= degree) return;
    const Element factor = field_.negate(a.back());
    for (std::size_t i = 0; i < degree; ++i) a[i] = field_.add(a[i], field_.multiply(factor, f_[i]));
    a.pop_back();
    trim(a);
}

/// sums[place + i] += factor·row[i].
void ResidueClasses::add_product(std::size_t place, Element factor, const Element* row, std::size_t count) {
    if (++pending_ == capacity_) { // the residues count as one product
        for (std::uint64_t& sum : sums_) sum = field_.reduce(sum);
        pending_ = 2;
    }
    std::uint64_t* const target = sums_.data() + place;
    for (std::size_t i = 0; i < count; ++i) target[i] += std::uint64_t{factor} * row[i];
}

void ResidueClasses::multiply(Vector& a, const Vector& b) {
    if (a.empty() || b.empty()) {
        a.clear();
        return;
    }
    const std::size_t degree = f_.size() - 1;
    const std::size_t size = a.size() + b.size() - 1;
    std::ranges::fill(sums_, 0);
    pending_ = 0;
    for (std::size_t i = 0; i < a.size(); ++i) add_product(i, a[i], b.data(), b.size());
    for (std::size_t i = size; i-- > degree;)
        add_product(i - degree, field_.negate(field_.reduce(sums_[i])), f_.data(), degree);
    a.resize(std::min(size, degree));
    for (std::size_t i = 0; i < a.size(); ++i) a[i] = field_.reduce(sums_[i]);
    trim(a);
}

} // namespace eliminant::algebra::dense
