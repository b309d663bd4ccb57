#include "eliminant/algebra/polynomial.hpp"

#include "eliminant/base/error.hpp"

#include "term_arithmetic.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::algebra {

namespace {

using Terms = std::variant<IntegerTerms, ResidueTerms>;

Terms empty_terms(const Ring& ring, const MonomialLayout& layout) {
    if (ring.field().is_rationals()) return IntegerTerms(layout);
    return ResidueTerms(layout);
}

/// Numerators over a denominator in lowest terms: coprime, denominator positive.
void reduce_fraction(IntegerTerms& terms, Integer& denominator) {
    if (denominator.is_one()) return;
    if (terms.empty()) {
        denominator = Integer(1);
        return;
    }
    Integer common = denominator;
    for (const Integer& c : terms.coefficients) {
        common = gcd(common, c);
        if (common.is_one()) break;
    }
    common = abs(common);
    if (denominator.sign() < 0) common.negate();
    if (common.is_one()) return;
    for (Integer& c : terms.coefficients) c.divide_exactly(common);
    denominator.divide_exactly(common);
}

/// f's terms in the wider of two layouts, without a copy where they are there already.
template <class Element>
const TermList<Element>& in_layout(const TermList<Element>& terms, const MonomialLayout& layout,
                                   std::optional<TermList<Element>>& storage) {
    if (terms.layout == &layout || terms.layout->bits() == layout.bits()) return terms;
    storage = repacked(terms, layout);
    return *storage;
}

} // namespace

Polynomial::Polynomial(Ring ring) : ring_(std::move(ring)), terms_(empty_terms(ring_, ring_.layout(8))) {}

Polynomial::Polynomial(Ring ring, Terms terms, Integer denominator)
    : ring_(std::move(ring)), terms_(std::move(terms)), denominator_(std::move(denominator)) {}

Polynomial Polynomial::from_terms(Ring ring, IntegerTerms terms, Integer denominator) {
    reduce_fraction(terms, denominator);
    return {std::move(ring), std::move(terms), std::move(denominator)};
}

Polynomial Polynomial::from_terms(Ring ring, ResidueTerms terms) {
    return {std::move(ring), std::move(terms), Integer(1)};
}

Polynomial Polynomial::constant(const Ring& ring, const mpq_class& value) {
    return term(Monomial(ring), value);
}

Polynomial Polynomial::variable(const Ring& ring, std::size_t index) {
    std::vector<std::uint64_t> exponents(ring.variable_count(), 0);
    exponents.at(index) = 1;
    return term(Monomial(ring, exponents), 1);
}

Polynomial Polynomial::variable(const Ring& ring, std::string_view name) {
    const auto index = ring.index_of(name);
    if (!index) throw DomainError(ring.to_string() + " has no variable '" + std::string(name) + "'");
    return variable(ring, *index);
}

Polynomial Polynomial::term(const Monomial& monomial, const mpq_class& coefficient) {
    PolynomialBuilder builder(monomial.ring());
    builder.add(Integer(coefficient.get_num()), Integer(coefficient.get_den()), monomial.exponents());
    return builder.build();
}

std::size_t Polynomial::size() const {
    return std::visit([](const auto& terms) { return terms.size(); }, terms_);
}

const MonomialLayout& Polynomial::layout() const {
    return std::visit([](const auto& terms) -> const MonomialLayout& { return *terms.layout; }, terms_);
}

const MonomialLayout::Word* Polynomial::packed_monomial(std::size_t i) const {
    return std::visit([i](const auto& terms) { return terms.monomial(i); }, terms_);
}

bool Polynomial::is_constant() const {
    return is_zero() || (size() == 1 && layout().is_one(packed_monomial(0)));
}

bool Polynomial::is_one() const { return size() == 1 && is_constant() && coefficient(0) == 1; }

mpq_class Polynomial::coefficient(std::size_t i) const {
    if (const auto* terms = std::get_if<IntegerTerms>(&terms_))
        return make_rational(terms->coefficients[i], denominator_);
    return {residue_terms().coefficients[i]};
}

mpq_class Polynomial::coefficient_of(const Monomial& monomial) const {
    require_same_ring(ring_, monomial.ring(), "coefficient of a monomial");
    std::vector<MonomialLayout::Word> wanted(layout().words());
    if (!layout().repack(monomial.layout(), monomial.words(), wanted.data())) return 0;
    std::size_t low = 0;
    std::size_t high = size();
    while (low < high) {
        const std::size_t middle = low + (high - low) / 2;
        const int side = layout().compare(packed_monomial(middle), wanted.data());
        if (side == 0) return coefficient(middle);
        if (side > 0)
            low = middle + 1;
        else
            high = middle;
    }
    return 0;
}

Monomial Polynomial::leading_monomial() const {
    if (is_zero()) throw DomainError("the zero polynomial has no leading monomial");
    return monomial(0);
}

mpq_class Polynomial::leading_coefficient() const {
    if (is_zero()) throw DomainError("the zero polynomial has no leading coefficient");
    return coefficient(0);
}

Polynomial Polynomial::leading_term() const { return term(leading_monomial(), coefficient(0)); }

Polynomial Polynomial::tail() const {
    Polynomial result = *this;
    if (is_zero()) return result;
    std::visit(
        [](auto& terms) {
            const auto words = static_cast<std::ptrdiff_t>(terms.layout->words());
            terms.monomials.erase(terms.monomials.begin(), terms.monomials.begin() + words);
            terms.coefficients.erase(terms.coefficients.begin());
        },
        result.terms_);
    if (auto* terms = std::get_if<IntegerTerms>(&result.terms_)) reduce_fraction(*terms, result.denominator_);
    return result;
}

std::int64_t Polynomial::total_degree() const {
    std::int64_t degree = -1;
    for (std::size_t i = 0; i < size(); ++i)
        degree = std::max(degree, static_cast<std::int64_t>(layout().total_degree(packed_monomial(i))));
    return degree;
}

std::int64_t Polynomial::degree(std::size_t variable) const {
    std::int64_t degree = -1;
    for (std::size_t i = 0; i < size(); ++i)
        degree = std::max(degree, static_cast<std::int64_t>(exponent(i, variable)));
    return degree;
}

bool Polynomial::is_homogeneous() const {
    for (std::size_t i = 1; i < size(); ++i) {
        if (layout().total_degree(packed_monomial(i)) != layout().total_degree(packed_monomial(0)))
            return false;
    }
    return true;
}

Polynomial Polynomial::operator-() const {
    Polynomial result = *this;
    if (auto* terms = std::get_if<IntegerTerms>(&result.terms_)) {
        for (Integer& c : terms->coefficients) c.negate();
    } else {
        for (auto& c : std::get<ResidueTerms>(result.terms_).coefficients)
            c = ring_.field().prime_field().negate(c);
    }
    return result;
}

Polynomial Polynomial::combine(const Polynomial& a, const Polynomial& b, bool subtract) {
    require_same_ring(a.ring_, b.ring_, subtract ? "difference of polynomials" : "sum of polynomials");
    const MonomialLayout& layout = a.ring_.layout(std::max(a.layout().bits(), b.layout().bits()));
    const auto merge = [&](const auto& domain, const auto& left, const auto& ca, const auto& right,
                           const auto& cb) {
        std::decay_t<decltype(std::optional(left))> left_storage;
        std::decay_t<decltype(std::optional(right))> right_storage;
        auto sum = linear_combination(domain, in_layout(left, layout, left_storage), ca,
                                      in_layout(right, layout, right_storage), cb);
        sum.layout = &layout;
        return sum;
    };
    if (!a.ring_.field().is_rationals()) {
        const PrimeDomain domain{a.ring_.field().prime_field()};
        const std::uint32_t sign = subtract ? domain.negate(1) : 1;
        return from_terms(a.ring_,
                          merge(domain, a.residue_terms(), std::uint32_t{1}, b.residue_terms(), sign));
    }
    const Integer common = lcm(a.denominator_, b.denominator_);
    Integer ca = common;
    Integer cb = common;
    ca.divide_exactly(a.denominator_);
    cb.divide_exactly(b.denominator_);
    if (subtract) cb.negate();
    return from_terms(a.ring_, merge(IntegerDomain{}, a.integer_terms(), ca, b.integer_terms(), cb), common);
}

Polynomial operator+(const Polynomial& a, const Polynomial& b) { return Polynomial::combine(a, b, false); }
Polynomial operator-(const Polynomial& a, const Polynomial& b) { return Polynomial::combine(a, b, true); }

bool operator==(const Polynomial& a, const Polynomial& b) {
    require_same_ring(a.ring_, b.ring_, "comparison of polynomials");
    if (a.size() != b.size() || a.denominator_ != b.denominator_) return false;
    const MonomialLayout& layout = a.ring_.layout(std::max(a.layout().bits(), b.layout().bits()));
    const auto equal = [&layout](const auto& left, const auto& right) {
        std::decay_t<decltype(std::optional(left))> left_storage;
        std::decay_t<decltype(std::optional(right))> right_storage;
        return left.coefficients == right.coefficients &&
               in_layout(left, layout, left_storage).monomials ==
                   in_layout(right, layout, right_storage).monomials;
    };
    if (a.ring_.field().is_rationals()) return equal(a.integer_terms(), b.integer_terms());
    return equal(a.residue_terms(), b.residue_terms());
}

Polynomial Polynomial::scaled(const mpq_class& factor) const {
    if (factor == 0) return Polynomial(ring_);
    Polynomial result = *this;
    if (auto* terms = std::get_if<IntegerTerms>(&result.terms_)) {
        const Integer numerator(factor.get_num());
        for (Integer& c : terms->coefficients) c *= numerator;
        result.denominator_ *= Integer(factor.get_den());
        reduce_fraction(*terms, result.denominator_);
        return result;
    }
    const PrimeField& field = ring_.field().prime_field();
    const auto residue = field.from_fraction(Integer(factor.get_num()), Integer(factor.get_den()));
    if (residue == 0) return Polynomial(ring_);
    for (auto& c : std::get<ResidueTerms>(result.terms_).coefficients) c = field.multiply(c, residue);
    return result;
}

Polynomial Polynomial::times_term(const Monomial& monomial, const mpq_class& coefficient) const {
    return *this * term(monomial, coefficient);
}

Polynomial Polynomial::monic() const { return is_zero() ? *this : scaled(1 / leading_coefficient()); }

Polynomial Polynomial::primitive_part() const {
    if (is_zero()) return *this;
    if (!ring_.field().is_rationals()) return monic();
    Polynomial result = *this;
    result.denominator_ = Integer(1);
    auto& terms = std::get<IntegerTerms>(result.terms_);
    Integer divisor = content_of(terms);
    if (terms.coefficients.front().sign() < 0) divisor.negate();
    if (!divisor.is_one()) {
        for (Integer& c : terms.coefficients) c.divide_exactly(divisor);
    }
    return result;
}

mpq_class Polynomial::content() const {
    if (is_zero()) return 0;
    if (!ring_.field().is_rationals()) return coefficient(0);
    return make_rational(content_of(integer_terms()), denominator_);
}

Polynomial Polynomial::in_ring(const Ring& target, std::span<const std::size_t> variable_map) const {
    const CoefficientField& from = ring_.field();
    if (!from.is_rationals() && !(from == target.field()))
        throw DomainError("coefficients of " + from.to_string() + " have no image in " +
                          target.field().to_string());
    const std::size_t n = ring_.variable_count();
    std::vector<std::uint64_t> source(n);
    std::vector<std::uint64_t> image(target.variable_count());
    PolynomialBuilder builder(target);
    for (std::size_t i = 0; i < size(); ++i) {
        layout().decode(packed_monomial(i), source);
        std::ranges::fill(image, 0);
        for (std::size_t v = 0; v < n; ++v) {
            if (source[v] == 0) continue;
            if (variable_map[v] == dropped)
                throw DomainError("the variable '" + ring_.names()[v] + "' has no image in " +
                                  target.to_string());
            image[variable_map[v]] += source[v];
        }
        if (from.is_rationals())
            builder.add(integer_terms().coefficients[i], denominator_, image);
        else
            builder.add(Integer(residue_terms().coefficients[i]), image);
    }
    return builder.build();
}

Polynomial Polynomial::in_ring(const Ring& target) const {
    std::vector<std::size_t> variable_map;
    for (const std::string& name : ring_.names())
        variable_map.push_back(target.index_of(name).value_or(dropped));
    return in_ring(target, variable_map);
}

} // namespace eliminant::algebra
