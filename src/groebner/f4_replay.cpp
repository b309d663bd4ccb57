#include "f4_trace.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace eliminant::groebner {

namespace {

using algebra::PrimeField;
using Coefficients = std::vector<LaneEntry>;
using PrimesRow = SparseRow<LaneEntry>;

/// Repeats the recorded matrices modulo eight primes. A lane whose computation comes out differently is
/// *lost*: its coefficients become zero, and the others go on.
class PackReplay {
  public:
    PackReplay(const F4Trace& trace, const LaneEntry& primes, const LaneKernels& kernels, base::Run& run)
        : trace_(trace), kernels_(kernels), run_(run), fields_(fields_of(primes)), primes_(primes) {
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
        dense_.assign(round.column_count, {});
        columns_.resize(round.column_count);
        coefficients_.resize(round.column_count);
        for (const F4Round::Row& pivot : round.pivots) {
            const PrimesRow row = row_of(round, pivot);
            by_column_[row.columns[0]] = row;
        }
    }

    /// Reduces a row; what is left is in columns_ and coefficients_, so many entries.
    std::size_t reduce(const PrimesRow& row) {
        constexpr std::size_t step = 1024; // columns between polls: a few milliseconds
        for (std::size_t i = 0; i < row.size; ++i)
            std::ranges::copy(row.coefficients[i].lane, dense_[row.columns[i]].lane);
        std::size_t count = 0;
        for (std::size_t begin = row.columns[0]; begin < dense_.size(); begin += step) {
            run_.poll();
            const std::size_t end = std::min(begin + step, dense_.size());
            count += kernels_.reduce_primes(primes_, by_column_.data(), begin, end, dense_.data(),
                                            columns_.data() + count, coefficients_.data() + count, nullptr);
        }
        return count;
    }

    void reduce_rows(const F4Round& round) {
        found_.clear();
        found_.reserve(round.rows.size()); // by_column_ points into it
        for (std::size_t i = 0; i < round.rows.size(); ++i) {
            const std::size_t size = reduce(row_of(round, round.rows[i]));
            FoundRow& row = found_.emplace_back(monic_row(size, round.leads[i]));
            by_column_[round.leads[i]] = {row.columns.data(), row.coefficients.data(), row.columns.size()};
        }
    }

    /// What reduce() left, divided by the entry in the column `lead`, which has to be the first one.
    FoundRow monic_row(std::size_t size, std::uint32_t lead) {
        std::size_t first = 0;
        for (; first < size && columns_[first] < lead; ++first)
            expect_zero(coefficients_[first], Replay::leads_differ);
        FoundRow row;
        const bool has_lead = first < size && columns_[first] == lead;
        row.columns.push_back(lead);
        row.coefficients.push_back(has_lead ? coefficients_[first] : LaneEntry{});
        if (has_lead) ++first;
        row.columns.insert(row.columns.end(), columns_.data() + first, columns_.data() + size);
        row.coefficients.insert(row.coefficients.end(), coefficients_.data() + first,
                                coefficients_.data() + size);
        const LaneEntry factor = inverse(row.coefficients.front());
        kernels_.scale(primes_, factor, row.coefficients.size(), row.coefficients.data());
        return row;
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

    /// From the last leading column on, so that what a row is reduced by is reduced already.
    void reduce_tails(const F4Round& round) {
        const std::size_t before = operands_.size();
        operands_.resize(before + round.found_count());
        std::vector<std::size_t> row_with_lead(round.column_count, 0);
        for (std::size_t i = 0; i < found_.size(); ++i) row_with_lead[found_[i].columns.front()] = i;
        for (std::size_t i = round.found_count(); i-- > 0;) {
            const std::span<const std::uint32_t> support(round.support.data() + round.found[i],
                                                         round.found[i + 1] - round.found[i]);
            const std::uint32_t lead = support.front();
            const FoundRow& row = found_[row_with_lead[lead]];
            by_column_[lead] = {};
            const std::size_t size =
                reduce({row.columns.data(), row.coefficients.data(), row.columns.size()});
            operands_[before + i] = aligned(size, support);
            by_column_[lead] = {support.data(), operands_[before + i].data(), support.size()};
        }
    }

    /// What reduce() left, with zeros where the learned support has more.
    Coefficients aligned(std::size_t size, std::span<const std::uint32_t> support) {
        Coefficients result(support.size());
        std::size_t s = 0;
        for (std::size_t i = 0; i < size; ++i) {
            while (s < support.size() && support[s] < columns_[i]) ++s;
            if (s < support.size() && support[s] == columns_[i])
                result[s] = coefficients_[i];
            else
                expect_zero(coefficients_[i], Replay::support_differs);
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
    std::vector<LaneSum> dense_;
    std::vector<std::uint32_t> columns_; ///< what reduce() left
    Coefficients coefficients_;
};

} // namespace

std::vector<F4Trace::Image> F4Trace::replay_pack(std::span<const std::uint32_t> primes,
                                                 const LaneKernels& kernels, base::Run& run,
                                                 Extent extent) const {
    if (primes.empty()) return {};
    LaneEntry pack{};
    for (std::size_t lane = 0; lane < lane_count; ++lane)
        pack.lane[lane] = primes[std::min(lane, primes.size() - 1)]; // spare lanes repeat the last prime
    PackReplay replay(*this, pack, kernels, run);
    replay.run();
    std::vector<Image> images(primes.size());
    for (std::size_t lane = 0; lane < primes.size(); ++lane) {
        images[lane].prime = primes[lane];
        images[lane].replay = replay.outcome(lane);
        if (images[lane].replay == Replay::agrees) images[lane].coefficients = replay.residues(lane, extent);
    }
    return images;
}

} // namespace eliminant::groebner
