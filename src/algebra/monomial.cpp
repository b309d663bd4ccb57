#include "eliminant/algebra/monomial.hpp"

#include "eliminant/base/error.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::algebra {

namespace {

constexpr unsigned widths[] = {8, 16, 32, 64};

std::vector<std::uint64_t> combine(const Monomial& a, const Monomial& b, const char* doing,
                                   auto&& operation) {
    require_same_ring(a.ring(), b.ring(), doing);
    std::vector<std::uint64_t> result = a.exponents();
    for (std::size_t i = 0; i < result.size(); ++i) result[i] = operation(result[i], b.exponent(i));
    return result;
}

} // namespace

Monomial::Monomial(Ring ring)
    : ring_(std::move(ring)), layout_(&ring_.layout(8)), words_(layout_->words(), 0) {}

Monomial::Monomial(Ring ring, std::span<const std::uint64_t> exponents)
    : ring_(std::move(ring)), layout_(nullptr) {
    if (exponents.size() != ring_.variable_count())
        throw DomainError("a monomial of " + ring_.to_string() + " has " +
                          std::to_string(ring_.variable_count()) + " exponents, found " +
                          std::to_string(exponents.size()));
    for (const unsigned bits : widths) {
        layout_ = &ring_.layout(bits);
        words_.resize(layout_->words());
        if (layout_->encode(exponents, words_.data())) return;
    }
    throw OverflowError("an exponent or weighted degree exceeds 2^63 - 1");
}

Monomial::Monomial(Ring ring, const MonomialLayout& layout, const MonomialLayout::Word* packed)
    : ring_(std::move(ring)), layout_(nullptr) {
    for (const unsigned bits : widths) {
        layout_ = &ring_.layout(bits);
        words_.resize(layout_->words());
        if (layout_->repack(layout, packed, words_.data())) return;
    }
}

std::vector<std::uint64_t> Monomial::exponents() const {
    std::vector<std::uint64_t> result(ring_.variable_count());
    layout_->decode(words_.data(), result);
    return result;
}

bool Monomial::divides(const Monomial& other) const {
    require_same_ring(ring_, other.ring_, "divisibility of monomials");
    for (std::size_t i = 0; i < ring_.variable_count(); ++i) {
        if (exponent(i) > other.exponent(i)) return false;
    }
    return true;
}

Monomial operator*(const Monomial& a, const Monomial& b) {
    // Exponents are below 2^63, so their sum does not wrap; the constructor rejects it if it is too large.
    return {a.ring_, combine(a, b, "product of monomials", std::plus<>())};
}

Monomial operator/(const Monomial& a, const Monomial& b) {
    if (!b.divides(a))
        throw DomainError("the monomial " + b.to_string() + " does not divide " + a.to_string());
    return {a.ring_, combine(a, b, "quotient of monomials", std::minus<>())};
}

Monomial lcm(const Monomial& a, const Monomial& b) {
    return {a.ring_, combine(a, b, "lcm of monomials", [](auto x, auto y) { return std::max(x, y); })};
}

Monomial gcd(const Monomial& a, const Monomial& b) {
    return {a.ring_, combine(a, b, "gcd of monomials", [](auto x, auto y) { return std::min(x, y); })};
}

bool operator==(const Monomial& a, const Monomial& b) {
    require_same_ring(a.ring_, b.ring_, "comparison of monomials");
    return a.layout_->bits() == b.layout_->bits() && a.words_ == b.words_;
}

std::strong_ordering operator<=>(const Monomial& a, const Monomial& b) {
    require_same_ring(a.ring_, b.ring_, "comparison of monomials");
    const MonomialLayout& layout = a.ring_.layout(std::max(a.layout_->bits(), b.layout_->bits()));
    std::vector<MonomialLayout::Word> left(layout.words());
    std::vector<MonomialLayout::Word> right(layout.words());
    static_cast<void>(layout.repack(*a.layout_, a.words_.data(), left.data())); // widening always fits
    static_cast<void>(layout.repack(*b.layout_, b.words_.data(), right.data()));
    return layout.compare(left.data(), right.data()) <=> 0;
}

std::string Monomial::to_string() const {
    std::string text;
    for (std::size_t i = 0; i < ring_.variable_count(); ++i) {
        const std::uint64_t e = exponent(i);
        if (e == 0) continue;
        if (!text.empty()) text += '*';
        text += ring_.names()[i];
        if (e != 1) text += '^' + std::to_string(e);
    }
    return text.empty() ? "1" : text;
}

} // namespace eliminant::algebra
