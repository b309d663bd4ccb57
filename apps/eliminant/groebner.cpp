/// \file
/// `eliminant groebner`.
#include "command.hpp"
#include "results.hpp"
#include "systems.hpp"

#include "eliminant/groebner/groebner_basis.hpp"

namespace eliminant::app {

namespace {

/// Rows and columns, null where no matrix was made.
Json largest_matrix(const groebner::Statistics& statistics) {
    const auto* const largest = statistics.largest_matrix();
    return largest == nullptr ? Json(nullptr) : Json::array({largest->rows, largest->columns});
}

/// Share of its entries that are not 0.
Json largest_matrix_density(const groebner::Statistics& statistics) {
    const auto* const largest = statistics.largest_matrix();
    return largest == nullptr ? Json(nullptr) : Json(largest->density());
}

Json statistics_fields(const groebner::Statistics& statistics, double seconds) {
    return {{"pairs_treated", statistics.pairs_treated},
            {"skipped_by_product", statistics.skipped_by_product},
            {"skipped_by_chain_m", statistics.skipped_by_chain_m},
            {"skipped_by_chain_f", statistics.skipped_by_chain_f},
            {"skipped_by_chain_b", statistics.skipped_by_chain_b},
            {"zero_reductions", statistics.zero_reductions},
            {"matrices", statistics.matrices.size()},
            {"largest_matrix", largest_matrix(statistics)},
            {"largest_matrix_density", largest_matrix_density(statistics)},
            {"primes_used", statistics.primes},
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
        options.choice<groebner::Proof>(
            "assurance", "how sure the result must be at least (default proved)",
            {{"proved", groebner::Proof::full}, {"probable", groebner::Proof::none}}, proof_);
    }

    ExitStatus run(std::span<const std::string> operands, Session& session) override {
        const System system = read_system(operands, system_, session.run());
        const GroebnerBasis basis =
            groebner_basis(system.ring, system.polynomials, {algorithm_, proof_}, session.run());
        for (const std::string& line : matrix_table(basis.statistics.matrices))
            session.console().detail(line);
        session.console().detail(statistics_line(basis.statistics, session.seconds()));
        session.write_result(session.format() == ResultFormat::json
                                 ? json(system.ring, basis, session)
                                 : ideal_in(session.format(), system.ring, basis.elements, session.run()));
        return exit_done;
    }

  private:
    std::string json(const Ring& ring, const GroebnerBasis& basis, Session& session) const {
        Json result = ring_fields(ring);
        result["basis"] = strings(basis.elements, session.run());
        result["algorithm"] = basis.algorithm == Algorithm::f4 ? "f4" : "buchberger";
        result["assurance"] = basis.proof == groebner::Proof::full ? "proved" : "probable";
        if (basis.proof == groebner::Proof::bounded) result["failure_bound"] = basis.failure_bound;
        result["statistics"] = statistics_fields(basis.statistics, session.seconds());
        return to_text(result);
    }

    SystemOptions system_;
    Algorithm algorithm_ = Algorithm::automatic;
    groebner::Proof proof_ = groebner::Proof::full;
};

} // namespace

std::unique_ptr<Command> make_groebner() { return std::make_unique<GroebnerCommand>(); }

} // namespace eliminant::app
