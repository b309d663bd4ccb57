// Residue classes modulo a polynomial over a prime field.
#pragma once

#include "algebra/univariate_mod_p.hpp"
#include "eliminant/algebra/prime_field.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eliminant::algebra::dense {

/// GF(p)[x]/(f), f monic of degree at least 1, for powers in it. Products are added up in 64 bits as long as
/// they fit, and nothing is allocated for each: at degree 2 or 3 and p near 2^29 a power x^p takes some 0.5
/// µs instead of 15.
class ResidueClasses {
  public:
    /// \param f must outlive this
    ResidueClasses(const PrimeField& field, const Vector& f);

    /// base^exponent; the base has lower degree than f, the exponent is positive.
    Vector power(const Vector& base, std::uint64_t exponent);
    /// (x + a)^exponent, the exponent being positive.
    Vector power_of_linear(Element a, std::uint64_t exponent);

  private:
    void multiply(Vector& a, const Vector& b);
    void multiply_by_linear(Vector& a, Element constant);
    void add_product(std::size_t place, Element factor, const Element* row, std::size_t count);

    const PrimeField& field_;
    const Vector& f_;
    std::vector<std::uint64_t> sums_;
    std::uint64_t capacity_;    ///< how many products, one of them a residue, fit in a sum
    std::uint64_t pending_ = 0; ///< products that a sum may hold
};

} // namespace eliminant::algebra::dense
