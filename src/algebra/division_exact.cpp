#include "division.hpp"

#include "division_dense.hpp"
#include "division_kernel.hpp"
#include "multiply_keys.hpp"
#include "multiply_plan.hpp"
#include "multiply_sums.hpp"
#include "term_arithmetic.hpp"

#include <algorithm>
#include <bit>
#include <concepts>
#include <type_traits>
#include <utility>

namespace eliminant::algebra {

namespace {

/// Divides coefficients by the divisor's leading one.
struct ResidueQuotient {
    PrimeField field;
    std::uint32_t inverse;

    DivisionOutcome operator()(std::uint32_t value, std::uint32_t& q) const {
        q = field.multiply(value, inverse);
        return DivisionOutcome::exact;
    }
};

struct IntegerQuotient {
    const Integer& leading;
    std::size_t max_bits; ///< of a coefficient of the quotient for which no accumulator overflows

    DivisionOutcome operator()(const Integer& value, Integer& q) const {
        if (!value.try_divide(leading, q)) return DivisionOutcome::inexact;
        return q.bit_length() <= max_bits ? DivisionOutcome::exact : DivisionOutcome::overflow;
    }
};

/// What is known of the quotient before the division: the field spans that it must have, and the key line of
/// the dividend.
///
/// For every linear form with non-negative coefficients the largest value in a product is the sum of the
/// largest values in the factors, and so for the smallest: leading and trailing forms multiply. Strides
/// likewise: a factor of something homogeneous in a grading by ℤ/g is homogeneous.
struct Frame {
    std::vector<FieldSpan> dividend;
    std::vector<FieldSpan> divisor;
    std::vector<FieldSpan> quotient;

    static std::optional<Frame> of(const MonomialLayout& layout, std::span<const MonomialLayout::Word> a,
                                   std::span<const MonomialLayout::Word> b) {
        Frame frame{field_spans(layout, a), field_spans(layout, b), {}};
        for (std::size_t f = 0; f < frame.dividend.size(); ++f) {
            const FieldSpan& whole = frame.dividend[f];
            const FieldSpan& part = frame.divisor[f];
            if (whole.low < part.low || whole.length() < part.length()) return std::nullopt;
            frame.quotient.push_back({whole.low - part.low, whole.high - part.high, whole.stride});
        }
        return frame;
    }
    bool holds(const MonomialLayout& layout, const MonomialLayout::Word* q) const {
        for (std::size_t f = 0; f < quotient.size(); ++f) {
            const std::uint64_t value = layout.field_value(q, f);
            if (value < quotient[f].low || value > quotient[f].high) return false;
        }
        return true;
    }
};

/// Division of a by b, which has two terms or more and is in the layout of a.
template <class Sums, class Quotient>
class ExactDivision {
  public:
    using Element = typename Sums::Element;
    using Terms = TermList<Element>;

    ExactDivision(const Terms& a, const Terms& b, const Frame& frame, const KeyLine& line, const Sums& sums,
                  const Quotient& quotient, base::Run& run)
        : a_(a), b_(b), frame_(frame), line_(line), sums_(sums), quotient_(quotient), run_(run),
          result_(*a.layout) {}

    template <class Key>
    DivisionOutcome compute(const ExactDivisionOptions& options) {
        const OperandValues<Sums> divisor_values(b_.coefficients);
        const KeyedTerms<Key, Element> a{keys_of<Key>(a_, frame_.dividend), a_.coefficients};
        const KeyedTerms<Key, typename Sums::Operand> b{keys_of<Key>(b_, frame_.divisor), divisor_values};
        const unsigned bits = options.window_bits
                                  ? *options.window_bits
                                  : choose_division_window(count_windows(a.keys), count_windows(b.keys),
                                                           sizeof(typename Sums::Cell));
        KeyDecoder decoder(line_);
        std::vector<MonomialLayout::Word> q(result_.layout->words());
        const auto find_term = [&](const Key& key, const Element& value, Element& coefficient) {
            decode_key(decoder, key, q.data());
            if (!divide_by_leading(q)) return DivisionOutcome::inexact;
            const DivisionOutcome outcome = quotient_(value, coefficient);
            if (outcome == DivisionOutcome::exact) result_.push_back(q.data(), coefficient);
            return outcome;
        };
        if constexpr (std::same_as<Key, std::uint64_t> && std::same_as<Sums, ResidueSums>) {
            if (may_be_dense(options, a.keys, b.keys))
                return divide_dense(a, b, sums_.field, run_, find_term);
        }
        return divide_by_window(a, b, bits, sums_, run_, find_term);
    }

    /// By integers, if that is expected to be faster, or else with outcome overflow.
    DivisionOutcome compute_by_kronecker(const ExactDivisionOptions& options, const CoefficientSize& size_a,
                                         const CoefficientSize& size_b) {
        const KeyedTerms<std::uint64_t, Integer> a{keys_of<std::uint64_t>(a_, frame_.dividend),
                                                   a_.coefficients};
        const KeyedTerms<std::uint64_t, Integer> b{keys_of<std::uint64_t>(b_, frame_.divisor),
                                                   b_.coefficients};
        // Room for a quotient with coefficients as large as those of the dividend.
        const std::size_t slot_bits = size_a.max_bits + size_b.sum_bits + 2;
        if (!may_be_dense(options, a.keys, b.keys)) return DivisionOutcome::overflow;
        const std::uint64_t last = a.keys.front() - b.keys.front();
        const double products = static_cast<double>(last + 1) * static_cast<double>(b.size());
        // A division takes GMP about as long as three products.
        if (options.kernel == QuotientKernel::automatic &&
            3 * kronecker_cost(last, b.keys.front(), a.size(), slot_bits) > products)
            return DivisionOutcome::overflow;
        KeyDecoder decoder(line_);
        std::vector<MonomialLayout::Word> q(result_.layout->words());
        return divide_by_kronecker(a, b, size_b, slot_bits, run_,
                                   [&](std::uint64_t key, Integer&& coefficient) {
                                       decode_key(decoder, key + b.keys.front(), q.data());
                                       if (!divide_by_leading(q)) return false;
                                       result_.push_back(q.data(), std::move(coefficient));
                                       return true;
                                   });
    }
    Terms& result() { return result_; }

  private:
    template <class Key>
    std::vector<Key> keys_of(const Terms& terms, const std::vector<FieldSpan>& spans) const {
        return as_keys<Key>(line_.encode(*terms.layout, terms.monomials, spans), line_.words());
    }

    /// Makes a monomial of a − q·b that of a quotient's term; false if there is no such term.
    bool divide_by_leading(std::vector<MonomialLayout::Word>& monomial) const {
        const MonomialLayout& layout = *result_.layout;
        if (!layout.divides(b_.monomial(0), monomial.data())) return false;
        layout.divide(monomial.data(), b_.monomial(0), monomial.data());
        return frame_.holds(layout, monomial.data());
    }
    static bool may_be_dense(const ExactDivisionOptions& options, const std::vector<std::uint64_t>& a,
                             const std::vector<std::uint64_t>& b) {
        constexpr std::uint64_t forced_limit = 1 << 16;
        if (options.kernel == QuotientKernel::dense)
            return a.front() < forced_limit && a.front() >= b.front();
        return options.kernel == QuotientKernel::automatic && a.front() >= b.front() && is_dense(a) &&
               is_dense(b);
    }

    const Terms& a_;
    const Terms& b_;
    const Frame& frame_;
    const KeyLine& line_;
    const Sums& sums_;
    const Quotient& quotient_;
    base::Run& run_;
    Terms result_;
};

template <class Sums, class Quotient>
DivisionOutcome
divide_with(const TermList<typename Sums::Element>& a, const TermList<typename Sums::Element>& b,
            const Frame& frame, const KeyLine& line, const Sums& sums, const Quotient& quotient,
            const ExactDivisionOptions& options, base::Run& run, TermList<typename Sums::Element>& result) {
    ExactDivision division(a, b, frame, line, sums, quotient, run);
    const DivisionOutcome outcome = line.words() == 1 ? division.template compute<std::uint64_t>(options)
                                                      : division.template compute<base::UInt128>(options);
    result = std::move(division.result());
    return outcome;
}

DivisionOutcome divide_terms(const ResidueTerms& a, const ResidueTerms& b, const Frame& frame,
                             const KeyLine& line, const PrimeField& field,
                             const ExactDivisionOptions& options, base::Run& run, ResidueTerms& result) {
    const ResidueQuotient quotient{field, field.inverse(b.coefficients.front())};
    return divide_with(a, b, frame, line, ResidueSums(field), quotient, options, run, result);
}

/// Over ℤ; the narrowest accumulators first, wider ones when the quotient's coefficients turn out too large.
/// A cell never exceeds ‖a‖∞ + ‖q‖∞·‖b‖₁.
DivisionOutcome divide_terms(const IntegerTerms& a, const IntegerTerms& b, const Frame& frame,
                             const KeyLine& line, const ExactDivisionOptions& options, base::Run& run,
                             IntegerTerms& result) {
    const CoefficientSize size_a = coefficient_size(a.coefficients);
    const CoefficientSize size_b = coefficient_size(b.coefficients);
    const auto attempt = [&]<class Sums>(const Sums& sums) {
        constexpr std::size_t inline_bits = 62;
        IntegerQuotient quotient{b.coefficients.front(), Sums::capacity};
        if constexpr (std::same_as<typename Sums::Operand, std::int64_t>) {
            if (!size_b.all_small || size_a.max_bits + 1 >= Sums::capacity ||
                size_b.sum_bits + 1 >= Sums::capacity)
                return DivisionOutcome::overflow;
            quotient.max_bits = std::min(inline_bits, Sums::capacity - 1 - size_b.sum_bits);
        }
        return divide_with(a, b, frame, line, sums, quotient, options, run, result);
    };
    DivisionOutcome outcome = DivisionOutcome::overflow;
    constexpr std::size_t fewest_products = 1 << 12; // below, the attempt costs more than it may save
    if (line.words() == 1 &&
        (options.kernel == QuotientKernel::dense || a.size() * b.size() >= fewest_products)) {
        const IntegerQuotient unused{b.coefficients.front(), 0};
        ExactDivision division(a, b, frame, line, IntegerSums{}, unused, run);
        outcome = division.compute_by_kronecker(options, size_a, size_b);
        result = std::move(division.result());
    }
    if (outcome == DivisionOutcome::overflow) outcome = attempt(WordSums<base::Int128>{});
    if (outcome == DivisionOutcome::overflow) outcome = attempt(TripleSums{});
    if (outcome == DivisionOutcome::overflow) outcome = attempt(IntegerSums{});
    return outcome;
}

/// a divided by the single term of b.
template <class Terms, class DivideCoefficient>
DivisionOutcome divide_by_term(const Terms& a, const Terms& b, DivideCoefficient&& divide_coefficient,
                               base::Run& run, Terms& result) {
    result = a;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (i % 1024 == 0) run.poll();
        if (!a.layout->divides(b.monomial(0), a.monomial(i))) return DivisionOutcome::inexact;
        a.layout->divide(a.monomial(i), b.monomial(0), result.monomial(i));
        if (!divide_coefficient(result.coefficients[i], b.coefficients[0])) return DivisionOutcome::inexact;
    }
    return DivisionOutcome::exact;
}

/// a/b for nonzero a and b. `divide_coefficient(c, d)` makes c the quotient c/d or returns false;
/// `divide_terms(b, frame, line)` does the long division. Where keys of exponents as huge as these take more
/// than two words the outcome is overflow.
template <class Terms, class DivideCoefficient, class DivideTerms>
DivisionOutcome quotient_of(const Terms& a, const Terms& narrow_b, DivideCoefficient&& divide_coefficient,
                            DivideTerms&& divide_terms, base::Run& run, Terms& result) {
    const MonomialLayout& layout = *a.layout;
    const auto b = repacked(narrow_b, layout);
    if (!b) return DivisionOutcome::inexact; // a larger exponent than any of a
    if (b->size() == 1) return divide_by_term(a, *b, divide_coefficient, run, result);
    const auto frame = Frame::of(layout, a.monomials, b->monomials);
    if (!frame) return DivisionOutcome::inexact;
    for (const bool first : {true, false}) { // leading and trailing terms multiply
        const std::size_t i = first ? 0 : a.size() - 1;
        const std::size_t j = first ? 0 : b->size() - 1;
        auto c = a.coefficients[i];
        if (!layout.divides(b->monomial(j), a.monomial(i)) || !divide_coefficient(c, b->coefficients[j]))
            return DivisionOutcome::inexact;
    }
    const KeyLine line(layout, frame->quotient, frame->divisor);
    if (line.words() > 2) return DivisionOutcome::overflow;
    return divide_terms(*b, *frame, line);
}

std::optional<Polynomial> finished(const Polynomial& a, const Polynomial& b, DivisionOutcome outcome,
                                   base::Run& run, auto&& make) {
    if (outcome == DivisionOutcome::exact) return make();
    if (outcome == DivisionOutcome::inexact) return std::nullopt;
    Division division = divide(a, {&b, 1}, run);
    if (!division.remainder.is_zero()) return std::nullopt;
    return std::move(division.quotients.front());
}

std::optional<Polynomial> divide_residues(const Polynomial& a, const Polynomial& b,
                                          const ExactDivisionOptions& options, base::Run& run) {
    const PrimeField& field = a.ring().field().prime_field();
    const ResidueTerms& terms = a.residue_terms();
    ResidueTerms result(*terms.layout);
    const auto divide_coefficient = [&field](std::uint32_t& c, std::uint32_t d) {
        c = field.multiply(c, field.inverse(d));
        return true;
    };
    const auto divide_long = [&](const ResidueTerms& divisor, const Frame& frame, const KeyLine& line) {
        return divide_terms(terms, divisor, frame, line, field, options, run, result);
    };
    const auto outcome = quotient_of(terms, b.residue_terms(), divide_coefficient, divide_long, run, result);
    return finished(a, b, outcome, run, [&] { return Polynomial::from_terms(a.ring(), std::move(result)); });
}

/// With numerators A, B and denominators, a/b = A/(B/c) · b.denominator() / (a.denominator() · c) where c is
/// the content of B. As B/c is primitive, it divides A over ℚ only if it does over ℤ (Gauss's lemma).
std::optional<Polynomial> divide_rationals(const Polynomial& a, const Polynomial& b,
                                           const ExactDivisionOptions& options, base::Run& run) {
    const IntegerTerms& terms = a.integer_terms();
    IntegerTerms primitive = b.integer_terms();
    const Integer content = content_of(primitive);
    if (!content.is_one()) {
        for (Integer& c : primitive.coefficients) c.divide_exactly(content);
    }
    IntegerTerms result(*terms.layout);
    const auto divide_coefficient = [](Integer& c, const Integer& d) {
        const Integer dividend = c;
        return dividend.try_divide(d, c);
    };
    const auto divide_long = [&](const IntegerTerms& divisor, const Frame& frame, const KeyLine& line) {
        return divide_terms(terms, divisor, frame, line, options, run, result);
    };
    const auto outcome = quotient_of(terms, primitive, divide_coefficient, divide_long, run, result);
    return finished(a, b, outcome, run, [&] {
        if (!b.denominator().is_one()) {
            for (Integer& c : result.coefficients) c *= b.denominator();
        }
        return Polynomial::from_terms(a.ring(), std::move(result), a.denominator() * content);
    });
}

} // namespace

std::optional<Polynomial> try_divide_with(const Polynomial& a, const Polynomial& b,
                                          const ExactDivisionOptions& options, base::Run& run) {
    require_same_ring(a.ring(), b.ring(), "exact division of polynomials");
    if (b.is_zero()) throw DomainError("division by the zero polynomial");
    if (a.is_zero()) return a;
    return a.ring().field().is_rationals() ? divide_rationals(a, b, options, run)
                                           : divide_residues(a, b, options, run);
}

std::optional<Polynomial> try_divide(const Polynomial& a, const Polynomial& b, base::Run& run) {
    return try_divide_with(a, b, {}, run);
}

std::optional<Polynomial> try_divide(const Polynomial& a, const Polynomial& b) {
    base::Run run;
    return try_divide(a, b, run);
}

Polynomial divide_exactly(const Polynomial& a, const Polynomial& b, base::Run& run) {
    auto quotient = try_divide(a, b, run);
    if (!quotient) throw DomainError("exact division of polynomials: the divisor does not divide");
    return *std::move(quotient);
}

Polynomial divide_exactly(const Polynomial& a, const Polynomial& b) {
    base::Run run;
    return divide_exactly(a, b, run);
}

} // namespace eliminant::algebra
