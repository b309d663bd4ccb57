// The resultant method against elimination on random shapes, and against the known equations.
#include "implicit/support.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace eliminant::implicit {
namespace {

namespace fs = std::filesystem;

/// Random formulas as text.
class Formulas {
  public:
    explicit Formulas(std::uint64_t seed) : random_(seed) {}

    int number(int bound) {
        return static_cast<int>(random_() % static_cast<unsigned>(2 * bound + 1)) - bound;
    }
    /// In s^i·t^j with i ≤ m, j ≤ n, i + j ≤ total, about `density` percent of them.
    std::string polynomial(int m, int n, int total, unsigned density = 100) {
        std::string text = std::to_string(number(5));
        for (int i = 0; i <= m; ++i) {
            for (int j = 0; j <= n && i + j <= total; ++j) {
                if (random_() % 100 >= density) continue;
                text +=
                    "+(" + std::to_string(number(5)) + ")*s^" + std::to_string(i) + "*t^" + std::to_string(j);
            }
        }
        return text;
    }
    std::string tensor(int m, int n, unsigned density = 100) { return polynomial(m, n, m + n, density); }
    std::mt19937_64& random() { return random_; }

  private:
    std::mt19937_64 random_;
};

ImplicitResult by(Method method, const std::string& text) {
    ImplicitizeOptions options;
    options.method = method;
    return implicitized(text, options);
}

/// Both methods say the same; whether resultants did it themselves.
bool agrees(const std::string& text) {
    const ImplicitResult result = by(Method::resultant, text);
    EXPECT_EQ(joined(result.equations), joined(by(Method::groebner, text).equations)) << text;
    EXPECT_EQ(result.assurance, Assurance::proved);
    return result.method == Method::resultant;
}

TEST(ResultantMethod, AgreesOnCurves) {
    for (std::uint64_t seed = 1; seed <= 60; ++seed) {
        Formulas formulas(seed);
        const int degree = 1 + static_cast<int>(seed % 5);
        const unsigned density = seed % 3 == 0 ? 50 : 100;
        const auto f = [&] { return formulas.tensor(0, degree, density); };
        const std::string bottom = seed % 2 == 0 ? "1" : "(t^2+(" + f() + "))";
        const std::string text = "parameters t, s\nx = (" + f() + ")/" + bottom + "\ny = (" + f() + ")/" +
                                 (seed % 4 == 1 ? bottom : "(7*t-2)");
        // Where f is a constant, the image may be a point.
        EXPECT_TRUE(agrees(text) || density < 100 || degree == 1) << text;
    }
}

TEST(ResultantMethod, ImproperParametrizationsGiveThePrimeEquation) {
    // Fibres of 2, 3, 4 points on curves; on surfaces the two points differ in s, in t, in both, or in
    // neither alone.
    for (const char* text : {
             "x = (t^2+t)^2\ny = (t^2+t)^3-1",
             "x = (t^3-2*t)/(t^3-2*t+1)\ny = (t^3-2*t)^2",
             "x = ((t^2+1)/(t-3))^2\ny = ((t^2+1)/(t-3))^3",
             "x = t^4\ny = t^8-t^4",
             "x = s^2*t\ny = s^4+t\nz = t^2-s^2",
             "x = (s^2+s)*t\ny = (s^2+s)^2+t\nz = t^2-1",
             "x = s*(t^2+t)\ny = s-(t^2+t)^2\nz = s^2",
             "x = s*t\ny = s+t\nz = s^2+t^2+s^3+t^3",
             "x = s^2\ny = s*t\nz = t^2+s^4",
             "x = s^2+s\ny = t^2+t\nz = (s^2+s)*(t^2+t)",
         })
        EXPECT_TRUE(agrees(text)) << text;
}

TEST(ResultantMethod, LeavesToOthersWhatItIsNotMadeFor) {
    for (const char* text : {
             "x = t\ny = t^2\nz = t^3",                   // no hypersurface
             "constants r\nx = r*cos(u)\ny = r*sin(u)+1", // symbols
             "x = s+t+u\ny = s*t\nz = t*u\nw = s*t*u+1",  // four coordinates
             "relation s^2+t^2 = 1\nx = s\ny = s*t",      // relations
             "x = s*u\ny = t\nz = s*u+t^2",               // more parameters than it takes
         })
        EXPECT_FALSE(agrees(text)) << text;
}

TEST(ResultantMethod, AgreesOnSurfaces) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        Formulas formulas(100 + seed);
        const bool triangular = seed % 2 == 0;
        const auto f = [&] {
            const unsigned density = seed % 3 == 0 ? 60 : 100;
            return "(" +
                   (triangular ? formulas.polynomial(2, 2, 2, density) : formulas.tensor(1, 2, density)) +
                   ")";
        };
        const std::string bottom = seed % 5 == 0 ? "/" + f() : std::string();
        const std::string text = "parameters s, t\nx = " + f() + bottom + "\ny = " + f() + bottom +
                                 "\nz = " + f() + (seed % 10 == 5 ? "/(s+2)" : bottom);
        agrees(text);
    }
}

TEST(ResultantMethod, AgreesOnSurfacesWithBasePoints) {
    // All forms vanish at points that are chosen: at (0,0) simply, at (0,0) doubly, at (0,0) and (1,1).
    const std::vector<std::vector<std::string>> ideals = {
        {"s", "t"}, {"s^2", "s*t", "t^2"}, {"s*(s-1)", "s-t"}};
    for (std::uint64_t seed = 1; seed <= 15; ++seed) {
        Formulas formulas(200 + seed);
        const auto& ideal = ideals[seed % ideals.size()];
        const auto form = [&] {
            std::string sum = "(0";
            for (const std::string& g : ideal)
                sum += "+(" + formulas.tensor(ideal.size() == 3 ? 0 : 1, 1) + ")*(" + g + ")";
            return sum + ")";
        };
        const std::string bottom = form();
        const std::string text = "parameters s, t\nx = " + form() + "/" + bottom + "\ny = " + form() + "/" +
                                 bottom + "\nz = " + form() + "/" + bottom;
        EXPECT_TRUE(agrees(text)) << text;
    }
}

TEST(ResultantMethod, AgreesWithCosinesAndSines) {
    for (const char* text : {
             "x = cos(u)+2\ny = sin(2u)",
             "x = cos(2u)\ny = sin(4u)+1",
             "x = cos(u)*(2+cos(v))\ny = sin(u)*(2+cos(v))\nz = sin(v)",
             "x = t*cos(u)\ny = t*sin(u)\nz = t^2+cos(2u)",
             "x = cos(u)*cos(v)\ny = sin(u)*cos(v)\nz = sin(v)*cos(u)",
         })
        EXPECT_TRUE(agrees(text)) << text;
}

TEST(ResultantMethod, TheResultDoesNotDependOnThreadsAndSeed) {
    const std::string text = "x = (s^2+t)/(s*t-2)\ny = (s-t^2)/(s*t-2)\nz = (s+t+1)/(s*t-2)";
    const Parametrization parametrization = parametrization_of(text);
    ImplicitizeOptions options;
    options.method = Method::resultant;
    std::set<std::string> answers;
    for (const unsigned threads : {1U, 2U, 5U}) {
        for (const std::uint64_t seed : {0U, 1U, 77U}) {
            RunOptions run_options;
            run_options.threads = threads;
            run_options.seed = seed;
            base::Run run(run_options);
            const ImplicitResult result = implicitize(parametrization, options, run);
            EXPECT_EQ(result.method, Method::resultant);
            answers.insert(joined(result.equations));
        }
    }
    EXPECT_EQ(answers.size(), 1U);
}

TEST(ResultantMethod, StopsWhenItIsToldTo) {
    base::Run run;
    run.request_stop();
    ImplicitizeOptions options;
    options.method = Method::resultant;
    EXPECT_THROW(implicitize(parametrization_of("x = t^2\ny = t^3-t"), options, run), Stopped);
}

std::string read_file(const fs::path& path) {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(ResultantMethod, FindsTheKnownEquations) {
    // With constants, a curve in space, and hypersurfaces in more dimensions; ES_2 has 6398 terms.
    const std::set<std::string> others = {"sphere_radius_r", "twisted_cubic", "L6", "ES_2"};
    std::size_t found = 0;
    for (const auto& entry : fs::directory_iterator(fs::path(ELIMINANT_DATA_DIR) / "implicit")) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() != ".expected" || others.contains(name)) continue;
        const ImplicitResult result =
            by(Method::resultant, read_file(fs::path(entry.path()).replace_extension(".par")));
        EXPECT_EQ(result.method, Method::resultant) << name;
        EXPECT_TRUE(joined(result.equations) + "\n" == read_file(entry.path())) << name;
        ++found;
    }
    EXPECT_GE(found, 40U);
}

} // namespace
} // namespace eliminant::implicit
