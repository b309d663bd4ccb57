#include "eliminant/algebra/integer.hpp"

#include "eliminant/base/error.hpp"

#include <cstdlib>
#include <limits>
#include <memory>
#include <numeric>

namespace eliminant::algebra {

namespace {

std::uint64_t magnitude(std::int64_t value) {
    return value < 0 ? ~static_cast<std::uint64_t>(value) + 1 : static_cast<std::uint64_t>(value);
}

} // namespace

Integer::View::View(const Integer& value) : inline_{} {
    if (value.is_small()) {
        limb_ = magnitude(value.small_value());
        pointer_ = mpz_roinit_n(inline_, &limb_, value.sign());
    } else {
        pointer_ = value.large().get_mpz_t();
    }
}

Integer::Integer(const mpz_class& value) : word_(0) {
    constexpr std::int64_t limit = std::int64_t{1} << 62;
    if (value.fits_slong_p() && value.get_si() >= -limit && value.get_si() < limit) {
        word_ = value.get_si() * 2;
    } else {
        word_ = reinterpret_cast<std::int64_t>(new mpz_class(value)) + 1;
    }
}

Integer Integer::from_digits(const std::string& digits) {
    // 18 decimal digits always fit in 62 bits.
    if (digits.size() <= 18) return {std::strtoll(digits.c_str(), nullptr, 10)};
    return Integer(mpz_class(digits, 10));
}

std::size_t Integer::bit_length() const { return is_zero() ? 0 : mpz_sizeinbase(View(*this), 2); }

mpz_class Integer::to_mpz() const { return is_small() ? mpz_class(small_value()) : large(); }

double Integer::to_double() const {
    return is_small() ? static_cast<double>(small_value()) : large().get_d();
}

std::string Integer::to_string() const {
    return is_small() ? std::to_string(small_value()) : large().get_str();
}

void Integer::release() noexcept {
    delete &large();
    word_ = 0;
}

std::int64_t Integer::clone(std::int64_t word) {
    const auto& source = *reinterpret_cast<const mpz_class*>(word - 1);
    return reinterpret_cast<std::int64_t>(new mpz_class(source)) + 1;
}

mpz_class& Integer::promote() {
    if (is_small()) word_ = reinterpret_cast<std::int64_t>(new mpz_class(small_value())) + 1;
    return large();
}

void Integer::demote() {
    const mpz_class& value = large();
    constexpr std::int64_t limit = std::int64_t{1} << 62;
    if (mpz_size(value.get_mpz_t()) > 1 || !value.fits_slong_p()) return;
    const std::int64_t small = value.get_si();
    if (small >= -limit && small < limit) set_small(small);
}

void Integer::assign_slow(const Integer& other) {
    if (this == &other) return;
    if (other.is_small()) {
        release();
        word_ = other.word_;
    } else if (is_small()) {
        word_ = clone(other.word_);
    } else {
        large() = other.large();
    }
}

void Integer::set_wide_slow(base::Int128 value) {
    const bool negative = value < 0;
    const auto bits = negative ? ~static_cast<base::UInt128>(value) + 1 : static_cast<base::UInt128>(value);
    const mp_limb_t limbs[2] = {static_cast<mp_limb_t>(bits), static_cast<mp_limb_t>(bits >> 64)};
    mpz_t view;
    const mp_size_t size = limbs[1] != 0 ? 2 : 1;
    mpz_srcptr source = mpz_roinit_n(view, limbs, negative ? -size : size);
    if (is_small())
        word_ = reinterpret_cast<std::int64_t>(new mpz_class(source)) + 1;
    else
        mpz_set(large().get_mpz_t(), source);
}

void Integer::add_slow(const Integer& other) {
    const View right(other);
    mpz_class& self = promote();
    mpz_add(self.get_mpz_t(), self.get_mpz_t(), right);
    demote();
}

void Integer::subtract_slow(const Integer& other) {
    if (this == &other) {
        set_small(0);
        return;
    }
    const View right(other);
    mpz_class& self = promote();
    mpz_sub(self.get_mpz_t(), self.get_mpz_t(), right);
    demote();
}

void Integer::multiply_slow(const Integer& other) {
    if (other.is_zero()) {
        set_small(0);
        return;
    }
    if (this == &other) {
        mpz_class& self = promote();
        mpz_mul(self.get_mpz_t(), self.get_mpz_t(), self.get_mpz_t());
        demote();
        return;
    }
    const View right(other);
    mpz_class& self = promote();
    mpz_mul(self.get_mpz_t(), self.get_mpz_t(), right);
    demote();
}

void Integer::accumulate_slow(const Integer& a, const Integer& b,
                              void (*accumulate)(mpz_ptr, mpz_srcptr, mpz_srcptr)) {
    if (a.is_zero() || b.is_zero()) return;
    if (this == &a || this == &b) { // promotion would pull the operand away under its view
        accumulate_slow(a * b, Integer(1), accumulate);
        return;
    }
    const View left(a);
    const View right(b);
    accumulate(promote().get_mpz_t(), left, right);
    demote();
}

void Integer::add_product_slow(const Integer& a, const Integer& b) { accumulate_slow(a, b, mpz_addmul); }
void Integer::subtract_product_slow(const Integer& a, const Integer& b) { accumulate_slow(a, b, mpz_submul); }

void Integer::negate_slow() {
    mpz_class& self = large();
    mpz_neg(self.get_mpz_t(), self.get_mpz_t());
    demote(); // 2^62 is large, −2^62 is not
}

int Integer::compare_slow(const Integer& a, const Integer& b) { return mpz_cmp(View(a), View(b)); }

std::strong_ordering compare_magnitude(const Integer& a, const Integer& b) {
    if (a.is_small() && b.is_small()) return magnitude(a.small_value()) <=> magnitude(b.small_value());
    return mpz_cmpabs(Integer::View(a), Integer::View(b)) <=> 0;
}

void Integer::divide_exactly(const Integer& d) {
    if (is_small() && d.is_small()) {
        set_wide(static_cast<base::Int128>(small_value() / d.small_value()));
        return;
    }
    if (this == &d) {
        set_small(1);
        return;
    }
    const View divisor(d);
    mpz_class& self = promote();
    mpz_divexact(self.get_mpz_t(), self.get_mpz_t(), divisor);
    demote();
}

Integer Integer::floor_divide(const Integer& n, const Integer& d, Integer* remainder) {
    if (d.is_zero()) throw DomainError("division of an integer by zero");
    mpz_class quotient;
    mpz_class rest;
    mpz_fdiv_qr(quotient.get_mpz_t(), rest.get_mpz_t(), View(n), View(d));
    if (remainder != nullptr) *remainder = Integer(rest);
    return Integer(quotient);
}

bool Integer::try_divide(const Integer& d, Integer& quotient) const {
    if (d.is_zero()) {
        quotient = Integer();
        return is_zero();
    }
    if (is_small() && d.is_small()) {
        const std::int64_t n = small_value();
        const std::int64_t m = d.small_value();
        if (n % m != 0) return false;
        quotient = from_wide(static_cast<base::Int128>(n / m));
        return true;
    }
    if (is_small()) { // 0 < |n| < |d|, as large values exceed every small one, but for n = ∓2^62, d = 2^62
        if (!is_zero() && compare_magnitude(*this, d) < 0) return false;
    }
    if (!mpz_divisible_p(View(*this), View(d))) return false;
    mpz_class result;
    mpz_divexact(result.get_mpz_t(), View(*this), View(d));
    quotient = Integer(result);
    return true;
}

std::uint64_t Integer::residue(std::uint64_t modulus) const {
    if (is_small()) {
        const std::int64_t value = small_value();
        const std::uint64_t r = magnitude(value) % modulus;
        return value < 0 && r != 0 ? modulus - r : r;
    }
    return mpz_fdiv_ui(large().get_mpz_t(), modulus);
}

Integer gcd(const Integer& a, const Integer& b) {
    if (a.is_small() && b.is_small())
        return Integer::from_wide(
            static_cast<base::Int128>(std::gcd(magnitude(a.small_value()), magnitude(b.small_value()))));
    if (a.is_zero()) return abs(b);
    if (b.is_zero()) return abs(a);
    if (a.is_small() || b.is_small()) { // the result fits in a word
        const Integer& small = a.is_small() ? a : b;
        const Integer& big = a.is_small() ? b : a;
        return {mpz_gcd_ui(nullptr, Integer::View(big), magnitude(small.small_value()))};
    }
    mpz_class result;
    mpz_gcd(result.get_mpz_t(), Integer::View(a), Integer::View(b));
    return Integer(result);
}

Integer lcm(const Integer& a, const Integer& b) {
    if (a.is_zero() || b.is_zero()) return {};
    Integer result = abs(a);
    result.divide_exactly(gcd(a, b));
    return result * abs(b);
}

Integer pow(const Integer& base, unsigned long exponent) {
    mpz_class result;
    mpz_pow_ui(result.get_mpz_t(), Integer::View(base), exponent);
    return Integer(result);
}

mpq_class make_rational(const Integer& numerator, const Integer& denominator) {
    mpq_class result(numerator.to_mpz(), denominator.to_mpz());
    result.canonicalize();
    return result;
}

} // namespace eliminant::algebra
