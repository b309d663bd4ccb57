/// \file
/// `eliminant groebner`.
#include "command.hpp"
#include "results.hpp"
#include "systems.hpp"

#include "eliminant/groebner/buchberger.hpp"
#include "eliminant/groebner/f4.hpp"

namespace eliminant::app {

namespace {

enum class Algorithm { automatic, buchberger, f4 };
enum class Assurance { proved, probable };

/// Rows and columns, null where no matrix was made.
Json largest_matrix(const groebner::Statistics& statistics) {
    if (statistics.matrices == 0) return nullptr;
    return Json::array({statistics.largest_matrix_rows, statistics.largest_matrix_columns});
}

/// Share of its entries that are not 0.
Json largest_matrix_density(const groebner::Statistics& statistics) {
    if (statistics.matrices == 0) return nullptr;
    return static_cast<double>(statistics.largest_matrix_entries) /
           (static_cast<double>(statistics.largest_matrix_rows) *
            static_cast<double>(statistics.largest_matrix_columns));
}

Json statistics_fields(const groebner::Statistics& statistics, double seconds) {
    return {{"pairs_treated", statistics.pairs_treated},
            {"skipped_by_product", statistics.skipped_by_product},
            {"skipped_by_chain_m", statistics.skipped_by_chain_m},
            {"skipped_by_chain_f", statistics.skipped_by_chain_f},
            {"skipped_by_chain_b", statistics.skipped_by_chain_b},
            {"zero_reductions", statistics.zero_reductions},
            {"matrices", statistics.matrices},
            {"largest_matrix", largest_matrix(statistics)},
            {"largest_matrix_density", largest_matrix_density(statistics)},
            {"primes_used", 0}, // the prime of Buchberger's first pass over QQ leaves no trace in the result
            {"seconds", seconds},
            {"peak_memory", peak_memory()}};
}

class GroebnerCommand : public Command {
  public:
    std::string_view usage() const override { return "[FILE | - | POLY…]"; }

    std::string_view description() const override {
        return "The reduced Groebner basis of the ideal that the polynomials generate: monic over GF(p), "
               "primitive\n"
               "integer polynomials with positive leading coefficient over QQ, one a line, the least "
               "leading\n"
               "monomial first.\n"
               "\n"
               "A file holds 'variables x, y, z', then optionally 'field GF(p)' and 'order lex', then a "
               "polynomial\n"
               "or an equation a line; '#' begins a comment. Without 'variables' they are the names in order "
               "of\n"
               "first appearance. The formats of msolve and Singular are read as well.\n"
               "\n"
               "Examples:\n"
               "  eliminant groebner 'x^2 + y^2 = 1' 'x*y = 1/4'\n"
               "  eliminant groebner --order 'elim(t)' --format json 'x = t^2' 'y = t^3'\n";
    }

    void declare(OptionSet& options) override {
        system_.declare(options);
        options.choice<Algorithm>(
            "algorithm", "how it is computed (default auto)",
            {{"auto", Algorithm::automatic}, {"buchberger", Algorithm::buchberger}, {"f4", Algorithm::f4}},
            algorithm_);
        options.choice<Assurance>("assurance", "how sure the result must be at least (default proved)",
                                  {{"proved", Assurance::proved}, {"probable", Assurance::probable}},
                                  assurance_);
    }

    ExitStatus run(std::span<const std::string> operands, Session& session) override {
        const System system = read_system(operands, system_, session.run());
        const GroebnerBasis basis = compute(system, session.run());
        session.console().detail(statistics_line(basis.statistics, session.seconds()));
        session.write_result(session.format() == ResultFormat::json
                                 ? json(system.ring, basis, session.seconds())
                                 : ideal_in(session.format(), system.ring, basis.elements));
        return exit_done;
    }

  private:
    bool uses_f4(const Ring& ring) const {
        return algorithm_ == Algorithm::f4 ||
               (algorithm_ == Algorithm::automatic && !ring.field().is_rationals());
    }

    GroebnerBasis compute(const System& system, Run& run) const {
        if (!uses_f4(system.ring)) return buchberger(system.ring, system.polynomials, {}, run);
        if (system.ring.field().is_rationals())
            throw UsageError("--algorithm: f4 needs a field GF(p); over QQ this version has buchberger");
        BuchbergerOptions options;
        options.selection = groebner::Selection::normal;
        if (assurance_ == Assurance::probable)
            options.linear_algebra = groebner::LinearAlgebra::probabilistic;
        return f4(system.ring, system.polynomials, options, run);
    }

    std::string json(const Ring& ring, const GroebnerBasis& basis, double seconds) const {
        Json result = ring_fields(ring);
        result["basis"] = strings(basis.elements);
        result["algorithm"] = uses_f4(ring) ? "f4" : "buchberger";
        const bool proved = basis.proof == groebner::Proof::full;
        result["assurance"] = proved ? "proved" : "probable";
        if (!proved) result["failure_bound"] = basis.failure_bound;
        result["statistics"] = statistics_fields(basis.statistics, seconds);
        return to_text(result);
    }

    SystemOptions system_;
    Algorithm algorithm_ = Algorithm::automatic;
    Assurance assurance_ = Assurance::proved;
};

} // namespace

std::unique_ptr<Command> make_groebner() { return std::make_unique<GroebnerCommand>(); }

} // namespace eliminant::app
