#pragma once

#include "eliminant/algebra/monomial_layout.hpp"
#include "eliminant/algebra/monomial_order.hpp"
#include "eliminant/algebra/prime_field.hpp"

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eliminant::algebra {

/// The coefficient field of a ring: ℚ, or GF(p) for a prime p below 2^31.
class CoefficientField {
  public:
    static CoefficientField rationals() { return {}; }
    /// Throws DomainError if p is not a prime below 2^31.
    static CoefficientField prime(std::uint64_t p) {
        CoefficientField field;
        field.prime_ = PrimeField(p);
        return field;
    }

    bool is_rationals() const { return !prime_.has_value(); }
    /// 0 for ℚ.
    std::uint32_t characteristic() const { return prime_ ? prime_->characteristic() : 0; }
    /// The field GF(p); only when !is_rationals().
    const PrimeField& prime_field() const { return *prime_; }
    /// `QQ` or `GF(p)`.
    std::string to_string() const;

    friend bool operator==(const CoefficientField&, const CoefficientField&) = default;

  private:
    CoefficientField() = default;
    std::optional<PrimeField> prime_;
};

/// A polynomial ring: coefficient field, variable names and monomial order; an immutable shared value.
///
/// Copies share one description, so copying and comparing rings is cheap. Two rings are equal if their
/// fields, names and orders are, no matter where they were made.
class Ring {
  public:
    /// Names are distinct identifiers: a letter, then letters, digits and underscores. Any number of
    /// variables, also none. Throws DomainError for a bad name, a repeated name or an order that does not
    /// fit.
    Ring(CoefficientField field, std::vector<std::string> names,
         MonomialOrder order = MonomialOrder::degrevlex());

    const CoefficientField& field() const;
    const MonomialOrder& order() const;
    std::size_t variable_count() const;
    const std::vector<std::string>& names() const;
    std::optional<std::size_t> index_of(std::string_view name) const;

    /// The same field and names with another order.
    Ring with_order(MonomialOrder order) const;
    Ring with_field(CoefficientField field) const;

    /// How monomials are packed at 8, 16, 32 or 64 bits a field. It lives as long as any copy of the ring.
    const MonomialLayout& layout(unsigned bits) const;
    /// The narrowest layout whose fields hold `max_field`. Throws OverflowError above 2^63 − 1.
    const MonomialLayout& layout_for(std::uint64_t max_field) const;

    /// For messages: `QQ[x, y, z], degrevlex`.
    std::string to_string() const;

    friend bool operator==(const Ring& a, const Ring& b);

  private:
    struct Data;
    std::shared_ptr<const Data> data_;
};

/// Throws RingMismatchError that prints both rings and says what was being done, unless they are equal.
void require_same_ring(const Ring& a, const Ring& b, std::string_view doing);

/// Whether text is a letter followed by letters, digits and underscores (ASCII).
bool is_identifier(std::string_view text);

} // namespace eliminant::algebra

namespace eliminant {
using algebra::CoefficientField;
using algebra::Ring;
} // namespace eliminant
