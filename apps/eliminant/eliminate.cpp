/// \file
/// `eliminant eliminate`.
#include "command.hpp"
#include "results.hpp"
#include "suggestion.hpp"
#include "systems.hpp"

#include "eliminant/algebra/parse.hpp"
#include "eliminant/ideal/operations.hpp"

namespace eliminant::app {

namespace {

/// The indices of the variables to eliminate.
std::vector<std::size_t> indices_of(const std::string& list, const Ring& ring) {
    const std::vector<std::string_view> known(ring.names().begin(), ring.names().end());
    std::vector<std::size_t> indices;
    for (const std::string& name : parse_names({list, "argument 1"})) {
        const std::optional<std::size_t> index = ring.index_of(name);
        if (!index)
            throw UsageError("argument 1: expected variables of the system (" + either(known) + "), found '" +
                             name + "'" + did_you_mean(name, known));
        indices.push_back(*index);
    }
    return indices;
}

class EliminateCommand : public Command {
  public:
    std::string_view usage() const override { return "VARIABLES [FILE | - | POLY…]"; }

    std::string_view description() const override {
        return "The elimination ideal: all consequences of the system in which none of VARIABLES (as 'x,y') "
               "occurs,\n"
               "given by its reduced Groebner basis. Its zeros are the closure of the projection of the "
               "system's\n"
               "zeros along VARIABLES. Files are as for 'eliminant groebner'.\n"
               "\n"
               "Example:\n"
               "  eliminant eliminate t 'x = t^2' 'y = t^3'\n";
    }

    void declare(OptionSet& options) override { system_.declare(options); }

    ExitStatus run(std::span<const std::string> operands, Session& session) override {
        if (operands.empty())
            throw UsageError(
                "expected the variables to eliminate, as x,y, found the end of the command line");
        const System system = read_system(operands.subspan(1), system_, session.run());
        const std::vector<std::size_t> variables = indices_of(operands[0], system.ring);
        const Ideal result = eliminate(Ideal(system.ring, system.polynomials), variables, session.run());
        session.write_result(ideal_in(session.format(), result, session.run()));
        return exit_done;
    }

  private:
    SystemOptions system_;
};

} // namespace

std::unique_ptr<Command> make_eliminate() { return std::make_unique<EliminateCommand>(); }

} // namespace eliminant::app
