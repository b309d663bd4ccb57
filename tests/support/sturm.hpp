/// \file
/// Sturm's theorem over the rationals: the slow twin of root isolation.
#pragma once

#include <gmpxx.h>

#include <cstddef>
#include <span>
#include <vector>

namespace eliminant::test {

using RationalPolynomial = std::vector<mpq_class>; ///< coefficient i belongs to t^i; no leading zeros

inline void trim(RationalPolynomial& p) {
    while (!p.empty() && p.back() == 0) p.pop_back();
}

inline mpq_class value_at(const RationalPolynomial& p, const mpq_class& t) {
    mpq_class sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = sum * t + p[i];
    return sum;
}

inline RationalPolynomial derivative(const RationalPolynomial& p) {
    RationalPolynomial result;
    for (std::size_t i = 1; i < p.size(); ++i) result.push_back(p[i] * static_cast<unsigned long>(i));
    return result;
}

inline RationalPolynomial remainder(RationalPolynomial a, const RationalPolynomial& b) {
    while (a.size() >= b.size()) {
        const mpq_class factor = a.back() / b.back();
        for (std::size_t i = 0; i < b.size(); ++i) a[a.size() - b.size() + i] -= factor * b[i];
        a.pop_back();
        trim(a);
    }
    return a;
}

/// The Sturm sequence of p ≠ 0; its last member is gcd(p, p') up to a factor.
class SturmSequence {
  public:
    explicit SturmSequence(RationalPolynomial p) {
        trim(p);
        sequence_.push_back(p);
        for (RationalPolynomial next = derivative(p); !next.empty();) {
            sequence_.push_back(next);
            next = remainder(sequence_[sequence_.size() - 2], sequence_.back());
            // Positive factors do not matter; without this one the coefficients would grow exponentially.
            const mpq_class scale = next.empty() ? mpq_class(1) : abs(next.back());
            for (mpq_class& c : next) c = -c / scale;
        }
        reduced_ = sequence_;
        for (RationalPolynomial& member : reduced_) member = quotient(member, sequence_.back());
    }

    /// The number of distinct roots in [a, b], a ≤ b.
    int roots(const mpq_class& a, const mpq_class& b) const {
        // Sturm counts (a, b] also where a is a root, multiple ones included.
        return variations(a) - variations(b) + (value_at(sequence_[0], a) == 0 ? 1 : 0);
    }

  private:
    int variations(const mpq_class& t) const {
        int count = 0;
        int previous = 0;
        for (const RationalPolynomial& p : reduced_) {
            const int sign = sgn(value_at(p, t));
            if (sign != 0 && previous != 0 && sign != previous) ++count;
            if (sign != 0) previous = sign;
        }
        return count;
    }
    static RationalPolynomial quotient(RationalPolynomial a, const RationalPolynomial& b) {
        RationalPolynomial result(a.size() >= b.size() ? a.size() - b.size() + 1 : 0);
        while (a.size() >= b.size()) {
            const mpq_class factor = a.back() / b.back();
            result[a.size() - b.size()] = factor;
            for (std::size_t i = 0; i < b.size(); ++i) a[a.size() - b.size() + i] -= factor * b[i];
            a.pop_back();
            trim(a);
        }
        return result;
    }

    std::vector<RationalPolynomial> sequence_;
    std::vector<RationalPolynomial> reduced_; ///< divided by gcd(p, p'), so that multiple roots count
};

inline RationalPolynomial rational(std::span<const mpz_class> p) {
    RationalPolynomial result(p.begin(), p.end());
    trim(result);
    return result;
}

} // namespace eliminant::test
