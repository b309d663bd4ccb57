// `eliminant preimages` and `eliminant contains-point`.
#include "program.hpp"

namespace eliminant::test {
namespace {

const std::vector<std::string> node{"x = t^2-1", "y = t^3-t"};

ProcessResult ask(std::vector<std::string> command, const std::vector<std::string>& shape) {
    command.insert(command.begin() + 1, shape.begin(), shape.end());
    return run(command);
}

TEST(Preimages, ArePrintedALineEach) {
    expect_output(ask({"preimages", "--at", "0,0"}, node), "t = -1\nt = 1\n");
    expect_output(ask({"preimages", "--at", "2,4"}, {"x = t^2", "y = t^4"}), "t^2-2 = 0\n");
    expect_output(ask({"preimages", "--at", "3,2,-1"}, {"x = s+t", "y = s*t", "z = s-t"}), "s = 1, t = 2\n");
    expect_output(ask({"preimages", "--at", "0,0,0"}, {"x = s*t", "y = s", "z = s^2"}), "s = 0\n");
    expect_output(ask({"preimages", "--format", "json", "--at", "0,0"}, node),
                  "{\"parameters\":[\"t\"],\"dimension\":0,\"count\":2,\"rational\":[[\"-1\"],[\"1\"]],"
                  "\"components\":[]}\n");
    const ProcessResult none = ask({"preimages", "--at", "5,5"}, node);
    EXPECT_EQ(none.output, "");
    EXPECT_EQ(none.errors, "");
    EXPECT_EQ(none.status, 1);
    expect_output(run_with_input({"preimages", "--at", "1/4,1/2"}, "bezier 2\n0 0\n0 1/2\n1 1\n"),
                  "t = 1/2\n");
}

TEST(ContainsPoint, IsAPredicate) {
    const std::vector<std::string> circle{"x = (1-t^2)/(1+t^2)", "y = 2t/(1+t^2)"};
    expect_output(ask({"contains-point", "--at", "3/5,0.8"}, circle), "true\n");
    expect_output(ask({"contains-point", "--at", "-1,0"}, circle), "true\n");
    const ProcessResult image = ask({"contains-point", "--image", "--at", "-1,0"}, circle);
    EXPECT_EQ(image.output, "false\n");
    EXPECT_EQ(image.status, 1);
    const ProcessResult outside = ask({"contains-point", "--format", "json", "--at", "1,1"}, circle);
    EXPECT_EQ(outside.output, "{\"contains\":false}\n");
    EXPECT_EQ(outside.status, 1);
}

TEST(ContainsPoint, ErrorsSayWhatIsMissing) {
    expect_error(ask({"contains-point"}, node), 2, "expected a point, as --at '1,2/3,0.5', found none");
    expect_error(ask({"preimages", "--at", "1"}, node), 2,
                 "--at: expected a number for each of the 2 coordinates, found 1");
    expect_error_with(ask({"preimages", "--at", "1,x"}, node), 2, "--at:1:3: ");
    expect_error_with(ask({"preimages", "--at", "1,2", "--format", "latex"}, node), 2, "--format: ");
    expect_error_with(ask({"preimages", "--at", "1,2"}, {"constants r", "x = r*t", "y = t"}), 2, "constants");
}

} // namespace
} // namespace eliminant::test
