#include "multiply.hpp"

#include "multiply_kernels.hpp"
#include "multiply_keys.hpp"
#include "multiply_kronecker.hpp"
#include "multiply_plan.hpp"
#include "multiply_points.hpp"
#include "multiply_sums.hpp"

#include <algorithm>
#include <concepts>
#include <limits>
#include <optional>
#include <utility>

namespace eliminant::algebra {

namespace {

template <class Sums>
constexpr bool is_modular = std::same_as<Sums, ResidueSums>;

/// Products of terms below which evaluation is not worth a plan.
constexpr std::size_t fewest_products = 1 << 14;

/// One product once its spans, layout and accumulators are settled.
template <class Sums>
class Product {
  public:
    using Element = typename Sums::Element;
    using Operand = typename Sums::Operand;

    /// `bits` bounds the coefficients of the result; it matters only over ℚ.
    Product(const KeyLine& line, const Sums& sums, std::size_t bits, const ProductOptions& options,
            base::Run& run)
        : sums_(sums), bits_(bits), options_(options), run_(run), decoder_(line), result_(line.target()) {}

    /// nullopt if another method, which takes so many nanoseconds, is expected to be faster.
    template <class Key>
    std::optional<TermList<Element>> compute(const KeyedTerms<Key, Operand>& a,
                                             const KeyedTerms<Key, Operand>& b, double other_cost) {
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
                choice =
                    choose_window(count_windows(a.keys), count_windows(b.keys),
                                  static_cast<double>(a.keys[0] + b.keys[0]) + 1, sizeof(typename Sums::Cell),
                                  Sums::polls ? 15 + 2.5e-5 * static_cast<double>(bits_ * bits_) : 0);
            if (options_.kernel == ProductKernel::window && choice.bits == 0) choice.bits = min_window_bits;
            if constexpr (std::same_as<Key, std::uint64_t>) {
                const std::size_t slot_bits = sums_.slot_bits(bits_);
                const double cost = kronecker_cost(a.keys[0], b.keys[0], a.size() + b.size(), slot_bits);
                constexpr std::uint64_t forced_limit = 1 << 20; // exponents near 2^63 would need 2^63 slots
                if ((options_.kernel == ProductKernel::kronecker && a.keys[0] + b.keys[0] < forced_limit) ||
                    (options_.kernel == ProductKernel::automatic &&
                     cost < std::min(choice.cost, other_cost))) {
                    multiply_by_kronecker(a, b, slot_bits, sums_, run_, emit);
                    return std::move(result_);
                }
            }
            if (other_cost < choice.cost) return std::nullopt;
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
    const Sums& sums_;
    std::size_t bits_;
    const ProductOptions& options_;
    base::Run& run_;
    KeyDecoder decoder_;
    TermList<Element> result_;
};

template <class Sums>
TermList<typename Sums::Element> product(const Ring& ring, const TermList<typename Sums::Element>& a,
                                         const TermList<typename Sums::Element>& b, const Sums& sums,
                                         std::size_t bits, const ProductOptions& options, base::Run& run) {
    const auto spans_a = field_spans(*a.layout, a.monomials);
    const auto spans_b = field_spans(*b.layout, b.monomials);
    const KeyLine line(ring.layout_for(widest_field(spans_a, spans_b)), spans_a, spans_b);
    Product<Sums> engine(line, sums, bits, options, run);
    const OperandValues<Sums> values_a(a.coefficients);
    const OperandValues<Sums> values_b(b.coefficients);
    const bool is_forced = options.kernel == ProductKernel::points;
    std::optional<PointProduct> points;
    if (is_forced || (options.kernel == ProductKernel::automatic && a.size() * b.size() >= fewest_products))
        points = PointProduct::plan(line.target(), *a.layout, a.monomials, *b.layout, b.monomials);
    const auto multiply_by_points = [&] {
        if constexpr (is_modular<Sums>)
            return points->multiply(a.coefficients, b.coefficients, bits, sums.field, run);
        else
            return points->multiply(a.coefficients, b.coefficients, bits, run);
    };
    if (is_forced && points) return multiply_by_points();
    double points_cost = std::numeric_limits<double>::infinity();
    if (points) {
        if constexpr (is_modular<Sums>)
            points_cost = points->cost(bits, sums.field);
        else
            points_cost = points->cost(bits);
    }
    const auto compute = [&]<class Key>(std::type_identity<Key>) {
        const auto keyed = [&](const auto& terms, const auto& spans, const auto& values) {
            return KeyedTerms<Key, typename Sums::Operand>{
                as_keys<Key>(line.encode(*terms.layout, terms.monomials, spans), line.words()), values};
        };
        auto result = engine.compute(keyed(a, spans_a, values_a), keyed(b, spans_b, values_b), points_cost);
        return result ? *std::move(result) : multiply_by_points();
    };
    if (line.words() == 1) return compute(std::type_identity<std::uint64_t>{});
    if (line.words() == 2) return compute(std::type_identity<base::UInt128>{});
    return compute(std::type_identity<LongKey>{});
}

IntegerTerms integer_product(const Ring& ring, const IntegerTerms& a, const IntegerTerms& b,
                             const ProductOptions& options, base::Run& run) {
    const CoefficientSize size_a = coefficient_size(a.coefficients);
    const CoefficientSize size_b = coefficient_size(b.coefficients);
    const std::size_t bits = product_bits(size_a, size_b);
    if (!size_a.all_small || !size_b.all_small) return product(ring, a, b, IntegerSums{}, bits, options, run);
    if (bits < 64) return product(ring, a, b, WordSums<std::int64_t>{}, bits, options, run);
    if (bits < 128) return product(ring, a, b, WordSums<base::Int128>{}, bits, options, run);
    return product(ring, a, b, TripleSums{}, bits, options, run);
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
    const std::size_t bits = 2 * bit_width(std::uint64_t{ring.field().characteristic()}) +
                             bit_width(std::uint64_t{std::min(a.size(), b.size())});
    return Polynomial::from_terms(
        ring, product(ring, a.residue_terms(), b.residue_terms(), sums, bits, options, run));
}

Polynomial multiply(const Polynomial& a, const Polynomial& b, base::Run& run) {
    return multiply_with(a, b, {}, run);
}

Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    base::Run run;
    return multiply(a, b, run);
}

} // namespace eliminant::algebra
