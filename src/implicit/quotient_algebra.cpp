#include "implicit/quotient_algebra.hpp"

#include "algebra/univariate_mod_p.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace eliminant::implicit {

namespace dense = algebra::dense;
using algebra::PrimeField;

namespace {

/// words[i] += factor·row[i]. Compilers make it a loop of widening vector multiplications.
void add_products(std::uint64_t* words, Residue factor, const Residue* row, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) words[i] += std::uint64_t{factor} * row[i];
}

} // namespace

Residue dot_product(const PrimeField& field, std::span<const Residue> a, std::span<const Residue> b) {
    std::uint64_t sum = 0;
    for (std::size_t begin = 0; begin < a.size(); begin += short_products_in_word) {
        const std::size_t end = std::min(a.size(), begin + short_products_in_word);
        for (std::size_t i = begin; i < end; ++i) sum += std::uint64_t{a[i]} * b[i];
        sum = field.reduce(sum);
    }
    return static_cast<Residue>(sum);
}

QuotientAlgebra::QuotientAlgebra(const PrimeField& field, Residues modulus, const base::Run& run)
    : field_(field), run_(run), modulus_(std::move(modulus)), negated_tail_(modulus_.size() - 1),
      wide_(2 * modulus_.size()) {
    for (std::size_t i = 0; i < negated_tail_.size(); ++i) negated_tail_[i] = field.negate(modulus_[i]);
}

void QuotientAlgebra::fold(std::size_t end) const {
    for (std::size_t i = 0; i < end; ++i) wide_[i] = field_.reduce(wide_[i]);
    pending_ = 1;
}

void QuotientAlgebra::accumulate(std::size_t at, Residue factor, std::span<const Residue> row) const {
    if (pending_ == short_products_in_word) fold(wide_.size());
    ++pending_;
    add_products(wide_.data() + at, factor, row.data(), row.size());
}

/// The class of the polynomial of `length` coefficients in wide_: tⁿ⁺ⁱ becomes tⁱ·(−R without leading term).
Residues QuotientAlgebra::reduced(std::size_t length) const {
    const std::size_t n = dimension();
    for (std::size_t i = length; i-- > n;) {
        const Residue top = field_.reduce(wide_[i]);
        if (top != 0) accumulate(i - n, top, negated_tail_);
    }
    Residues result(n, 0);
    for (std::size_t i = 0; i < std::min(n, length); ++i) result[i] = field_.reduce(wide_[i]);
    return result;
}

Residues QuotientAlgebra::element(Residues polynomial) const {
    if (polynomial.size() <= dimension()) {
        polynomial.resize(dimension(), 0);
        return polynomial;
    }
    wide_.assign(std::max(polynomial.size(), 2 * modulus_.size()), 0);
    std::copy(polynomial.begin(), polynomial.end(), wide_.begin());
    pending_ = 1;
    return reduced(polynomial.size());
}

Residues QuotientAlgebra::multiply(std::span<const Residue> a, std::span<const Residue> b) const {
    run_.poll();
    const std::size_t n = dimension();
    std::fill(wide_.begin(), wide_.begin() + static_cast<std::ptrdiff_t>(2 * n), 0);
    pending_ = 0;
    for (std::size_t i = 0; i < n; ++i)
        if (a[i] != 0) accumulate(i, a[i], b);
    return reduced(2 * n - 1);
}

Residues QuotientAlgebra::value(std::span<const Residues> coefficients, std::span<const Residue> a) const {
    Residues result(dimension(), 0);
    for (std::size_t i = coefficients.size(); i-- > 0;) {
        if (i + 1 < coefficients.size()) result = multiply(result, a);
        const Residues term = element(coefficients[i]);
        for (std::size_t j = 0; j < result.size(); ++j) result[j] = field_.add(result[j], term[j]);
    }
    return result;
}

/// Euclid's algorithm on R and a, with the cofactors of a alone.
std::optional<Residues> QuotientAlgebra::inverse(const Residues& a) const {
    Residues r0 = modulus_;
    Residues r1 = a;
    dense::trim(r1);
    Residues v0;
    Residues v1 = {1};
    while (r1.size() > 1) {
        run_.poll();
        const Residues quotient = dense::divide(field_, r0, r1);
        std::swap(r0, r1);
        Residues product = dense::multiply(field_, quotient, v1);
        product.resize(std::max(product.size(), v0.size()), 0);
        for (std::size_t i = 0; i < product.size(); ++i)
            product[i] = field_.subtract(i < v0.size() ? v0[i] : 0, product[i]);
        v0 = std::exchange(v1, std::move(product));
    }
    if (r1.empty()) return std::nullopt;
    const Residue scale = field_.inverse(r1[0]);
    for (Residue& c : v1) c = field_.multiply(c, scale);
    return element(std::move(v1));
}

/// tr(tⁱ) for 0 ≤ i < 2n − 1, the power sums of the roots of R.
const Residues& QuotientAlgebra::traces_of_generator() const {
    if (!traces_.empty()) return traces_;
    const std::size_t n = dimension();
    // With R = tⁿ + r₁tⁿ⁻¹ + … + rₙ: sₖ = −r₁sₖ₋₁ − … − rₖ₋₁s₁ − k·rₖ for k ≤ n, and the recurrence of R
    // beyond.
    const Residues recurrence(negated_tail_.rbegin(), negated_tail_.rend());
    traces_.assign(1, field_.reduce(n));
    for (std::size_t k = 1; k + 1 < 2 * n; ++k) {
        run_.poll();
        std::uint64_t sum = 0;
        const std::size_t terms = std::min(k - 1, n);
        for (std::size_t i = 0; i < terms; ++i) {
            sum += std::uint64_t{recurrence[i]} * traces_[k - 1 - i];
            if (i % short_products_in_word == short_products_in_word - 1) sum = field_.reduce(sum);
        }
        sum = field_.reduce(sum);
        if (k <= n) sum += std::uint64_t{recurrence[k - 1]} * k;
        traces_.push_back(field_.reduce(sum));
    }
    return traces_;
}

Residues QuotientAlgebra::traces_of_powers(const Residues& a, std::size_t count) const {
    const std::size_t n = dimension();
    const Residues& traces = traces_of_generator();
    const auto steps =
        std::max<std::size_t>(1, static_cast<std::size_t>(std::sqrt(static_cast<double>(count))));
    std::vector<Residues> baby = {a};
    while (baby.size() < steps) baby.push_back(multiply(baby.back(), a));

    Residues result;
    Residues giant = element({1});
    Residues functional(n); // x ↦ tr(giant·x) on the powers of t
    while (result.size() < count) {
        for (std::size_t i = 0; i < n; ++i)
            functional[i] = dot_product(field_, giant, std::span(traces).subspan(i, n));
        for (std::size_t i = 0; i < steps && result.size() < count; ++i)
            result.push_back(dot_product(field_, baby[i], functional));
        if (result.size() < count) giant = multiply(giant, baby.back());
    }
    return result;
}

Residues from_power_sums(const PrimeField& field, std::span<const Residue> sums) {
    const std::size_t n = sums.size();
    Residues backwards(n + 1, 0); // coefficients from the leading one down
    backwards[0] = 1;
    for (std::size_t k = 1; k <= n; ++k) {
        std::uint64_t sum = 0;
        for (std::size_t i = 1; i <= k; ++i) {
            sum += std::uint64_t{backwards[k - i]} * sums[i - 1];
            if (i % short_products_in_word == 0) sum = field.reduce(sum);
        }
        const Residue inverse = field.inverse(field.reduce(k));
        backwards[k] = field.negate(field.multiply(field.reduce(sum), inverse));
    }
    return {backwards.rbegin(), backwards.rend()};
}

} // namespace eliminant::implicit
