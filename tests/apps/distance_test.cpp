// `eliminant distance`: what SURFACE may be, its lines, its errors.
#include "program.hpp"

#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <sstream>

namespace eliminant::test {
namespace {

using Json = nlohmann::ordered_json;

TEST(Distance, PrintsALineALevel) {
    expect_output(run({"distance", "x^2+y^2+z^2 = 9/4", "--at", "0,0,7/2", "--level", "first"}),
                  "first_order 1.4285714285714286\nsign 1\n");
    expect_output(run({"distance", "2x-y+2z-3", "--at", "0,0,0", "--level", "second"}),
                  "second_order 1\nsign -1\n");
    const ProcessResult all = run({"distance", "x^2+y^2+z^2-4", "--at", "1/3,0,0"});
    std::istringstream lines(all.output);
    std::string name;
    double first = 0, second = 0, guaranteed = 0;
    int sign = 0;
    lines >> name >> first;
    EXPECT_EQ(name, "first_order");
    lines >> name >> second;
    EXPECT_EQ(name, "second_order");
    lines >> name >> guaranteed;
    EXPECT_EQ(name, "guaranteed");
    lines >> name >> sign;
    EXPECT_EQ(name, "sign");
    EXPECT_EQ(first, 35.0 / 6);
    EXPECT_NEAR(second, 5.0 / 3, 1e-15);
    EXPECT_NEAR(guaranteed, 5.0 / 3, 1e-10);
    EXPECT_LE(guaranteed, 5.0 / 3);
    EXPECT_EQ(sign, -1);
}

TEST(Distance, TakesExactCoordinates) {
    // 1/10 is not the double nearest to it: the point is on the surface.
    expect_output(run({"distance", "10x-1", "--at", "0.1,0,0"}),
                  "first_order 0\nsecond_order 0\nguaranteed 0\nsign 0\n");
    expect_output(run({"distance", "x - 1/3", "--at", "1/3,0,0", "--level", "guaranteed"}),
                  "guaranteed 0\nsign 0\n");
}

TEST(Distance, ReadsEveryKindOfSurface) {
    const std::string answer = "first_order 1\nsign 1\n";
    const ScratchDirectory folder;
    const auto of = [&](std::vector<std::string> surface, const std::string& at) {
        surface.insert(surface.begin(), "distance");
        surface.insert(surface.end(), {"--at", at, "--level", "first"});
        return run(surface);
    };
    expect_output(of({folder.write("plane.txt", "# a plane\n  z\n")}, "4,5,1"), answer);
    expect_output(of({folder.write("plane.par", "parameters s, t\nx = s\ny = t\nz = s*0\n")}, "4,5,1"),
                  answer);
    expect_output(of({"x = s", "y = t", "z = 0"}, "4,5,1"), answer);
    expect_output(of({"x*r - q", "--set", "r=2", "--set", "q=1/2"}, "5/4,0,0"), answer);
    expect_output(of({"x^2+y^2"}, "3/5,4/5"), "first_order 0.5\nsign 1\n");
    expect_output(run_with_input({"distance", "-", "--at", "4,5,1", "--level", "first"}, "z\n"), answer);
    // A constant of a parametrization gets its value before the parameters are eliminated.
    expect_output(of({"constants r", "x = r*cos(t)", "y = r*sin(t)", "--set=r=1/2"}, "1/2,0"),
                  "first_order 0\nsign 0\n");
}

TEST(Distance, WritesJson) {
    const Json json = Json::parse(run({"distance", "x^2+1", "--at", "0,0,0", "--format", "json"}).output);
    EXPECT_EQ(json["first_order"], "inf"); // JSON has no such number
    EXPECT_EQ(json["second_order"], 1.0);
    EXPECT_EQ(json["sign"], 1);
}

TEST(Distance, AnswersAtPointsThatNoDoubleHolds) {
    const auto all_at = [](const std::string& at) {
        std::istringstream lines(run({"distance", "x^2+y^2+z^2-1", "--at", at}).output);
        std::string name;
        std::array<std::string, 4> values;
        for (std::string& value : values) lines >> name >> value;
        return values;
    };
    EXPECT_EQ(all_at("1e-320,0,0")[3], "-1");
    EXPECT_EQ(all_at("1e-320,0,0")[1], "1");
    for (const char* far : {"1e308,0,0", "1e400,-1,0"}) {
        const double bound = std::stod(all_at(far)[2]);
        EXPECT_GT(bound, 9.99e307) << far;
        EXPECT_TRUE(std::isfinite(bound)) << far;
    }
    EXPECT_EQ(all_at("1e308,0,0")[0], "5.0000000000000001e+307");
    EXPECT_EQ(all_at("1e400,0,0")[0], "inf"); // 5e399
    const std::string third = std::string(3000, '3') + "/" + std::string(3000, '9');
    EXPECT_EQ(all_at(third + ",0,0")[1],
              run({"distance", "x^2+y^2+z^2-1", "--at", "1/3,0,0", "--level", "second"})
                  .output.substr(13, all_at(third + ",0,0")[1].size()));
    for (const char* no_number : {"nan,0,0", "inf,0,0", "-inf,0,0"})
        expect_error_with(run({"distance", "x", "--at", no_number}), 2, "expected a number");
    expect_error_with(run({"distance", "x", "--at", "1e99999999,0,0"}), 2, "decimal exponent");
}

TEST(Distance, TellsTheSchemeOfEvaluation) {
    const ProcessResult result =
        run({"distance", "(x^2+2*y^2+3*z^2+x*y-1)^10", "--at", "1,1,1", "--level", "first", "--verbose"});
    EXPECT_NE(result.errors.find("scheme: structured, (5 terms)^10: "), std::string::npos) << result.errors;
    EXPECT_NE(result.errors.find("not horner, Horner in "), std::string::npos) << result.errors;
    EXPECT_EQ(result.status, 0);
}

TEST(Distance, SaysWhatIsWrong) {
    expect_error_with(run({"distance", "x/y", "--at", "1,2,3"}), 2, "divided by constants only, found 'y'");
    expect_error(run({"distance", "x"}), 2, "expected a point, as --at '1,2/3,0.5', found none");
    expect_error(run({"distance", "x*r", "--at", "1,2,3"}), 2,
                 "--set: expected a value for the constant 'r' of the surface, as --set r=2, found none");
    expect_error(run({"distance", "x*radius", "--at", "1,2,3", "--set", "radius=1", "--set", "radios=2"}), 2,
                 "--set: expected a constant of the surface, found 'radios'; did you mean 'radius'?");
    expect_error_with(run({"distance", "x", "--at", "1,2,a"}), 2, "--at:1:5: expected a number, found 'a'");
    expect_error_with(run({"distance", "z", "--at", "1,2"}), 2, "expected three coordinates");
    expect_error_with(run({"distance", "x", "--at", "1,2,3,4"}), 2, "expected three coordinates");
    expect_error_with(run({"distance", "x", "--at", "1,2,1/0"}), 2, "--at:1:");
    expect_error(run({"distance", "x", "--at", "1,2,3", "--set", "r"}), 2,
                 "--set: expected NAME=VALUE, as r=2, found 'r'");
    expect_error_with(run({"distance", "x", "--at", "1,2,3", "--format", "latex"}), 2, "text or json");
    expect_error_with(run({"distance", "x^2000", "--at", "1,2,3"}), 2, "expected a degree of at most 1000");
    expect_error_with(run({"distance", "x = t", "y = t^2", "z = t^3", "--at", "1,2,3"}), 2, "codimension 2");
}

} // namespace
} // namespace eliminant::test
