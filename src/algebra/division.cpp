#include "eliminant/algebra/arithmetic.hpp"

#include "multiply_heap.hpp"
#include "multiply_keys.hpp"
#include "multiply_sums.hpp"
#include "term_arithmetic.hpp"

#include <algorithm>
#include <deque>
#include <optional>
#include <type_traits>
#include <utility>

namespace eliminant::algebra {

namespace {

using Word = MonomialLayout::Word;

/// A divisor as the algorithm uses it: over ℚ its primitive integer multiple.
template <class Element>
struct Divisor {
    const TermList<Element>* terms;
    std::uint64_t mask;    ///< divisibility_mask of the leading monomial
    Integer content{1};    ///< over ℚ the numerators are content · terms
    Element inverse_lc{0}; ///< over GF(p)
};

/// Packed words as one number that compares as the monomials do.
template <class Key>
Key ordered_key(const MonomialLayout& layout, const Word* m) {
    if constexpr (std::is_same_v<Key, LongKey>) {
        LongKey key{{m, m + layout.words()}};
        for (std::size_t w = 0; w < layout.words(); ++w) key.words[w] ^= layout.flip()[w];
        return key;
    } else {
        Key key = 0;
        for (std::size_t w = 0; w < layout.words(); ++w) {
            if constexpr (sizeof(Key) > sizeof(Word)) key <<= 64;
            key |= m[w] ^ layout.flip()[w];
        }
        return key;
    }
}

template <class Key>
void monomial_of_key(const MonomialLayout& layout, const Key& key, Word* out) {
    const std::size_t n = layout.words();
    for (std::size_t w = 0; w < n; ++w) {
        if constexpr (std::is_same_v<Key, LongKey>)
            out[w] = key.words[w] ^ layout.flip()[w];
        else if constexpr (sizeof(Key) > sizeof(Word))
            out[w] = static_cast<Word>(key >> (64 * (n - 1 - w))) ^ layout.flip()[w];
        else
            out[w] = key ^ layout.flip()[w];
    }
}

/// Division of f by several divisors in one layout. Over ℚ it is fraction-free: at every moment
///
///     scale · f = Σ quotients[i] · divisors[i] + remainder + what is left
///
/// in integers, and the scale grows only by what a leading coefficient lacks.
///
/// What is left is never formed: it is f and the products of quotient terms by divisors, waiting in a heap
/// for their turn (Monagan and Pearce 2011), so each of its terms is added up once, when it leads.
template <class Domain, class Sums, class Key>
class LongDivision {
  public:
    using Element = typename Domain::Element;
    using Terms = TermList<Element>;

    LongDivision(const Domain& domain, const Sums& sums, const MonomialLayout& layout, const Terms& f,
                 std::span<const Divisor<Element>> divisors, bool keep_quotients, base::Run& run)
        : domain_(domain), sums_(sums), layout_(layout), f_(f), divisors_(divisors), run_(run),
          remainder_(layout), quotients_(keep_quotients ? divisors.size() : 0, Terms(layout)), heap_(64),
          leading_(layout.words()), scratch_(layout.words()) {}

    /// False if an exponent outgrew the layout.
    bool compute() {
        std::size_t next = 0; // term of f
        std::vector<std::uint32_t> active;
        while (next < f_.size() || !heap_.empty()) {
            run_.poll();
            typename Sums::Cell sum{};
            active.clear();
            Key key{};
            const bool from_f = next < f_.size();
            if (from_f) key = ordered_key<Key>(layout_, f_.monomial(next));
            if (!heap_.empty() && (!from_f || !(heap_.top() < key))) {
                if (!from_f || key < heap_.top()) key = heap_.top();
                heap_.pop_all(active);
            }
            monomial_of_key(layout_, key, leading_.data());
            if (from_f && layout_.equal(f_.monomial(next), leading_.data()))
                add_scaled(sum, f_.coefficients[next++]);
            for (const std::uint32_t i : active) {
                if constexpr (Sums::polls) run_.poll();
                sums_.add(sum, rows_[i].factor,
                          divisors_[rows_[i].divisor].terms->coefficients[rows_[i].cursor]);
            }
            for (const std::uint32_t i : active) {
                ++rows_[i].cursor;
                if (!await(i)) return false;
            }
            Element value = sums_.take(sum);
            if (!Sums::is_zero(value) && !reduce(std::move(value))) return false;
        }
        finish(remainder_, remainder_epochs_);
        for (std::size_t i = 0; i < quotients_.size(); ++i) finish(quotients_[i], quotient_epochs_[i]);
        return true;
    }

    Terms& remainder() { return remainder_; }
    Terms& quotient(std::size_t i) { return quotients_[i]; }
    const Integer& scale() const { return scale_; }

  private:
    struct Row {
        std::size_t divisor;
        std::size_t cursor; ///< next term of the divisor
        Element factor;     ///< minus the coefficient of the quotient term
    };

    void add_scaled(typename Sums::Cell& sum, const Element& c) {
        if constexpr (Domain::is_field)
            sums_.add(sum, c, 1);
        else
            sums_.add(sum, c, scale_);
    }

    /// Puts the next product of a row in the heap, if it has one.
    bool await(std::uint32_t i) {
        const Row& row = rows_[i];
        const Terms& g = *divisors_[row.divisor].terms;
        if (row.cursor == g.size()) return true;
        if (!layout_.multiply(row_monomials_.data() + i * layout_.words(), g.monomial(row.cursor),
                              scratch_.data()))
            return false;
        heap_.push(ordered_key<Key>(layout_, scratch_.data()), i);
        return true;
    }

    /// Takes the leading term value · leading_ to the quotients or the remainder.
    bool reduce(Element value) {
        const std::uint64_t outside = ~layout_.divisibility_mask(leading_.data());
        const auto found = std::ranges::find_if(divisors_, [&](const Divisor<Element>& d) {
            return (d.mask & outside) == 0 && layout_.divides(d.terms->monomial(0), leading_.data());
        });
        if (found == divisors_.end()) {
            remainder_.push_back(leading_.data(), std::move(value));
            remainder_epochs_.push_back(factors_.size());
            return true;
        }
        const auto index = static_cast<std::size_t>(found - divisors_.begin());
        const Element q = divide_coefficient(std::move(value), *found);
        layout_.divide(leading_.data(), found->terms->monomial(0), leading_.data());
        if (!quotients_.empty()) {
            quotients_[index].push_back(leading_.data(), q);
            quotient_epochs_.resize(quotients_.size());
            quotient_epochs_[index].push_back(factors_.size());
        }
        row_monomials_.insert(row_monomials_.end(), leading_.begin(), leading_.end());
        rows_.push_back({index, 1, domain_.negate(q)});
        return await(static_cast<std::uint32_t>(rows_.size() - 1));
    }

    Element divide_coefficient(Element value, const Divisor<Element>& divisor) {
        if constexpr (Domain::is_field) {
            return domain_.multiply(value, divisor.inverse_lc);
        } else {
            const Integer& leading = divisor.terms->coefficients.front();
            Integer q;
            if (value.try_divide(leading, q)) return q;
            Integer factor = abs(leading);
            factor.divide_exactly(gcd(value, leading));
            scale_ *= factor;
            for (Row& row : rows_) {
                if (row.cursor < divisors_[row.divisor].terms->size()) row.factor *= factor;
            }
            value *= factor;
            value.divide_exactly(leading);
            factors_.push_back(std::move(factor));
            return value;
        }
    }

    /// Brings terms found at different scales to the last one.
    void finish(Terms& terms, const std::vector<std::size_t>& epochs) {
        if constexpr (!Domain::is_field) {
            Integer missing(1);
            std::size_t epoch = factors_.size();
            for (std::size_t i = terms.size(); i-- > 0;) {
                run_.poll();
                while (epoch > epochs[i]) missing *= factors_[--epoch];
                if (!missing.is_one()) terms.coefficients[i] *= missing;
            }
        }
    }

    const Domain& domain_;
    const Sums& sums_;
    const MonomialLayout& layout_;
    const Terms& f_;
    std::span<const Divisor<Element>> divisors_;
    base::Run& run_;
    Terms remainder_;
    std::vector<Terms> quotients_;
    std::vector<std::size_t> remainder_epochs_; ///< how many factors each term has already
    std::vector<std::vector<std::size_t>> quotient_epochs_ =
        std::vector<std::vector<std::size_t>>(quotients_.size());
    Integer scale_ = Integer(1);   ///< the product of all factors
    std::vector<Integer> factors_; ///< in the sequence of their use
    ChainedHeap<Key> heap_;
    std::vector<Row> rows_;
    std::vector<Word> row_monomials_;
    std::vector<Word> leading_;
    std::vector<Word> scratch_;
};

const IntegerTerms& terms_of(const Polynomial& f, const IntegerDomain&) { return f.integer_terms(); }
const ResidueTerms& terms_of(const Polynomial& f, const PrimeDomain&) { return f.residue_terms(); }

/// The whole division in one layout; nullopt if an exponent outgrew it.
template <class Domain, class Sums, class Key>
std::optional<Division> divide_in(const Domain& domain, const Sums& sums, const MonomialLayout& layout,
                                  const Polynomial& f, std::span<const Polynomial> divisors,
                                  bool keep_quotients, base::Run& run) {
    using Terms = TermList<typename Domain::Element>;
    std::deque<Terms> storage; // of what is not used as it is; a deque keeps addresses
    const auto here = [&](const Terms& terms) -> const Terms* {
        if (terms.layout->bits() == layout.bits()) return &terms;
        return &storage.emplace_back(*repacked(terms, layout));
    };
    std::vector<Divisor<typename Domain::Element>> prepared;
    for (const Polynomial& g : divisors) {
        run.poll();
        auto& divisor = prepared.emplace_back();
        divisor.terms = here(terms_of(g, domain));
        divisor.mask = layout.divisibility_mask(divisor.terms->monomial(0));
        if constexpr (Domain::is_field) {
            divisor.inverse_lc = domain.field.inverse(divisor.terms->coefficients.front());
        } else {
            divisor.content = content_of(*divisor.terms);
            if (divisor.content.is_one()) continue;
            Terms& primitive = storage.emplace_back(*divisor.terms);
            for (Integer& c : primitive.coefficients) c.divide_exactly(divisor.content);
            divisor.terms = &primitive;
        }
    }
    LongDivision<Domain, Sums, Key> division(domain, sums, layout, *here(terms_of(f, domain)), prepared,
                                             keep_quotients, run);
    if (!division.compute()) return std::nullopt;

    Division result{{}, Polynomial(f.ring())};
    if constexpr (Domain::is_field) {
        result.remainder = Polynomial::from_terms(f.ring(), std::move(division.remainder()));
        for (std::size_t i = 0; keep_quotients && i < divisors.size(); ++i)
            result.quotients.push_back(Polynomial::from_terms(f.ring(), std::move(division.quotient(i))));
    } else {
        const Integer denominator = division.scale() * f.denominator();
        result.remainder = Polynomial::from_terms(f.ring(), std::move(division.remainder()), denominator);
        for (std::size_t i = 0; keep_quotients && i < divisors.size(); ++i) {
            Terms& quotient = division.quotient(i);
            if (!divisors[i].denominator().is_one()) {
                for (Integer& c : quotient.coefficients) c *= divisors[i].denominator();
            }
            result.quotients.push_back(
                Polynomial::from_terms(f.ring(), std::move(quotient), denominator * prepared[i].content));
        }
    }
    return result;
}

template <class Domain, class Sums>
Division divide_with(const Domain& domain, const Sums& sums, const Polynomial& f,
                     std::span<const Polynomial> divisors, bool keep_quotients, base::Run& run) {
    unsigned bits = f.layout().bits();
    for (const Polynomial& g : divisors) bits = std::max(bits, g.layout().bits());
    for (; bits <= 64; bits *= 2) { // in orders that are not graded the exponents can grow
        const MonomialLayout& layout = f.ring().layout(bits);
        const auto attempt = [&]<class Key>(std::type_identity<Key>) {
            return divide_in<Domain, Sums, Key>(domain, sums, layout, f, divisors, keep_quotients, run);
        };
        auto result = layout.words() == 1   ? attempt(std::type_identity<std::uint64_t>{})
                      : layout.words() == 2 ? attempt(std::type_identity<base::UInt128>{})
                                            : attempt(std::type_identity<LongKey>{});
        if (result) return *std::move(result);
    }
    throw OverflowError("division: an exponent or weighted degree exceeds 2^63 - 1");
}

Division divide_any(const Polynomial& f, std::span<const Polynomial> divisors, bool keep_quotients,
                    base::Run& run) {
    for (const Polynomial& g : divisors) {
        require_same_ring(f.ring(), g.ring(), "division of polynomials");
        if (g.is_zero()) throw DomainError("division by the zero polynomial");
    }
    if (f.ring().field().is_rationals())
        return divide_with(IntegerDomain{}, IntegerSums{}, f, divisors, keep_quotients, run);
    const PrimeField& field = f.ring().field().prime_field();
    return divide_with(PrimeDomain{field}, ResidueSums(field), f, divisors, keep_quotients, run);
}

/// All terms times a monomial, in `layout`; nullopt if an exponent does not fit.
template <class Element>
std::optional<TermList<Element>> shifted(const TermList<Element>& terms, const Monomial& by,
                                         const MonomialLayout& layout) {
    std::vector<Word> factor(layout.words());
    auto result = repacked(terms, layout);
    if (!result || !layout.repack(by.layout(), by.words(), factor.data())) return std::nullopt;
    for (std::size_t i = 0; i < terms.size(); ++i) {
        if (!layout.multiply(result->monomial(i), factor.data(), result->monomial(i))) return std::nullopt;
    }
    return result;
}

/// shift_f·f·cf − shift_g·g·cg in the narrowest layout from that of f on.
template <class Domain>
auto shifted_difference(const Domain& domain, const Ring& ring, const auto& f, const Monomial& shift_f,
                        const auto& cf, const auto& g, const Monomial& shift_g, const auto& cg) {
    for (unsigned bits = std::max(f.layout->bits(), g.layout->bits()); bits <= 64; bits *= 2) {
        const MonomialLayout& layout = ring.layout(bits);
        const auto left = shifted(f, shift_f, layout);
        const auto right = shifted(g, shift_g, layout);
        if (left && right) return linear_combination(domain, *left, cf, *right, domain.negate(cg));
    }
    throw OverflowError("S-polynomial: an exponent or weighted degree exceeds 2^63 - 1");
}

} // namespace

Division divide(const Polynomial& f, std::span<const Polynomial> divisors, base::Run& run) {
    return divide_any(f, divisors, true, run);
}

Polynomial normal_form(const Polynomial& f, std::span<const Polynomial> divisors, base::Run& run) {
    return divide_any(f, divisors, false, run).remainder;
}

Polynomial s_polynomial(const Polynomial& f, const Polynomial& g) {
    const Monomial common = lcm(f.leading_monomial(), g.leading_monomial());
    const Monomial shift_f = common / f.leading_monomial();
    const Monomial shift_g = common / g.leading_monomial();
    if (f.ring().field().is_rationals()) {
        // With leading numerators a and b and d = gcd(a, b): (b/d · x^s f − a/d · x^t g) / (a·b/d).
        const IntegerTerms& left = f.integer_terms();
        const IntegerTerms& right = g.integer_terms();
        Integer a = left.coefficients.front();
        Integer b = right.coefficients.front();
        const Integer d = gcd(a, b);
        const Integer denominator = abs(lcm(a, b));
        const bool negative = (a.sign() < 0) != (b.sign() < 0);
        a.divide_exactly(negative ? -d : d);
        b.divide_exactly(negative ? -d : d);
        return Polynomial::from_terms(
            f.ring(), shifted_difference(IntegerDomain{}, f.ring(), left, shift_f, b, right, shift_g, a),
            denominator);
    }
    const PrimeDomain domain{f.ring().field().prime_field()};
    const ResidueTerms& left = f.residue_terms();
    const ResidueTerms& right = g.residue_terms();
    return Polynomial::from_terms(
        f.ring(),
        shifted_difference(domain, f.ring(), left, shift_f, domain.field.inverse(left.coefficients.front()),
                           right, shift_g, domain.field.inverse(right.coefficients.front())));
}

} // namespace eliminant::algebra
