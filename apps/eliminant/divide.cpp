/// \file
/// `eliminant divide`.
#include "command.hpp"
#include "results.hpp"
#include "systems.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/print.hpp"

#include <algorithm>
#include <array>

namespace eliminant::app {

namespace {

class DivideCommand : public Command {
  public:
    std::string_view usage() const override { return "F by [FILE | - | G1 G2…]"; }

    std::string_view description() const override {
        return "Multivariate division: F = q1*G1 + q2*G2 + … + r, where no term of r is divisible by a "
               "leading term\n"
               "of a divisor. Each step uses the first divisor that applies. F and the divisors are "
               "polynomials or\n"
               "files (see 'eliminant groebner --help').\n"
               "\n"
               "Examples:\n"
               "  eliminant divide 'x^2*y + x*y^2 + y^2' by 'x*y - 1' 'y^2 - 1' --order lex\n"
               "  eliminant groebner 'x^2 + y^2 - 1' 'x - y' | eliminant divide 'x^3' by -\n";
    }

    void declare(OptionSet& options) override { system_.declare(options); }

    ExitStatus run(std::span<const std::string> operands, Session& session) override {
        const auto by = std::find(operands.begin(), operands.end(), "by");
        if (by == operands.end())
            throw UsageError("expected 'F by G1 G2…', found no 'by'; see 'eliminant divide --help'");
        const std::span dividend_operands(operands.begin(), by);
        const std::span divisor_operands(by + 1, operands.end());
        if (dividend_operands.empty()) throw UsageError("expected a polynomial before 'by', found nothing");
        if (divisor_operands.empty()) throw UsageError("expected divisors after 'by', found nothing");

        const std::vector<System> systems =
            read_systems(std::array{dividend_operands, divisor_operands}, system_, session.run());
        if (systems[0].polynomials.size() != 1)
            throw UsageError("expected one polynomial before 'by', found " +
                             std::to_string(systems[0].polynomials.size()));
        const std::vector<Polynomial>& divisors = systems[1].polynomials;
        const auto zero = std::ranges::find_if(divisors, [](const Polynomial& g) { return g.is_zero(); });
        if (zero != divisors.end())
            throw UsageError("expected divisors that are not zero, found divisor " +
                             std::to_string(zero - divisors.begin() + 1) + " to be 0");
        const Division division = divide(systems[0].polynomials[0], divisors, session.run());
        session.write_result(session.format() == ResultFormat::json
                                 ? json(systems[0].ring, division, session.run())
                                 : text(session.format(), division, session.run()));
        return exit_done;
    }

  private:
    static std::string text(ResultFormat format, const Division& division, const Run& run) {
        std::string result;
        for (std::size_t i = 0; i < division.quotients.size(); ++i)
            result += assignment_in(format, std::string("q").append(std::to_string(i + 1)),
                                    division.quotients[i], run);
        return result + assignment_in(format, "r", division.remainder, run);
    }

    static std::string json(const Ring& ring, const Division& division, const Run& run) {
        Json result = ring_fields(ring);
        result["quotients"] = strings(division.quotients, run);
        result["remainder"] = to_string(division.remainder, run);
        return to_text(result);
    }

    SystemOptions system_;
};

} // namespace

std::unique_ptr<Command> make_divide() { return std::make_unique<DivideCommand>(); }

} // namespace eliminant::app
