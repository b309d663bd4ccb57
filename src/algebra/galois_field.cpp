#include "galois_field.hpp"

#include "random.hpp"

namespace eliminant::algebra {

namespace {

/// GF(p)[x] modulo a monic polynomial of degree k; elements are their digits in base p, x^0 lowest.
class PolynomialQuotient {
  public:
    using Digits = std::vector<std::uint32_t>;

    /// `tail` is the modulus without its leading term.
    PolynomialQuotient(std::uint32_t p, const Digits& tail) : p_(p), size_(tail.size()) {
        for (std::uint64_t top = 0; top < p; ++top) {
            for (const std::uint32_t c : tail)
                reductions_.push_back(static_cast<std::uint32_t>(top * (p - c) % p));
        }
    }

    Digits one() const {
        Digits result(size_, 0);
        result[0] = 1;
        return result;
    }
    void multiply_by_x(Digits& a) const {
        const std::uint32_t* reduction = reductions_.data() + std::size_t{a.back()} * size_;
        for (std::size_t i = size_; i-- > 0;) {
            const std::uint32_t sum = (i == 0 ? 0 : a[i - 1]) + reduction[i];
            a[i] = sum >= p_ ? sum - p_ : sum;
        }
    }
    Digits multiply(const Digits& a, const Digits& b) const {
        Digits sum(size_, 0);
        for (std::size_t j = size_; j-- > 0;) {
            multiply_by_x(sum);
            for (std::size_t i = 0; i < size_; ++i)
                sum[i] = static_cast<std::uint32_t>((sum[i] + std::uint64_t{a[i]} * b[j]) % p_);
        }
        return sum;
    }
    /// x^exponent.
    Digits power_of_x(std::uint64_t exponent) const {
        Digits result = one();
        for (int bit = 63 - __builtin_clzll(exponent | 1); bit >= 0; --bit) {
            result = multiply(result, result);
            if ((exponent >> bit & 1) != 0) multiply_by_x(result);
        }
        return result;
    }

  private:
    std::uint32_t p_;
    std::size_t size_;
    Digits reductions_; ///< for each digit c that x shifts out, c·x^k reduced: k digits
};

std::vector<std::uint64_t> prime_divisors(std::uint64_t n) {
    std::vector<std::uint64_t> primes;
    for (std::uint64_t d = 2; d * d <= n; ++d) {
        if (n % d == 0) primes.push_back(d);
        while (n % d == 0) n /= d;
    }
    if (n > 1) primes.push_back(n);
    return primes;
}

/// A modulus for which x generates a cyclic group of order p^k − 1. Then all nonzero elements are powers of
/// x, so the quotient is a field, and no separate test of irreducibility is needed.
PolynomialQuotient primitive_quotient(std::uint32_t p, unsigned k, std::uint64_t group) {
    const auto primes = prime_divisors(group);
    Random random(p);
    while (true) {
        PolynomialQuotient::Digits tail(k);
        for (auto& digit : tail) digit = random.below(p);
        if (tail[0] == 0) continue;
        PolynomialQuotient quotient(p, tail);
        const auto one = quotient.one();
        if (quotient.power_of_x(group) != one) continue;
        bool primitive = true;
        for (const std::uint64_t r : primes) primitive = primitive && quotient.power_of_x(group / r) != one;
        if (primitive) return quotient;
    }
}

} // namespace

std::optional<unsigned> GaloisField::degree_for(std::uint32_t p, std::uint64_t size) {
    unsigned k = 1;
    std::uint64_t elements = p;
    for (; elements < size; elements *= p) ++k;
    return elements <= max_size ? std::optional(k) : std::nullopt;
}

GaloisField::GaloisField(std::uint32_t p, unsigned k, base::Run& run) : group_(1) {
    for (unsigned i = 0; i < k; ++i) group_ *= p;
    group_ -= 1;
    const PolynomialQuotient quotient = primitive_quotient(p, k, group_);
    // Number of an element: its digits read in base p. Adding 1 changes the lowest digit only.
    std::vector<std::uint32_t> number_of_power(group_);
    std::vector<Element> element_of_number(std::size_t{group_} + 1, 0);
    auto digits = quotient.one();
    for (std::uint32_t i = 0; i < group_; ++i) {
        if (i % 4096 == 0) run.poll();
        std::uint32_t number = 0;
        for (std::size_t j = digits.size(); j-- > 0;) number = number * p + digits[j];
        number_of_power[i] = number;
        element_of_number[number] = i + 1;
        quotient.multiply_by_x(digits);
    }
    successor_.resize(group_);
    for (std::uint32_t i = 0; i < group_; ++i) {
        const std::uint32_t number = number_of_power[i];
        successor_[i] = element_of_number[number % p == p - 1 ? number - (p - 1) : number + 1];
    }
    embedded_.assign(element_of_number.begin(), element_of_number.begin() + p);
    log_minus_one_ = embedded_[p - 1] - 1;
    residues_.resize(p - 1);
    for (std::uint32_t r = 1; r < p; ++r) residues_[(embedded_[r] - 1) / (group_ / (p - 1))] = r;
}

std::optional<std::uint32_t> GaloisField::residue(Element a) const {
    if (a == 0) return 0;
    // GF(p)* is the subgroup of order p − 1: the powers of g^((p^k − 1)/(p − 1)).
    const auto step = static_cast<std::uint32_t>(group_ / residues_.size());
    if ((a - 1) % step != 0) return std::nullopt;
    return residues_[(a - 1) / step];
}

} // namespace eliminant::algebra
