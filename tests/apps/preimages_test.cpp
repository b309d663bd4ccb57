// `eliminant preimages`, `eliminant contains-point` and `eliminant inversion`.
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
                  "{\"parameters\":[\"t\"],\"dimension\":0,\"count\":2,\"real_count\":2,\"has_real\":true,"
                  "\"limit_at_infinity\":false,\"rational\":[[\"-1\"],[\"1\"]],\"components\":[],"
                  "\"nonzero\":[]}\n");
    expect_output(ask({"preimages", "--at", "1,1"}, {"x = s/t", "y = s^2/t^2"}), "s-t = 0, t != 0\n");
    const ProcessResult limit = ask({"preimages", "--at", "-1,0"}, {"x = (1-t^2)/(1+t^2)", "y = 2t/(1+t^2)"});
    EXPECT_EQ(limit.output, "");
    EXPECT_EQ(limit.status, 1);
    EXPECT_NE(limit.errors.find("the limit for t to infinity"), std::string::npos) << limit.errors;
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
    const std::vector<std::string> umbrella{"x = s*t", "y = s", "z = t^2"};
    for (const std::string option : {"--image", "--real"})
        EXPECT_EQ(ask({"contains-point", option, "--at", "0,0,4"}, umbrella).output, "true\n");
    EXPECT_EQ(ask({"contains-point", "--image", "--at", "0,0,-4"}, umbrella).output, "true\n");
    EXPECT_EQ(ask({"contains-point", "--real", "--at", "0,0,-4"}, umbrella).output, "false\n");
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
}

TEST(Preimages, TakeValuesOfConstants) {
    const std::vector<std::string> circle{"constants r", "x = r*cos(u)", "y = r*sin(u)"};
    expect_output(ask({"preimages", "--at", "3,4", "--set", "r=5"}, circle), "cos_u = 3/5, sin_u = 4/5\n");
    expect_output(ask({"contains-point", "--at", "3,4", "--set", "r=5"}, circle), "true\n");
    EXPECT_EQ(ask({"contains-point", "--image", "--at", "3,4", "--set", "r=6"}, circle).output, "false\n");
    // As if it had been written with the number: (t²−1)/(t−1) is t+1, also at t = 1.
    expect_output(
        ask({"preimages", "--at", "2,1", "--set", "r=1"}, {"constants r", "x = (t^2-r)/(t-1)", "y = t"}),
        "t = 1\n");
    for (const std::string command : {"preimages", "contains-point"}) {
        expect_error(
            ask({command, "--at", "1,2"}, circle), 2,
            "--set: expected a value for the constant 'r' of the parametrization, as --set r=2, found "
            "none");
        expect_error(ask({command, "--at", "1,2", "--set", "r=1", "--set", "R=1"}, circle), 2,
                     "--set: expected a constant of the parametrization, found 'R'");
    }
    expect_error_with(ask({"preimages", "--at", "1", "--set", "r=0"}, {"constants r", "x = t/r"}), 2,
                      "denominator");
}

TEST(Inversion, IsPrintedALineAParameter) {
    expect_output(ask({"inversion"}, node), "t = (y)/(x)\n");
    expect_output(ask({"inversion"}, {"x = s*t", "y = s", "z = t^2"}), "s = y\nt = (x)/(y)\n");
    expect_output(ask({"inversion"}, {"constants r", "x = r*cos(u)", "y = r*sin(u)"}),
                  "cos_u = (x)/(r)\nsin_u = (y)/(r)\n");
    expect_output(ask({"inversion"}, {"x = cos(2u)", "y = sin(4u)"}), "cos_2u = x\nsin_2u = (y)/(2*x)\n");
    expect_output(ask({"inversion", "--format", "json"}, node),
                  "{\"variables\":[\"x\",\"y\"],\"parametrization_degree\":1,\"parameters\":[{\"name\":\"t\","
                  "\"numerator\":\"y\",\"denominator\":\"x\"}]}\n");
}

TEST(Inversion, SaysWhyThereIsNone) {
    expect_error(ask({"inversion"}, {"x = t^2", "y = t^4"}), 1,
                 "no such formula: 2 parameter values reach a general point");
    expect_error(ask({"inversion"}, {"x = s+t", "y = (s+t)^2", "z = 1"}), 1,
                 "no such formula: infinitely many parameter values reach a general point");
    const ProcessResult json = ask({"inversion", "--format", "json"}, {"x = t^2", "y = t^4"});
    EXPECT_EQ(json.output, "{\"variables\":[\"x\",\"y\"],\"parametrization_degree\":2,\"parameters\":[]}\n");
    EXPECT_EQ(json.status, 1);
    expect_error_with(ask({"inversion"}, {"relation s^2 = t^3", "x = s", "y = t"}), 2, "relations");
    expect_error_with(ask({"inversion", "--format", "latex"}, node), 2, "--format: ");
}

} // namespace
} // namespace eliminant::test
