#include "implicit/curve_inversion.hpp"

#include "algebra/random.hpp"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

namespace eliminant::implicit {

namespace dense = algebra::dense;
using algebra::Polynomial;
using algebra::PrimeField;
using dense::Element;
using dense::Vector;

namespace {

std::size_t length_of(const MovingLine& line) {
    return std::max({line[0].size(), line[1].size(), line[2].size()});
}

/// The coefficients of the highest power of t.
std::array<Element, 3> leading_vector(const MovingLine& line) {
    const std::size_t length = length_of(line);
    std::array<Element, 3> result{};
    for (std::size_t k = 0; k < 3; ++k) result[k] = line[k].size() == length ? line[k].back() : 0;
    return result;
}

/// a·d − b·c
Element determinant(const PrimeField& field, Element a, Element b, Element c, Element d) {
    return field.subtract(field.multiply(a, d), field.multiply(b, c));
}

/// Factors of a linear combination, of as few of the lines as possible, in which leading vectors cancel;
/// empty if they are independent. Three leading vectors of syzygies are all orthogonal to that of the forms.
Vector leading_dependence(const PrimeField& field, const std::vector<MovingLine>& lines) {
    std::vector<std::array<Element, 3>> v;
    for (const MovingLine& line : lines) v.push_back(leading_vector(line));
    for (std::size_t i = 0; i < v.size(); ++i) {
        for (std::size_t j = i + 1; j < v.size(); ++j) {
            bool parallel = true;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t l = (k + 1) % 3;
                parallel = parallel && determinant(field, v[i][k], v[i][l], v[j][k], v[j][l]) == 0;
            }
            if (!parallel) continue;
            const std::size_t k = v[i][0] != 0 ? 0 : (v[i][1] != 0 ? 1 : 2);
            Vector factors(v.size(), 0);
            factors[i] = v[j][k];
            factors[j] = field.negate(v[i][k]);
            return factors;
        }
    }
    if (v.size() < 3) return {};
    for (std::size_t k = 0; k < 3; ++k) { // a plane of coordinates to which they project independently
        const std::size_t l = (k + 1) % 3;
        const Element first = determinant(field, v[1][k], v[1][l], v[2][k], v[2][l]);
        const Element second = determinant(field, v[2][k], v[2][l], v[0][k], v[0][l]);
        const Element third = determinant(field, v[0][k], v[0][l], v[1][k], v[1][l]);
        if (third != 0) return {first, second, third};
    }
    return {};
}

/// Replaces the longest of the lines with a factor by their combination, shifted to its length.
void reduce_longest(const PrimeField& field, std::vector<MovingLine>& lines, const Vector& factors) {
    std::size_t longest = lines.size();
    for (std::size_t i = 0; i < lines.size(); ++i)
        if (factors[i] != 0 && (longest == lines.size() || length_of(lines[i]) > length_of(lines[longest])))
            longest = i;
    const std::size_t length = length_of(lines[longest]);
    MovingLine sum;
    for (std::size_t k = 0; k < 3; ++k) {
        sum[k].assign(length, 0);
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (factors[i] != 0)
                dense::add_multiple<PrimeField>(
                    field, std::span(sum[k]).subspan(length - length_of(lines[i])), lines[i][k], factors[i]);
        dense::trim(sum[k]);
    }
    lines[longest] = std::move(sum);
    if (length_of(lines[longest]) == 0) lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(longest));
}

Vector negated(const PrimeField& field, Vector f) {
    for (Element& c : f) c = field.negate(c);
    return f;
}

/// u₀ + u₁x + u₂y, a polynomial in t.
Vector line_at(const PrimeField& field, const MovingLine& line, Element x, Element y) {
    Vector result = line[0];
    result.resize(length_of(line), 0);
    dense::add_multiple<PrimeField>(field, result, line[1], x);
    dense::add_multiple<PrimeField>(field, result, line[2], y);
    dense::trim(result);
    return result;
}

/// The first subresultant of f and g, deg f ≥ deg g, up to a sign that depends on degrees alone, by Euclid's
/// remainders r₀ = f, r₁ = g, …, r_k of degree 1: r_k times ∏ lc(rᵢ)^(deg rᵢ₋₁ − deg rᵢ₊₁) over 0 < i < k
/// (von zur Gathen and Gerhard, Modern Computer Algebra, §6.10). nullopt where degrees do not fall by one.
std::optional<std::pair<Element, Element>> first_subresultant(const PrimeField& field, Vector f, Vector g) {
    Element factor = 1;
    while (g.size() > 2) {
        const Element leading = g.back();
        const std::size_t length = f.size();
        static_cast<void>(dense::divide(field, f, g));
        std::swap(f, g);
        if (g.size() + 1 != f.size()) return std::nullopt;
        factor = field.multiply(factor, field.power(leading, length - g.size()));
    }
    if (g.size() != 2) return std::nullopt;
    return std::pair{field.multiply(factor, g[0]), field.multiply(factor, g[1])};
}

/// A polynomial of degree e in two variables by its values at (first + i, first + j), i + j ≤ e: rows[i][j].
/// Newton's scheme in both variables; what is left are the coefficients of xⁱyʲ.
void interpolate_triangle(const PrimeField& field, std::vector<Vector>& rows, Element first) {
    const std::size_t count = rows.size();
    const auto along = [&](std::size_t line, auto&& cell) {
        const std::size_t length = count - line;
        for (std::size_t r = 1; r < length; ++r) {
            const Element inverse = field.inverse(static_cast<Element>(r));
            for (std::size_t i = length - 1; i >= r; --i)
                cell(i) = field.multiply(field.subtract(cell(i), cell(i - 1)), inverse);
        }
    };
    const auto to_powers = [&](std::size_t line, auto&& cell) {
        const std::size_t length = count - line;
        for (std::size_t i = length - 1; i-- > 0;)
            for (std::size_t k = i; k + 1 < length; ++k)
                cell(k) = field.subtract(
                    cell(k), field.multiply(field.add(first, static_cast<Element>(i)), cell(k + 1)));
    };
    const auto row = [&rows](std::size_t i) {
        return [&rows, i](std::size_t j) -> Element& { return rows[i][j]; };
    };
    const auto column = [&rows](std::size_t j) {
        return [&rows, j](std::size_t i) -> Element& { return rows[i][j]; };
    };
    for (std::size_t i = 0; i < count; ++i) along(i, row(i));
    for (std::size_t j = 0; j < count; ++j) along(j, column(j));
    for (std::size_t i = 0; i < count; ++i) to_powers(i, row(i));
    for (std::size_t j = 0; j < count; ++j) to_powers(j, column(j));
}

} // namespace

std::optional<std::array<MovingLine, 2>> moving_line_basis(const PrimeField& field, MovingLine forms,
                                                           base::Run& run) {
    for (Vector& form : forms) dense::trim(form);
    const std::size_t length = length_of(forms);
    std::vector<MovingLine> lines = {MovingLine{forms[1], negated(field, forms[0]), Vector()},
                                     MovingLine{forms[2], Vector(), negated(field, forms[0])},
                                     MovingLine{Vector(), forms[2], negated(field, forms[1])}};
    std::erase_if(lines, [](const MovingLine& line) { return length_of(line) == 0; });
    for (;;) {
        run.poll();
        const Vector factors = leading_dependence(field, lines);
        if (factors.empty()) break;
        reduce_longest(field, lines, factors);
    }
    if (lines.size() != 2 || length_of(lines[0]) + length_of(lines[1]) != length + 1) return std::nullopt;
    if (length_of(lines[0]) < length_of(lines[1])) std::swap(lines[0], lines[1]);
    return std::array{std::move(lines[0]), std::move(lines[1])};
}

std::optional<Polynomial> curve_inversion_modulo(const PrimeField& field, const MovingLine& forms,
                                                 const algebra::Ring& ring, std::size_t t, std::uint64_t seed,
                                                 base::Run& run) {
    const auto basis = moving_line_basis(field, forms, run);
    if (!basis || length_of(basis->back()) < 2) return std::nullopt;
    const auto& [longer, shorter] = *basis;
    // Without a remainder the formula is the shorter line itself.
    const std::size_t degree = length_of(shorter) == 2 ? 1 : length_of(longer) + length_of(shorter) - 4;
    algebra::Random random(seed);
    const Element first = random.below(field.characteristic());
    std::array<std::vector<Vector>, 2> coefficients; // of 1 and of t
    for (std::size_t i = 0; i <= degree; ++i) {
        for (auto& rows : coefficients) rows.emplace_back(degree + 1 - i);
        for (std::size_t j = 0; i + j <= degree; ++j) {
            run.poll();
            const Element x = field.add(first, static_cast<Element>(i));
            const Element y = field.add(first, static_cast<Element>(j));
            Vector f = line_at(field, longer, x, y);
            Vector g = line_at(field, shorter, x, y);
            if (f.size() != length_of(longer) || g.size() != length_of(shorter)) return std::nullopt;
            const auto value = first_subresultant(field, std::move(f), std::move(g));
            if (!value) return std::nullopt;
            std::tie(coefficients[0][i][j], coefficients[1][i][j]) = *value;
        }
    }
    std::vector<std::size_t> plane; // x and y
    for (std::size_t k = 0; k < 3; ++k)
        if (k != t) plane.push_back(k);
    algebra::PolynomialBuilder builder(ring);
    for (std::size_t power = 0; power < 2; ++power) {
        interpolate_triangle(field, coefficients[power], first);
        for (std::size_t i = 0; i <= degree; ++i) {
            for (std::size_t j = 0; i + j <= degree; ++j) {
                if (coefficients[power][i][j] == 0) continue;
                std::array<std::uint64_t, 3> exponents{};
                exponents[t] = power;
                exponents[plane[0]] = i;
                exponents[plane[1]] = j;
                builder.add(algebra::Integer(coefficients[power][i][j]), exponents);
            }
        }
    }
    return builder.build().monic();
}

} // namespace eliminant::implicit
