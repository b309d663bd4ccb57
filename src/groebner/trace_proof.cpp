#include "trace_proof.hpp"

#include "base/parallel.hpp"
#include "groebner/monomial_ideal.hpp"

#include <algorithm>
#include <bit>
#include <map>
#include <optional>
#include <utility>

namespace eliminant::groebner {

using algebra::Integer;
using algebra::PrimeField;
using algebra::RationalLifting;

namespace {

using PrimesRow = SparseRow<LaneEntry>;

/// Generators and elements as integer vectors, with the size of their coefficients.
struct Operands {
    std::vector<const std::vector<Integer>*> coefficients;
    std::vector<std::size_t> bits; ///< of the largest coefficient
    std::size_t generator_count = 0;

    void add(const std::vector<Integer>& vector) {
        coefficients.push_back(&vector);
        std::size_t most = 0;
        for (const Integer& c : vector) most = std::max(most, c.bit_length());
        bits.push_back(most);
    }
};

/// The operands modulo eight primes.
struct Pack {
    explicit Pack(const LaneEntry& numbers) : primes(numbers), lanes(numbers) {}

    LaneEntry primes;
    LanePrimes lanes;
    /// Elements are divided by their leading coefficients; behind the last coefficient stands the factor by
    /// which that was done: 1 for generators.
    std::vector<std::vector<LaneEntry>> operands;
    std::vector<LaneEntry> leads; ///< what they were divided by
    bool is_good = true;          ///< no leading coefficient vanishes
};

Pack make_pack(const Operands& operands, const LaneEntry& primes, base::Run& run) {
    Pack pack(primes);
    const LaneKernels& kernels = lane_kernels(base::best_vector_unit());
    const std::vector<PrimeField> fields(std::begin(primes.lane), std::end(primes.lane));
    for (std::size_t k = 0; k < operands.coefficients.size(); ++k) {
        run.poll();
        const std::vector<Integer>& integers = *operands.coefficients[k];
        std::vector<LaneEntry> image(integers.size() + 1);
        for (std::size_t i = 0; i < integers.size(); ++i) {
            if (i % 4096 == 4095) run.poll();
            for (std::size_t lane = 0; lane < lane_count; ++lane)
                image[i].lane[lane] = fields[lane].from_integer(integers[i]);
        }
        LaneEntry lead{};
        LaneEntry factor{};
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            const std::uint32_t c = k < operands.generator_count ? 1 : image.front().lane[lane];
            if (c == 0) pack.is_good = false;
            lead.lane[lane] = c;
            factor.lane[lane] = c == 0 ? 0 : fields[lane].inverse(c);
        }
        kernels.scale(pack.lanes, factor, integers.size(), image.data());
        image.back() = factor;
        pack.operands.push_back(std::move(image));
        pack.leads.push_back(lead);
    }
    return pack;
}

/// A matrix whose pivots and found elements have a column of their own each, behind the others: what stands
/// there after the elimination of a row is, but for the sign, the multiple of them that was subtracted.
class TaggedRound {
  public:
    /// \param first_found the operand that is its first found element
    TaggedRound(const F4Round& round, const Operands& operands, std::size_t first_found)
        : round_(round), operands_(operands) {
        for (const F4Round::Row& pivot : round.pivots) {
            const auto begin = round.columns_of_rows.begin() + static_cast<std::ptrdiff_t>(pivot.begin);
            add(pivot.operand, {begin, begin + static_cast<std::ptrdiff_t>(size(pivot.operand))});
        }
        for (std::size_t i = 0; i < round.found_count(); ++i) {
            add(first_found + i, {round.support.begin() + static_cast<std::ptrdiff_t>(round.found[i]),
                                  round.support.begin() + static_cast<std::ptrdiff_t>(round.found[i + 1])});
        }
    }

    std::size_t row_count() const { return round_.rows.size(); }
    std::size_t row_operand(std::size_t row) const { return round_.rows[row].operand; }
    std::size_t tag_count() const { return tagged_.size(); }
    std::size_t tag_operand(std::size_t tag) const { return tagged_[tag].operand; }
    bool is_found(std::size_t tag) const { return tag >= round_.pivots.size(); }

    using Multipliers = std::vector<std::pair<std::uint32_t, LaneEntry>>; ///< tags ascending

    /// The multipliers of each row modulo eight primes; nothing if a row does not reduce to zero.
    std::optional<std::vector<Multipliers>> multipliers(const Pack& pack, base::Run& run) const {
        std::vector<PrimesRow> by_column(round_.column_count + tag_count());
        for (const Tagged& row : tagged_) {
            by_column[row.columns.front()] = {row.columns.data(), pack.operands[row.operand].data(),
                                              row.columns.size()};
        }
        std::vector<LaneSum> dense(by_column.size());
        std::vector<std::uint32_t> columns(by_column.size());
        std::vector<LaneEntry> entries(by_column.size());
        std::vector<Multipliers> result;
        for (const F4Round::Row& row : round_.rows) {
            const std::uint32_t* const places = round_.columns_of_rows.data() + row.begin;
            const std::vector<LaneEntry>& image = pack.operands[row.operand];
            for (std::size_t i = 0; i < size(row.operand); ++i)
                std::ranges::copy(image[i].lane, dense[places[i]].lane);
            const std::size_t count = reduce(pack, by_column, dense, columns, entries, run);
            if (count > 0 && columns[0] < round_.column_count) return std::nullopt;
            result.push_back(signed_multipliers(pack, row.operand, columns, entries, count));
        }
        return result;
    }

  private:
    struct Tagged {
        std::size_t operand;
        std::vector<std::uint32_t> columns;
    };

    std::size_t size(std::size_t operand) const { return operands_.coefficients[operand]->size(); }

    void add(std::size_t operand, std::vector<std::uint32_t> columns) {
        columns.push_back(static_cast<std::uint32_t>(round_.column_count + tagged_.size()));
        tagged_.push_back({operand, std::move(columns)});
    }

    static std::size_t reduce(const Pack& pack, const std::vector<PrimesRow>& by_column,
                              std::vector<LaneSum>& dense, std::vector<std::uint32_t>& columns,
                              std::vector<LaneEntry>& entries, base::Run& run) {
        constexpr std::size_t step = 1024; // columns between polls
        const LaneKernels& kernels = lane_kernels(base::best_vector_unit());
        std::size_t count = 0;
        for (std::size_t begin = 0; begin < dense.size(); begin += step) {
            run.poll();
            count += kernels.reduce_primes(pack.lanes, by_column.data(), begin,
                                           std::min(begin + step, dense.size()), dense.data(),
                                           columns.data() + count, entries.data() + count, nullptr);
        }
        return count;
    }

    /// With regard to the integer vectors, of which the row and the others are multiples modulo the primes.
    Multipliers signed_multipliers(const Pack& pack, std::size_t row_operand,
                                   const std::vector<std::uint32_t>& columns, std::vector<LaneEntry>& entries,
                                   std::size_t count) const {
        const LaneKernels& kernels = lane_kernels(base::best_vector_unit());
        kernels.scale(pack.lanes, pack.leads[row_operand], count, entries.data());
        Multipliers result;
        for (std::size_t i = 0; i < count; ++i) {
            LaneEntry multiplier{};
            for (std::size_t lane = 0; lane < lane_count; ++lane) {
                const std::uint32_t c = entries[i].lane[lane];
                multiplier.lane[lane] = c == 0 ? 0 : pack.primes.lane[lane] - c;
            }
            result.emplace_back(columns[i] - static_cast<std::uint32_t>(round_.column_count), multiplier);
        }
        return result;
    }

    const F4Round& round_;
    const Operands& operands_;
    std::vector<Tagged> tagged_; ///< pivots, then found elements
};

/// The images of all operands modulo more and more primes.
class Packs {
  public:
    Packs(const Operands& operands, PrimeSequence& primes, base::Run& run)
        : operands_(operands), primes_(primes), run_(run) {}

    const Pack& operator[](std::size_t i) const { return packs_[i]; }

    void extend(std::size_t count) {
        if (count <= packs_.size()) return;
        std::vector<LaneEntry> numbers(count - packs_.size());
        for (LaneEntry& entry : numbers) std::ranges::generate(entry.lane, [this] { return primes_.next(); });
        std::vector<std::optional<Pack>> made(numbers.size());
        base::parallel_for(run_, made.size(), [&](std::size_t i, std::size_t) {
            made[i] = make_pack(operands_, numbers[i], run_);
        });
        for (std::optional<Pack>& pack : made) {
            if (pack->is_good) packs_.push_back(std::move(*pack));
        }
        extend(count);
    }

  private:
    const Operands& operands_;
    PrimeSequence& primes_;
    base::Run& run_;
    std::vector<Pack> packs_;
};

/// The proof for one matrix.
class RoundProof {
  public:
    RoundProof(const TaggedRound& round, const Operands& operands, Packs& packs, base::Run& run)
        : round_(round), operands_(operands), packs_(packs), run_(run) {}

    /// \param expected how many packs may be needed
    bool succeeds(std::size_t expected) {
        const std::size_t threads = run_.threads();
        std::size_t more = std::max<std::size_t>(expected, 1);
        while (true) {
            if (!add_packs(more)) return false;
            more = threads * (1 + used_ / (4 * threads)); // each try begins anew
            if (lifting_->lift_with_all_primes(run_) && identities_hold()) return true;
        }
    }

    std::size_t packs_used() const { return used_; }

  private:
    bool add_packs(std::size_t count) {
        packs_.extend(used_ + count);
        std::vector<std::optional<std::vector<TaggedRound::Multipliers>>> made(count);
        base::parallel_for(run_, count, [&](std::size_t i, std::size_t) {
            made[i] = round_.multipliers(packs_[used_ + i], run_);
        });
        for (std::size_t i = 0; i < count; ++i, ++used_) {
            if (!made[i]) return false;
            if (!lifting_ && !begin(*made[i], packs_[used_])) return false;
            if (!add(*made[i], packs_[used_])) return false;
        }
        return true;
    }

    bool begin(const std::vector<TaggedRound::Multipliers>& rows, const Pack& pack) {
        std::vector<std::size_t> sizes;
        for (const auto& row : rows) {
            auto& tags = tags_.emplace_back();
            for (const auto& [tag, multiplier] : row) tags.push_back(tag);
            sizes.push_back(tags.size());
        }
        lifting_.emplace(sizes);
        return elements_are_independent(rows, pack);
    }

    /// Whether the multipliers of the found elements make an invertible matrix modulo the first prime.
    bool elements_are_independent(const std::vector<TaggedRound::Multipliers>& rows, const Pack& pack) const {
        const PrimeField field(pack.primes.lane[0]);
        const std::size_t first = round_.tag_count() - rows.size();
        std::vector<std::vector<std::uint32_t>> matrix;
        for (const auto& row : rows) {
            auto& dense = matrix.emplace_back(rows.size(), 0);
            for (const auto& [tag, multiplier] : row)
                if (round_.is_found(tag)) dense[tag - first] = multiplier.lane[0];
        }
        for (std::size_t c = 0; c < matrix.size(); ++c) {
            run_.poll();
            std::size_t pivot = c;
            while (pivot < matrix.size() && matrix[pivot][c] == 0) ++pivot;
            if (pivot == matrix.size()) return false;
            std::swap(matrix[c], matrix[pivot]);
            const std::uint32_t inverse = field.inverse(matrix[c][c]);
            for (std::size_t i = c + 1; i < matrix.size(); ++i) {
                if (matrix[i][c] == 0) continue;
                const std::uint32_t factor = field.multiply(matrix[i][c], inverse);
                for (std::size_t k = c; k < matrix.size(); ++k)
                    matrix[i][k] = field.subtract(matrix[i][k], field.multiply(factor, matrix[c][k]));
            }
        }
        return true;
    }

    /// False if there is a multiplier that vanished modulo the first primes.
    bool add(const std::vector<TaggedRound::Multipliers>& rows, const Pack& pack) {
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            std::vector<std::uint32_t> residues;
            residues.reserve(lifting_->entry_count());
            for (std::size_t r = 0; r < rows.size(); ++r) {
                std::size_t next = 0;
                for (const std::uint32_t tag : tags_[r]) {
                    const bool has = next < rows[r].size() && rows[r][next].first == tag;
                    residues.push_back(has ? rows[r][next++].second.lane[lane] : 0);
                }
                if (next != rows[r].size()) return false;
            }
            lifting_->add(pack.primes.lane[lane], std::move(residues));
            modulus_ *= pack.primes.lane[lane];
        }
        return true;
    }

    /// Whether the product of the primes exceeds twice what can stand on either side of (1).
    bool identities_hold() const {
        const std::size_t available = mpz_sizeinbase(modulus_.get_mpz_t(), 2) - 1; // 2^available ≤ M
        for (std::size_t r = 0; r < tags_.size(); ++r) {
            const RationalLifting::Vector& multipliers = lifting_->vectors()[r];
            std::size_t bits = multipliers.denominator.bit_length() + operands_.bits[round_.row_operand(r)];
            for (std::size_t i = 0; i < tags_[r].size(); ++i) {
                bits = std::max(bits, multipliers.numerators[i].bit_length() +
                                          operands_.bits[round_.tag_operand(tags_[r][i])]);
            }
            // tags + 1 summands, each below 2^bits in size.
            if (bits + static_cast<std::size_t>(std::bit_width(tags_[r].size() + 1)) + 1 > available)
                return false;
        }
        return true;
    }

    const TaggedRound& round_;
    const Operands& operands_;
    Packs& packs_;
    base::Run& run_;
    std::size_t used_ = 0; ///< packs
    mpz_class modulus_ = 1;
    std::vector<std::vector<std::uint32_t>> tags_; ///< per row: those with multipliers
    std::optional<RationalLifting> lifting_;
};

/// ∏(1 − t^d) over the degrees, unless it has very many terms or exponents that overflow.
std::optional<SparseSeries> numerator_of_complete_intersection(const std::vector<std::uint64_t>& degrees) {
    constexpr std::size_t many = 100000;
    std::map<std::uint64_t, Integer> product{{0, Integer(1)}};
    for (const std::uint64_t d : degrees) {
        std::map<std::uint64_t, Integer> next = product;
        for (const auto& [exponent, c] : product) {
            std::uint64_t sum = 0;
            if (__builtin_add_overflow(exponent, d, &sum) || next.size() > many) return std::nullopt;
            next[sum] -= c;
        }
        std::erase_if(next, [](const auto& term) { return term.second.is_zero(); });
        product = std::move(next);
    }
    return SparseSeries(product.begin(), product.end());
}

bool has_finite_dimension(const std::vector<Exponents>& leads) {
    const std::size_t n = leads.empty() ? 1 : leads.front().size();
    std::vector<char> has_power(n, 0);
    for (const Exponents& lead : leads) {
        if (std::ranges::count_if(lead, [](std::uint64_t e) { return e > 0; }) != 1) continue;
        const auto variable = std::ranges::find_if(lead, [](std::uint64_t e) { return e > 0; });
        has_power[static_cast<std::size_t>(variable - lead.begin())] = 1;
    }
    return std::ranges::count(has_power, 0) == 0;
}

} // namespace

bool lies_in_ideal_of_generators(const F4Trace& trace, std::span<const RationalLifting::Vector> elements,
                                 PrimeSequence& primes, base::Run& run) {
    Operands operands;
    for (const auto& generator : trace.generators()) operands.add(generator);
    operands.generator_count = trace.generators().size();
    for (const RationalLifting::Vector& element : elements) operands.add(element.numerators);
    Packs packs(operands, primes, run);
    std::size_t first_found = operands.generator_count;
    std::size_t expected_packs = 1;
    for (const F4Round& round : trace.rounds()) {
        run.report([&] {
            const auto done = static_cast<std::uint64_t>(&round - trace.rounds().data());
            return base::Progress{"proof", done, trace.rounds().size(),
                                  std::to_string(round.rows.size()) + " rows"};
        });
        if (round.rows.size() != round.found_count()) return false;
        if (round.found_count() == 0) continue;
        const TaggedRound tagged(round, operands, first_found);
        RoundProof proof(tagged, operands, packs, run);
        if (!proof.succeeds(expected_packs)) return false;
        expected_packs = 2 * proof.packs_used() / 3; // numbers grow from matrix to matrix, mostly
        first_found += round.found_count();
    }
    return true;
}

bool has_all_leading_monomials(const F4Trace& trace, std::span<const algebra::Polynomial> generators,
                               base::Run& run) {
    const std::vector<Exponents> leads = leading_exponents(trace.basis().elements);
    if (leads.size() == 1 && trace.basis().elements.front().is_constant()) return true;
    std::vector<std::uint64_t> degrees;
    bool are_homogeneous = true;
    for (const algebra::Polynomial& f : generators) {
        if (f.is_zero()) continue;
        are_homogeneous = are_homogeneous && f.is_homogeneous();
        degrees.push_back(static_cast<std::uint64_t>(f.total_degree()));
    }
    const std::size_t n = trace.ring().variable_count();
    if (degrees.size() == n && has_finite_dimension(leads)) return true;
    return are_homogeneous && degrees.size() <= n &&
           hilbert_numerator(leads, run) == numerator_of_complete_intersection(degrees);
}

} // namespace eliminant::groebner
