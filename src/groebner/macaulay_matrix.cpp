#include "macaulay_matrix.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>

namespace eliminant::groebner {

/// One elimination. Rows are reduced in packs of eight, a lane each; packs in *waves*: those of a wave are
/// reduced at the same time by the pivots known when it began, then one after the other by those that the
/// wave itself has found meanwhile.
class Elimination {
  public:
    using Column = MacaulayMatrix::Column;
    using Element = MacaulayMatrix::Element;
    using Row = MacaulayMatrix::Row;

    Elimination(const MacaulayMatrix& matrix, const MacaulayMatrix::EchelonOptions& options, base::Run& run)
        : matrix_(matrix), options_(options), run_(run), transcript_(options.transcript),
          kernels_(lane_kernels(options.unit)), primes_(same_in_all_lanes(matrix.field_)),
          by_column_(matrix.columns_), workers_(run.threads()), random_(options.seed) {
        for (const SparseRow<Element>& pivot : matrix.pivots_) by_column_[pivot.columns[0]] = pivot;
        if (transcript_) transcript_->pivots.assign(matrix.columns_, false);
    }

    MacaulayMatrix::Echelon run() {
        const std::size_t rows = matrix_.rows_.size();
        found_.reserve(rows); // by_column_ points into what its elements hold
        std::size_t done = 0;
        if (options_.rank) {
            find_as_many(*options_.rank);
            done = rows;
        } else if (options_.combine) {
            // A combination has more pivots to be reduced by than a row has, and those that vanish come on
            // top: it takes few independent rows to pay, so a sample is taken first.
            while (rows - done > sample) {
                const std::size_t before = found_.size();
                reduce_rows(done, done + sample);
                done += sample;
                if (4 * (found_.size() - before) > sample) continue;
                const std::size_t end = std::min(done + block, rows);
                combine_rows(done, end);
                done = end;
            }
        }
        reduce_rows(done, rows);
        std::ranges::sort(found_, {}, [](const Row& row) { return row.columns.front(); });
        return {reduced_tails(), failure_bound_};
    }

  private:
    /// Rows in lanes, as sparse as what is left of them.
    struct Pack {
        std::vector<Column> columns; ///< ascending
        std::vector<LaneEntry> entries;
        std::vector<std::uint8_t> used; ///< per column, for the transcript: see LaneReduction
    };
    /// What belongs to a thread.
    struct Worker {
        std::vector<LaneSum> dense; ///< zero between reductions
        std::vector<Column> columns;
        std::vector<LaneEntry> entries;
    };

    static constexpr std::size_t sample = 32; ///< rows reduced to see how many are independent
    static constexpr std::size_t block = 512; ///< rows combined with one another

    /// Packs that are reduced at the same time. With one thread a pack sees all that was found before it;
    /// with more, waves are long enough to share out.
    std::size_t wave_length() const { return run_.threads() == 1 ? 1 : 2 * std::size_t{run_.threads()}; }

    base::Progress progress(std::size_t rows_done) const {
        return {"F4 elimination", rows_done, matrix_.rows_.size(),
                "matrix of " + std::to_string(matrix_.row_count()) + " rows and " +
                    std::to_string(matrix_.columns_) + " columns, " + std::to_string(found_.size()) +
                    " new rows"};
    }

    static LaneEntry same_in_all_lanes(const algebra::PrimeField& field) {
        LaneEntry entry;
        std::ranges::fill(entry.lane, field.characteristic());
        return entry;
    }

    Worker& worker(std::size_t number) {
        Worker& w = workers_[number];
        w.dense.resize(matrix_.columns_);
        w.columns.resize(matrix_.columns_);
        w.entries.resize(matrix_.columns_);
        return w;
    }

    /// Reduces what was put in the worker's dense row, from column `first` on.
    void reduce(Worker& w, std::size_t first, Pack& pack) {
        constexpr std::size_t step = 256; // columns between polls: a few milliseconds
        std::size_t count = 0;
        for (std::size_t begin = first; begin < matrix_.columns_; begin += step) {
            run_.poll();
            const std::size_t end = std::min(begin + step, matrix_.columns_);
            count += kernels_.reduce_rows(primes_, by_column_.data(), begin, end, w.dense.data(),
                                          w.columns.data() + count, w.entries.data() + count,
                                          transcript_ ? pack.used.data() : nullptr);
        }
        pack.columns.assign(w.columns.data(), w.columns.data() + count);
        pack.entries.assign(w.entries.data(), w.entries.data() + count);
    }

    static void scatter(const SparseRow<Element>& row, std::size_t lane, std::vector<LaneSum>& dense) {
        for (std::size_t i = 0; i < row.size; ++i) dense[row.columns[i]].lane[lane] = row.coefficients[i];
    }

    void reduce_rows(std::size_t begin, std::size_t end) {
        const std::size_t enough = options_.rank.value_or(matrix_.rows_.size());
        const std::size_t step = wave_length() * lane_count;
        for (std::size_t first = begin; first < end && found_.size() < enough; first += step)
            reduce_wave(first, std::min(first + step, end));
    }

    /// Where the rank is known it does not matter how the rows come about: random combinations of all rows
    /// are independent with probability about 1 − 1/p, and of the rows that vanish none is looked at. Those
    /// that are missing after a few more than it should take are looked for among the rows themselves.
    void find_as_many(std::size_t rank) {
        const std::size_t rows = matrix_.rows_.size();
        const bool pays = 2 * rank < rows && transcript_ == nullptr;
        if (pays && MacaulayMatrix::can_combine(matrix_.field_)) {
            for (std::size_t packs = rank / lane_count + 2; packs > 0 && found_.size() < rank;) {
                const std::size_t count = std::min(packs, wave_length());
                combine_wave(0, rows, count);
                packs -= count;
            }
        }
        reduce_rows(0, rows);
    }

    void reduce_wave(std::size_t begin, std::size_t end) {
        reduce_packs((end - begin + lane_count - 1) / lane_count, [&](std::size_t i, Worker& w) {
            const std::size_t first = begin + i * lane_count;
            const std::size_t size = std::min(lane_count, end - first);
            for (std::size_t lane = 0; lane < size; ++lane)
                scatter(matrix_.rows_[first + lane], lane, w.dense);
            return first_column(first, first + size);
        });
        run_.report([&] { return progress(end); });
        const std::size_t known = found_.size();
        for (std::size_t i = 0; i < wave_.size(); ++i) add_found(wave_[i], known, begin + i * lane_count);
    }

    /// Reduces random combinations of rows until at least `enough` of the eight in a pack vanish.
    ///
    /// If the rows have not all been found yet, their remainders by what was found span a space that is not
    /// zero, and each combination vanishes with probability 1/p, independently. That `enough` of eight do,
    /// by accident, has a probability of at most C(8, enough)·p^−enough; the bound is summed over all packs.
    void combine_rows(std::size_t begin, std::size_t end) {
        const double p = matrix_.field_.characteristic();
        std::size_t enough = 1; // p^−enough below 2^−48; at most 3, as p is at least 2^16
        while (std::pow(p, -static_cast<double>(enough)) > 0x1p-48) ++enough;
        constexpr double choices = 70; // C(8, 4), the largest of them
        bool vanish = false;
        while (!vanish) {
            const std::size_t packs = wave_length();
            vanish = combine_wave(begin, end, packs) + enough <= lane_count;
            failure_bound_ +=
                static_cast<double>(packs) * choices * std::pow(p, -static_cast<double>(enough));
        }
    }

    /// Reduces packs of random combinations of rows. The least number of rows that one of them gave.
    std::size_t combine_wave(std::size_t begin, std::size_t end, std::size_t packs) {
        std::vector<std::uint64_t> seeds(packs);
        for (std::uint64_t& seed : seeds) seed = random_();
        reduce_packs(packs, [&](std::size_t i, Worker& w) {
            std::mt19937_64 random(seeds[i]);
            for (std::size_t r = begin; r < end; ++r) {
                if (r % 16 == 0) run_.poll();
                LaneEntry factor;
                for (std::uint32_t& x : factor.lane) x = matrix_.field_.reduce(random());
                kernels_.subtract_row(primes_, factor, matrix_.rows_[r], w.dense.data());
            }
            return first_column(begin, end);
        });
        run_.report([&] { return progress(end); });
        const std::size_t known = found_.size();
        std::size_t least = lane_count;
        for (Pack& pack : wave_) {
            const std::size_t before = found_.size();
            add_found(pack, known, begin);
            least = std::min(least, found_.size() - before);
        }
        return least;
    }

    std::size_t first_column(std::size_t begin_row, std::size_t end_row) const {
        std::size_t first = matrix_.columns_;
        for (std::size_t r = begin_row; r < end_row; ++r)
            first = std::min<std::size_t>(first, matrix_.rows_[r].columns[0]);
        return first;
    }

    /// Makes and reduces the packs of a wave. `fill(i, worker)` puts pack i in the worker's dense row and
    /// returns its first column.
    template <class Fill>
    void reduce_packs(std::size_t count, Fill&& fill) {
        wave_.resize(count);
        base::parallel_for(run_, count, [&](std::size_t i, std::size_t thread) {
            Worker& w = worker(thread);
            const std::size_t first = fill(i, w);
            if (transcript_) wave_[i].used.assign(matrix_.columns_, 0);
            reduce(w, first, wave_[i]);
        });
    }

    void reduce_again(Pack& pack) {
        if (pack.columns.empty()) return;
        Worker& w = worker(0);
        for (std::size_t i = 0; i < pack.columns.size(); ++i)
            std::ranges::copy(pack.entries[i].lane, w.dense[pack.columns[i]].lane);
        reduce(w, pack.columns.front(), pack);
    }

    /// Gauss–Jordan elimination of the eight lanes; those that do not vanish become pivots. `known` of the
    /// pivots found were there when the pack was reduced, and `first_row` is the row in its first lane.
    void add_found(Pack& pack, std::size_t known, std::size_t first_row) {
        if (found_.size() != known) reduce_again(pack);
        const algebra::PrimeField& field = matrix_.field_;
        const std::size_t size = pack.entries.size();
        std::array<std::size_t, lane_count> leads{};
        LaneEntry inverses{};
        unsigned useful = 0;
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            run_.poll();
            std::size_t& lead = leads[lane];
            while (lead < size && pack.entries[lead].lane[lane] == 0) ++lead;
            if (lead == size) continue;
            useful |= 1U << lane;
            inverses.lane[lane] = field.inverse(pack.entries[lead].lane[lane]);
            LaneEntry factor{};
            bool subtracts = false;
            for (std::size_t other = 0; other < lane_count; ++other) {
                if (other == lane) continue;
                factor.lane[other] = field.multiply(pack.entries[lead].lane[other], inverses.lane[lane]);
                subtracts = subtracts || factor.lane[other] != 0;
            }
            if (subtracts)
                kernels_.subtract_lane(primes_, factor, lane, size - lead, pack.entries.data() + lead);
        }
        if (transcript_ && transcript_->keeps_zero_rows) {
            write_zero_rows(useful, first_row);
            write_pivots(pack, ~0U);
        } else if (transcript_) {
            write_pivots(pack, useful);
        }
        if (useful == 0) return;
        kernels_.scale(primes_, inverses, size, pack.entries.data());
        for (std::size_t lane = 0; lane < lane_count; ++lane) {
            if ((useful >> lane & 1U) == 0) continue;
            const Row& row = found_.emplace_back(lane_of(pack, leads[lane], lane));
            by_column_[row.columns.front()] = {row.columns.data(), row.coefficients.data(),
                                               row.columns.size()};
            if (transcript_) {
                transcript_->rows.push_back(first_row + lane);
                transcript_->leads.push_back(row.columns.front());
            }
        }
    }

    /// Those pivots of which a multiple was subtracted in one of the lanes.
    void write_pivots(const Pack& pack, unsigned lanes) {
        for (std::size_t c = 0; c < pack.used.size(); ++c) {
            if ((pack.used[c] & lanes) != 0) transcript_->pivots[c] = true;
        }
    }

    void write_zero_rows(unsigned useful, std::size_t first_row) {
        const std::size_t count = std::min(lane_count, matrix_.rows_.size() - first_row);
        for (std::size_t lane = 0; lane < count; ++lane) {
            if ((useful >> lane & 1U) == 0) transcript_->zero_rows.push_back(first_row + lane);
        }
    }

    /// One lane, from an entry on.
    static Row lane_of(const Pack& pack, std::size_t first, std::size_t lane) {
        Row row;
        for (std::size_t i = first; i < pack.entries.size(); ++i) {
            if (pack.entries[i].lane[lane] == 0) continue;
            row.columns.push_back(pack.columns[i]);
            row.coefficients.push_back(pack.entries[i].lane[lane]);
        }
        return row;
    }

    /// The rows found, all that follows the leading entry reduced by all of them. What they are reduced by
    /// need not be reduced itself, so packs are independent.
    std::vector<Row> reduced_tails() {
        for (const Row& row : found_) // sorting has moved the rows, though not what they point to
            by_column_[row.columns.front()] = {row.columns.data(), row.coefficients.data(),
                                               row.columns.size()};
        transcript_ = nullptr;
        std::vector<Row> result(found_.size());
        const std::size_t packs = (found_.size() + lane_count - 1) / lane_count;
        base::parallel_for(run_, packs, [&](std::size_t i, std::size_t thread) {
            Worker& w = worker(thread);
            const std::size_t begin = i * lane_count;
            const std::size_t size = std::min(lane_count, found_.size() - begin);
            for (std::size_t lane = 0; lane < size; ++lane) {
                const Row& row = found_[begin + lane];
                scatter({row.columns.data() + 1, row.coefficients.data() + 1, row.columns.size() - 1}, lane,
                        w.dense);
            }
            Pack pack;
            reduce(w, found_[begin].columns.front() + 1, pack);
            for (std::size_t lane = 0; lane < size; ++lane) {
                Row tail = lane_of(pack, 0, lane);
                tail.columns.insert(tail.columns.begin(), found_[begin + lane].columns.front());
                tail.coefficients.insert(tail.coefficients.begin(), 1);
                result[begin + lane] = std::move(tail);
            }
        });
        return result;
    }

    const MacaulayMatrix& matrix_;
    const MacaulayMatrix::EchelonOptions& options_;
    base::Run& run_;
    MacaulayMatrix::Transcript* transcript_;
    const LaneKernels& kernels_;
    LanePrimes primes_;
    std::vector<SparseRow<Element>> by_column_;
    std::vector<Worker> workers_;
    std::vector<Pack> wave_;
    std::vector<Row> found_;
    std::mt19937_64 random_;
    double failure_bound_ = 0;
};

MacaulayMatrix::Echelon MacaulayMatrix::echelon(const EchelonOptions& options, base::Run& run) const {
    return Elimination(*this, options, run).run();
}

} // namespace eliminant::groebner
