#include "exponent_rows.hpp"

#include <algorithm>

namespace eliminant::algebra {

template <class Field>
PowerTable<Field>::PowerTable(const Field& field, dense::Element base, std::uint64_t max_exponent)
    : field_(field), base_(base),
      table_(dense::powers(field, base,
                           static_cast<std::size_t>(std::min<std::uint64_t>(max_exponent, 4095)) + 1)) {}

std::uint64_t largest_exponent(const ExponentRows& rows, std::size_t variable) {
    std::uint64_t largest = 0;
    for (std::size_t i = 0; i < rows.count; ++i)
        largest = std::max(largest, rows.entries[i * rows.variables + variable]);
    return largest;
}

template <class Field>
dense::Vector monomial_values(const Field& field, const ExponentRows& rows, const dense::Vector& point) {
    dense::Vector values(rows.count, 1);
    for (std::size_t v = 1; v < rows.variables; ++v) {
        const PowerTable<Field> powers(field, point[v], largest_exponent(rows, v));
        for (std::size_t i = 0; i < rows.count; ++i)
            values[i] = field.multiply(values[i], powers(rows.entries[i * rows.variables + v]));
    }
    return values;
}

template class PowerTable<PrimeField>;
template class PowerTable<GaloisField>;
template dense::Vector monomial_values(const PrimeField&, const ExponentRows&, const dense::Vector&);
template dense::Vector monomial_values(const GaloisField&, const ExponentRows&, const dense::Vector&);

} // namespace eliminant::algebra
