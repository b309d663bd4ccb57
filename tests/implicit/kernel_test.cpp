// The parts of the computation on their own: bounds, primes, reconstruction.
#include "implicit/kernel.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "implicit/remaindering.hpp"
#include "implicit/support.hpp"

namespace eliminant::implicit {
namespace {

struct Graph {
    Parametrization parametrization;
    ProjectiveMap map;
    GradedMap graded;

    explicit Graph(const std::string& text)
        : parametrization(parametrization_of(text)), map(forms_of(parametrization)),
          graded(graded_map(parametrization, map, {})) {}

    static ProjectiveMap forms_of(const Parametrization& parametrization) {
        base::Run run;
        return over_common_denominator(parametrization, run);
    }
};

const std::vector<std::string> sample = {
    "x = t^2\ny = t^3-t",
    "x = (t^2+1)/(t-2)\ny = t/(t+1)",
    "x = s*t-1\ny = s+7/3*t\nz = t^2",
    "x = s/t\ny = t/(s+1)\nz = (s-t)/(s+t)",
    "x = t\ny = t^2+t\nz = t^3-5",
    "x = 1/t\ny = 1/(t+1)\nz = 1/(t^2+1)",
    "constants r\nx = r*t^2-1\ny = t^3+r^2",
    "constants r\nx = t/(t^2+r)\ny = (r*t-1)/t\nz = t",
    "x = cos(u)+2\ny = sin(2u)\nz = cos(3u)",
    "x = cos(u)/(2+sin(u))\ny = sin(u)",
};

TEST(GradedMap, HasHomogeneousGenerators) {
    for (const std::string& text : sample) {
        const Graph graph(text);
        for (const Polynomial& f : graph.graded.generators) {
            std::int64_t degree = -1;
            for (std::size_t i = 0; i < f.size(); ++i) {
                std::int64_t sum = 0;
                for (std::size_t j = 0; j < graph.graded.weights.size(); ++j)
                    sum += static_cast<std::int64_t>(f.exponent(i, j) * graph.graded.weights[j]);
                if (i == 0) degree = sum;
                EXPECT_EQ(sum, degree) << text;
            }
        }
    }
}

TEST(Kernel, IsTheSameByPrimesAndOverTheRationals) {
    base::Run run;
    for (const std::string& text : sample) {
        const Graph graph(text);
        const Kernel by_primes = kernel_by_primes(graph.graded, Codimension::unknown, run);
        EXPECT_EQ(joined(by_primes.generators), joined(kernel_over_rationals(graph.graded, run).generators))
            << text;
        EXPECT_GE(by_primes.primes_used, 1U);
        if (by_primes.generators.size() != 1) continue;
        // The same without a limit on the codimension as with the early end.
        const Kernel early = kernel_by_primes(graph.graded, Codimension::one_at_most, run);
        EXPECT_EQ(joined(by_primes.generators), joined(early.generators)) << text;
    }
}

TEST(Kernel, SurvivesPrimesModuloWhichTheImageIsSmaller) {
    // The first prime tried is 2147483647, modulo which y = x².
    const std::string text = "x = t^2+2147483647*t\ny = t^4";
    const ImplicitResult result = implicitized(text, {.method = Method::groebner});
    ASSERT_EQ(result.equations.size(), 1U);
    EXPECT_EQ(result.equations[0].total_degree(), 4);
    EXPECT_GE(result.statistics.primes_used, 3U);
    std::mt19937_64 random(1);
    EXPECT_TRUE(vanishes_on_image(result.equations[0], parametrization_of(text), random));
    // And one modulo which it is a point, the rank of the differential there being no help.
    EXPECT_EQ(equations_of("x = 2147483647*t\ny = 2147483647*t^2+2147483647"),
              "x^2-2147483647*y+4611686014132420609");
    EXPECT_EQ(equations_of("x = 2147483647*t+t^2*2147483647\ny = t^2*2147483647\nz = 2147483647"),
              "z-2147483647\n"
              "x^2-2*x*y+y^2-2147483647*y");
}

TEST(Kernel, DoesNotDependOnTheRankThatWasSeen) {
    // As if every point had been unlucky.
    base::Run run;
    const Graph surface("x = s*t\ny = s\nz = t^2");
    EXPECT_EQ(kernel_by_primes(surface.graded, Codimension::unknown, run).generators.size(), 1U);
    const Graph dense("x = s*t\ny = s");
    EXPECT_TRUE(kernel_by_primes(dense.graded, Codimension::unknown, run).generators.empty());
}

TEST(VanishingBound, BoundsTheCoefficientsOfTheComposition) {
    base::Run run;
    std::mt19937_64 random(7);
    for (const char* text : {"x = 3*s-2\ny = s*t+t^2-5\nz = 7*t", "x = s-t\ny = 2*s^2-t\nz = 1-s*t"}) {
        const Graph graph(text);
        const Ring& source = graph.parametrization.ring();
        std::vector<Polynomial> images(graph.graded.ring.variable_count(), Polynomial::constant(source, 1));
        for (std::size_t i = 1; i < graph.map.forms.size(); ++i)
            images[graph.graded.images[i]] = graph.map.forms[i];
        for (int round = 0; round < 20; ++round) {
            PolynomialBuilder builder(graph.graded.ring);
            for (int term = 0; term < 6; ++term) {
                std::vector<std::uint64_t> exponents(graph.graded.ring.variable_count(), 0);
                for (std::size_t i = graph.graded.eliminated; i < exponents.size(); ++i)
                    exponents[i] = random() % 4;
                builder.add(Integer(static_cast<std::int64_t>(random() % 2001) - 1000), exponents);
            }
            const Polynomial F = builder.build();
            const mpz_class bound = vanishing_bound(graph.graded, F).to_mpz();
            const Polynomial composition = compose(F, source, images, run);
            for (std::size_t i = 0; i < composition.size(); ++i)
                EXPECT_LE(abs(composition.coefficient(i)), mpq_class(bound)) << text;
        }
    }
}

TEST(Remaindering, FindsRationalPolynomials) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    for (const char* text :
         {"x", "3*x^2-7*y+5", "123456789012345678901234567890*x^3-y^2+98765432109876543210",
          "1000000007*x*y+2147483647*x-2147483629", "x^5-2147483647*2147483629*y"}) {
        const Polynomial f = parse_polynomial(ring, SourceText(text)).primitive_part();
        Remaindering remaindering(ring);
        std::uint64_t p = 2147483648U;
        std::optional<std::vector<Polynomial>> found;
        int primes = 0;
        for (; primes < 12; ++primes) {
            p = algebra::previous_prime(p);
            const Polynomial image = f.in_ring(ring.with_field(CoefficientField::prime(p))).monic();
            ASSERT_TRUE(remaindering.accepts({image}) || primes > 0) << text;
            if (remaindering.accepts({image})) remaindering.add({image}, run);
            found = remaindering.reconstruct(run);
            if (found && (*found)[0] == f) break;
        }
        ASSERT_TRUE(found) << text;
        EXPECT_EQ((*found)[0], f) << "not within " << primes << " primes";
    }
}

TEST(Remaindering, KeepsPolynomialsWithOtherLeadingMonomialsApart) {
    base::Run run;
    const Ring ring(CoefficientField::rationals(), {"x", "y"});
    const Ring modular = ring.with_field(CoefficientField::prime(101));
    const Polynomial x = Polynomial::variable(modular, "x");
    const Polynomial y = Polynomial::variable(modular, "y");
    Remaindering remaindering(ring);
    EXPECT_TRUE(remaindering.accepts({x}));
    remaindering.add({x, y}, run);
    EXPECT_TRUE(remaindering.accepts({x + y, y}));
    EXPECT_FALSE(remaindering.accepts({x}));
    EXPECT_FALSE(remaindering.accepts({y, x}));
    EXPECT_FALSE(remaindering.accepts({x * x, y}));
    EXPECT_EQ(remaindering.modulus(), 101);
    EXPECT_EQ(remaindering.prime_count(), 1U);
}

} // namespace
} // namespace eliminant::implicit
