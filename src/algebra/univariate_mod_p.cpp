#include "univariate_mod_p.hpp"

#include "residue_rows.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::algebra::dense {

namespace {

/// Rows that are shorter are not worth a call of vector code and what it prepares.
constexpr std::size_t short_row = 24;

/// r[i] = s·r[i] + t·b[i−1] + u·b[i] for 0 ≤ i < n, with b[−1] = 0: one remainder of a gcd without an
/// inversion. Three products of residues below 2^31 fit in 64 bits, so a coefficient costs one reduction.
void combine(const PrimeField& field, Vector& r, const Vector& b, std::size_t n, Element s, Element t,
             Element u) {
    r[0] = field.reduce(std::uint64_t{s} * r[0] + std::uint64_t{u} * b[0]);
    if (n > short_row) {
        const std::uint32_t p = field.characteristic();
        residue_rows().combine(r.data() + 1, b.data(), n - 1, {s, p}, {t, p}, {u, p}, p);
        return;
    }
    for (std::size_t i = 1; i < n; ++i)
        r[i] = field.reduce(std::uint64_t{s} * r[i] + std::uint64_t{t} * b[i - 1] + std::uint64_t{u} * b[i]);
}

void combine(const GaloisField& field, Vector& r, const Vector& b, std::size_t n, Element s, Element t,
             Element u) {
    for (std::size_t i = 0; i < n; ++i) {
        Element sum = field.add(field.multiply(s, r[i]), field.multiply(u, b[i]));
        if (i > 0) sum = field.add(sum, field.multiply(t, b[i - 1]));
        r[i] = sum;
    }
}

/// Replaces a by a nonzero multiple of its remainder modulo b, deg a = deg b + 1. With leading coefficients α
/// of a, β of b and the next ones α', β', the quotient of β²·a by b is αβ·x + (βα' − αβ').
template <class Field>
void remainder_of_next_degree(const Field& field, Vector& a, const Vector& b) {
    const std::size_t n = b.size() - 1; // degree of b
    const Element lead = b[n];
    const Element quotient1 = field.multiply(a[n + 1], lead);
    const Element below = n == 0 ? 0 : b[n - 1];
    const Element quotient0 = field.subtract(field.multiply(lead, a[n]), field.multiply(a[n + 1], below));
    if (n == 0) {
        a.clear();
        return;
    }
    combine(field, a, b, n, field.multiply(lead, lead), field.negate(quotient1), field.negate(quotient0));
    a.resize(n);
    trim(a);
}

} // namespace

template <>
void add_multiple(const PrimeField& field, std::span<Element> a, std::span<const Element> b, Element factor) {
    const std::uint32_t p = field.characteristic();
    if (b.size() > short_row) {
        residue_rows().add_multiple(a.data(), b.data(), b.size(), ResidueFactor(factor, p), p);
        return;
    }
    for (std::size_t i = 0; i < b.size(); ++i) a[i] = field.reduce(a[i] + std::uint64_t{factor} * b[i]);
}

template <>
void add_multiple(const GaloisField& field, std::span<Element> a, std::span<const Element> b,
                  Element factor) {
    for (std::size_t i = 0; i < b.size(); ++i) a[i] = field.add(a[i], field.multiply(factor, b[i]));
}

template <class Field>
Element evaluate(const Field& field, std::span<const Element> f, Element x) {
    Element value = 0;
    for (std::size_t i = f.size(); i-- > 0;) value = field.add(field.multiply(value, x), f[i]);
    return value;
}

template <class Field>
Vector powers(const Field& field, Element x, std::size_t count) {
    Vector result(count, 1);
    for (std::size_t i = 1; i < count; ++i) result[i] = field.multiply(result[i - 1], x);
    return result;
}

template <class Field>
Vector multiply(const Field& field, const Vector& a, const Vector& b) {
    if (a.empty() || b.empty()) return {};
    Vector product(a.size() + b.size() - 1, 0);
    for (std::size_t i = 0; i < a.size(); ++i)
        add_multiple<Field>(field, std::span(product).subspan(i), b, a[i]);
    return product; // a field has no zero divisors: the leading coefficient is not 0
}

template <class Field>
Vector divide(const Field& field, Vector& a, const Vector& b) {
    if (a.size() < b.size()) return {};
    Vector quotient(a.size() - b.size() + 1, 0);
    const Element inverse = field.inverse(b.back());
    for (std::size_t i = quotient.size(); i-- > 0;) {
        quotient[i] = field.multiply(a[i + b.size() - 1], inverse);
        if (quotient[i] != 0)
            add_multiple<Field>(field, std::span(a).subspan(i), b, field.negate(quotient[i]));
    }
    trim(a);
    return quotient;
}

template <class Field>
void make_monic(const Field& field, Vector& f) {
    if (f.empty() || f.back() == 1) return;
    const Element inverse = field.inverse(f.back());
    for (Element& c : f) c = field.multiply(c, inverse);
}

template <class Field>
Vector gcd(const Field& field, Vector a, Vector b, base::Run& run) {
    if (a.size() < b.size()) std::swap(a, b);
    while (!b.empty()) {
        run.poll();
        if (b.size() == 1) return {1};
        if (a.size() == b.size() + 1)
            remainder_of_next_degree(field, a, b);
        else
            divide(field, a, b);
        std::swap(a, b);
    }
    make_monic(field, a);
    return a;
}

template <class Field>
void multiply_by_root(const Field& field, Vector& f, Element root) {
    const Element minus = field.negate(root);
    f.push_back(f.back());
    for (std::size_t i = f.size() - 2; i > 0; --i) f[i] = field.add(f[i - 1], field.multiply(minus, f[i]));
    f[0] = field.multiply(minus, f[0]);
}

template <class Field>
Vector interpolate(const Field& field, std::span<const Element> points, std::span<const Element> values) {
    Vector f(points.size(), 0);
    Vector master = {1}; // ∏ (x − points[j]) over the points used
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Element gap = field.subtract(values[i], evaluate<Field>(field, f, points[i]));
        const Element height = evaluate<Field>(field, master, points[i]);
        add_multiple<Field>(field, f, master, field.multiply(gap, field.inverse(height)));
        multiply_by_root(field, master, points[i]);
    }
    trim(f);
    return f;
}

#define ELIMINANT_INSTANTIATE(Field)                                                                         \
    template Element evaluate(const Field&, std::span<const Element>, Element);                              \
    template Vector powers(const Field&, Element, std::size_t);                                              \
    template Vector multiply(const Field&, const Vector&, const Vector&);                                    \
    template Vector divide(const Field&, Vector&, const Vector&);                                            \
    template void make_monic(const Field&, Vector&);                                                         \
    template Vector gcd(const Field&, Vector, Vector, base::Run&);                                           \
    template void multiply_by_root(const Field&, Vector&, Element);                                          \
    template Vector interpolate(const Field&, std::span<const Element>, std::span<const Element>);
ELIMINANT_INSTANTIATE(PrimeField)
ELIMINANT_INSTANTIATE(GaloisField)
#undef ELIMINANT_INSTANTIATE

} // namespace eliminant::algebra::dense
