#include "rational_lifting.hpp"

#include "base/parallel.hpp"
#include "rational_reconstruction.hpp"
#include "remainder_table.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <optional>
#include <utility>

namespace eliminant::algebra {

namespace {

/// How much smaller than the modulus a number must be to be taken for found.
constexpr unsigned margin_bits = 40;

/// How many primes the table after that for `primes` has. What a number takes grows with the square.
std::size_t next_table_size(std::size_t primes) { return primes + std::max<std::size_t>(2, primes / 8 * 2); }

} // namespace

/// Finds the entries of one vector after the other; scratch memory of one thread.
class RationalLifting::Worker {
  public:
    Worker(RationalLifting& lifting, base::Run& run) : all_(lifting), run_(run) {}

    /// Finds entries of vector g until one needs more primes; false then.
    bool advance(std::size_t g) {
        Vector& vector = all_.vectors_[g];
        factors_.assign(all_.tables_.size(), std::nullopt);
        level_ = 0;
        first_level_ = all_.needs_all_primes_[g] != 0 ? all_.tables_.size() - 1 : 0;
        const std::size_t end = all_.size(g);
        while (vector.numerators.size() < end) {
            run_.poll();
            const std::size_t first = vector.numerators.size();
            const std::size_t count = std::min(block, end - first);
            gather(all_.begins_[g] + first, count);
            for (std::size_t i = 0; i < count; ++i) {
                if (!find({block_.data() + i * all_.prime_count(), all_.prime_count()}, vector)) return false;
            }
        }
        return true;
    }

  private:
    /// Entries whose residues are brought together at a time: a cache line of each prime's.
    static constexpr std::size_t block = 16;

    void gather(std::size_t first, std::size_t count) {
        const std::size_t primes = all_.prime_count();
        block_.resize(block * primes);
        for (std::size_t j = 0; j < primes; ++j) {
            for (std::size_t i = 0; i < count; ++i) block_[i * primes + j] = all_.residues_[j][first + i];
        }
    }

    const RemainderTable::Factor& factor(std::size_t level, const Integer& denominator) {
        if (!factors_[level]) factors_[level] = all_.tables_[level]->prepare(denominator);
        return *factors_[level];
    }

    /// Appends the entry with these residues to the vector's numerators.
    bool find(std::span<const std::uint32_t> residues, Vector& vector) {
        // Neighbours have much the same length: begin with the table of the one before.
        for (level_ = std::max(level_, first_level_ + 1) - 1; level_ < all_.tables_.size(); ++level_) {
            const RemainderTable& table = *all_.tables_[level_];
            table.combine(residues.first(table.prime_count()), factor(level_, vector.denominator), limbs_,
                          number_);
            if (mpz_sizeinbase(number_.get_mpz_t(), 2) + margin_bits <= table.modulus_bits()) {
                vector.numerators.emplace_back(number_);
                return true;
            }
        }
        --level_;
        const mpz_class& modulus = all_.tables_.back()->modulus();
        if (number_ < 0) number_ += modulus;
        const auto fraction = reconstruct_fraction(number_, modulus, margin_bits, run_);
        if (!fraction) return false;
        const Integer more(fraction->denominator);
        vector.denominator *= more;
        for (Integer& n : vector.numerators) n *= more;
        vector.numerators.emplace_back(fraction->numerator);
        factors_.assign(all_.tables_.size(), std::nullopt);
        return true;
    }

    RationalLifting& all_;
    base::Run& run_;
    std::vector<std::uint32_t> block_;
    std::vector<std::optional<RemainderTable::Factor>> factors_; ///< per table: the denominator
    std::size_t level_ = 0;                                      ///< the table that sufficed
    std::size_t first_level_ = 0;                                ///< the first that is tried
    std::vector<mp_limb_t> limbs_;
    mpz_class number_;
};

RationalLifting::RationalLifting(const std::vector<std::size_t>& sizes)
    : vectors_(sizes.size()), needs_all_primes_(sizes.size(), 0) {
    begins_.push_back(0);
    for (const std::size_t size : sizes) begins_.push_back(begins_.back() + size);
}
RationalLifting::~RationalLifting() = default;
RationalLifting::RationalLifting(RationalLifting&&) noexcept = default;
RationalLifting& RationalLifting::operator=(RationalLifting&&) noexcept = default;

void RationalLifting::add(std::uint32_t prime, std::vector<std::uint32_t> residues) {
    primes_.push_back(prime);
    residues_.push_back(std::move(residues));
}

/// Tables of growing size for the first primes, and one for all: as long as it is not for all, a table can
/// serve again when there are more primes.
void RationalLifting::extend_tables(base::Run& run) {
    if (!tables_.empty() && tables_.back()->prime_count() == prime_count()) return;
    std::size_t size = 0;
    std::size_t kept = 0;
    while (kept < tables_.size() && tables_[kept]->prime_count() == next_table_size(size))
        size = tables_[kept++]->prime_count();
    tables_.resize(kept);
    while (size < prime_count()) {
        run.poll();
        size = std::min(next_table_size(size), prime_count());
        tables_.push_back(std::make_unique<const RemainderTable>(std::span(primes_).first(size)));
    }
}

bool RationalLifting::lift(base::Run& run) {
    if (prime_count() == 0) return entry_count() == 0;
    extend_tables(run);
    if (!vectors_.empty() && !Worker(*this, run).advance(hardest_)) return false;
    std::vector<std::size_t> open;
    for (std::size_t g = 0; g < vectors_.size(); ++g) {
        if (!is_found(g)) open.push_back(g);
    }
    // After a failure the others stop where they are: what they found by then does not change what is found
    // in the end.
    std::atomic<std::size_t> failed{vectors_.size()};
    base::parallel_for(run, open.size(), [&](std::size_t item, std::size_t) {
        if (failed.load(std::memory_order_relaxed) < vectors_.size()) return;
        if (!Worker(*this, run).advance(open[item])) failed.store(open[item], std::memory_order_relaxed);
    });
    if (failed.load() == vectors_.size()) return true;
    hardest_ = failed.load();
    return false;
}

bool RationalLifting::lift_with_all_primes(base::Run& run) {
    std::ranges::fill(needs_all_primes_, char{1});
    vectors_.assign(vectors_.size(), {});
    return lift(run);
}

std::vector<RationalLifting::Vector> RationalLifting::take_vectors() {
    residues_.clear();
    tables_.clear();
    return std::move(vectors_);
}

bool RationalLifting::agrees(std::uint32_t prime, std::span<const std::uint32_t> residues, base::Run& run) {
    std::vector<char> wrong(vectors_.size(), 0);
    base::parallel_for(run, vectors_.size(), [&](std::size_t g, std::size_t) {
        const std::uint64_t denominator = vectors_[g].denominator.residue(prime);
        for (std::size_t i = 0; i < size(g) && wrong[g] == 0; ++i) {
            if (i % 1024 == 0) run.poll();
            wrong[g] =
                vectors_[g].numerators[i].residue(prime) != residues[begins_[g] + i] * denominator % prime;
        }
    });
    for (std::size_t g = 0; g < vectors_.size(); ++g) {
        if (wrong[g] == 0) continue;
        vectors_[g] = {};
        needs_all_primes_[g] = 1;
    }
    return std::ranges::count(wrong, 0) == static_cast<std::ptrdiff_t>(wrong.size());
}

bool RationalLifting::agrees_with_added(std::size_t index, base::Run& run) {
    return agrees(primes_[index], residues_[index], run);
}

} // namespace eliminant::algebra
