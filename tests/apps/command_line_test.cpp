// How the command line is understood: commands, options, values, help.
#include "program.hpp"

namespace eliminant::test {
namespace {

TEST(CommandLine, VersionIsThatOfTheLibrary) {
    expect_output(run({"--version"}), "eliminant 0.1.0\n");
    expect_output(run({"groebner", "--version"}), "eliminant 0.1.0\n");
}

TEST(CommandLine, HelpGoesToStandardOutput) {
    for (const std::string option : {"--help", "-h"}) {
        const ProcessResult result = run({option});
        EXPECT_EQ(result.status, 0);
        EXPECT_EQ(result.errors, "");
        for (const char* command : {"implicitize", "verify", "groebner", "divide", "eliminate", "ideal"})
            EXPECT_NE(result.output.find(command), std::string::npos) << command;
    }
    EXPECT_EQ(run({"help"}).output, run({"--help"}).output);
    EXPECT_EQ(run({"help", "divide"}).output, run({"divide", "--help"}).output);
}

/// The lines of a help text that can be pasted: they are indented and begin with the program's name.
std::vector<std::string> examples_in(const std::string& help) {
    std::vector<std::string> examples;
    std::istringstream lines(help);
    for (std::string line; std::getline(lines, line);)
        if (line.rfind("  eliminant ", 0) == 0) examples.push_back(line.substr(2));
    return examples;
}

TEST(CommandLine, EveryExampleInTheHelpWorksWhenPasted) {
    const std::string directory = std::filesystem::path(ELIMINANT_PROGRAM).parent_path().string();
    const std::string path = directory + ":" + std::getenv("PATH");
    // Some examples read files of data/, some write.
    const ScratchDirectory scratch;
    std::filesystem::create_directory_symlink(ELIMINANT_DATA_DIR, scratch.path("data"));
    for (const std::string command : {"", "implicitize", "contains-point", "preimages", "inversion", "verify",
                                      "groebner", "divide", "eliminate", "ideal", "distance"}) {
        const ProcessResult help = command.empty() ? run({"--help"}) : run({command, "--help"});
        EXPECT_EQ(help.status, 0);
        EXPECT_EQ(help.output.rfind("Usage: eliminant", 0), 0U);
        for (const char* option : {"--output", "--format", "--quiet", "--verbose", "--threads",
                                   "--time-limit", "--memory-limit", "--seed", "--help", "--version"})
            EXPECT_NE(help.output.find(option), std::string::npos) << command << " " << option;

        const std::vector<std::string> examples = examples_in(help.output);
        EXPECT_FALSE(examples.empty()) << command;
        for (const std::string& example : examples) {
            const ProcessResult result =
                run_process({"/bin/sh", "-c", "cd '" + scratch.path() + "' && " + example},
                            {.environment = {{"PATH", path}}});
            EXPECT_LE(result.status, 1) << example << "\n" << result.errors; // 1 is an answer too
            EXPECT_NE(result.output, "") << example;
        }
    }
}

TEST(CommandLine, UnknownCommandsAreNamed) {
    expect_error(run({"implicitise", "x = t"}), 2,
                 "unknown command 'implicitise'; did you mean 'implicitize'?");
    expect_error(run({"impl"}), 2, "unknown command 'impl'; did you mean 'implicitize'?");
    expect_error(run({"frobnicate"}), 2, "unknown command 'frobnicate'; see 'eliminant --help'");
    expect_error(run({}), 2, "expected a command, found the end of the command line; see 'eliminant --help'");
}

TEST(CommandLine, UnknownOptionsAreNamed) {
    expect_error(run({"groebner", "--ordr", "lex", "x"}), 2,
                 "unknown option '--ordr'; did you mean '--order'?");
    expect_error(run({"groebner", "--zzzzzz", "x"}), 2, "unknown option '--zzzzzz'");
    expect_error_with(run({"groebner", "-x"}), 2, "unknown option '-x'");
}

TEST(CommandLine, BadValuesSayWhatWasExpected) {
    const auto expect_complaint = [](const std::vector<std::string>& options, const std::string& message) {
        std::vector<std::string> arguments{"groebner", "x"};
        arguments.insert(arguments.end(), options.begin(), options.end());
        expect_error(run(arguments), 2, message);
    };
    expect_complaint({"--format", "jsn"}, "--format: expected text, json, latex, singular, macaulay2, sage "
                                          "or maple, found 'jsn'; did you mean 'json'?");
    expect_complaint({"--threads", "many"},
                     "--threads: expected a whole number from 1 to 4096, found 'many'");
    expect_complaint({"--threads", "0"}, "--threads: expected a whole number from 1 to 4096, found '0'");
    expect_complaint({"--threads=-1"}, "--threads: expected a whole number from 1 to 4096, found '-1'");
    expect_complaint({"--threads"}, "--threads: expected N, found the end of the command line");
    for (const std::string seconds : {"-1", "soon", "1s", "nan", "inf", "1e999", ""})
        expect_complaint({"--time-limit", seconds},
                         "--time-limit: expected a number of seconds that is not negative, found '" +
                             seconds + "'");
    for (const std::string size : {"-1", "2Q", "G", "2GG", "1e30", "", "0x10"})
        expect_complaint({"--memory-limit", size},
                         "--memory-limit: expected a size as 2G, 512M or 1000000, found '" + size + "'");
    expect_complaint({"--seed", "1.5"},
                     "--seed: expected a whole number from 0 to 18446744073709551615, found '1.5'");
    expect_complaint({"--quiet=yes"}, "--quiet: expected no value, found 'yes'");
    expect_complaint(
        {"--algorithm", "buchburger"},
        "--algorithm: expected auto, buchberger or f4, found 'buchburger'; did you mean 'buchberger'?");
}

TEST(CommandLine, ValuesAreTakenInEveryCustomaryForm) {
    const std::string json = run({"groebner", "--format", "json", "x"}).output;
    EXPECT_EQ(json.substr(0, 1), "{");
    EXPECT_EQ(run({"groebner", "x", "--format=json"}).output.substr(0, 1), "{");
    EXPECT_EQ(run({"--format", "json", "groebner", "x"}).output.substr(0, 1), "{");
    expect_output(run({"groebner", "--format", "json", "x", "--format", "text"}), "x\n"); // the last one wins
    expect_output(run({"groebner", "--seed", "7", "--threads", "2", "--time-limit", "1e3", "--memory-limit",
                       "1.5G", "x"}),
                  "x\n");
    expect_output(run({"groebner", "-q", "x", "--memory-limit", "2GiB"}), "x\n");
}

TEST(CommandLine, APolynomialMayBeginWithAMinus) {
    expect_output(run({"groebner", "-x^2+1"}), "x^2-1\n");
    expect_output(run({"groebner", "-2x"}), "x\n");
    expect_output(run({"groebner", "-(x+y)"}), "x+y\n");
    expect_output(run({"groebner", "-v+1"}), "v-1\n"); // -v is an option, -+ and -1 are not
    expect_output(run({"groebner", "--", "-x"}), "x\n");
    expect_output(run({"groebner", "--variables", "o", "--", "-o+1"}), "o-1\n");
}

TEST(CommandLine, MissingOperandsAreNamed) {
    expect_error(run({"divide", "x"}), 2,
                 "expected 'F by G1 G2…', found no 'by'; see 'eliminant divide --help'");
    expect_error(run({"divide", "x", "by"}), 2, "expected divisors after 'by', found nothing");
    expect_error(run({"divide", "by", "x"}), 2, "expected a polynomial before 'by', found nothing");
    expect_error(run({"eliminate"}), 2,
                 "expected the variables to eliminate, as x,y, found the end of the command line");
    expect_error(run({"ideal"}), 2, "ideal: expected an operation; see 'eliminant ideal --help'");
    expect_error(run({"ideal", "sum", "x"}), 2, "ideal sum: expected at least 2 ideals, found 1");
    expect_error(run({"ideal", "dimension", "x", "y"}), 2, "ideal dimension: expected 1 ideal, found 2");
    expect_error_with(run({"ideal", "dimensoin", "x"}), 2, "did you mean 'dimension'?");
}

} // namespace
} // namespace eliminant::test
