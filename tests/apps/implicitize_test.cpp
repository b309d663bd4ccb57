// `eliminant implicitize`: known answers, its formats, and what it says.
#include "program.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>
#include <sstream>

namespace eliminant::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

const std::vector<std::string> circle{"implicitize", "x = (1-t^2)/(1+t^2)", "y = 2t/(1+t^2)"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
}

std::string read_file(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Every case of data/implicit with a known answer, except those that take over a second.
std::vector<std::string> easy_cases() {
    const std::set<std::string> hard{"ES_0",
                                     "ES_1",
                                     "ES_2",
                                     "L6",
                                     "lichtblau97",
                                     "teapot_spout",
                                     "rational12_curve",
                                     "dense10_curve",
                                     "dense40_curve",
                                     "bicubic_random",
                                     "bicubic_hoffmann"};
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(ELIMINANT_DATA_DIR) / "implicit")) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() == ".expected" && hard.count(name) == 0) names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

class EasyCase : public ::testing::TestWithParam<std::string> {};

TEST_P(EasyCase, IsRight) {
    const fs::path stem = fs::path(ELIMINANT_DATA_DIR) / "implicit" / GetParam();
    const ProcessResult result = run({"implicitize", stem.string() + ".par"});
    EXPECT_EQ(result.output, read_file(stem.string() + ".expected"));
    EXPECT_EQ(result.status, 0);
}

INSTANTIATE_TEST_SUITE_P(Data, EasyCase, ::testing::ValuesIn(easy_cases()),
                         [](const auto& instance) { return instance.param; });

TEST(Implicitize, ReadsFilesStandardInputAndArguments) {
    const ScratchDirectory scratch;
    const std::string text = "# the circle\nparameters t\nx = (1-t^2)/(1+t^2)\ny = 2*t/(1+t^2)\n";
    expect_output(run({"implicitize", scratch.write("circle.par", text)}), "x^2+y^2-1\n");
    expect_output(run_with_input({"implicitize", "-"}, text), "x^2+y^2-1\n");
    expect_output(run_with_input({"implicitize"}, text), "x^2+y^2-1\n");
    expect_output(run(circle), "x^2+y^2-1\n");
    expect_output(run({"implicitize", "x = cos(u)", "y = sin(u)"}), "x^2+y^2-1\n");
    expect_output(run({"implicitize", "constants r", "x = r*cos(u)", "y = r*sin(u)"}), "x^2+y^2-r^2\n");
    expect_output(run({"implicitize", "relation u^2 + v^2 = 1", "x = u", "y = v"}), "x^2+y^2-1\n");
}

TEST(Implicitize, HigherCodimensionIsAReducedBasisAndADenseImageIsZero) {
    const std::vector<std::string> cubic{"implicitize", "x = t", "y = t^2", "z = t^3"};
    expect_output(run(cubic), "y^2-x*z\nx*y-z\nx^2-y\n");
    expect_output(run(with(cubic, {"--order", "lex"})), "y^3-z^2\nx*z-y^2\nx*y-z\nx^2-y\n");
    EXPECT_EQ(run({"implicitize", "x = s", "y = t"}).output, "0\n");
    expect_error_with(run(with(cubic, {"--order", "elim(t)"})), 2, "--order:1:6: ");
}

TEST(Implicitize, AHelicoidIsDenseWithAWarning) {
    const ProcessResult result = run({"implicitize", "x = u*cos(v)", "y = u*sin(v)", "z = v"});
    EXPECT_EQ(result.output, "0\n");
    EXPECT_EQ(result.errors.rfind("eliminant: warning: ", 0), 0U) << result.errors;
    EXPECT_EQ(result.status, 0);
}

TEST(Implicitize, JsonHasTheDocumentedFields) {
    const auto report_of = [](std::vector<std::string> arguments) {
        return Json::parse(run(with(std::move(arguments), {"--format", "json"})).output);
    };
    const Json hypersurface = report_of(circle);
    std::vector<std::string> keys;
    for (const auto& [key, value] : hypersurface.items()) keys.push_back(key);
    EXPECT_EQ(keys, (std::vector<std::string>{"variables", "equations", "codimension", "degree", "terms",
                                              "max_coefficient_digits", "method", "assurance",
                                              "parametrization_degree", "seconds"}));
    EXPECT_EQ(hypersurface["variables"], Json({"x", "y"}));
    EXPECT_EQ(hypersurface["equations"], Json::array({"x^2+y^2-1"}));
    EXPECT_EQ(hypersurface["codimension"], 1);
    EXPECT_EQ(hypersurface["degree"], 2);
    EXPECT_EQ(hypersurface["terms"], 3);
    EXPECT_EQ(hypersurface["max_coefficient_digits"], 1);
    EXPECT_TRUE(hypersurface["method"].is_string());
    EXPECT_EQ(hypersurface["assurance"], "proved");
    const Json& degree = hypersurface["parametrization_degree"];
    EXPECT_TRUE(degree.is_null() || degree == 1);
    EXPECT_TRUE(hypersurface["seconds"].is_number());

    const Json cubic = report_of({"implicitize", "x = t", "y = t^2", "z = 1000*t^3"});
    EXPECT_EQ(cubic["codimension"], 2);
    EXPECT_EQ(cubic["degree"], Json({2, 2, 2}));
    EXPECT_EQ(cubic["terms"], Json({2, 2, 2}));
    EXPECT_EQ(cubic["max_coefficient_digits"], 4);

    const Json dense = report_of({"implicitize", "x = s", "y = t"});
    EXPECT_EQ(dense["equations"], Json::array());
    EXPECT_EQ(dense["codimension"], 0);
    EXPECT_EQ(dense["degree"], Json::array());

    const Json constants = report_of({"implicitize", "constants r", "x = r^5*cos(u)", "y = r^5*sin(u)"});
    EXPECT_EQ(constants["variables"], Json({"x", "y", "r"}));
    EXPECT_EQ(constants["degree"], 2); // in the coordinates
}

TEST(Implicitize, TextIsReadBackByTheProgram) {
    const std::string equation = run(circle).output;
    expect_output(run_with_input({"groebner"}, equation), equation);
    const std::string ideal = run({"implicitize", "x = t", "y = t^2", "z = t^3"}).output;
    expect_output(run_with_input({"groebner", "--variables", "x,y,z"}, ideal), ideal);
}

TEST(Implicitize, ErrorsNameThePlace) {
    const auto expect_at = [](const std::string& text, const std::string& place) {
        expect_error_with(run_with_input({"implicitize", "-"}, text), 2, "eliminant: -:" + place + ": ");
    };
    expect_at("x = t +\ny = t\n", "1:8");
    expect_at("x = 1/(t - t)\n", "1:7");
    expect_at("x = tan(t)\n", "1:8");
    expect_at("x = cos(t^2)\n", "1:5");
    expect_at("x = t\nx = t^2\n", "2:1");
    expect_at("parameters t, t\nx = t\n", "1:15");
    expect_at("parameters t\nx = t + s\n", "2:9");
    expect_at("nonsense\n", "1:9");
}

TEST(Implicitize, EveryMethodAgrees) {
    for (const std::string method : {"auto", "groebner", "linear", "resultant"})
        expect_output(run(with(circle, {"--method", method})), "x^2+y^2-1\n");
    expect_output(run(with(circle, {"--assurance", "probable"})), "x^2+y^2-1\n");
    expect_error_with(run(with(circle, {"--method", "grobner"})), 2, "did you mean 'groebner'?");
}

TEST(Implicitize, ReadsControlNets) {
    expect_output(run_with_input({"implicitize"}, "rational bezier 2\n1 0 1\n1 1 1\n0 1 2\n"), "x^2+y^2-1\n");
    expect_output(run({"implicitize", "bezier 1 1\n0 0 0\n1 0 0\n0 1 0\n1 1 1\n"}), "x*y-z\n");
    expect_error(run_with_input({"implicitize"}, "bezier 1\n0 0\n"), 2,
                 "-:3:1: expected 2 control points, found 1");
}

TEST(Implicitize, ABatchIsPrintedShapeByShape) {
    const std::string good = "patch line\nbezier 1\n0 0\n1 1\npatch cubic\nx = t\ny = t^3\n";
    expect_output(run_with_input({"implicitize"}, good), "# line\nx-y\n# cubic\nx^3-y\n");
    expect_output(run_with_input({"implicitize", "--format", "latex"}, "patch a b\nx = t\ny = t^2\n"),
                  "% a b\n\\[ x^{2}-y \\]\n");
    const ScratchDirectory scratch;
    EXPECT_EQ(run_with_input({"implicitize", "-o", scratch.path("out")}, good).status, 0);
    EXPECT_EQ(scratch.read("out"), "# line\nx-y\n# cubic\nx^3-y\n");

    const ProcessResult result =
        run_with_input({"implicitize", "--format", "json"}, "patch bad\nx = u +\n" + good);
    EXPECT_EQ(result.status, 2);
    EXPECT_EQ(result.errors.rfind("eliminant: -:2:8: ", 0), 0U) << result.errors;
    std::istringstream lines(result.output);
    std::string line;
    std::vector<Json> reports;
    while (std::getline(lines, line)) reports.push_back(Json::parse(line));
    ASSERT_EQ(reports.size(), 3U);
    EXPECT_EQ(reports[0].at("name"), "bad");
    EXPECT_EQ(reports[0].at("error"), "-:2:8: expected a number, a name or a parenthesis, found end of line");
    EXPECT_EQ(reports[1].at("name"), "line");
    EXPECT_EQ(reports[2].at("equations"), Json::array({"x^3-y"}));
    EXPECT_EQ(reports[2].at("degree"), 3);
}

TEST(Implicitize, ReadsTheTeapot) {
    const fs::path teapot = fs::path(ELIMINANT_DATA_DIR) / "teapot" / "teapot.net";
    const ProcessResult result = run({"implicitize", teapot.string()});
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.errors, "");
    EXPECT_EQ(std::count(result.output.begin(), result.output.end(), '\n'), 64);
    EXPECT_EQ(result.output.rfind("# rim_1\n", 0), 0U);
}

TEST(Implicitize, TheVerboseAreToldTheProof) {
    const ProcessResult result = run(with(circle, {"-v"}));
    EXPECT_EQ(result.output, "x^2+y^2-1\n");
    for (const char* part : {"method: linear", "predicted: linear ", "assurance: proved: ", "seconds: "})
        EXPECT_NE(result.errors.find(part), std::string::npos) << part;
}

} // namespace
} // namespace eliminant::test
