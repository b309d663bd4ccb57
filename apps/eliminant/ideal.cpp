/// \file
/// `eliminant ideal`.
#include "command.hpp"
#include "results.hpp"
#include "suggestion.hpp"
#include "systems.hpp"

#include "eliminant/algebra/print.hpp"
#include "eliminant/ideal/dimension.hpp"
#include "eliminant/ideal/hilbert.hpp"
#include "eliminant/ideal/ideal.hpp"
#include "eliminant/ideal/operations.hpp"

#include <algorithm>
#include <array>

namespace eliminant::app {

namespace {

using Ideals = std::span<const Ideal>;

/// The answer to a question with the answers yes and no.
ExitStatus write_answer(std::string_view operation, bool answer, Session& session) {
    session.write_result(session.format() == ResultFormat::json ? to_text(Json{{operation, answer}})
                         : answer                               ? "true\n"
                                                                : "false\n");
    return answer ? exit_done : exit_negative;
}

ExitStatus write_ideal(const Ideal& I, Session& session) {
    session.write_result(ideal_in(session.format(), I, session.run()));
    return exit_done;
}

/// Applies an operation of two ideals from left to right.
template <class Operation>
ExitStatus fold(Ideals ideals, Session& session, const Operation& operation) {
    Ideal result = ideals.front();
    for (const Ideal& next : ideals.subspan(1)) result = operation(result, next, session.run());
    return write_ideal(result, session);
}

ExitStatus run_sum(Ideals ideals, Session& session) {
    return fold(ideals, session, [](const Ideal& I, const Ideal& J, Run&) { return sum(I, J); });
}

ExitStatus run_product(Ideals ideals, Session& session) {
    return fold(ideals, session, [](const Ideal& I, const Ideal& J, Run& run) { return product(I, J, run); });
}

ExitStatus run_intersect(Ideals ideals, Session& session) {
    return fold(ideals, session,
                [](const Ideal& I, const Ideal& J, Run& run) { return intersect(I, J, run); });
}

ExitStatus run_quotient(Ideals ideals, Session& session) {
    return write_ideal(quotient(ideals[0], ideals[1], session.run()), session);
}

ExitStatus run_saturate(Ideals ideals, Session& session) {
    return write_ideal(saturate(ideals[0], ideals[1], session.run()), session);
}

ExitStatus run_contains(Ideals ideals, Session& session) {
    return write_answer("contains", ideals[0].contains(ideals[1], session.run()), session);
}

ExitStatus run_equal(Ideals ideals, Session& session) {
    return write_answer("equal", ideals[0].equals(ideals[1], session.run()), session);
}

ExitStatus run_radical_contains(Ideals ideals, Session& session) {
    const std::vector<Polynomial>& elements = ideals[1].generators();
    const bool answer = std::all_of(elements.begin(), elements.end(), [&](const Polynomial& f) {
        return radical_contains(ideals[0], f, session.run());
    });
    return write_answer("radical-contains", answer, session);
}

ExitStatus run_dimension(Ideals ideals, Session& session) {
    const std::int64_t answer = dimension(ideals[0], session.run());
    session.write_result(session.format() == ResultFormat::json ? to_text(Json{{"dimension", answer}})
                                                                : std::to_string(answer) + "\n");
    return exit_done;
}

/// As a JSON number where it fits one, otherwise its digits.
Json number(const mpz_class& value) {
    return value.fits_slong_p() ? Json(value.get_si()) : Json(value.get_str());
}

ExitStatus run_hilbert(Ideals ideals, Session& session) {
    const Ideal& I = ideals[0];
    Run& run = session.run();
    // A reduced basis of a homogeneous ideal is homogeneous, whatever the generators were.
    const std::vector<Polynomial>& basis = I.some_groebner_basis(run);
    const bool graded =
        std::all_of(basis.begin(), basis.end(), [](const Polynomial& f) { return f.is_homogeneous(); });
    const HilbertSeries series =
        (graded ? hilbert_series(I, run) : affine_hilbert_series(I, run)).reduced(run);
    const std::string numerator = to_string(series.numerator());
    const std::string polynomial = to_string(series.hilbert_polynomial());
    const std::string kind = graded ? "graded" : "affine";

    if (session.format() == ResultFormat::json) {
        session.write_result(to_text({{"series", kind},
                                      {"numerator", numerator},
                                      {"denominator_exponent", series.denominator_exponent()},
                                      {"polynomial", polynomial},
                                      {"regularity_index", series.regularity_index()},
                                      {"dimension", dimension(I, run)},
                                      {"degree", number(degree(I, run))}}));
        return exit_done;
    }
    session.write_result(kind + "_series = (" + numerator + ")/(1-t)^" +
                         std::to_string(series.denominator_exponent()) + "\n" + kind +
                         "_polynomial = " + polynomial + "\n" + //
                         "regularity_index = " + std::to_string(series.regularity_index()) + "\n" +
                         "dimension = " + std::to_string(dimension(I, run)) + "\n" + //
                         "degree = " + degree(I, run).get_str() + "\n");
    return exit_done;
}

struct Operation {
    std::string_view name;
    std::size_t least_operands;
    std::size_t most_operands;
    ExitStatus (*run)(Ideals, Session&);
};

constexpr std::size_t any_number = ~std::size_t{0};

constexpr std::array operations{
    Operation{"sum", 2, any_number, run_sum},
    Operation{"product", 2, any_number, run_product},
    Operation{"intersect", 2, any_number, run_intersect},
    Operation{"quotient", 2, 2, run_quotient},
    Operation{"saturate", 2, 2, run_saturate},
    Operation{"contains", 2, 2, run_contains},
    Operation{"equal", 2, 2, run_equal},
    Operation{"radical-contains", 2, 2, run_radical_contains},
    Operation{"dimension", 1, 1, run_dimension},
    Operation{"hilbert", 1, 1, run_hilbert},
};

const Operation& find_operation(std::string_view name) {
    std::vector<std::string_view> names;
    for (const Operation& operation : operations) {
        if (operation.name == name) return operation;
        names.push_back(operation.name);
    }
    throw UsageError("ideal: expected " + either(names) + ", found '" + std::string(name) + "'" +
                     did_you_mean(name, names));
}

class IdealCommand : public Command {
  public:
    std::string_view usage() const override { return "OPERATION A [B…]"; }

    std::string_view description() const override {
        return "Operations on ideals. A and B are files as for 'eliminant groebner', '-' for standard input, "
               "or lists\n"
               "of polynomials as 'x^2, x*y'. Ideals are printed by their reduced Groebner basis.\n"
               "\n"
               "  sum A B…              A + B\n"
               "  product A B…          A B\n"
               "  intersect A B…        A ∩ B\n"
               "  quotient A B          A : B = {f : f B ⊆ A}\n"
               "  saturate A B          A : B^∞, the union of all A : B^k\n"
               "  contains A B          whether B ⊆ A; prints true or false, exit status 0 or 1, as do\n"
               "  equal A B             whether A = B\n"
               "  radical-contains A B  whether some power of each element of B is in A\n"
               "  dimension A           the dimension of the zeros of A, -1 if there are none\n"
               "  hilbert A             Hilbert series and polynomial, dimension and degree\n"
               "\n"
               "Examples:\n"
               "  eliminant ideal intersect 'x^2, y' 'x - 1, y'\n"
               "  eliminant ideal radical-contains 'x^2 - y^2, x*y' 'x + y'\n";
    }

    void declare(OptionSet& options) override { system_.declare(options); }

    ExitStatus run(std::span<const std::string> operands, Session& session) override {
        if (operands.empty()) throw UsageError("ideal: expected an operation; see 'eliminant ideal --help'");
        const Operation& operation = find_operation(operands[0]);
        const std::span inputs = operands.subspan(1);
        if (inputs.size() < operation.least_operands || inputs.size() > operation.most_operands)
            throw UsageError("ideal " + std::string(operation.name),
                             (operation.most_operands == any_number ? "at least " : "") +
                                 std::to_string(operation.least_operands) +
                                 (operation.least_operands == 1 ? " ideal" : " ideals"),
                             std::to_string(inputs.size()));

        std::vector<std::span<const std::string>> groups;
        for (const std::string& input : inputs) groups.emplace_back(&input, 1);
        std::vector<Ideal> ideals;
        for (System& system : read_systems(groups, system_, session.run()))
            ideals.emplace_back(system.ring, std::move(system.polynomials));
        return operation.run(ideals, session);
    }

  private:
    SystemOptions system_;
};

} // namespace

std::unique_ptr<Command> make_ideal() { return std::make_unique<IdealCommand>(); }

} // namespace eliminant::app
