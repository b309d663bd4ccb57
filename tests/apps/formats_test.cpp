// --format: other systems' syntax, and Singular itself as the judge of its own.
#include "program.hpp"

namespace eliminant::test {
namespace {

const std::vector<std::string> other_formats{"latex", "singular", "macaulay2", "sage", "maple"};

TEST(Formats, APolynomialIsDeclaredForOtherSystems) {
    const auto circle_in = [](const std::string& format) {
        const ProcessResult result = run({"implicitize", "x = cos(u)", "y = sin(u)", "--format", format});
        EXPECT_EQ(result.errors, "") << format;
        return result.output;
    };
    EXPECT_EQ(circle_in("text"), "x^2+y^2-1\n");
    EXPECT_EQ(circle_in("latex"), "\\[ x^{2}+y^{2}-1 \\]\n");
    EXPECT_EQ(circle_in("singular"), "ring r = 0,(x,y),dp;\npoly f = x^2+y^2-1;\n");
    EXPECT_EQ(circle_in("macaulay2"), "R = QQ[x,y, MonomialOrder => GRevLex];\nf = sub(x^2+y^2-1,R);\n");
    EXPECT_EQ(circle_in("sage"), "R.<x,y> = PolynomialRing(QQ, order='degrevlex')\nf = R(x^2+y^2-1)\n");
    EXPECT_EQ(circle_in("maple"), "f := x^2+y^2-1;\n");
}

TEST(Formats, EveryCommandTakesEveryFormat) {
    const std::vector<std::vector<std::string>> commands{
        {"implicitize", "x = t", "y = t^2", "z = t^3"},
        {"implicitize", "x = s", "y = t"}, // 0
        {"groebner", "x^2 - y", "x*y - 1"},
        {"groebner", "--variables", "x", "0"},
        {"divide", "x^2", "by", "x - 1/2"},
        {"eliminate", "t", "x = t^2", "y = t^3"},
        {"ideal", "intersect", "x", "y"},
    };
    for (const std::vector<std::string>& command : commands)
        for (const std::string& format : other_formats) {
            std::vector<std::string> arguments = command;
            arguments.insert(arguments.end(), {"--format", format});
            const ProcessResult result = run(arguments);
            EXPECT_EQ(result.status, 0) << command[0] << " " << format << ": " << result.errors;
            EXPECT_NE(result.output, "") << command[0] << " " << format;
        }
}

TEST(Formats, OurSingularSyntaxIsReadBack) {
    const std::string basis = run({"groebner", "x^2 - y", "x*y - 1/3"}).output;
    const std::string singular = run({"groebner", "x^2 - y", "x*y - 1/3", "--format", "singular"}).output;
    expect_output(run_with_input({"groebner"}, singular), basis);
}

TEST(Formats, SingularFindsTheSameBasis) {
    if (std::system("command -v Singular >/dev/null") != 0) GTEST_SKIP() << "Singular is not installed";
    const ScratchDirectory scratch;
    std::string script =
        run({"groebner", "x^2 + y*z - 1", "x*y*z - 2", "x - y^2", "--format", "singular"}).output;
    script += "if (size(reduce(I, std(I))) == 0 and size(reduce(std(I), I)) == 0) { print(\"a basis\"); }\n";
    scratch.write("script", script);
    const ProcessResult result =
        run_process({"/bin/sh", "-c", "Singular -q <script"}, {.directory = scratch.path()});
    EXPECT_NE(result.output.find("a basis"), std::string::npos) << script << result.output;
}

} // namespace
} // namespace eliminant::test
