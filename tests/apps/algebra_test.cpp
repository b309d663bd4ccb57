// The commands on polynomial systems: groebner, divide, eliminate, ideal.
#include "program.hpp"

#include <nlohmann/json.hpp>

namespace eliminant::test {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> keys(const Json& object) {
    std::vector<std::string> result;
    for (const auto& [key, value] : object.items()) result.push_back(key);
    return result;
}

Json json_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--format", "json"});
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.errors, "");
    return Json::parse(result.output);
}

TEST(Groebner, PrintsTheReducedBasisAscending) {
    // Cox, Little, O'Shea, Ideals, Varieties, and Algorithms, §2.7, example 1 (deglex) and its lex basis.
    expect_output(run({"groebner", "--order", "deglex", "x^3 - 2*x*y", "x^2*y - 2*y^2 + x"}),
                  "2*y^2-x\nx*y\nx^2\n");
    expect_output(run({"groebner", "--order", "lex", "x^3 - 2*x*y", "x^2*y - 2*y^2 + x"}), "y^3\nx-2*y^2\n");
}

TEST(Groebner, TakesEveryOrder) {
    const std::vector<std::string> twisted_cubic{"t^2 - y", "t^3 - z", "t - x"};
    const auto basis = [&](const std::string& order) {
        std::vector<std::string> arguments{"groebner", "--variables", "t,x,y,z", "--order", order};
        arguments.insert(arguments.end(), twisted_cubic.begin(), twisted_cubic.end());
        return run(arguments).output;
    };
    EXPECT_EQ(basis("elim(t)"), "y^2-x*z\nx*y-z\nx^2-y\nt-x\n");
    EXPECT_EQ(basis("matrix(1,0,0,0;0,1,1,1;0,0,0,-1;0,0,-1,0)"), basis("elim(t)"));
    EXPECT_EQ(basis("lex"), basis("matrix(1,0,0,0;0,1,0,0;0,0,1,0;0,0,0,1)"));
    EXPECT_EQ(basis("degrevlex"), basis("weight(1,1,1,1;revlex)"));
    EXPECT_EQ(basis("deglex"), basis("weight(1,1,1,1;lex)"));
    expect_error_with(run({"groebner", "--order", "matrix(1,1;1,1)", "x", "y"}), 2, "--order:1:");
    expect_error_with(run({"groebner", "--order", "weight(1,1)", "x"}), 2, "--order:1:");
    expect_error_with(run({"groebner", "--order", "elim(z)", "x"}), 2, "--order:1:6: ");
}

TEST(Groebner, IsMonicOverAPrimeField) {
    expect_output(run({"groebner", "--field", "GF(7)", "3*x^2 - 2", "y/2 - 1"}), "y+5\nx^2+4\n");
    expect_output(run({"groebner", "--field", "GF(2147483647)", "2*x + 1"}), "x+1073741824\n");
    expect_output(run_with_input({"groebner"}, "variables x\nfield GF(5)\n6*x + 7\n"), "x+2\n");
}

TEST(Groebner, AlgorithmsAgree) {
    std::string basis;
    for (const std::string algorithm : {"auto", "buchberger", "f4"}) {
        const ProcessResult result =
            run({"groebner", "--field", "GF(32003)", "--algorithm", algorithm, "a+b+c+d", "a*b+b*c+c*d+d*a",
                 "a*b*c+b*c*d+c*d*a+d*a*b", "a*b*c*d-1"});
        if (basis.empty()) basis = result.output;
        expect_output(result, basis);
    }
    EXPECT_NE(basis, "");
    EXPECT_EQ(json_of({"groebner", "--field", "GF(7)", "--algorithm", "f4", "x"})["algorithm"], "f4");
}

TEST(Groebner, TrivialIdeals) {
    expect_output(run({"groebner", "x", "x - 1"}), "1\n");
    expect_output(run({"groebner", "--variables", "x", "0"}), "0\n");
}

TEST(Groebner, JsonHasTheDocumentedFields) {
    const Json result =
        json_of({"groebner", "--order", "weight(2,1;lex)", "x^2 - 12345678901234567890*y", "x*y - 1"});
    EXPECT_EQ(keys(result), (std::vector<std::string>{"variables", "field", "order", "basis", "algorithm",
                                                      "assurance", "statistics"}));
    EXPECT_EQ(result["variables"], Json({"x", "y"}));
    EXPECT_EQ(result["field"], "QQ");
    EXPECT_EQ(result["order"], "weight(2,1;lex)");
    EXPECT_EQ(result["algorithm"], "f4");
    EXPECT_EQ(result["assurance"], "proved");
    for (const Json& polynomial : result["basis"]) EXPECT_TRUE(polynomial.is_string());
    const Json& statistics = result["statistics"];
    for (const char* counter :
         {"pairs_treated", "skipped_by_product", "skipped_by_chain_m", "skipped_by_chain_f",
          "skipped_by_chain_b", "zero_reductions", "primes_used", "peak_memory"})
        EXPECT_TRUE(statistics.at(counter).is_number_integer()) << counter;
    EXPECT_TRUE(statistics.at("seconds").is_number());
    EXPECT_EQ(json_of({"groebner", "--field", "GF(7)", "x"})["field"], "GF(7)");
}

TEST(Groebner, TextIsReadBackByTheProgram) {
    for (const std::string order : {"lex", "degrevlex", "elim(b)"}) {
        const std::vector<std::string> options{"groebner", "--variables", "a,b,c", "--order", order};
        std::vector<std::string> first = options;
        first.insert(first.end(), {"a+b+c", "a*b+b*c+c*a", "a*b*c-3/7"});
        std::vector<std::string> second = options;
        second.emplace_back("-");
        const std::string basis = run(first).output;
        EXPECT_NE(basis, "");
        expect_output(run_with_input(second, basis), basis);
    }
}

TEST(Groebner, ReadsOtherSystemsFiles) {
    const std::string msolve = "x, y\n0\nx^2 + y^2 - 1,\nx - y\n";
    const std::string singular = "ring r = 0,(x,y),dp;\nideal I = x2+y2-1, x-y;\n";
    const std::string basis = "x-y\n2*y^2-1\n";
    expect_output(run_with_input({"groebner"}, msolve), basis);
    expect_output(run_with_input({"groebner", "--input-format", "msolve"}, msolve), basis);
    expect_output(run_with_input({"groebner"}, singular), basis);
    expect_output(run_with_input({"groebner", "--input-format", "singular"}, singular), basis);
    EXPECT_EQ(run_with_input({"groebner", "--input-format", "singular"}, msolve).status, 2);
}

TEST(Groebner, RepeatedOrUnknownNamesAreErrors) {
    expect_error_with(run_with_input({"groebner"}, "variables x, x\nx\n"), 2, "-:1:14: ");
    expect_error_with(run_with_input({"groebner"}, "variables x\nx + y\n"), 2, "-:2:5: ");
    expect_error_with(run({"groebner", "--variables", "x", "y"}), 2, "argument:1:1: ");
}

TEST(Divide, PrintsQuotientsAndRemainder) {
    // Cox, Little, O'Shea, §2.3, example 4.
    expect_output(run({"divide", "x^2*y + x*y^2 + y^2", "by", "x*y - 1", "y^2 - 1", "--order", "lex"}),
                  "q1 = x+y\nq2 = 1\nr = x+y+1\n");
    expect_output(run_with_input({"divide", "x^3", "by", "-"}, "x - 2\n"), "q1 = x^2+2*x+4\nr = 8\n");
    const Json result = json_of({"divide", "x^2", "by", "x - 1/2"});
    EXPECT_EQ(keys(result),
              (std::vector<std::string>{"variables", "field", "order", "quotients", "remainder"}));
    EXPECT_EQ(result["quotients"], Json({"x+1/2"}));
    EXPECT_EQ(result["remainder"], "1/4");
    expect_error(run({"divide", "x", "by", "y", "x-x"}), 2,
                 "expected divisors that are not zero, found divisor 2 to be 0");
    expect_error(run({"divide", "x, y", "by", "x"}), 2, "expected one polynomial before 'by', found 2");
}

TEST(Eliminate, PrintsTheEliminationIdeal) {
    expect_output(run({"eliminate", "t", "x = t^2", "y = t^3"}), "x^3-y^2\n");
    expect_output(run({"eliminate", "t, x", "x = t^2", "y = t^3"}), "0\n");
    expect_output(run({"eliminate", "t", "t*x - 1", "x"}), "1\n");
    EXPECT_EQ(json_of({"eliminate", "t", "x = t^2", "y = t^3"})["variables"], Json({"x", "y"}));
    expect_error(run({"eliminate", "u", "x = t^2"}), 2,
                 "argument 1: expected variables of the system (x or t), found 'u'");
}

TEST(IdealCommand, Operations) {
    expect_output(run({"ideal", "sum", "x^2", "y", "x-y"}), "y\nx\n");
    expect_output(run({"ideal", "product", "x, y", "x"}), "x*y\nx^2\n");
    expect_output(run({"ideal", "intersect", "x", "y"}), "x*y\n");
    expect_output(run({"ideal", "quotient", "x^2*y", "x"}), "x*y\n");
    expect_output(run({"ideal", "saturate", "x^2*y", "x"}), "y\n");
    expect_output(run({"ideal", "dimension", "x*y, x*z"}), "2\n");
    expect_output(run({"ideal", "dimension", "1"}), "-1\n");
    EXPECT_EQ(json_of({"ideal", "dimension", "x*y"}), Json({{"dimension", 1}}));
}

TEST(IdealCommand, HilbertSeriesPolynomialDimensionAndDegree) {
    // The twisted cubic: 3d + 1, as a cone in four variables and as an affine curve.
    const std::vector<std::string> cone{"ideal", "hilbert", "x*z-y^2, x*w-y*z, y*w-z^2"};
    expect_output(run(cone),
                  "graded_series = (2*t+1)/(1-t)^2\ngraded_polynomial = 3*d+1\nregularity_index = 0\n"
                  "dimension = 2\ndegree = 3\n");
    expect_output(run({"ideal", "hilbert", "y-x^2, z-x^3"}),
                  "affine_series = (2*t+1)/(1-t)^2\naffine_polynomial = 3*d+1\nregularity_index = 0\n"
                  "dimension = 1\ndegree = 3\n");
    const Json result = json_of(cone);
    EXPECT_EQ(keys(result),
              (std::vector<std::string>{"series", "numerator", "denominator_exponent", "polynomial",
                                        "regularity_index", "dimension", "degree"}));
    EXPECT_EQ(result["degree"], 3);
}

TEST(IdealCommand, PredicatesAnswerWithTheExitStatus) {
    const auto expect_answer = [](const std::vector<std::string>& arguments, bool answer) {
        const ProcessResult result = run(arguments);
        EXPECT_EQ(result.output, answer ? "true\n" : "false\n");
        EXPECT_EQ(result.errors, "");
        EXPECT_EQ(result.status, answer ? 0 : 1);
    };
    expect_answer({"ideal", "contains", "x, y", "x*y, x+y"}, true);
    expect_answer({"ideal", "contains", "x*y", "x"}, false);
    expect_answer({"ideal", "equal", "x+y, x-y", "x, y"}, true);
    expect_answer({"ideal", "equal", "x^2", "x"}, false);
    expect_answer({"ideal", "radical-contains", "x^2", "x"}, true);
    expect_answer({"ideal", "radical-contains", "x^2", "x, y"}, false);
    EXPECT_EQ(json_of({"ideal", "contains", "x", "x^2"}), Json({{"contains", true}}));
}

TEST(IdealCommand, JoinsTheVariablesOfItsSystems) {
    const ScratchDirectory scratch;
    scratch.write("a.sys", "variables x, y\nx*y\n");
    scratch.write("b.sys", "variables y, z\ny*z\n");
    expect_output(run({"ideal", "sum", "a.sys", "b.sys"}, {.directory = scratch.path()}), "y*z\nx*y\n");
    scratch.write("c.sys", "variables x\nfield GF(7)\nx\n");
    expect_error(run({"ideal", "sum", "a.sys", "c.sys"}, {.directory = scratch.path()}), 2,
                 "expected systems over one field, found QQ and GF(7)");
}

} // namespace
} // namespace eliminant::test
