#include "basis_proof.hpp"

#include "f4_computation.hpp"
#include "row_identities.hpp"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

namespace eliminant::groebner {

using algebra::Polynomial;
using algebra::Ring;

namespace {

/// F4 on the elements modulo a prime, with all rows; nothing if a coefficient vanishes.
std::optional<std::vector<F4Round>> rounds_modulo(std::uint32_t p, std::span<const Polynomial> elements,
                                                  const BuchbergerOptions& options, base::Run& run) {
    const Ring ring = elements.front().ring().with_field(algebra::CoefficientField::prime(p));
    std::vector<Polynomial> images;
    for (const Polynomial& f : elements) {
        run.poll();
        images.push_back(f.in_ring(ring));
        if (images.back().size() != f.size()) return std::nullopt;
    }
    std::vector<F4Round> rounds;
    static_cast<void>(F4Computation(ring, images, options, run, &rounds, nullptr, true).run());
    return rounds;
}

/// What the rows of the matrices stand for.
class ElementRows {
  public:
    explicit ElementRows(std::span<const Polynomial> elements) : elements_(elements) {}

    /// Takes notice of what the matrix found. False if it is anything but elements as they are.
    bool add_found(const F4Round& round) {
        for (std::size_t i = 0; i < round.found_count(); ++i) {
            const auto support =
                std::span(round.support).subspan(round.found[i], round.found[i + 1] - round.found[i]);
            const auto row = std::ranges::find(round.leads, support.front()) - round.leads.begin();
            const F4Round::Row& r = round.rows[static_cast<std::size_t>(row)];
            if (r.operand >= elements_.size() || !std::ranges::equal(identity_row(round, r).columns, support))
                return false;
            found_.push_back(r.operand);
        }
        return true;
    }

    std::size_t found_count() const { return found_.size(); }

    /// Pivots and found elements; the rows are for the caller to add. After add_found() of the matrix.
    RowIdentities statement(const F4Round& round) const {
        RowIdentities result;
        result.column_count = round.column_count;
        for (const F4Round::Row& pivot : round.pivots) result.basis.push_back(identity_row(round, pivot));
        for (std::size_t i = 0; i < round.found_count(); ++i) {
            const std::size_t element = found_[found_.size() - round.found_count() + i];
            result.basis.push_back(
                {element,
                 std::span(round.support).subspan(round.found[i], round.found[i + 1] - round.found[i])});
        }
        return result;
    }

    RowIdentities::Row identity_row(const F4Round& round, const F4Round::Row& row) const {
        const std::size_t element =
            row.operand < elements_.size() ? row.operand : found_[row.operand - elements_.size()];
        return {element, std::span(round.columns_of_rows).subspan(row.begin, elements_[element].size())};
    }

  private:
    std::span<const Polynomial> elements_;
    std::vector<std::size_t> found_; ///< by F4, in its sequence: numbers of elements
};

/// How many rows are proved together: the residues of their multipliers shall not take much memory.
std::size_t rows_at_a_time(const RowIdentities& statement, std::size_t operand_bits) {
    constexpr std::size_t bytes = std::size_t{1} << 24;
    const std::size_t bytes_of_multiplier = 8 + operand_bits / 2;
    return std::max<std::size_t>(16, bytes / (bytes_of_multiplier * (statement.basis.size() + 1)));
}

/// Whether identities are likely to cost less than exact reductions. The time to lift the multipliers of a
/// row grows with its pivots and with the square of the length of the coefficients, or so: 0.4 s for
/// hcyclic-7 with a cost of 10^8, 8 s for hexapod with 6·10^9, over a minute for alea-6, with 5·10^10, that
/// Buchberger's algorithm proves in 20 s.
bool are_worth_while(const std::vector<F4Round>& rounds, std::size_t operand_bits) {
    constexpr double most = 1e10;
    double cost = 0;
    for (const F4Round& round : rounds)
        cost += static_cast<double>(round.zero_rows.size()) * static_cast<double>(round.pivots.size());
    const double words = static_cast<double>(operand_bits) / 32;
    return cost * words * words < most;
}

} // namespace

bool is_proved_groebner(std::span<const Polynomial> elements, const BuchbergerOptions& options,
                        PrimeSequence& primes, base::Run& run) {
    if (elements.empty()) return true;
    Operands operands;
    std::size_t operand_bits = 0;
    for (const Polynomial& f : elements) {
        run.poll();
        operands.emplace_back(f.integer_terms().coefficients);
        operand_bits = std::max(operand_bits, operands.back().bits());
    }
    std::optional<std::vector<F4Round>> rounds;
    while (!rounds) rounds = rounds_modulo(primes.next(), elements, options, run);
    rounds->pop_back(); // where tails are reduced
    if (!are_worth_while(*rounds, operand_bits)) return false;
    IdentityProver prover(operands, primes, run);
    ElementRows rows(elements);
    for (F4Round& round : *rounds) {
        if (!rows.add_found(round)) return false;
        RowIdentities statement = rows.statement(round);
        const std::size_t step = rows_at_a_time(statement, operand_bits);
        for (std::size_t begin = 0; begin < round.zero_rows.size(); begin += step) {
            run.report([&] {
                const auto done = static_cast<std::uint64_t>(&round - rounds->data());
                return base::Progress{"proof of S-polynomials", done, rounds->size(),
                                      std::to_string(round.zero_rows.size() - begin) + " rows"};
            });
            statement.rows.clear();
            const std::size_t end = std::min(begin + step, round.zero_rows.size());
            for (std::size_t i = begin; i < end; ++i)
                statement.rows.push_back(rows.identity_row(round, round.zero_rows[i]));
            if (!prover.holds(statement)) return false;
        }
        round = {};
    }
    return rows.found_count() == elements.size();
}

} // namespace eliminant::groebner
