#pragma once

#include "eliminant/algebra/monomial.hpp"
#include "eliminant/algebra/ring.hpp"
#include "eliminant/algebra/term_list.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace eliminant::algebra {

/// A polynomial: terms strictly decreasing in its ring's order, no zero coefficients; a value.
///
/// Over ℚ it is stored as an integer polynomial over one positive denominator that is coprime to the content,
/// the form in which all algorithms work; over GF(p) as residues. A coefficient is presented as a rational
/// either way (a residue as the integer in [0, p)).
///
/// Operations on polynomials of different rings throw RingMismatchError; exponents from 2^63 on
/// OverflowError. The operators run to completion; long work has a named form that takes a Run
/// (arithmetic.hpp).
class Polynomial {
  public:
    /// Zero.
    explicit Polynomial(Ring ring);
    /// Over GF(p), throws DomainError if p divides the denominator.
    static Polynomial constant(const Ring& ring, const mpq_class& value);
    static Polynomial variable(const Ring& ring, std::size_t index);
    /// Throws DomainError if the ring has no such variable.
    static Polynomial variable(const Ring& ring, std::string_view name);
    static Polynomial term(const Monomial& monomial, const mpq_class& coefficient);

    const Ring& ring() const { return ring_; }
    bool is_zero() const { return size() == 0; }
    bool is_constant() const;
    bool is_one() const;
    /// Number of terms.
    std::size_t size() const;

    /// Term i, 0 ≤ i < size(), 0 being the leading one.
    Monomial monomial(std::size_t i) const { return {ring_, layout(), packed_monomial(i)}; }
    mpq_class coefficient(std::size_t i) const;
    std::uint64_t exponent(std::size_t i, std::size_t variable) const {
        return layout().exponent(packed_monomial(i), variable);
    }
    /// Coefficient of a monomial, 0 if it does not occur. O(log size).
    mpq_class coefficient_of(const Monomial& monomial) const;

    /// Leading data in the ring's order; throw DomainError for 0.
    Monomial leading_monomial() const;
    mpq_class leading_coefficient() const;
    Polynomial leading_term() const;
    /// Without the leading term; 0 for 0.
    Polynomial tail() const;

    /// Largest sum of exponents; −1 for 0.
    std::int64_t total_degree() const;
    /// Largest exponent of a variable; −1 for 0.
    std::int64_t degree(std::size_t variable) const;
    /// Whether all terms have the same total degree (0 has).
    bool is_homogeneous() const;

    Polynomial operator-() const;
    friend Polynomial operator+(const Polynomial& a, const Polynomial& b);
    friend Polynomial operator-(const Polynomial& a, const Polynomial& b);
    friend Polynomial operator*(const Polynomial& a, const Polynomial& b);
    Polynomial& operator+=(const Polynomial& other) { return *this = *this + other; }
    Polynomial& operator-=(const Polynomial& other) { return *this = *this - other; }
    Polynomial& operator*=(const Polynomial& other) { return *this = *this * other; }
    friend bool operator==(const Polynomial& a, const Polynomial& b);

    Polynomial scaled(const mpq_class& factor) const;
    Polynomial times_term(const Monomial& monomial, const mpq_class& coefficient) const;

    /// Divided by the leading coefficient; 0 stays 0.
    Polynomial monic() const;
    /// Over ℚ the primitive integer polynomial with positive leading coefficient of which *this is a rational
    /// multiple; over GF(p) monic(). 0 stays 0.
    Polynomial primitive_part() const;
    /// The rational c > 0 with *this = ± c · primitive_part() over ℚ; the leading coefficient over GF(p); 0
    /// for 0.
    mpq_class content() const;

    /// The image in `target` under variable i ↦ target variable variable_map[i]. Coefficients are mapped (ℚ
    /// to GF(p) throws DomainError where p divides the denominator; GF(p) to another field is a DomainError).
    /// A variable mapped to `dropped` must not occur (DomainError). O(n log n) for n terms.
    Polynomial in_ring(const Ring& target, std::span<const std::size_t> variable_map) const;
    /// The same, variables matched by name; names that occur in *this must exist in `target`.
    Polynomial in_ring(const Ring& target) const;
    static constexpr std::size_t dropped = ~std::size_t{0};

    // For algorithms: the packed form.

    const MonomialLayout& layout() const;
    const MonomialLayout::Word* packed_monomial(std::size_t i) const;
    /// Numerators over denominator(); only over ℚ.
    const IntegerTerms& integer_terms() const { return std::get<IntegerTerms>(terms_); }
    const Integer& denominator() const { return denominator_; }
    /// Only over GF(p).
    const ResidueTerms& residue_terms() const { return std::get<ResidueTerms>(terms_); }
    /// Takes sorted terms in one of the ring's layouts; over ℚ brings numerators and denominator (nonzero) to
    /// lowest terms.
    static Polynomial from_terms(Ring ring, IntegerTerms terms, Integer denominator = Integer(1));
    static Polynomial from_terms(Ring ring, ResidueTerms terms);

  private:
    Polynomial(Ring ring, std::variant<IntegerTerms, ResidueTerms> terms, Integer denominator);
    static Polynomial combine(const Polynomial& a, const Polynomial& b, bool subtract);

    Ring ring_;
    std::variant<IntegerTerms, ResidueTerms> terms_;
    Integer denominator_ = Integer(1); ///< positive; coprime to the numerators' content; 1 over GF(p)
};

/// Collects terms in any sequence, equal monomials adding up, and makes the polynomial of them.
///
/// Amortised O(1) a term, then one sort. Exponents widen the packing as needed.
class PolynomialBuilder {
  public:
    explicit PolynomialBuilder(Ring ring);
    /// Over ℚ adds numerator/denominator · monomial; denominator is not zero. Over GF(p) its image
    /// (DomainError where p divides the denominator). One exponent a variable.
    void add(const Integer& numerator, const Integer& denominator, std::span<const std::uint64_t> exponents);
    void add(const Integer& coefficient, std::span<const std::uint64_t> exponents) {
        add(coefficient, Integer(1), exponents);
    }
    std::size_t size() const;
    /// The sum of all that was added; the builder is empty afterwards.
    Polynomial build();

  private:
    void widen();

    Ring ring_;
    std::variant<IntegerTerms, ResidueTerms> terms_; ///< unsorted
    std::vector<Integer> denominators_;              ///< per term, once one differs from 1
    std::vector<MonomialLayout::Word> scratch_;
};

} // namespace eliminant::algebra

namespace eliminant {
using algebra::Polynomial;
using algebra::PolynomialBuilder;
} // namespace eliminant
