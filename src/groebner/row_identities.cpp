#include "row_identities.hpp"

#include "algebra/rational_lifting.hpp"
#include "base/parallel.hpp"

#include <algorithm>
#include <bit>
#include <optional>
#include <unordered_map>
#include <utility>

namespace eliminant::groebner {

using algebra::PrimeField;
using algebra::RationalLifting;

namespace {

/// The basis elements of which multiples are subtracted from a row, by their numbers, ascending.
struct Multipliers {
    std::vector<std::uint32_t> tags;
    std::vector<LaneEntry> values;
};

/// What eight primes say about the rows.
struct Images {
    enum class Outcome : unsigned char {
        found,
        leads_vanish, ///< some leading coefficient modulo one of the primes: they say nothing
        rows_remain,  ///< some row does not reduce to zero
    };
    Outcome outcome = Outcome::found;
    std::vector<Multipliers> rows;
};

/// The elimination of the rows modulo eight primes. Each basis element has a column of its own, behind the
/// others: what stands there after the elimination of a row is, but for the sign, the multiple of it that was
/// subtracted.
///
///     basis  [ 1 * * … * | 1/ℓ₁          ]     divided by their leading coefficients ℓ
///            [   1 * … * |      1/ℓ₂     ]
///     rows   [ * * * … * |               ]
class TaggedElimination {
  public:
    TaggedElimination(const RowIdentities& identities, const Operands& operands, const LaneEntry& primes,
                      base::Run& run)
        : identities_(identities), operands_(operands), run_(run), pack_(primes),
          kernels_(lane_kernels(base::best_vector_unit())) {}

    Images images() {
        Images result;
        if (!add_basis()) {
            result.outcome = Images::Outcome::leads_vanish;
            return result;
        }
        for (const RowIdentities::Row& row : identities_.rows) {
            if (reduces_to_zero(row)) {
                result.rows.push_back(multipliers());
                continue;
            }
            result.outcome = Images::Outcome::rows_remain;
            break;
        }
        return result;
    }

  private:
    std::size_t columns_and_tags() const { return identities_.column_count + identities_.basis.size(); }

    const std::vector<LaneEntry>& residues(std::size_t operand) {
        const auto [place, is_new] = residues_.try_emplace(operand);
        if (is_new) place->second = pack_.residues(operands_[operand], run_);
        return place->second;
    }

    bool add_basis() {
        by_column_.resize(columns_and_tags());
        // Once for all multiples of an operand: divided by the leading coefficient, with 1/ℓ behind.
        for (std::size_t i = 0; i < identities_.basis.size(); ++i) {
            run_.poll();
            const RowIdentities::Row& row = identities_.basis[i];
            const auto [place, is_new] = monic_.try_emplace(row.operand);
            std::vector<LaneEntry>& monic = place->second;
            if (is_new) {
                monic = pack_.residues(operands_[row.operand], run_);
                if (std::ranges::count(monic.front().lane, 0U) != 0) return false;
                const LaneEntry inverse = pack_.inverse(monic.front());
                kernels_.scale(pack_.lanes(), inverse, monic.size(), monic.data());
                monic.push_back(inverse);
            }
            std::vector<std::uint32_t>& columns = columns_of_basis_.emplace_back();
            columns.reserve(row.columns.size() + 1);
            columns.assign(row.columns.begin(), row.columns.end());
            columns.push_back(static_cast<std::uint32_t>(identities_.column_count + i));
            by_column_[columns.front()] = {columns.data(), monic.data(), columns.size()};
        }
        dense_.resize(columns_and_tags());
        columns_.resize(columns_and_tags());
        entries_.resize(columns_and_tags());
        return true;
    }

    /// What is left of the row is in columns_ and entries_ then, count_ of them.
    bool reduces_to_zero(const RowIdentities::Row& row) {
        constexpr std::size_t step = 1024; // columns between polls
        const std::vector<LaneEntry>& image = residues(row.operand);
        for (std::size_t i = 0; i < image.size(); ++i)
            std::ranges::copy(image[i].lane, dense_[row.columns[i]].lane);
        count_ = 0;
        for (std::size_t begin = row.columns.front(); begin < dense_.size(); begin += step) {
            run_.poll();
            count_ += kernels_.reduce_primes(pack_.lanes(), by_column_.data(), begin,
                                             std::min(begin + step, dense_.size()), dense_.data(),
                                             columns_.data() + count_, entries_.data() + count_, nullptr);
        }
        return count_ == 0 || columns_[0] >= identities_.column_count;
    }

    Multipliers multipliers() const {
        Multipliers result;
        result.tags.resize(count_);
        result.values.resize(count_);
        for (std::size_t i = 0; i < count_; ++i) {
            result.tags[i] = columns_[i] - static_cast<std::uint32_t>(identities_.column_count);
            for (std::size_t lane = 0; lane < lane_count; ++lane)
                result.values[i].lane[lane] = pack_.field(lane).negate(entries_[i].lane[lane]);
        }
        return result;
    }

    const RowIdentities& identities_;
    const Operands& operands_;
    base::Run& run_;
    PrimePack pack_;
    const LaneKernels& kernels_;
    std::unordered_map<std::size_t, std::vector<LaneEntry>> residues_; ///< of the operands of rows
    std::unordered_map<std::size_t, std::vector<LaneEntry>> monic_;    ///< of those of the basis
    std::vector<std::vector<std::uint32_t>> columns_of_basis_;
    std::vector<SparseRow<LaneEntry>> by_column_;
    std::vector<LaneSum> dense_; ///< zero between rows
    std::vector<std::uint32_t> columns_;
    std::vector<LaneEntry> entries_;
    std::size_t count_ = 0;
};

} // namespace

/// The proof of one statement.
class IdentityProver::Statement {
  public:
    Statement(IdentityProver& prover, const RowIdentities& identities)
        : prover_(prover), run_(prover.run_), identities_(identities) {}

    /// \param expected how many packs may be needed
    bool holds(std::size_t expected) {
        const std::size_t threads = run_.threads();
        std::size_t more = std::max<std::size_t>(expected, 1);
        for (;;) {
            if (!add_packs(more)) return false;
            more = threads * (1 + used_ / (8 * threads)); // each try begins anew
            if (!lifting_ || !lifting_->lift_with_all_primes(run_)) continue;
            const std::size_t missing = missing_bits();
            if (missing == 0) return true;
            more = std::max(more, missing / (lane_count * DigitVector::digit_bits) + 1);
        }
    }

    std::size_t packs_used() const { return used_; }

  private:
    /// As many at a time as there are threads: their images take more memory than what is kept of them.
    bool add_packs(std::size_t count) {
        for (const std::size_t end = used_ + count; used_ < end;) {
            std::vector<LaneEntry> primes(std::min<std::size_t>(end - used_, run_.threads()));
            for (LaneEntry& entry : primes) entry = prover_.pack(used_++);
            std::vector<Images> images(primes.size());
            base::parallel_for(run_, primes.size(), [&](std::size_t i, std::size_t) {
                images[i] = TaggedElimination(identities_, prover_.operands_, primes[i], run_).images();
            });
            for (std::size_t i = 0; i < primes.size(); ++i) {
                if (images[i].outcome == Images::Outcome::leads_vanish) continue;
                if (images[i].outcome == Images::Outcome::rows_remain) return false;
                if (!lifting_ && !begin(images[i].rows, primes[i])) return false;
                if (!add(images[i].rows, primes[i])) return false;
            }
        }
        return true;
    }

    bool begin(const std::vector<Multipliers>& rows, const LaneEntry& primes) {
        std::vector<std::size_t> sizes;
        for (const Multipliers& row : rows) {
            tags_.push_back(row.tags);
            sizes.push_back(row.tags.size());
        }
        lifting_.emplace(sizes);
        return identities_.generated == 0 || basis_is_generated(rows, PrimeField(primes.lane[0]));
    }

    /// Whether the multipliers of the basis elements that shall be generated make an invertible matrix modulo
    /// the first prime.
    bool basis_is_generated(const std::vector<Multipliers>& rows, const PrimeField& field) const {
        const std::size_t first = identities_.basis.size() - identities_.generated;
        std::vector<std::vector<std::uint32_t>> matrix;
        for (const Multipliers& row : rows) {
            auto& dense = matrix.emplace_back(identities_.generated, 0);
            for (std::size_t i = 0; i < row.tags.size(); ++i)
                if (row.tags[i] >= first) dense[row.tags[i] - first] = row.values[i].lane[0];
        }
        if (matrix.size() != identities_.generated) return false;
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
    bool add(const std::vector<Multipliers>& rows, const LaneEntry& primes) {
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            std::vector<std::uint32_t> residues;
            residues.reserve(lifting_->entry_count());
            for (std::size_t r = 0; r < rows.size(); ++r) {
                std::size_t next = 0;
                for (const std::uint32_t tag : tags_[r]) {
                    const bool has = next < rows[r].tags.size() && rows[r].tags[next] == tag;
                    residues.push_back(has ? rows[r].values[next++].lane[lane] : 0);
                }
                if (next != rows[r].tags.size()) return false;
            }
            lifting_->add(primes.lane[lane], std::move(residues));
            modulus_ *= primes.lane[lane];
        }
        return true;
    }

    /// By how many bits the product of the primes falls short of twice what can stand on either side of (1).
    std::size_t missing_bits() const {
        const Operands& operands = prover_.operands_;
        const std::size_t available = mpz_sizeinbase(modulus_.get_mpz_t(), 2) - 1; // 2^available ≤ M
        std::size_t needed = 0;
        for (std::size_t r = 0; r < tags_.size(); ++r) {
            const RationalLifting::Vector& multipliers = lifting_->vectors()[r];
            std::size_t bits =
                multipliers.denominator.bit_length() + operands[identities_.rows[r].operand].bits();
            for (std::size_t i = 0; i < tags_[r].size(); ++i) {
                bits = std::max(bits, multipliers.numerators[i].bit_length() +
                                          operands[identities_.basis[tags_[r][i]].operand].bits());
            }
            // tags + 1 summands, each below 2^bits in size.
            needed =
                std::max(needed, bits + static_cast<std::size_t>(std::bit_width(tags_[r].size() + 1)) + 1);
        }
        return needed - std::min(needed, available);
    }

    IdentityProver& prover_;
    base::Run& run_;
    const RowIdentities& identities_;
    std::size_t used_ = 0; ///< packs
    mpz_class modulus_ = 1;
    std::vector<std::vector<std::uint32_t>> tags_; ///< per row: those with multipliers
    std::optional<RationalLifting> lifting_;
};

/// Those of which a sequence was told to begin with may be smaller than PrimePack takes.
std::uint32_t IdentityProver::next_prime() {
    for (;;) {
        const std::uint32_t p = primes_.next();
        if (p >> DigitVector::digit_bits != 0) return p;
    }
}

const LaneEntry& IdentityProver::pack(std::size_t i) {
    while (packs_.size() <= i)
        std::ranges::generate(packs_.emplace_back().lane, [this] { return next_prime(); });
    return packs_[i];
}

bool IdentityProver::holds(const RowIdentities& identities) {
    if (identities.rows.empty()) return identities.generated == 0;
    Statement statement(*this, identities);
    if (!statement.holds(expected_packs_)) return false;
    expected_packs_ =
        statement.packs_used() - statement.packs_used() / 4; // what the next one takes is not known
    return true;
}

} // namespace eliminant::groebner
