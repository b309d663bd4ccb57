#include "multiply.hpp"

#include "multiply_kernels.hpp"
#include "multiply_keys.hpp"
#include "multiply_plan.hpp"
#include "multiply_sums.hpp"

#include <algorithm>
#include <concepts>
#include <utility>

namespace eliminant::algebra {

namespace {

/// One product once its spans, layout and accumulators are settled.
template <class Sums>
class Product {
  public:
    using Element = typename Sums::Element;
    using Operand = typename Sums::Operand;

    Product(const KeyLine& line, const Sums& sums, const ProductOptions& options, base::Run& run)
        : line_(line), sums_(sums), options_(options), run_(run), decoder_(line), result_(line.target()) {}

    template <class Key>
    TermList<Element> compute(const KeyedTerms<Key, Operand>& a, const KeyedTerms<Key, Operand>& b) {
        const auto emit = [this](const Key& key, Element&& value) {
            result_.monomials.resize(result_.monomials.size() + result_.layout->words());
            decode_key(decoder_, key,
                       result_.monomials.data() + result_.monomials.size() - result_.layout->words());
            result_.coefficients.push_back(std::move(value));
        };
        WindowChoice choice;
        choice.swapped = b.size() < a.size();
        if constexpr (!std::same_as<Key, LongKey>) {
            if (options_.kernel != ProductKernel::heap)
                choice = choose_window(count_windows(a.keys), count_windows(b.keys),
                                       static_cast<double>(a.keys[0] + b.keys[0]) + 1,
                                       sizeof(typename Sums::Cell));
            if (options_.kernel == ProductKernel::window && choice.bits == 0) choice.bits = min_window_bits;
            if (options_.window_bits != 0) choice.bits = options_.window_bits;
            if (choice.bits != 0) {
                multiply_by_window(choice.swapped ? b : a, choice.swapped ? a : b, choice.bits, sums_, run_,
                                   emit);
                return std::move(result_);
            }
        }
        multiply_by_heap(choice.swapped ? b : a, choice.swapped ? a : b, sums_, run_, emit);
        return std::move(result_);
    }

  private:
    const KeyLine& line_;
    const Sums& sums_;
    const ProductOptions& options_;
    base::Run& run_;
    KeyDecoder decoder_;
    TermList<Element> result_;
};

/// The widest fields of a product, and the narrowest layout that holds them.
const MonomialLayout& product_layout(const Ring& ring, std::span<const FieldSpan> a,
                                     std::span<const FieldSpan> b) {
    std::uint64_t widest = 0;
    for (std::size_t f = 0; f < a.size(); ++f) widest = std::max(widest, a[f].high + b[f].high);
    return ring.layout_for(widest);
}

template <class Sums>
TermList<typename Sums::Element> product(const Ring& ring, const TermList<typename Sums::Element>& a,
                                         const TermList<typename Sums::Element>& b, const Sums& sums,
                                         const ProductOptions& options, base::Run& run) {
    const auto spans_a = field_spans(*a.layout, a.monomials);
    const auto spans_b = field_spans(*b.layout, b.monomials);
    const KeyLine line(product_layout(ring, spans_a, spans_b), spans_a, spans_b);
    Product<Sums> engine(line, sums, options, run);
    const OperandValues<Sums> values_a(a.coefficients);
    const OperandValues<Sums> values_b(b.coefficients);
    const auto compute = [&]<class Key>(std::type_identity<Key>) {
        const auto keyed = [&](const auto& terms, const auto& spans, const auto& values) {
            return KeyedTerms<Key, typename Sums::Operand>{
                as_keys<Key>(line.encode(*terms.layout, terms.monomials, spans), line.words()), values};
        };
        return engine.compute(keyed(a, spans_a, values_a), keyed(b, spans_b, values_b));
    };
    if (line.words() == 1) return compute(std::type_identity<std::uint64_t>{});
    if (line.words() == 2) return compute(std::type_identity<base::UInt128>{});
    return compute(std::type_identity<LongKey>{});
}

IntegerTerms integer_product(const Ring& ring, const IntegerTerms& a, const IntegerTerms& b,
                             const ProductOptions& options, base::Run& run) {
    const CoefficientSize size_a = coefficient_size(a.coefficients);
    const CoefficientSize size_b = coefficient_size(b.coefficients);
    if (!size_a.all_small || !size_b.all_small) return product(ring, a, b, IntegerSums{}, options, run);
    const std::size_t bits = product_bits(size_a, size_b);
    if (bits < 64) return product(ring, a, b, WordSums<std::int64_t>{}, options, run);
    if (bits < 128) return product(ring, a, b, WordSums<base::Int128>{}, options, run);
    return product(ring, a, b, TripleSums{}, options, run);
}

} // namespace

Polynomial multiply_with(const Polynomial& a, const Polynomial& b, const ProductOptions& options,
                         base::Run& run) {
    require_same_ring(a.ring(), b.ring(), "product of polynomials");
    const Ring& ring = a.ring();
    if (a.is_zero() || b.is_zero()) return Polynomial(ring);
    if (ring.field().is_rationals())
        return Polynomial::from_terms(
            ring, integer_product(ring, a.integer_terms(), b.integer_terms(), options, run),
            a.denominator() * b.denominator());
    const ResidueSums sums(ring.field().prime_field());
    return Polynomial::from_terms(ring,
                                  product(ring, a.residue_terms(), b.residue_terms(), sums, options, run));
}

Polynomial multiply(const Polynomial& a, const Polynomial& b, base::Run& run) {
    return multiply_with(a, b, {}, run);
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    base::Run run;
    return multiply(a, b, run);
}

Polynomial pow(const Polynomial& f, std::uint64_t exponent, base::Run& run) {
    Polynomial result = Polynomial::constant(f.ring(), 1);
    Polynomial square = f;
    for (; exponent != 0; exponent >>= 1) {
        if ((exponent & 1) != 0) result = multiply(result, square, run);
        if (exponent > 1) square = multiply(square, square, run);
    }
    return result;
}

Polynomial pow(const Polynomial& f, std::uint64_t exponent) {
    base::Run run;
    return pow(f, exponent, run);
}

} // namespace eliminant::algebra
