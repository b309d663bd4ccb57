#include "trace_proof.hpp"

#include "groebner/monomial_ideal.hpp"
#include "row_identities.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace eliminant::groebner {

using algebra::Integer;
using algebra::RationalLifting;

namespace {

/// The statement about one matrix of a trace.
class RoundStatement {
  public:
    /// \param first_found the place of its first found element in the trace's sequence
    RoundStatement(const F4Trace& trace, const F4Round& round, std::size_t first_found)
        : trace_(trace), round_(round), numbers_(trace.element_numbers()) {
        identities_.column_count = round.column_count;
        std::vector<RowIdentities::Row> generated;
        std::vector<char> is_copied(round.column_count, 0); // by leading column
        for (const F4Round::Row& pivot : round.pivots) identities_.basis.push_back(row(pivot));
        for (std::size_t i = 0; i < round.found_count(); ++i) {
            const RowIdentities::Row found{
                trace.generators().size() + numbers_[first_found + i],
                std::span(round.support).subspan(round.found[i], round.found[i + 1] - round.found[i])};
            const bool is_copy = trace.is_copy(first_found + i);
            is_copied[found.columns.front()] = is_copy ? 1 : 0;
            (is_copy ? identities_.basis : generated).push_back(found);
        }
        for (std::size_t i = 0; i < round.rows.size(); ++i) {
            if (is_copied[round.leads[i]] == 0) identities_.rows.push_back(row(round.rows[i]));
        }
        identities_.generated = generated.size();
        identities_.basis.insert(identities_.basis.end(), generated.begin(), generated.end());
    }

    const RowIdentities& identities() const { return identities_; }

  private:
    RowIdentities::Row row(const F4Round::Row& r) const {
        const std::size_t generators = trace_.generators().size();
        if (r.operand < generators) {
            const std::size_t size = trace_.generators()[r.operand].size();
            return {r.operand, std::span(round_.columns_of_rows).subspan(r.begin, size)};
        }
        const std::size_t element = numbers_[r.operand - generators];
        return {generators + element,
                std::span(round_.columns_of_rows).subspan(r.begin, trace_.element_sizes()[element])};
    }

    const F4Trace& trace_;
    const F4Round& round_;
    std::span<const std::uint32_t> numbers_;
    RowIdentities identities_;
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

bool lies_in_ideal_of_generators(const F4Trace& trace, std::vector<RationalLifting::Vector> elements,
                                 PrimeSequence& primes, base::Run& run) {
    Operands operands;
    operands.reserve(trace.generators().size() + elements.size());
    for (const auto& generator : trace.generators()) operands.emplace_back(generator);
    for (RationalLifting::Vector& element : elements) {
        run.poll();
        operands.emplace_back(std::exchange(element, {}).numerators);
    }
    IdentityProver prover(operands, primes, run);
    std::size_t first_found = 0;
    for (const F4Round& round : trace.rounds()) {
        run.report([&] {
            const auto done = static_cast<std::uint64_t>(&round - trace.rounds().data());
            return base::Progress{"proof", done, trace.rounds().size(),
                                  std::to_string(round.rows.size()) + " rows"};
        });
        if (!prover.holds(RoundStatement(trace, round, first_found).identities())) return false;
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
