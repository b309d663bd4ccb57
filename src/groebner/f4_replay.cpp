#include "f4_trace.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace eliminant::groebner {

namespace {

using algebra::PrimeField;
using Coefficients = std::vector<LaneEntry>;
using PrimesRow = SparseRow<LaneEntry>;

/// What a thread reduces rows in. All packs share it: a thread that waits for rows reduced elsewhere holds
/// nothing here.
struct Scratch {
    std::vector<LaneSum> dense; ///< zero between reductions
    std::vector<std::uint32_t> columns;
    Coefficients entries;

    void fit(std::size_t column_count) {
        if (dense.size() >= column_count) return;
        dense.resize(column_count);
        columns.resize(column_count);
        entries.resize(column_count);
    }
};

/// Repeats the recorded matrices modulo eight primes. A lane whose computation comes out differently is
/// *lost*: its coefficients become zero, and the others go on.
///
/// With several threads the rows of a matrix go in *waves*. Those of a wave are reduced at the same time by
/// what was known when it began, then one after the other by what the wave itself has found before them.
/// What is left of a row is its remainder modulo the pivots and all rows before it, which is unique: so the
/// images do not depend on the waves.
class PackReplay {
  public:
    /// \param scratch one for each thread of the run
    /// \param thread the present one
    PackReplay(const F4Trace& trace, const LaneEntry& primes, const LaneKernels& kernels,
               std::span<Scratch> scratch, std::size_t thread, base::Run& run)
        : trace_(trace), kernels_(kernels), run_(run), fields_(fields_of(primes)), primes_(primes),
          scratch_(scratch), thread_(thread) {
        outcomes_.fill(Replay::agrees);
    }

    void run() {
        for (const auto& generator : trace_.generators()) operands_.push_back(image(generator));
        for (const F4Round& round : trace_.rounds()) {
            run_.report([&] { return progress(round); });
            begin(round);
            reduce_rows(round);
            reduce_tails(round);
        }
    }

    Replay outcome(std::size_t lane) const { return outcomes_[lane]; }

    std::vector<std::uint32_t> residues(std::size_t lane, F4Trace::Extent extent) const {
        return extent == F4Trace::Extent::basis ? residues_of_basis(lane) : residues_of_elements(lane);
    }

  private:
    std::vector<std::uint32_t> residues_of_elements(std::size_t lane) const {
        std::vector<std::uint32_t> result;
        const std::size_t generators = trace_.generators().size();
        for (std::size_t i = generators; i < operands_.size(); ++i) {
            if (trace_.is_copy(i - generators)) continue;
            for (const LaneEntry& c : operands_[i]) result.push_back(c.lane[lane]);
        }
        return result;
    }

    /// Ascending by leading monomial.
    std::vector<std::uint32_t> residues_of_basis(std::size_t lane) const {
        std::vector<std::uint32_t> result;
        result.reserve(trace_.coefficient_count());
        const std::size_t count = trace_.basis().elements.size(); // found by the last matrix, descending
        for (std::size_t i = 0; i < count; ++i) {
            for (const LaneEntry& c : operands_[operands_.size() - 1 - i]) result.push_back(c.lane[lane]);
        }
        return result;
    }

    struct FoundRow {
        std::vector<std::uint32_t> columns;
        Coefficients coefficients;

        PrimesRow view() const { return {columns.data(), coefficients.data(), columns.size()}; }
    };

    static std::vector<PrimeField> fields_of(const LaneEntry& primes) {
        return {std::begin(primes.lane), std::end(primes.lane)};
    }

    base::Progress progress(const F4Round& round) const {
        const auto done = static_cast<std::uint64_t>(&round - trace_.rounds().data());
        return {"F4 replay", done, trace_.rounds().size(), std::to_string(round.rows.size()) + " rows"};
    }

    void lose(std::size_t lane, Replay outcome) {
        if (outcomes_[lane] == Replay::agrees) outcomes_[lane] = outcome;
    }
    bool is_lost(std::size_t lane) const { return outcomes_[lane] != Replay::agrees; }
    /// Loses the lanes in which an entry is not zero.
    void expect_zero(const LaneEntry& entry, Replay otherwise) {
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            if (entry.lane[lane] != 0) lose(lane, otherwise);
        }
    }

    Coefficients image(const std::vector<algebra::Integer>& integers) {
        Coefficients result(integers.size());
        for (std::size_t i = 0; i < integers.size(); ++i) {
            for (std::size_t lane = 0; lane < lane_count; ++lane) {
                const std::uint32_t residue = fields_[lane].from_integer(integers[i]);
                if (residue == 0) lose(lane, Replay::input_vanishes);
                result[i].lane[lane] = residue;
            }
        }
        return result;
    }

    PrimesRow row_of(const F4Round& round, const F4Round::Row& row) const {
        const Coefficients& coefficients = operands_[row.operand];
        return {round.columns_of_rows.data() + row.begin, coefficients.data(), coefficients.size()};
    }

    void begin(const F4Round& round) {
        by_column_.assign(round.column_count, {});
        std::size_t entries = 0;
        for (const F4Round::Row& pivot : round.pivots) {
            const PrimesRow row = row_of(round, pivot);
            by_column_[row.columns[0]] = row;
            entries += row.size;
        }
        // A row is worth handing to another thread if it takes some fifty microseconds.
        constexpr std::size_t entries_worth_a_wave = std::size_t{1} << 15U;
        const bool is_small = entries + round.column_count < entries_worth_a_wave;
        wave_length_ = is_small || run_.threads() == 1 ? 1 : 4 * std::size_t{run_.threads()};
    }

    /// Calls body(i, scratch) for begin ≤ i < end, a wave, on all threads.
    template <class Body>
    void in_parallel(std::size_t begin, std::size_t end, std::size_t column_count, Body&& body) {
        const auto treat = [&](std::size_t i, std::size_t thread) {
            scratch_[thread].fit(column_count);
            body(i, scratch_[thread]);
        };
        if (end - begin == 1) return treat(begin, thread_);
        base::parallel_for(run_, end - begin,
                           [&](std::size_t item, std::size_t thread) { treat(begin + item, thread); });
    }

    /// What by_column_ leaves of a row.
    FoundRow remainder(const PrimesRow& row, Scratch& scratch) const {
        constexpr std::size_t step = 1024; // columns between polls: a few milliseconds
        for (std::size_t i = 0; i < row.size; ++i)
            std::ranges::copy(row.coefficients[i].lane, scratch.dense[row.columns[i]].lane);
        std::size_t count = 0;
        for (std::size_t begin = row.columns[0]; begin < by_column_.size(); begin += step) {
            run_.poll();
            const std::size_t end = std::min(begin + step, by_column_.size());
            count += kernels_.reduce_primes(primes_, by_column_.data(), begin, end, scratch.dense.data(),
                                            scratch.columns.data() + count, scratch.entries.data() + count,
                                            nullptr);
        }
        return {{scratch.columns.data(), scratch.columns.data() + count},
                {scratch.entries.data(), scratch.entries.data() + count}};
    }

    void reduce_rows(const F4Round& round) {
        found_.assign(round.rows.size(), {}); // by_column_ points into it
        for (std::size_t begin = 0; begin < found_.size(); begin += wave_length_) {
            const std::size_t end = std::min(begin + wave_length_, found_.size());
            in_parallel(begin, end, round.column_count, [&](std::size_t i, Scratch& scratch) {
                found_[i] = remainder(row_of(round, round.rows[i]), scratch);
            });
            for (std::size_t i = begin; i < end; ++i) {
                FoundRow& row = found_[i];
                if (i > begin && can_be_reduced(row)) {
                    scratch_[thread_].fit(round.column_count);
                    row = remainder(row.view(), scratch_[thread_]);
                }
                make_monic(row, round.leads[i]);
                by_column_[round.leads[i]] = row.view();
            }
        }
    }

    bool can_be_reduced(const FoundRow& row) const {
        return std::ranges::any_of(row.columns,
                                   [this](std::uint32_t c) { return by_column_[c].columns != nullptr; });
    }

    /// Divides a row by its entry in the column `lead`, which has to be the first one.
    void make_monic(FoundRow& row, std::uint32_t lead) {
        std::size_t first = 0;
        for (; first < row.columns.size() && row.columns[first] < lead; ++first)
            expect_zero(row.coefficients[first], Replay::leads_differ);
        const auto before = static_cast<std::ptrdiff_t>(first);
        row.columns.erase(row.columns.begin(), row.columns.begin() + before);
        row.coefficients.erase(row.coefficients.begin(), row.coefficients.begin() + before);
        if (row.columns.empty() || row.columns.front() != lead) {
            row.columns.insert(row.columns.begin(), lead);
            row.coefficients.insert(row.coefficients.begin(), LaneEntry{});
        }
        const LaneEntry factor = inverse(row.coefficients.front());
        kernels_.scale(primes_, factor, row.coefficients.size(), row.coefficients.data());
    }

    /// Of a leading coefficient. 0 in lost lanes, and those in which it is 0 are lost.
    LaneEntry inverse(const LaneEntry& c) {
        LaneEntry result{};
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            if (c.lane[lane] == 0) lose(lane, Replay::leads_differ);
            if (is_lost(lane)) continue;
            result.lane[lane] = fields_[lane].inverse(c.lane[lane]);
        }
        return result;
    }

    /// From the last leading column on, so that most of what a row is reduced by is reduced already; within a
    /// wave it is not, which makes no difference to what is left.
    void reduce_tails(const F4Round& round) {
        const std::size_t before = operands_.size();
        operands_.resize(before + round.found_count());
        std::vector<std::size_t> row_with_lead(round.column_count, 0);
        for (std::size_t i = 0; i < found_.size(); ++i) row_with_lead[found_[i].columns.front()] = i;
        std::vector<LaneEntry> unexpected(round.found_count());
        for (std::size_t end = round.found_count(); end > 0;) {
            const std::size_t begin = end - std::min(wave_length_, end);
            in_parallel(begin, end, round.column_count, [&](std::size_t i, Scratch& scratch) {
                const std::span<const std::uint32_t> support = support_of(round, i);
                const FoundRow& row = found_[row_with_lead[support.front()]];
                operands_[before + i] = aligned(reduced_tail(row, scratch), support, unexpected[i]);
            });
            for (std::size_t i = end; i-- > begin;) {
                expect_zero(unexpected[i], Replay::support_differs);
                const std::span<const std::uint32_t> support = support_of(round, i);
                by_column_[support.front()] = {support.data(), operands_[before + i].data(), support.size()};
            }
            end = begin;
        }
    }

    static std::span<const std::uint32_t> support_of(const F4Round& round, std::size_t i) {
        return {round.support.data() + round.found[i], round.found[i + 1] - round.found[i]};
    }

    /// The row with all that follows its leading entry reduced.
    FoundRow reduced_tail(const FoundRow& row, Scratch& scratch) const {
        if (row.columns.size() == 1) return row;
        FoundRow tail =
            remainder({row.columns.data() + 1, row.coefficients.data() + 1, row.columns.size() - 1}, scratch);
        tail.columns.insert(tail.columns.begin(), row.columns.front());
        tail.coefficients.insert(tail.coefficients.begin(), row.coefficients.front());
        return tail;
    }

    /// The coefficients of a row, with zeros where the learned support has more. What is not in the support
    /// is collected in `unexpected`.
    static Coefficients aligned(const FoundRow& row, std::span<const std::uint32_t> support,
                                LaneEntry& unexpected) {
        Coefficients result(support.size());
        unexpected = {};
        std::size_t s = 0;
        for (std::size_t i = 0; i < row.columns.size(); ++i) {
            while (s < support.size() && support[s] < row.columns[i]) ++s;
            if (s < support.size() && support[s] == row.columns[i]) {
                result[s] = row.coefficients[i];
                continue;
            }
            for (std::size_t lane = 0; lane < lane_count; ++lane)
                unexpected.lane[lane] |= row.coefficients[i].lane[lane];
        }
        return result;
    }

    const F4Trace& trace_;
    const LaneKernels& kernels_;
    base::Run& run_;
    std::vector<PrimeField> fields_;
    LanePrimes primes_;
    std::array<Replay, lane_count> outcomes_;
    std::vector<Coefficients> operands_;
    std::vector<FoundRow> found_; ///< of the present matrix, in the sequence of its rows
    std::vector<PrimesRow> by_column_;
    std::span<Scratch> scratch_;
    std::size_t thread_;
    std::size_t wave_length_ = 1; ///< rows of the present matrix that are reduced at the same time
};

std::vector<F4Trace::Image> images_of(const F4Trace& trace, std::span<const std::uint32_t> primes,
                                      const LaneKernels& kernels, std::span<Scratch> scratch,
                                      std::size_t thread, base::Run& run, F4Trace::Extent extent) {
    if (primes.empty()) return {};
    LaneEntry pack{};
    for (std::size_t lane = 0; lane < lane_count; ++lane)
        pack.lane[lane] = primes[std::min(lane, primes.size() - 1)]; // spare lanes repeat the last prime
    PackReplay replay(trace, pack, kernels, scratch, thread, run);
    replay.run();
    std::vector<F4Trace::Image> images(primes.size());
    for (std::size_t lane = 0; lane < primes.size(); ++lane) {
        images[lane].prime = primes[lane];
        images[lane].replay = replay.outcome(lane);
        if (images[lane].replay == Replay::agrees) images[lane].coefficients = replay.residues(lane, extent);
    }
    return images;
}

} // namespace

std::vector<F4Trace::Image> F4Trace::replay_pack(std::span<const std::uint32_t> primes,
                                                 const LaneKernels& kernels, base::Run& run,
                                                 Extent extent) const {
    std::vector<Scratch> scratch(run.threads());
    return images_of(*this, primes, kernels, scratch, 0, run, extent);
}

std::vector<F4Trace::Image> F4Trace::replay(std::span<const std::uint32_t> primes, base::Run& run,
                                            Extent extent) const {
    const LaneKernels& kernels = lane_kernels(base::best_vector_unit());
    std::vector<Scratch> scratch(run.threads());
    std::vector<Image> images(primes.size());
    const std::size_t packs = (primes.size() + lane_count - 1) / lane_count;
    base::parallel_for(run, packs, [&](std::size_t pack, std::size_t thread) {
        const std::size_t begin = pack * lane_count;
        const std::size_t size = std::min(lane_count, primes.size() - begin);
        std::ranges::move(
            images_of(*this, primes.subspan(begin, size), kernels, scratch, thread, run, extent),
            images.begin() + static_cast<std::ptrdiff_t>(begin));
    });
    return images;
}

} // namespace eliminant::groebner
