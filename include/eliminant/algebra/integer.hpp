#pragma once

#include "eliminant/base/wide.hpp"

#include <gmpxx.h>

#include <compare>
#include <concepts>
#include <cstdint>
#include <string>
#include <utility>

namespace eliminant::algebra {

/// Exact integer in eight bytes: values of at most 63 bits are stored inline, larger ones own a GMP integer.
///
/// Most coefficients of most computations are small; keeping them inline makes their arithmetic one or two
/// instructions and a vector of them contiguous. The representation is canonical: a value is inline exactly
/// when it fits, so equality of small values is equality of words.
///
///     word_   vvvv…vvv0   value v, shifted left by one
///             pppp…ppp1   pointer to an mpz_class, tagged in its lowest bit
///
/// Memory exhaustion surfaces as std::bad_alloc from the inline part; GMP's own allocator decides for limbs.
class Integer {
  public:
    Integer() noexcept = default;

    template <std::signed_integral T>
    Integer(T value) : word_(0) { // NOLINT(google-explicit-constructor): integers are numbers
        set_wide(static_cast<base::Int128>(value));
    }
    template <std::unsigned_integral T>
    Integer(T value) : word_(0) { // NOLINT(google-explicit-constructor)
        set_wide(static_cast<base::Int128>(value));
    }
    explicit Integer(const mpz_class& value);

    Integer(const Integer& other) : word_(other.is_small() ? other.word_ : clone(other.word_)) {}
    Integer(Integer&& other) noexcept : word_(std::exchange(other.word_, 0)) {}
    Integer& operator=(const Integer& other) {
        if (is_small() && other.is_small())
            word_ = other.word_;
        else
            assign_slow(other);
        return *this;
    }
    Integer& operator=(Integer&& other) noexcept {
        std::swap(word_, other.word_);
        return *this;
    }
    ~Integer() {
        if (!is_small()) release();
    }

    /// Value of 128 bits, the widest sum of products that the fast paths form.
    static Integer from_wide(base::Int128 value) {
        Integer result;
        result.set_wide(value);
        return result;
    }
    /// Decimal digits without sign or spaces; the caller has checked them.
    static Integer from_digits(const std::string& digits);

    bool is_small() const { return (word_ & 1) == 0; }
    /// The value; meaningful only when is_small().
    std::int64_t small_value() const { return word_ >> 1; }

    bool is_zero() const { return word_ == 0; }
    bool is_one() const { return word_ == 2; }
    int sign() const { return is_small() ? (word_ > 0) - (word_ < 0) : mpz_sgn(large().get_mpz_t()); }
    /// Number of bits of the absolute value; 0 for 0.
    std::size_t bit_length() const;

    mpz_class to_mpz() const;
    double to_double() const;
    std::string to_string() const;

    Integer& operator+=(const Integer& other) {
        std::int64_t sum = 0;
        if (((word_ | other.word_) & 1) == 0 && !__builtin_add_overflow(word_, other.word_, &sum))
            word_ = sum;
        else
            add_slow(other);
        return *this;
    }
    Integer& operator-=(const Integer& other) {
        std::int64_t difference = 0;
        if (((word_ | other.word_) & 1) == 0 && !__builtin_sub_overflow(word_, other.word_, &difference))
            word_ = difference;
        else
            subtract_slow(other);
        return *this;
    }
    Integer& operator*=(const Integer& other) {
        std::int64_t product = 0;
        if (((word_ | other.word_) & 1) == 0 && !__builtin_mul_overflow(word_, other.word_ >> 1, &product))
            word_ = product;
        else
            multiply_slow(other);
        return *this;
    }
    /// *this += a·b without a temporary for word-size operands.
    void add_product(const Integer& a, const Integer& b) {
        if (((word_ | a.word_ | b.word_) & 1) == 0)
            set_wide((word_ >> 1) + static_cast<base::Int128>(a.word_ >> 1) * (b.word_ >> 1));
        else
            add_product_slow(a, b);
    }
    /// *this −= a·b.
    void subtract_product(const Integer& a, const Integer& b) {
        if (((word_ | a.word_ | b.word_) & 1) == 0)
            set_wide((word_ >> 1) - static_cast<base::Int128>(a.word_ >> 1) * (b.word_ >> 1));
        else
            subtract_product_slow(a, b);
    }
    /// *this /= d, which must divide it and not be zero (unchecked: the quotient is garbage otherwise).
    void divide_exactly(const Integer& d);
    /// Quotient rounded towards −∞ and the remainder in [0, |d|) for d > 0. Throws DomainError for d = 0.
    static Integer floor_divide(const Integer& n, const Integer& d, Integer* remainder = nullptr);
    /// Whether d divides *this; then `quotient` is set. d = 0 divides only 0, with quotient 0.
    bool try_divide(const Integer& d, Integer& quotient) const;

    void negate() {
        // −(−2^62) does not fit inline; every other small value does.
        if (is_small())
            set_wide(-static_cast<base::Int128>(word_ >> 1));
        else
            negate_slow();
    }
    Integer operator-() const {
        Integer result(*this);
        result.negate();
        return result;
    }

    /// Residue in [0, modulus); modulus is not zero.
    std::uint64_t residue(std::uint64_t modulus) const;

    friend Integer operator+(Integer a, const Integer& b) { return a += b; }
    friend Integer operator-(Integer a, const Integer& b) { return a -= b; }
    friend Integer operator*(Integer a, const Integer& b) { return a *= b; }
    friend bool operator==(const Integer& a, const Integer& b) {
        // Canonical form: two values of which one is small are equal only as words.
        return a.word_ == b.word_ || (!a.is_small() && !b.is_small() && a.large() == b.large());
    }
    friend std::strong_ordering operator<=>(const Integer& a, const Integer& b) {
        if (a.is_small() && b.is_small()) return a.word_ <=> b.word_;
        return compare_slow(a, b) <=> 0;
    }
    /// Comparison of absolute values.
    friend std::strong_ordering compare_magnitude(const Integer& a, const Integer& b);

    /// Greatest common divisor, non-negative; gcd(0, 0) = 0.
    friend Integer gcd(const Integer& a, const Integer& b);
    friend Integer lcm(const Integer& a, const Integer& b);
    friend Integer abs(const Integer& a) { return a.sign() < 0 ? -a : a; }
    friend Integer pow(const Integer& base, unsigned long exponent);

    friend void swap(Integer& a, Integer& b) noexcept { std::swap(a.word_, b.word_); }

    /// Read-only GMP view of any Integer, valid while the Integer lives unchanged; no allocation.
    class View {
      public:
        explicit View(const Integer& value);
        View(const View&) = delete;
        View& operator=(const View&) = delete;
        operator mpz_srcptr() const { return pointer_; } // NOLINT(google-explicit-constructor)

      private:
        mp_limb_t limb_ = 0;
        mpz_t inline_;
        mpz_srcptr pointer_;
    };

  private:
    const mpz_class& large() const { return *reinterpret_cast<const mpz_class*>(word_ - 1); }
    mpz_class& large() { return *reinterpret_cast<mpz_class*>(word_ - 1); }

    void set_wide(base::Int128 value) {
        constexpr base::Int128 limit = static_cast<base::Int128>(1) << 62;
        if (value >= -limit && value < limit) [[likely]]
            set_small(static_cast<std::int64_t>(value));
        else
            set_wide_slow(value);
    }
    void set_small(std::int64_t value) {
        if (!is_small()) release();
        word_ = value * 2;
    }
    void release() noexcept;
    static std::int64_t clone(std::int64_t word);
    /// Makes room for a large value and returns it; its old value, if it was small, is carried over.
    mpz_class& promote();
    /// Restores the canonical form after an operation on a large value.
    void demote();

    void assign_slow(const Integer& other);
    void set_wide_slow(base::Int128 value);
    void add_slow(const Integer& other);
    void subtract_slow(const Integer& other);
    void multiply_slow(const Integer& other);
    void add_product_slow(const Integer& a, const Integer& b);
    void subtract_product_slow(const Integer& a, const Integer& b);
    void accumulate_slow(const Integer& a, const Integer& b,
                         void (*accumulate)(mpz_ptr, mpz_srcptr, mpz_srcptr));
    void negate_slow();
    static int compare_slow(const Integer& a, const Integer& b);

    std::int64_t word_ = 0;
};

/// The rational n/d in lowest terms; d is not zero.
mpq_class make_rational(const Integer& numerator, const Integer& denominator);

} // namespace eliminant::algebra

namespace eliminant {
using algebra::Integer;
} // namespace eliminant
