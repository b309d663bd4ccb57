/// \file
/// The program `eliminant`: finds the command, reads its options, and turns what happens into an exit status.
#include "command.hpp"
#include "suggestion.hpp"

#include "eliminant/base/version.hpp"

#include <array>
#include <new>
#include <stdexcept>
#include <vector>

namespace eliminant::app {

namespace {

constexpr std::array commands{
    CommandEntry{"implicitize", "exact implicit equations of a parametrization", make_implicitize},
    CommandEntry{"contains-point", "whether a point lies on the image of a parametrization",
                 make_contains_point},
    CommandEntry{"preimages", "the parameters that reach a point", make_preimages},
    CommandEntry{"inversion", "the parameters as rational functions of the point", make_inversion},
    CommandEntry{"verify", "check the certificate of an implicit equation", make_verify},
    CommandEntry{"groebner", "reduced Groebner basis of a polynomial system", make_groebner},
    CommandEntry{"divide", "multivariate division with quotients and remainder", make_divide},
    CommandEntry{"eliminate", "the consequences of a system without some variables", make_eliminate},
    CommandEntry{"ideal", "sum, product, intersection, quotient, membership, dimension, …", make_ideal},
    CommandEntry{"distance", "how far a point is from a surface: estimates and a proven bound",
                 make_distance},
    CommandEntry{"render", "a picture of a surface, right in every pixel", make_render},
};

const CommandEntry& find_command(std::string_view name) {
    std::vector<std::string_view> names;
    for (const CommandEntry& entry : commands) {
        if (entry.name == name) return entry;
        names.push_back(entry.name);
    }
    throw UsageError("unknown command '" + std::string(name) + "'" + did_you_mean(name, names) +
                     (nearest(name, names) ? "" : "; see 'eliminant --help'"));
}

std::string program_help(const OptionSet& options) {
    std::string text =
        "Usage: eliminant COMMAND [OPTION…] [ARGUMENT…]\n\n"
        "Exact implicit equations of parametric curves and surfaces, and the algebra behind them.\n\n"
        "Commands:\n";
    constexpr std::size_t name_width = 16;
    for (const CommandEntry& entry : commands) {
        std::string name(entry.name);
        name.resize(name_width, ' ');
        text.append("  ").append(name).append(entry.summary).append("\n");
    }
    text += "\n'eliminant COMMAND --help' says more about each.\n\n"
            "Example:\n"
            "  eliminant implicitize 'x = (1-t^2)/(1+t^2)' 'y = 2t/(1+t^2)'\n";
    text += options.help();
    text += "\nExit status: 0 done; 1 the answer is no; 2 bad usage or bad input; 3 a limit was reached;\n"
            "130 interrupted.\n";
    return text;
}

std::string command_help(const CommandEntry& entry, const Command& command, const OptionSet& options) {
    std::string text = "Usage: eliminant ";
    text.append(entry.name).append(" [OPTION…] ").append(command.usage()).append("\n\n");
    return text.append(command.description()).append(options.help());
}

void print(std::string_view text) {
    Run run;
    Destination("-").write(text, run);
}

/// The command's own run, with everything that can stop it.
ExitStatus execute(Command& command, const CommonOptions& common, std::span<const std::string> operands,
                   Console& console) {
    Session session(common, console);
    const auto limit_reached = [&](std::string_view reason) {
        console.error(reason);
        session.write_incomplete(reason);
        return exit_limit;
    };
    try {
        return command.run(operands, session);
    } catch (const Stopped& stopped) {
        if (stopped.reason() != StopReason::interrupted) return limit_reached(stopped.what());
        console.error(stopped.what());
        return exit_interrupted;
    } catch (const std::bad_alloc&) {
        return limit_reached("memory exhausted");
    } catch (const std::length_error&) { // a container beyond any memory
        return limit_reached("memory exhausted");
    }
}

/// Arguments are those behind the program's name.
ExitStatus run_command_line(std::vector<std::string> arguments, Console& console) {
    // As with git, `help COMMAND` is `COMMAND --help`, and common options may also stand before the command.
    if (!arguments.empty() && arguments[0] == "help") {
        arguments.erase(arguments.begin());
        arguments.emplace_back("--help");
    }
    CommonOptions common;
    OptionSet program_options;
    common.declare(program_options);
    const std::vector<std::string> rest = program_options.read(arguments, OptionSet::Reading::to_command);
    if (rest.empty() && common.help) return print(program_help(program_options)), exit_done;
    if (!common.version && rest.empty())
        throw UsageError("expected a command, found the end of the command line; see 'eliminant --help'");

    std::unique_ptr<Command> command;
    OptionSet options;
    std::vector<std::string> operands;
    if (!rest.empty()) {
        const CommandEntry& entry = find_command(rest[0]);
        command = entry.make();
        options.heading("Options");
        command->declare(options);
        common.declare(options);
        operands = options.read(std::span(rest).subspan(1));
        if (common.help) return print(command_help(entry, *command, options)), exit_done;
    }
    if (common.version) return print("eliminant " + std::string(version_string) + "\n"), exit_done;

    console.set_verbose(common.verbose);
    return execute(*command, common, operands, console);
}

ExitStatus guarded(std::vector<std::string> arguments, Console& console) {
    try {
        return run_command_line(std::move(arguments), console);
    } catch (const ParseError& error) {
        console.error(error);
    } catch (const Error& error) {
        console.error(error.what());
    } catch (const std::exception& error) {
        console.error(std::string("internal error: ") + error.what());
    }
    return exit_usage;
}

} // namespace

} // namespace eliminant::app

int main(int argument_count, char** arguments) {
    eliminant::app::prepare_process();
    eliminant::app::Console console;
    return eliminant::app::guarded({arguments + (argument_count > 0 ? 1 : 0), arguments + argument_count},
                                   console);
}
