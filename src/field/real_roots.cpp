#include "eliminant/field/real_roots.hpp"

#include "dyadic.hpp"

#include "eliminant/algebra/gcd.hpp"
#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/algebra/ring.hpp"
#include "eliminant/base/error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace eliminant::field {
namespace {

using Coefficients = std::vector<mpz_class>;

/// The map x ↦ (start + width·x) / 2^shift of [0, 1] to the interval asked for.
struct Window {
    mpz_class start;
    mpz_class width;
    long shift = 0; ///< at least 0

    /// The image of numerator / 2^exponent, rounded to nearest.
    double at(const mpz_class& numerator, unsigned long exponent) const {
        mpz_class sum = start;
        mpz_mul_2exp(sum.get_mpz_t(), sum.get_mpz_t(), exponent);
        sum += width * numerator;
        const std::size_t bits = mpz_sizeinbase(sum.get_mpz_t(), 2);
        long dropped = 0;
        if (bits > 54) { // to 54 bits towards zero, then the last one away from it
            dropped = static_cast<long>(bits) - 53;
            mpz_tdiv_q_2exp(sum.get_mpz_t(), sum.get_mpz_t(), bits - 54);
            sum += sgn(sum);
            mpz_tdiv_q_2exp(sum.get_mpz_t(), sum.get_mpz_t(), 1);
        }
        return std::ldexp(sum.get_d(), static_cast<int>(dropped - static_cast<long>(exponent) - shift));
    }
};

/// A power of two that is at least every real root: Cauchy's bound 1 + max |c_i / c_n|.
double root_bound(std::span<const mpz_class> p) {
    std::size_t largest = 0;
    for (const mpz_class& c : p.first(p.size() - 1))
        largest = std::max(largest, mpz_sizeinbase(c.get_mpz_t(), 2));
    const std::size_t leading = mpz_sizeinbase(p.back().get_mpz_t(), 2);
    const double exponent = static_cast<double>(largest) - static_cast<double>(leading) + 2.0;
    if (exponent > 1023.0) throw base::OverflowError("real roots: a root may exceed the range of doubles");
    return std::ldexp(1.0, static_cast<int>(std::max(exponent, 1.0)));
}

Window make_window(std::span<const mpz_class> p, double lower, double upper) {
    if (std::isnan(lower) || std::isnan(upper) || std::isinf(lower))
        throw base::DomainError("real roots: the interval is not one of numbers");
    if (std::isinf(upper) && upper > 0.0) upper = std::max(root_bound(p), lower);
    const std::array bounds{lower, upper};
    const long exponent = std::min(common_exponent(bounds), 0L);
    Window window;
    window.start = scaled_integer(lower, exponent);
    window.width = scaled_integer(upper, exponent) - window.start;
    window.shift = -exponent;
    return window;
}

/// p ← p(x + 1).
void shift_by_one(Coefficients& p) {
    for (std::size_t i = 0; i + 1 < p.size(); ++i)
        for (std::size_t j = p.size() - 1; j-- > i;) p[j] += p[j + 1];
}

/// p(start + width·x) up to a positive factor: the roots on the window become those on [0, 1].
Coefficients on_unit_interval(std::span<const mpz_class> p, const Window& window) {
    Coefficients q(p.begin(), p.end());
    const std::size_t n = q.size() - 1;
    for (std::size_t i = 0; i <= n; ++i) {
        const auto bits = static_cast<mp_bitcnt_t>(window.shift) * static_cast<mp_bitcnt_t>(n - i);
        mpz_mul_2exp(q[i].get_mpz_t(), q[i].get_mpz_t(), bits);
    }
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = n; j-- > i;) q[j] += window.start * q[j + 1];
    mpz_class power = 1;
    for (std::size_t i = 1; i <= n; ++i) {
        power *= window.width;
        q[i] *= power;
    }
    return q;
}

/// Sign changes of (x + 1)^n p(1/(x + 1)): at least the number of roots in the open interval (0, 1), equal to
/// it if 0 or 1. Counting stops at 2.
int sign_variations(const Coefficients& p) {
    Coefficients reversed(p.rbegin(), p.rend());
    shift_by_one(reversed);
    int variations = 0;
    int previous = 0;
    for (const mpz_class& c : reversed) {
        const int sign = sgn(c);
        if (sign == 0) continue;
        if (previous != 0 && sign != previous && ++variations == 2) break;
        previous = sign;
    }
    return variations;
}

/// A root of a squarefree polynomial on [0, 1]: the point position / 2^level, or the only root of `local`
/// in (0, 1), where x stands for (position + x) / 2^level.
struct Isolated {
    mpz_class position;
    unsigned long level = 0;
    Coefficients local; ///< empty for a point
};

/// What is still to be searched: an open interval with the polynomial on it, not 0 at its start; or, without
/// polynomial, a point that is a root.
using Pending = Isolated;

void divide_by_x(Coefficients& p) { p.erase(p.begin()); }

/// Roots of a squarefree polynomial on [0, 1], ascending.
std::vector<Isolated> isolate(Coefficients p, bool first_only, base::Run& run) {
    std::vector<Pending> pending;
    mpz_class at_one = 0;
    for (const mpz_class& c : p) at_one += c;
    if (at_one == 0) pending.push_back({1, 0, {}});
    const bool root_at_zero = p[0] == 0;
    if (root_at_zero) divide_by_x(p);
    pending.push_back({0, 0, std::move(p)});
    if (root_at_zero) pending.push_back({0, 0, {}});

    std::vector<Isolated> roots;
    while (!pending.empty() && !(first_only && !roots.empty())) {
        run.poll();
        Pending item = std::move(pending.back());
        pending.pop_back();
        const int variations = item.local.empty() ? 1 : sign_variations(item.local);
        if (variations == 0) continue;
        if (variations == 1) {
            roots.push_back(std::move(item));
            continue;
        }

        Coefficients left = std::move(item.local);
        for (std::size_t i = 0; i < left.size(); ++i)
            mpz_mul_2exp(left[i].get_mpz_t(), left[i].get_mpz_t(), left.size() - 1 - i);
        Coefficients right = left;
        shift_by_one(right);
        const mpz_class middle = 2 * item.position + 1;
        const bool root_at_middle = right[0] == 0;
        if (root_at_middle) divide_by_x(right);
        pending.push_back({middle, item.level + 1, std::move(right)});
        if (root_at_middle) pending.push_back({middle, item.level + 1, {}});
        pending.push_back({2 * item.position, item.level + 1, std::move(left)});
    }
    return roots;
}

/// Sign of p(numerator / 2^exponent).
int sign_at(const Coefficients& p, const mpz_class& numerator, unsigned long exponent) {
    mpz_class value = p.back();
    mpz_class term;
    for (std::size_t i = p.size() - 1; i-- > 0;) {
        value *= numerator;
        mpz_mul_2exp(term.get_mpz_t(), p[i].get_mpz_t(), exponent * (p.size() - 1 - i));
        value += term;
    }
    return sgn(value);
}

/// The root as the nearest double, by bisection until both ends of the interval around it round to it.
double refine(const Isolated& root, const Window& window, base::Run& run) {
    if (root.local.empty()) return window.at(root.position, root.level);
    const int sign_before = sgn(root.local[0]);
    mpz_class left = 0; // the root is in (left, left + 1) / 2^bits of the isolating interval
    unsigned long bits = 0;
    const auto end = [&](const mpz_class& x) {
        mpz_class position = root.position;
        mpz_mul_2exp(position.get_mpz_t(), position.get_mpz_t(), bits);
        position += x;
        return window.at(position, root.level + bits);
    };
    constexpr unsigned long most_bits = 2200; // from the largest double to the smallest
    int agreeing = 0;                         // a root halfway between two doubles never has them agree
    while (bits < most_bits && agreeing < 16) {
        run.poll();
        ++bits;
        left *= 2;
        const mpz_class middle = left + 1;
        const int sign = sign_at(root.local, middle, bits);
        if (sign == 0) return end(middle);
        if (sign == sign_before) left = middle;
        if (root.level + bits < 50 || bits % 4 != 0) continue;
        const double low = end(left);
        const double high = end(left + 1);
        if (low == high) break;
        if (std::nextafter(low, high) == high) ++agreeing;
    }
    return end(left);
}

struct Part {
    Coefficients base;
    unsigned multiplicity = 1;
};

/// The squarefree decomposition by multiplicities.
std::vector<Part> squarefree_parts(const Coefficients& p, base::Run& run) {
    const algebra::Ring ring(algebra::CoefficientField::rationals(), {"t"}, algebra::MonomialOrder::lex());
    algebra::PolynomialBuilder builder(ring);
    for (std::size_t i = 0; i < p.size(); ++i) {
        const std::array<std::uint64_t, 1> exponents{i};
        if (p[i] != 0) builder.add(algebra::Integer(p[i]), exponents);
    }
    std::vector<Part> parts;
    for (const algebra::Factor& factor : squarefree_decomposition(builder.build(), run).factors) {
        Part part{Coefficients(static_cast<std::size_t>(factor.base.total_degree()) + 1),
                  static_cast<unsigned>(factor.multiplicity)};
        for (std::size_t i = 0; i < factor.base.size(); ++i)
            part.base[factor.base.exponent(i, 0)] = factor.base.coefficient(i).get_num();
        parts.push_back(std::move(part));
    }
    return parts;
}

/// Sign of p just below 0.
int sign_before_zero(const Coefficients& p) {
    const auto lowest = std::ranges::find_if(p, [](const mpz_class& c) { return c != 0; });
    return (lowest - p.begin()) % 2 == 0 ? sgn(*lowest) : -sgn(*lowest);
}

std::vector<RealRoot> find_roots(std::span<const mpz_class> coefficients, double lower, double upper,
                                 bool first_only, base::Run& run) {
    while (!coefficients.empty() && coefficients.back() == 0)
        coefficients = coefficients.first(coefficients.size() - 1);
    if (coefficients.empty())
        throw base::DomainError("real roots: every number is a root of the polynomial 0");
    const Window window = make_window(coefficients, lower, upper);
    std::vector<RealRoot> roots;
    if (lower > upper) return roots;
    Coefficients p = on_unit_interval(coefficients, window);
    if (window.width == 0) { // p(start + x): the multiplicity is the order at 0
        Window point = window;
        point.width = 1;
        p = on_unit_interval(coefficients, point);
        if (p[0] != 0) return roots;
        const auto order = std::ranges::find_if(p, [](const mpz_class& c) { return c != 0; }) - p.begin();
        return {{lower, static_cast<unsigned>(order), sign_before_zero(p)}};
    }
    for (const Part& part : squarefree_parts(p, run))
        for (const Isolated& root : isolate(part.base, first_only, run))
            roots.push_back({refine(root, window, run), part.multiplicity, 0});
    std::ranges::stable_sort(roots, {}, &RealRoot::value);
    int sign = sign_before_zero(p);
    for (RealRoot& root : roots) {
        root.sign_before = sign;
        if (root.multiplicity % 2 != 0) sign = -sign;
    }
    if (first_only && roots.size() > 1) roots.resize(1);
    return roots;
}

} // namespace

std::vector<RealRoot> real_roots(std::span<const mpz_class> coefficients, double lower, double upper,
                                 base::Run& run) {
    return find_roots(coefficients, lower, upper, false, run);
}

std::optional<RealRoot> first_real_root(std::span<const mpz_class> coefficients, double lower, double upper,
                                        base::Run& run) {
    const std::vector<RealRoot> roots = find_roots(coefficients, lower, upper, true, run);
    if (roots.empty()) return std::nullopt;
    return roots.front();
}

} // namespace eliminant::field
