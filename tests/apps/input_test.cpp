// Where input comes from, how a file is told from an expression, and what is said about input that is none.
#include "program.hpp"

namespace eliminant::test {
namespace {

TEST(Input, ComesFromFilesStandardInputAndTheCommandLine) {
    const ScratchDirectory scratch;
    const std::string file = scratch.write("circle.sys", "variables x, y\nx^2 + y^2 = 1\n");
    expect_output(run({"groebner", file}), "x^2+y^2-1\n");
    expect_output(run({"groebner", "circle.sys"}, {.directory = scratch.path()}), "x^2+y^2-1\n");
    expect_output(run_with_input({"groebner", "-"}, "x^2 + y^2 - 1\n"), "x^2+y^2-1\n");
    expect_output(run_with_input({"groebner"}, "x^2 + y^2 - 1\n"), "x^2+y^2-1\n");
    expect_output(run({"groebner", "x^2 + y^2 = 1"}), "x^2+y^2-1\n");
    expect_output(run({"groebner", "x^2, y - x"}), "x-y\ny^2\n");
}

TEST(Input, ASingleNameOfAnExistingFileIsThatFile) {
    const ScratchDirectory scratch;
    scratch.write("x", "y^2\n");
    expect_output(run({"groebner", "x"}, {.directory = scratch.path()}), "y^2\n");
    expect_output(run({"groebner", "x", "z"}, {.directory = scratch.path()}), "z\nx\n");
    std::filesystem::create_directory(scratch.path("d"));
    expect_output(run({"groebner", "d"}, {.directory = scratch.path()}), "d\n");
}

TEST(Input, AMissingFileIsNotTakenForAPolynomial) {
    for (const std::string name :
         {"circle.sys", "./circle", "../circle", "dir/circle", "/no/circle", "my circle.sys"})
        expect_error(run({"groebner", name}), 2, name + ": no such file");
    expect_error(run({"groebner", "a.sys", "b.sys"}), 2, "a.sys: no such file");
    expect_error(run({"implicitize", "circle"}), 2, "circle: no such file");
    expect_error_with(run({"implicitize", "t^2"}), 2, "argument:1:");
    expect_error(run({"groebner", "/tmp/"}), 2, "/tmp/: is a directory");
    expect_error(run({"groebner", "/etc/passwd/x"}), 2, "/etc/passwd/x: not a directory");
    for (const std::string text : {"x/2", "3/4", "0.5", "x"})
        EXPECT_EQ(run({"groebner", text}).status, 0) << text;
}

TEST(Input, SeveralFilesAreRefused) {
    const ScratchDirectory scratch;
    scratch.write("a.sys", "x\n");
    scratch.write("b.sys", "y\n");
    expect_error(run({"groebner", "a.sys", "b.sys"}, {.directory = scratch.path()}), 2,
                 "input: expected one file or several expressions, found 'a.sys' among several arguments");
    expect_error(run_with_input({"groebner", "-", "x"}, "y"), 2,
                 "input: expected one file or several expressions, found '-' among several arguments");
    expect_error(run_with_input({"ideal", "sum", "-", "-"}, "x"), 2,
                 "input: expected '-' once, found it more often: standard input can be read only once");
}

TEST(Input, ErrorsNameThePlace) {
    const ScratchDirectory scratch;
    scratch.write("bad.sys", "variables x, y\n\nx^2 + * y\n");
    expect_error_with(run({"groebner", "bad.sys"}, {.directory = scratch.path()}), 2,
                      "bad.sys:3:7: expected ");
    expect_error_with(run_with_input({"groebner", "-"}, "x +\n"), 2, "eliminant: -:1:");
    expect_error_with(run({"groebner", "x", "y $ 2"}), 2, "argument 2:1:3: expected ");
    expect_error_with(run({"groebner", "x, y $ 2"}), 2, "argument:1:6: expected ");
    expect_error_with(run({"groebner", "--field", "GF(4)", "x"}), 2, "--field:1:");
    expect_error_with(run({"groebner", "--order", "lexx", "x"}), 2, "--order:1:1: ");
    expect_error_with(run({"groebner", "--variables", "x,x", "x"}), 2, "--variables:1:3: ");
    expect_error_with(run({"implicitize", "x = t", "y = t +"}), 2, "argument 2:1:8: expected ");
}

TEST(Input, OnATerminalACaretShowsThePlace) {
    const ProcessResult result = run({"groebner", "x^2 + $y"}, {.terminal = true});
    EXPECT_EQ(result.status, 2);
    EXPECT_NE(result.errors.find("\r\n  x^2 + $y\r\n        ^\r\n"), std::string::npos) << result.errors;
    // A line longer than the terminal is cut around the place, multi-byte characters count once.
    const std::string before(500, '1');
    const ProcessResult cut = run({"groebner", before + "−$" + before}, {.terminal = true});
    EXPECT_EQ(cut.status, 2);
    const std::size_t line_end = cut.errors.rfind('^');
    ASSERT_NE(line_end, std::string::npos);
    EXPECT_LT(cut.errors.size(), 400U);
}

TEST(Input, EmptyInputIsAnError) {
    for (const std::string command : {"implicitize", "groebner"}) {
        const ProcessResult result = run_with_input({command, "-"}, "");
        expect_error_with(result, 2, "-:1:1: expected ");
        EXPECT_EQ(run({command, ""}).status, 2);
        EXPECT_EQ(run_with_input({command, "-"}, "# nothing\n\n").status, 2);
    }
}

TEST(Input, HostileTextIsAnErrorInOneLine) {
    const std::string nested(1'000'000, '(');
    std::string binary = "x\n";
    for (int byte = 0; byte < 256; ++byte) binary += static_cast<char>(byte);
    const std::string long_line(1 << 20, '+');
    for (const std::string& text :
         {nested, binary, long_line, std::string("\x1b]0;title\x07"), std::string(1, '\0'),
          std::string("\xff\xfe"), std::string("x^99999999999999999999"), std::string("x/0"),
          std::string("x^-1"), std::string("x y"), std::string("x^2y")}) {
        for (const std::string command : {"groebner", "implicitize"}) {
            const ProcessResult result = run_with_input({command, "-"}, text);
            expect_error_with(result, 2, "-:");
            EXPECT_LT(result.errors.size(), 1000U);
            EXPECT_EQ(result.errors.find('\x1b'), std::string::npos);
        }
    }
}

TEST(Input, ALongLineOfSenseIsRead) {
    std::string sum = "x";
    while (sum.size() < (1 << 20)) sum += "+1*x";
    const ProcessResult result = run_with_input({"groebner"}, sum);
    EXPECT_EQ(result.output, "x\n");
    EXPECT_EQ(result.status, 0);
}

TEST(Input, LineEndsOfOtherSystemsAndAMissingLastOneAreRead) {
    expect_output(run_with_input({"groebner"}, "variables x, y\r\nx - 1\r\ny^2\r\n"), "x-1\ny^2\n");
    expect_output(run_with_input({"groebner"}, "x^2 - 1"), "x^2-1\n");
}

} // namespace
} // namespace eliminant::test
