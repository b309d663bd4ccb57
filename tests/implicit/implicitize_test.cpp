// What implicitize() promises, case by case.
#include "implicit/direct_elimination.hpp"
#include "implicit/support.hpp"

#include <algorithm>

namespace eliminant::implicit {
namespace {

bool has_warning(const ImplicitResult& result, const std::string& part) {
    return std::ranges::any_of(
        result.warnings, [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

struct Example {
    std::string text;
    std::string equations;
    std::size_t codimension;
};

void check(const std::vector<Example>& examples) {
    for (const Example& example : examples) {
        const ImplicitResult result = implicitized(example.text);
        EXPECT_EQ(joined(result.equations), example.equations) << example.text;
        EXPECT_EQ(result.codimension, example.codimension) << example.text;
        EXPECT_EQ(result.assurance, Assurance::proved) << example.text;
        EXPECT_FALSE(result.proof.empty()) << example.text;
        EXPECT_EQ(result.equations.empty(), has_warning(result, "dense")) << example.text;
    }
}

TEST(Implicitize, AnswersDegenerateInput) {
    check({
        {"x = 5", "x-5", 1},
        {"x = -2/3", "3*x+2", 1},
        {"x = 0", "x", 1},
        {"x = t", "0", 0},
        {"x = t^2/(t+1)", "0", 0},
        {"x = 3\ny = 4\nz = 1/2", "2*z-1\ny-4\nx-3", 3},
        {"x = 3\ny = s\nz = t", "x-3", 1},
        {"x = 3\ny = t", "x-3", 1},
        {"x = 0\ny = t", "x", 1},
        {"x = 3\ny = t\nz = t^2", "x-3\ny^2-z", 2},
        {"x = t\ny = t", "x-y", 1},
        {"x = t\ny = t\nz = t^2", "x-y\ny^2-z", 2},
        {"x = 1/t\ny = 2/t", "2*x-y", 1},
        {"x = s\ny = s^2\nz = t", "x^2-y", 1},
        {"parameters s, t, u\nx = s\ny = s^2", "x^2-y", 1},
        {"x = s + t\ny = (s + t)^2", "x^2-y", 1},
        {"x = t^6\ny = t^4", "y^3-x^2", 1},
        {"x = t^2/t\ny = t*s/s", "x-y", 1},
        {"x = (t^2-1)/(t-1)\ny = t^2", "x^2-2*x-y+1", 1},
        {"x = s\ny = t\nz = s*t\nw = u", "x*y-z", 1},
        {"x = s\ny = t\nz = s*t\nw = 1/(s*t)", "z*w-1\nx*y-z", 2},
        {"x = t/2\ny = t^2/3", "4*x^2-3*y", 1},
        {"x = s/t\ny = t/s", "x*y-1", 1},
        {"x = s/t\ny = s^2/t^2\nz = s^3/t^3", "y^2-x*z\nx*y-z\nx^2-y", 2},
    });
}

TEST(Implicitize, FindsNoMultipleWhereHomogenisingASaturationWould) {
    // The first polynomial in the coordinates is then h³z(x² + y² − yh).
    check({{"x = s*t/(s^2+t^2)\ny = s^2/(s^2+t^2)\nz = s^3", "x^2+y^2-y", 1}});
}

TEST(Implicitize, TreatsConstantsAsElementsOfTheField) {
    check({
        {"constants r\nx = r\ny = t", "x-r", 1},
        {"constants a, b\nx = a\ny = b", "y-b\nx-a", 2},
        {"constants r\nx = t/r\ny = t^2", "x^2*r^2-y", 1},
        {"constants r\nx = t\ny = t^2 + r*t", "x^2+x*r-y", 1},
        {"constants r\nx = t/(t+r)\ny = 1/t", "x*y*r+x-1", 1},
        {"constants r\nx = t*(r+1)/(r^2-1)\ny = t", "x*r-x-y", 1},
        {"constants a, b\nx = a*cos(u)\ny = b*sin(u)", "x^2*b^2+y^2*a^2-a^2*b^2", 1},
        {"constants R, r\nx = (R+r*cos(u))*cos(v)\ny = (R+r*cos(u))*sin(v)\nz = r*sin(u)",
         "x^4+2*x^2*y^2+y^4+2*x^2*z^2+2*y^2*z^2+z^4-2*x^2*R^2-2*x^2*r^2-2*y^2*R^2-2*y^2*r^2+2*z^2*R^2-2*z^2*"
         "r^2+R^4"
         "-2*R^2*r^2+r^4",
         1},
        // Unused, and equal names in another sequence.
        {"constants q\nx = t\ny = t^2", "x^2-y", 1},
        // The leading coefficient in the coordinates is −r² + 1 up to sign: its leading integer is positive.
        {"constants r\nx = t\ny = (1-r^2)*t^2", "x^2*r^2-x^2+y", 1},
    });
    EXPECT_EQ(implicitized("constants b, a\nx = t").ring.names(), (std::vector<std::string>{"x", "b", "a"}));
}

TEST(Implicitize, ReducesTailsOverTheFieldOfConstants) {
    // Over ℚ(r) each basis is reduced: no term of one element is divisible, in the coordinates, by another's.
    check({
        {"constants r\nx = t\ny = r*t\nz = t^2 + r", "x*r-y\ny^2-z*r^2+r^3", 2},
    });
}

TEST(Implicitize, HandlesAnglesExactly) {
    check({
        {"x = cos(u)\ny = sin(u)", "x^2+y^2-1", 1},
        {"x = cos(u)", "0", 0},
        {"x = cos(u)\ny = cos(2u)", "2*x^2-y-1", 1},
        {"x = sin(u)\ny = sin(3*u)", "4*x^3-3*x+y", 1},
        {"x = cos(-u)\ny = sin(-u)", "x^2+y^2-1", 1},
        {"x = cos(2u)\ny = sin(2u)", "x^2+y^2-1", 1},
        {"x = cos(u)^2+sin(u)^2\ny = u", "x-1", 1},
        {"x = 1/cos(u)\ny = sin(u)/cos(u)", "x^2-y^2-1", 1},
        {"x = sin(u)/(1+cos(u))\ny = cos(u)", "x^2*y+x^2+y-1", 1},
        {"x = (2+cos(u))*cos(v)\ny = (2+cos(u))*sin(v)\nz = sin(u)",
         "x^4+2*x^2*y^2+y^4+2*x^2*z^2+2*y^2*z^2+z^4-10*x^2-10*y^2+6*z^2+9", 1},
        {"x = 2*cos(u)+2*cos(u)^2\ny = 2*sin(u)+2*sin(u)*cos(u)", // the cardioid of data/
         "x^4+2*x^2*y^2+y^4-4*x^3-4*x*y^2-4*y^2", 1},
        {"x = t*cos(u)\ny = t*sin(u)\nz = t", "x^2+y^2-z^2", 1},
        {"x = cos(u)\ny = sin(u)\nz = t", "x^2+y^2-1", 1},
    });
    const ImplicitResult helicoid = implicitized("x = s*cos(t)\ny = s*sin(t)\nz = t");
    EXPECT_TRUE(helicoid.equations.empty());
    EXPECT_TRUE(has_warning(helicoid, "independent"));
}

TEST(Implicitize, RespectsRelations) {
    check({
        {"x = s\ny = t\nrelation s^2+t^2 = 1", "x^2+y^2-1", 1},
        {"x = s^2\ny = t\nrelation s^2 = t^3", "y^3-x", 1},
        {"x = s/(t+2)\ny = 1/(t+2)\nrelation s^2 = t", "x^2+2*y^2-y", 1},
        {"x = s\ny = t\nrelation s*t = 0", "x*y", 1},               // reducible
        {"x = s\ny = t\nrelation s^2*t^3 = 0", "x*y", 1},           // not reduced
        {"x = s\ny = t\nz = 1/s\nrelation s*t = 0", "y\nx*z-1", 2}, // a component inside a denominator
        {"x = s\ny = t\nz = u\nrelation s*t = 0\nrelation s*u = 0", "x*z\nx*y", 1}, // of mixed dimension
        {"x = s\ny = t\nrelation s = s", "0", 0},                                   // no condition
        {"x = s\ny = s+1\nrelation t^2 = 3", "x-y+1", 1}, // of a parameter that does not occur
        {"x = s\nrelation s^2 = 2", "x^2-2", 1},          // points
        {"x = s\ny = t\nrelation s^2 = 2\nrelation t^2 = 2", "y^2-2\nx^2-2", 2},
        {"x = cos(u)\ny = t\nrelation t = sin(u)^2", "x^2+y-1", 1},
        {"constants r\nx = s\ny = t\nrelation s^2+t^2 = r^2", "x^2+y^2-r^2", 1},
        {"constants r\nx = s/(t+1)\ny = t\nrelation r*s = 0", "x", 1}, // r is not zero
        {"constants r\nx = s\ny = t\nrelation r*s = t\nrelation s^2 = r", "x*r-y\ny^2-r^3", 2},
    });
}

TEST(Implicitize, ReturnsTheRadicalOfAReducibleImage) {
    check({
        {"x = s\ny = t\nz = u\nrelation s^2 = 0\nrelation t^2 = 0", "y\nx", 2},
        {"x = s\ny = t\nz = u\nrelation s^2 = 0\nrelation s*t = 0", "x", 1},
        {"x = s\ny = t\nrelation (s^2+t^2-1)^2*s = 0\nrelation t*(s^2+t^2-1)^3 = 0",
         "x^2*y+y^3-y\nx^3+x*y^2-x", 1},
    });
}

TEST(Implicitize, SaysThatNothingIsLeftOfAnEmptyDomain) {
    for (const char* text :
         {"x = s\nrelation 1 = 0", "x = 1/s\nrelation s = 0", "constants r\nx = s\nrelation r = 0",
          "x = cos(u)\nrelation cos(u) = 2\nrelation cos(u) = 3"}) {
        const ImplicitResult result = implicitized(text);
        EXPECT_EQ(joined(result.equations), "1") << text;
        EXPECT_EQ(result.codimension, 2U) << text;
        EXPECT_TRUE(has_warning(result, "empty")) << text;
    }
}

TEST(Implicitize, HonoursTheOrderWhereThereAreSeveralEquations) {
    const std::string cubic = "x = t\ny = t^2\nz = t^3";
    ImplicitizeOptions options;
    EXPECT_EQ(equations_of(cubic, options), "y^2-x*z\nx*y-z\nx^2-y");
    options.order = MonomialOrder::lex();
    EXPECT_EQ(equations_of(cubic, options), "y^3-z^2\nx*z-y^2\nx*y-z\nx^2-y");
    options.order = MonomialOrder::elimination({2});
    EXPECT_EQ(equations_of(cubic, options), "x^2-y\nz-x*y");
    // A single equation is in degrevlex always.
    options.order = MonomialOrder::lex();
    EXPECT_EQ(equations_of("x = t^2\ny = t^3", options), "x^3-y^2");
    EXPECT_EQ(equations_of("x = t^3\ny = t^2", options), "y^3-x^2");
    EXPECT_EQ(equations_of("constants r\nx = t\ny = t^2\nz = r*t^3", options),
              "y^3*r^2-z^2\nx*z-y^2*r\nx*y*r-z\nx^2-y");
    options.order = MonomialOrder::weighted({1, 2}, MonomialOrder::TieBreak::lex);
    EXPECT_THROW(equations_of(cubic, options), DomainError);
}

TEST(Implicitize, NotesPointsThatAreNotReached) {
    EXPECT_EQ(implicitized("x = s*t\ny = s\nz = t^2").notes.size(), 1U);
    EXPECT_TRUE(implicitized("x = s\ny = t\nz = s^3-3*s*t^2").notes.empty());
    EXPECT_TRUE(implicitized("x = 2*s\ny = s^2").notes.empty());
    EXPECT_EQ(implicitized("x = 1/s\ny = s").notes.size(), 1U);
}

TEST(Implicitize, AnswersTheSameForEverySeed) {
    const Parametrization p = parametrization_of("x = (s^2-t)/(s+1)\ny = s*t\nz = (t^2+1)/(s+1)");
    std::string first;
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        RunOptions options;
        options.seed = seed;
        base::Run run(std::move(options));
        const std::string equations = joined(implicitize(p, {}, run).equations);
        if (seed == 0) first = equations;
        EXPECT_EQ(equations, first);
    }
}

TEST(Implicitize, AnswersTheSameForEveryNumberOfThreads) {
    const Parametrization p =
        parametrization_of("x = 641*t^6-205*t^5+422*t^4+973\ny = -928*t^6+168*t^3+313*t-711");
    std::string first;
    for (const unsigned threads : {1U, 2U, 3U, 8U}) {
        RunOptions options;
        options.threads = threads;
        base::Run run(std::move(options));
        const ImplicitResult result = implicitize(p, {}, run);
        EXPECT_GT(result.statistics.primes_used, 3U);
        if (threads == 1) first = joined(result.equations);
        EXPECT_EQ(joined(result.equations), first);
    }
}

TEST(Implicitize, StopsAllItsThreads) {
    const Parametrization p = parametrization_of("x = s^3*t-t^2+1\ny = s*t^3-2*s\nz = s^2*t^2-s+5*t");
    base::Run* current = nullptr;
    RunOptions options;
    options.threads = 3;
    options.progress_interval = std::chrono::milliseconds(0);
    int reports = 0;
    options.progress = [&](const Progress&) {
        if (++reports == 200) current->request_stop();
    };
    base::Run run(std::move(options));
    current = &run;
    EXPECT_THROW(implicitize(p, {.method = Method::groebner}, run), Stopped);
}

TEST(Implicitize, StopsWhereverItIsAskedTo) {
    // Progress is reported from inside; the n-th report asks for the stop.
    const Parametrization surface = parametrization_of("x = s^3*t-t^2+1\ny = s*t^3-2*s\nz = s^2*t^2-s+5*t");
    const Parametrization curve = parametrization_of("constants r\nx = t^5-r*t\ny = t^4+t\nz = t^3/(t+r)");
    const Parametrization domain =
        parametrization_of("x = s^3-t\ny = (t^2+u)/(s+1)\nz = u^3\nrelation s^3+t^3+u^3 = s*t+1");
    for (const Parametrization* p : {&surface, &curve, &domain}) {
        std::size_t stops = 0;
        for (int n = 1; n < 1000; n *= 2) {
            base::Run* current = nullptr;
            int reports = 0;
            RunOptions options;
            options.progress_interval = std::chrono::milliseconds(0);
            options.progress = [&](const Progress&) {
                if (++reports == n) current->request_stop();
            };
            base::Run run(std::move(options));
            current = &run;
            try {
                implicitize(*p, {}, run);
                EXPECT_LT(reports, n) << "the stop was not noticed";
            } catch (const Stopped& stopped) {
                EXPECT_EQ(stopped.reason(), StopReason::interrupted);
                ++stops;
            }
        }
        EXPECT_GE(stops, 3U);
    }
}

TEST(Implicitize, StopsBeforeItBegins) {
    base::Run run;
    run.request_stop();
    EXPECT_THROW(implicitize(parametrization_of("x = s*t\ny = s\nz = t^2"), {}, run), Stopped);
}

TEST(Implicitize, RejectsDegreesThatCannotBeGraded) {
    base::Run run;
    EXPECT_THROW(implicitize(parametrization_of("x = t^99999999999+t\ny = t"), {}, run), DomainError);
    EXPECT_EQ(implicitize(parametrization_of("x = t^99999999999\ny = t"), {}, run).method, Method::toric);
}

TEST(Implicitize, CountsThePreimagesOfAGeneralPoint) {
    const auto degree_of = [](const std::string& text) {
        return implicitized(text, {.parametrization_degree = true}).parametrization_degree;
    };
    EXPECT_EQ(degree_of("x = t^2\ny = t^3"), 1U);
    EXPECT_EQ(degree_of("x = t^2\ny = t^4+t^2"), 2U);
    EXPECT_EQ(degree_of("x = t^6/(t^6+1)\ny = 1/(t^6+2)"), 6U);
    EXPECT_EQ(degree_of("x = t+1/t\ny = t^2+1/t^2"), 2U);
    EXPECT_EQ(degree_of("x = t^5"), 5U); // a dense image
    EXPECT_EQ(degree_of("x = s^2\ny = t^3"), 6U);
    EXPECT_EQ(degree_of("x = s^2\ny = s*t\nz = t^2"), 2U);
    EXPECT_EQ(degree_of("x = s*t\ny = s+t\nz = s^2+t^2"), 2U);
    EXPECT_EQ(degree_of("x = 3*s+3*s*t^2-s^3\ny = 3*t+3*s^2*t-t^3\nz = 3*s^2-3*t^2"), 1U);
    EXPECT_EQ(degree_of("x = t\ny = t^2\nz = t^3"), 1U);
    EXPECT_EQ(degree_of("x = cos(u)^2\ny = cos(u)*sin(u)"), 2U);
    EXPECT_EQ(degree_of("constants r\nx = r*cos(u)\ny = r*sin(u)"), 1U);
    EXPECT_EQ(degree_of("constants r\nx = r*t^4\ny = t^2+r"), 2U);
    EXPECT_EQ(degree_of("x = s/(t^2+1)\ny = s^2/(t^2+1)\nz = t^2"), 2U);
    EXPECT_EQ(degree_of("x = (s+t)^2\ny = (s+t)^3"), std::nullopt);                   // infinitely many
    EXPECT_EQ(degree_of("parameters s, t\nx = s\ny = s^2"), std::nullopt);            // infinitely many
    EXPECT_EQ(degree_of("x = 5"), std::nullopt);                                      // no parameter
    EXPECT_EQ(degree_of("x = s\ny = t\nrelation s^2 = t"), std::nullopt);             // not computed
    EXPECT_EQ(implicitized("x = t^2\ny = t^3").parametrization_degree, std::nullopt); // not asked for
}

TEST(Implicitize, ProbableIsSaidWhereNothingWasProved) {
    ImplicitizeOptions options;
    options.assurance = Assurance::probable;
    const ImplicitResult curve = implicitized("x = t^2-1\ny = t^3-t", options);
    EXPECT_EQ(joined(curve.equations), "x^3+x^2-y^2");
    EXPECT_EQ(curve.assurance, Assurance::probable);
    EXPECT_NE(curve.proof.find("no theorem"), std::string::npos);
    EXPECT_FALSE(curve.claims);
    EXPECT_EQ(implicitized("x = t\ny = t^2\nz = t^3", options).assurance, Assurance::proved);
    EXPECT_TRUE(implicitized("x = t^2-1\ny = t^3-t").claims);
}

TEST(Implicitize, NamesItsMethodsAndAssurances) {
    EXPECT_EQ(to_string(Method::automatic), "auto");
    EXPECT_EQ(to_string(Method::groebner), "groebner");
    EXPECT_EQ(to_string(Method::linear), "linear");
    EXPECT_EQ(to_string(Method::toric), "toric");
    EXPECT_EQ(to_string(Assurance::proved), "proved");
    EXPECT_EQ(to_string(Assurance::probable), "probable");
    for (const Method method : {Method::groebner, Method::linear})
        EXPECT_EQ(implicitized("x = t\ny = t^2", {.method = method}).method, method);
    EXPECT_NE(implicitized("x = t\ny = t^2").method, Method::automatic);
    // Of a curve in space.
    EXPECT_EQ(implicitized("x = t\ny = t^2\nz = t^3", {.method = Method::linear}).method, Method::groebner);
}

} // namespace
} // namespace eliminant::implicit
