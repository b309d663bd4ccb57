#include "multiply_points.hpp"

#include "base/parallel.hpp"

#include "point_transform.hpp"
#include "remainder_table.hpp"
#include "word_remainders.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

namespace eliminant::algebra {

namespace {

/// The work on a line of points grows with the square of its length.
constexpr std::uint32_t max_degree = 4096;

/// A factor's way from terms to its values at the points of the product.
class FactorValues {
  public:
    FactorValues(const ProductBox::Factor& factor, const ExponentSet& product, const PointTransform& target)
        : set_(factor.bounds, factor.degree), transform_(set_), target_(&target) {
        const std::size_t axes = set_.axes();
        for (std::size_t term = 0; term < factor.points.size(); term += axes)
            starts_.push_back(
                transform_.first_positions()[set_.rank(std::span(factor.points).subspan(term, axes))]);
        ends_.resize(set_.size());
        std::size_t rank = 0;
        set_.for_each_run([&](std::span<const std::uint32_t> e, std::uint32_t run) {
            const std::size_t first = product.rank(e);
            for (std::uint32_t t = 0; t < run; ++t, ++rank)
                ends_[transform_.newton_positions()[rank]] = target.newton_positions()[first + t];
        });
    }

    /// \param residue of the coefficient of the i-th term
    template <class Residue>
    PointTransform::Values at_points(const PrimeField& field, const Residue& residue,
                                     const base::Run& run) const {
        PointTransform::Values newton(transform_.size(), 0);
        for (std::size_t i = 0; i < starts_.size(); ++i) newton[starts_[i]] = residue(i);
        transform_.monomials_to_newton(newton, field, run);
        PointTransform::Values values(target_->size(), 0);
        for (std::size_t i = 0; i < newton.size(); ++i) values[ends_[i]] = newton[i];
        target_->newton_to_values(values, field, run);
        return values;
    }

  private:
    ExponentSet set_;
    PointTransform transform_;
    const PointTransform* target_;
    std::vector<std::uint32_t> starts_; ///< of the terms in the factor's first layout
    std::vector<std::uint32_t> ends_;   ///< in the product's last layout, by place in the factor's last
};

/// A product modulo some primes: residues by prime, then by the rank of the monomial's point.
struct ProductImages {
    ExponentSet set;
    std::vector<std::uint32_t> primes;
    std::vector<PointTransform::Values> residues;

    /// \param residue_a (i, field) is the image of the coefficient of the i-th term of a
    template <class ResidueA, class ResidueB>
    ProductImages(const ProductBox& box, std::vector<std::uint32_t> moduli, const ResidueA& residue_a,
                  const ResidueB& residue_b, const base::Run& run)
        : set({box.bounds().begin(), box.bounds().end()}, box.degree()), primes(std::move(moduli)),
          residues(primes.size()) {
        const PointTransform transform(set);
        const FactorValues a(box.a(), set, transform);
        const FactorValues b(box.b(), set, transform);
        base::parallel_for(run, primes.size(), [&](std::size_t k, std::size_t) {
            const PrimeField field(primes[k]);
            PointTransform::Values values = a.at_points(
                field, [&](std::size_t i) { return residue_a(i, field); }, run);
            const PointTransform::Values others = b.at_points(
                field, [&](std::size_t i) { return residue_b(i, field); }, run);
            residue_rows().multiply(values.data(), others.data(), values.size(), primes[k]);
            transform.values_to_newton(values, field, run);
            transform.newton_to_monomials(values, field, run);
            residues[k].resize(values.size());
            const auto positions = transform.first_positions();
            for (std::size_t rank = 0; rank < values.size(); ++rank)
                residues[k][rank] = values[positions[rank]];
        });
    }

    bool is_zero(std::size_t rank) const {
        return std::ranges::all_of(residues, [rank](const auto& image) { return image[rank] == 0; });
    }
};

/// Primes from 2^31 down whose product exceeds 2^bits.
std::vector<std::uint32_t> primes_beyond(std::size_t bits) {
    std::vector<std::uint32_t> primes;
    std::uint64_t bound = std::uint64_t{1} << 31;
    // Each is above 2^30.99 for as long as there are fewer than ten thousand.
    for (std::size_t known = 0; known <= 100 * bits; known += 3099) {
        bound = previous_prime(bound);
        primes.push_back(static_cast<std::uint32_t>(bound));
    }
    return primes;
}

/// Sorts keys, and what goes with them, byte by byte, least significant first, where they differ at all.
void sort_decreasing(std::vector<MonomialLayout::Word>& keys, std::vector<std::uint32_t>& companions) {
    MonomialLayout::Word differing = 0;
    for (const MonomialLayout::Word key : keys) differing |= key ^ keys[0];
    std::vector<MonomialLayout::Word> sorted_keys(keys.size());
    std::vector<std::uint32_t> sorted(keys.size());
    for (unsigned shift = 0; shift < 64; shift += 8) {
        if ((differing >> shift & 0xff) == 0) continue;
        std::size_t begins[257] = {};
        for (const MonomialLayout::Word key : keys) ++begins[256 - (key >> shift & 0xff)];
        std::partial_sum(std::begin(begins), std::end(begins), std::begin(begins));
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const std::size_t place = begins[255 - (keys[i] >> shift & 0xff)]++;
            sorted_keys[place] = keys[i];
            sorted[place] = companions[i];
        }
        keys.swap(sorted_keys);
        companions.swap(sorted);
    }
}

/// The monomials at whose points an image is not zero, decreasing in the order of the ring.
struct Support {
    std::vector<MonomialLayout::Word> monomials;
    std::vector<std::uint32_t> ranks; ///< of their points
};

Support support_of(const ProductBox& box, const ProductImages& images, const base::Run& run) {
    const std::size_t words = box.target().words();
    Support support;
    std::vector<MonomialLayout::Word> monomial(words);
    std::uint32_t rank = 0;
    images.set.for_each_run([&](std::span<const std::uint32_t> e, std::uint32_t length) {
        run.poll();
        std::copy(box.origin().begin(), box.origin().end(), monomial.begin());
        for (std::size_t axis = 0; axis < e.size(); ++axis) {
            for (std::size_t w = 0; w < words; ++w) monomial[w] += e[axis] * box.step(axis)[w];
        }
        for (std::uint32_t t = 0; t < length; ++t, ++rank) {
            if (!images.is_zero(rank)) {
                support.monomials.insert(support.monomials.end(), monomial.begin(), monomial.end());
                support.ranks.push_back(rank);
            }
            for (std::size_t w = 0; w < words; ++w) monomial[w] += box.step(e.size() - 1)[w];
        }
    });
    return support;
}

void sort_decreasing(const MonomialLayout& layout, Support& support) {
    const std::size_t words = layout.words();
    const auto comes_before = [&](std::uint32_t i, std::uint32_t j) {
        return layout.compare(support.monomials.data() + i * words, support.monomials.data() + j * words) > 0;
    };
    bool is_sorted = true;
    for (std::uint32_t i = 1; i < support.ranks.size() && is_sorted; ++i) is_sorted = comes_before(i - 1, i);
    if (is_sorted) return;
    if (words == 1) {
        for (MonomialLayout::Word& m : support.monomials) m ^= layout.flip()[0];
        sort_decreasing(support.monomials, support.ranks);
        for (MonomialLayout::Word& m : support.monomials) m ^= layout.flip()[0];
        return;
    }
    std::vector<std::uint32_t> sequence(support.ranks.size());
    std::iota(sequence.begin(), sequence.end(), 0U);
    std::ranges::sort(sequence, comes_before);
    Support sorted;
    for (const std::uint32_t i : sequence) {
        const auto first = support.monomials.begin() + static_cast<std::ptrdiff_t>(i * words);
        sorted.monomials.insert(sorted.monomials.end(), first, first + static_cast<std::ptrdiff_t>(words));
        sorted.ranks.push_back(support.ranks[i]);
    }
    support = std::move(sorted);
}

/// \param value (rank) is the coefficient at a point where an image is not zero
template <class Element, class Value>
TermList<Element> collect(const ProductBox& box, const ProductImages& images, const Value& value,
                          const base::Run& run) {
    Support support = support_of(box, images, run);
    sort_decreasing(box.target(), support);
    TermList<Element> terms(box.target());
    terms.reserve(support.ranks.size());
    const MonomialLayout::Word* monomial = support.monomials.data();
    for (const std::uint32_t rank : support.ranks) {
        if (rank % 1024 == 0) run.poll();
        Element coefficient = value(rank);
        if (coefficient != Element(0)) terms.push_back(monomial, std::move(coefficient));
        monomial += box.target().words();
    }
    return terms;
}

} // namespace

PointProduct::PointProduct(ProductBox box)
    : box_(std::move(box)), census_(ExponentSet::census(box_.bounds(), box_.degree())) {}

std::optional<PointProduct> PointProduct::plan(const MonomialLayout& target, const MonomialLayout& layout_a,
                                               std::span<const Word> a, const MonomialLayout& layout_b,
                                               std::span<const Word> b) {
    auto box = ProductBox::of(target, max_degree, layout_a, a, layout_b, b);
    if (!box) return std::nullopt;
    PointProduct product(*std::move(box));
    // Their numbers have 32 bits, and where they outnumber the products of terms by far those are faster.
    const std::size_t terms_a = a.size() / layout_a.words();
    const std::size_t terms_b = b.size() / layout_b.words();
    const double products = static_cast<double>(terms_a) * static_cast<double>(terms_b);
    if (product.census_.points > std::min(1e9, products + 1024)) return std::nullopt;
    return product;
}

bool PointProduct::suits(const PrimeField& field) const {
    return field.characteristic() > *std::ranges::max_element(box_.bounds()) && field.characteristic() != 2;
}

double PointProduct::cost_of_images(std::size_t primes) const {
    // Measured on Zen 5 with products of 1 to 8 variables.
    const auto axes = static_cast<double>(box_.axes());
    const double points = census_.points;
    const double layouts = points * axes * (4 + 3 * axes / (1 + static_cast<double>(box_.degree()) / axes));
    double rows = 0;
    for (const std::uint32_t bound : box_.bounds()) rows += 8 * static_cast<double>(bound) * bound;
    return 5000 + layouts + static_cast<double>(primes) * (0.5 * census_.degrees + 6 * axes * points + rows);
}

double PointProduct::cost(std::size_t bits) const {
    const std::size_t primes = bits / 31 + 1;
    const auto count = static_cast<double>(primes);
    const double remainders = primes <= WordRemainders::max_primes ? 5 : 10 + count / 8;
    return cost_of_images(primes) + census_.points * remainders * count;
}

double PointProduct::cost(std::size_t bits, const PrimeField& field) const {
    return suits(field) ? cost_of_images(1) : cost(bits);
}

IntegerTerms PointProduct::multiply(std::span<const Integer> a, std::span<const Integer> b, std::size_t bits,
                                    const base::Run& run) const {
    const auto residue_a = [&](std::size_t i, const PrimeField& field) { return field.from_integer(a[i]); };
    const auto residue_b = [&](std::size_t i, const PrimeField& field) { return field.from_integer(b[i]); };
    const ProductImages images(box_, primes_beyond(bits + 1), residue_a, residue_b, run);
    if (images.primes.size() <= WordRemainders::max_primes) {
        const WordRemainders remainders(images.primes);
        return collect<Integer>(
            box_, images,
            [&](std::size_t rank) {
                const base::UInt128 x =
                    remainders.value([&](std::size_t k) { return images.residues[k][rank]; });
                const bool negative = x > remainders.modulus() / 2;
                return Integer::from_wide(static_cast<base::Int128>(negative ? x - remainders.modulus() : x));
            },
            run);
    }
    const RemainderTable table(images.primes);
    const RemainderTable::Factor one = table.prepare(Integer(1));
    std::vector<std::uint32_t> residues(images.primes.size());
    std::vector<mp_limb_t> scratch;
    mpz_class x;
    return collect<Integer>(
        box_, images,
        [&](std::size_t rank) {
            for (std::size_t k = 0; k < residues.size(); ++k) residues[k] = images.residues[k][rank];
            table.combine(residues, one, scratch, x);
            return Integer(x);
        },
        run);
}

ResidueTerms PointProduct::multiply(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b,
                                    std::size_t bits, const PrimeField& field, const base::Run& run) const {
    if (suits(field)) {
        const ProductImages images(
            box_, {field.characteristic()}, [&](std::size_t i, const PrimeField&) { return a[i]; },
            [&](std::size_t i, const PrimeField&) { return b[i]; }, run);
        return collect<std::uint32_t>(
            box_, images, [&](std::size_t rank) { return images.residues[0][rank]; }, run);
    }
    const ProductImages images(
        box_, primes_beyond(bits), [&](std::size_t i, const PrimeField& image) { return image.reduce(a[i]); },
        [&](std::size_t i, const PrimeField& image) { return image.reduce(b[i]); }, run);
    const WordRemainders remainders(images.primes);
    return collect<std::uint32_t>(
        box_, images,
        [&](std::size_t rank) {
            return reduced(remainders.value([&](std::size_t k) { return images.residues[k][rank]; }), field);
        },
        run);
}

} // namespace eliminant::algebra
