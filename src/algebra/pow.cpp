#include "eliminant/algebra/arithmetic.hpp"

#include "multiply_heap.hpp"
#include "multiply_keys.hpp"
#include "multiply_sums.hpp"

#include <limits>
#include <optional>
#include <utility>

namespace eliminant::algebra {

namespace {

constexpr std::uint64_t max_exponent = std::numeric_limits<std::uint64_t>::max() >> 1;

std::uint64_t checked_product(std::uint64_t a, std::uint64_t b) {
    std::uint64_t product = 0;
    if (__builtin_mul_overflow(a, b, &product) || product > max_exponent)
        throw OverflowError("power of a polynomial: an exponent or weighted degree exceeds 2^63 - 1");
    return product;
}

/// GMP ends the process when a number does not fit in memory by far; so that is an error here.
Integer checked_power(const Integer& base, std::uint64_t exponent) {
    constexpr std::size_t max_bits = std::size_t{1} << 36;
    if (base.bit_length() > 1 && exponent > max_bits / base.bit_length())
        throw OverflowError("power of a polynomial: a coefficient has more than 2^36 bits");
    // The base is 0 or ±1 where the exponent does not fit.
    if (exponent > std::numeric_limits<unsigned long>::max() / 2) exponent = 2 + exponent % 2;
    return pow(base, static_cast<unsigned long>(exponent));
}

/// The arithmetic of a recurrence: products of coefficients by the integers l − n·k, then division.
struct IntegerRecurrence {
    using Sums = IntegerSums;
    Sums sums;
    static Integer power(const Integer& c, std::uint64_t n) { return checked_power(c, n); }
    static Integer scaled(const Integer& c, std::int64_t factor) { return c * Integer(factor); }
    /// sum / (leading · factor), which is exact.
    static Integer divided(Integer sum, const Integer& leading, std::int64_t factor) {
        sum.divide_exactly(leading * Integer(factor));
        return sum;
    }
};

struct ResidueRecurrence {
    using Sums = ResidueSums;
    Sums sums;
    const PrimeField& field() const { return sums.field; }
    std::uint32_t residue(std::int64_t x) const { return field().from_integer(Integer(x)); }
    std::uint32_t power(std::uint32_t c, std::uint64_t n) const { return field().power(c, n); }
    std::uint32_t scaled(std::uint32_t c, std::int64_t factor) const {
        return field().multiply(c, residue(factor));
    }
    std::uint32_t divided(std::uint32_t sum, std::uint32_t leading, std::int64_t factor) const {
        return field().multiply(sum, field().inverse(field().multiply(leading, residue(factor))));
    }
};

/// g = f^n for f = Σ fᵢ x^kᵢ, k₀ > k₁ > …, in one variable (monomials as keys): f·x·g' = n·x·f'·g gives
///
///     g_l · f₀ · (n·k₀ − l) = Σ_{i ≥ 1} fᵢ · (l + k₀ − kᵢ − n·kᵢ) · g_(l + k₀ − kᵢ),
///
/// each term of g from larger ones, #f − 1 products a term (Euler; D. Knuth, TAOCP 2, §4.7, for dense f; with
/// the heap for sparse f: M. Monagan and R. Pearce, Sparse polynomial powering using heaps, CASC 2012). In
/// GF(p) it needs n·k₀ < p, so that no factor n·k₀ − l vanishes.
template <class Recurrence, class Emit>
void power_by_recurrence(const Recurrence& r, const std::vector<std::uint64_t>& keys, const auto& f,
                         std::uint64_t n, base::Run& run, Emit&& emit) {
    using Element = typename Recurrence::Sums::Element;
    std::vector<std::uint64_t> power_keys{n * keys[0]};
    std::vector<Element> power{r.power(f[0], n)};
    emit(power_keys[0], power[0]);
    ChainedHeap<std::uint64_t> heap(keys.size());
    std::vector<std::size_t> cursor(keys.size(), 0); // row i: the term of g that fᵢ meets next
    std::vector<std::uint32_t> active;
    std::vector<std::uint32_t> starved; // rows that wait for the next term of g
    const auto await = [&](std::uint32_t i) {
        if (cursor[i] == power.size()) {
            starved.push_back(i);
            return;
        }
        const std::uint64_t drop = keys[0] - keys[i];
        if (power_keys[cursor[i]] >= drop)
            heap.push(power_keys[cursor[i]] - drop, i); // else all further ones drop out
    };
    for (std::uint32_t i = 1; i < keys.size(); ++i) await(i);
    while (!heap.empty()) {
        const std::uint64_t key = heap.top();
        active.clear();
        heap.pop_all(active);
        typename Recurrence::Sums::Cell sum{};
        for (const std::uint32_t i : active) {
            run.poll();
            const std::uint64_t met = power_keys[cursor[i]];
            const auto factor = static_cast<std::int64_t>(met) - static_cast<std::int64_t>(n * keys[i]);
            r.sums.add(sum, r.scaled(f[i], factor), power[cursor[i]]);
        }
        Element value = r.sums.take(sum);
        for (const std::uint32_t i : active) {
            ++cursor[i];
            await(i);
        }
        if (Recurrence::Sums::is_zero(value)) continue;
        value = r.divided(std::move(value), f[0], static_cast<std::int64_t>(n * keys[0] - key));
        emit(key, value);
        power_keys.push_back(key);
        power.push_back(std::move(value));
        for (const std::uint32_t i : std::exchange(starved, {})) await(i);
    }
}

/// f^n by the recurrence, where it applies: keys of one word and, in GF(p), a large enough characteristic.
template <class Recurrence>
std::optional<TermList<typename Recurrence::Sums::Element>>
try_recurrence(const Recurrence& r, const Ring& ring, const TermList<typename Recurrence::Sums::Element>& f,
               std::uint64_t n, base::Run& run) {
    using Element = typename Recurrence::Sums::Element;
    const auto spans = field_spans(*f.layout, f.monomials);
    std::vector<FieldSpan> others = spans; // of f^(n − 1)
    for (FieldSpan& span : others) {
        checked_product(span.high, n);
        span.low *= n - 1;
        span.high *= n - 1;
    }
    const KeyLine line(ring.layout_for(widest_field(others, spans)), others, spans);
    if (line.words() != 1) return std::nullopt;
    const auto keys = line.encode(*f.layout, f.monomials, spans);
    const std::uint64_t limit =
        ring.field().is_rationals() ? max_exponent : ring.field().characteristic() - 1;
    if (keys[0] > limit / n) return std::nullopt;
    TermList<Element> result(line.target());
    KeyDecoder decoder(line);
    std::vector<MonomialLayout::Word> monomial(line.target().words());
    power_by_recurrence(r, keys, f.coefficients, n, run, [&](std::uint64_t key, const Element& value) {
        decode_key(decoder, key, monomial.data());
        result.push_back(monomial.data(), value);
    });
    return result;
}

Polynomial term_power(const Polynomial& f, std::uint64_t n) {
    const Ring& ring = f.ring();
    std::vector<std::uint64_t> exponents = f.monomial(0).exponents();
    for (auto& e : exponents) e = checked_product(e, n);
    PolynomialBuilder builder(ring);
    if (ring.field().is_rationals())
        builder.add(checked_power(f.integer_terms().coefficients[0], n), checked_power(f.denominator(), n),
                    exponents);
    else
        builder.add(Integer(ring.field().prime_field().power(f.residue_terms().coefficients[0], n)),
                    exponents);
    return builder.build();
}

} // namespace

Polynomial pow(const Polynomial& f, std::uint64_t exponent, base::Run& run) {
    const Ring& ring = f.ring();
    if (exponent == 0) return Polynomial::constant(ring, 1);
    if (exponent == 1 || f.is_zero()) return f;
    if (f.size() == 1) return term_power(f, exponent);
    if (ring.field().is_rationals()) {
        if (auto result = try_recurrence(IntegerRecurrence{}, ring, f.integer_terms(), exponent, run))
            return Polynomial::from_terms(ring, *std::move(result), checked_power(f.denominator(), exponent));
    } else if (auto result = try_recurrence(ResidueRecurrence{ResidueSums(ring.field().prime_field())}, ring,
                                            f.residue_terms(), exponent, run)) {
        return Polynomial::from_terms(ring, *std::move(result));
    }
    // Squaring from the top bit down: the other factor is always f itself.
    Polynomial result = f;
    for (int bit = 62 - __builtin_clzll(exponent); bit >= 0; --bit) {
        result = multiply(result, result, run);
        if ((exponent >> bit & 1) != 0) result = multiply(result, f, run);
    }
    return result;
}

Polynomial pow(const Polynomial& f, std::uint64_t exponent) {
    base::Run run;
    return pow(f, exponent, run);
}

} // namespace eliminant::algebra
