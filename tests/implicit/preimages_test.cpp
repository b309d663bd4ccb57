// Fibres against the map itself, and against fibres that are known; rational zeros against products of
// factors.
#include "eliminant/implicit/preimages.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/base/error.hpp"
#include "implicit/rational_zeros.hpp"
#include "implicit/support.hpp"

#include <set>

namespace eliminant::implicit {
namespace {

using Values = std::vector<mpq_class>;

Preimages preimages_of(const std::string& text, const Values& point) {
    base::Run run;
    return preimages(parametrization_of(text), point, run);
}

/// The components, each by its lex basis.
std::vector<std::string> components_of(const Preimages& found) {
    base::Run run;
    std::vector<std::string> result;
    for (const Ideal& component : found.components)
        result.push_back(joined(component.groebner_basis(MonomialOrder::lex(), run)));
    return result;
}

TEST(RationalZeros, AreThoseOfTheLinearFactors) {
    std::mt19937_64 random(1);
    const Ring ring(CoefficientField::rationals(), {"t"});
    const Polynomial t = Polynomial::variable(ring, 0);
    base::Run run;
    for (int i = 0; i < 60; ++i) {
        Polynomial f = Polynomial::constant(ring, 1 + static_cast<int>(random() % 9));
        std::set<mpq_class> zeros;
        for (std::size_t k = random() % 5; k-- > 0;) {
            mpq_class zero(static_cast<long>(random() % 4001) - 2000, 1 + random() % 999);
            if (random() % 4 == 0) zero = 0;
            zero.canonicalize();
            zeros.insert(zero);
            f *= pow(t - Polynomial::constant(ring, zero), 1 + random() % 3);
        }
        for (std::size_t k = random() % 3; k-- > 0;) // no rational zeros
            f *= t * t + t + Polynomial::constant(ring, 1 + static_cast<int>(random() % 50));
        f *= t * t - Polynomial::constant(ring, 2);
        EXPECT_EQ(rational_zeros(f, run), Values(zeros.begin(), zeros.end())) << to_string(f);
    }
    EXPECT_TRUE(rational_zeros(Polynomial::constant(ring, 7), run).empty());
    // Numbers of many digits.
    const mpq_class large("123456789012345678901234567891/987654321098765432109876543211");
    EXPECT_EQ(rational_zeros((t - Polynomial::constant(ring, large)) * (t * t * t - t + t * t - t * t), run),
              (Values{-1, 0, large, 1}));
}

TEST(Preimages, HoldThePointThatWasMapped) {
    const std::vector<std::string> maps = {
        "x = t^2-1\ny = t^3-t",
        "x = (t^2+1)/(t-7)\ny = t/(t^2+3)",
        "x = s*t\ny = s+t\nz = s^2-t",
        "x = s/(s*t+1)\ny = t/(s*t+1)\nz = s^2-t^2",
        "x = s\ny = s*t\nz = s*t^2+t\nw = t^3",
    };
    std::mt19937_64 random(2);
    base::Run run;
    for (const std::string& text : maps) {
        const Parametrization parametrization = parametrization_of(text);
        const ImplicitResult closure = implicitized(text);
        for (int i = 0; i < 4; ++i) {
            Values parameters;
            for (std::size_t k = 0; k < parametrization.ring().variable_count(); ++k)
                parameters.emplace_back(static_cast<int>(random() % 11) - 5, 1 + random() % 3);
            for (mpq_class& value : parameters) value.canonicalize();
            Values point;
            bool defined = true;
            for (const Coordinate& coordinate : parametrization.coordinates()) {
                const mpq_class bottom = evaluate(coordinate.value.denominator, parameters);
                defined = defined && bottom != 0;
                if (defined) point.push_back(evaluate(coordinate.value.numerator, parameters) / bottom);
            }
            if (!defined) continue;
            const Preimages found = preimages(parametrization, point, run);
            EXPECT_EQ(found.dimension, 0) << text;
            EXPECT_EQ(std::ranges::count(found.rational, parameters), 1) << text;
            ASSERT_TRUE(found.count);
            EXPECT_GE(*found.count, static_cast<unsigned long>(found.rational.size()));
            EXPECT_TRUE(closure_contains(closure, point, run)) << text;
            point[0] += 1; // beside the image, or on another sheet of it
            EXPECT_EQ(preimages(parametrization, point, run).dimension >= 0,
                      closure_contains(closure, point, run))
                << text << ": these images are closed around there";
        }
    }
}

TEST(Preimages, AreSplitIntoRationalPointsAndTheRest) {
    const Preimages node = preimages_of("x = t^2-1\ny = t^3-t", {0, 0});
    EXPECT_EQ(node.rational, (std::vector<Values>{{-1}, {1}}));
    EXPECT_EQ(node.count, mpz_class(2));
    const Preimages conjugate = preimages_of("x = t^2\ny = t^4", {2, 4});
    EXPECT_TRUE(conjugate.rational.empty());
    EXPECT_EQ(components_of(conjugate), std::vector<std::string>{"t^2-2"});
    // (t² − 2)(t − 1) and a double zero, which counts once.
    const Preimages mixed = preimages_of("x = (t^2-2)*(t-1)^2\ny = (t^2-2)*(t-1)*(t+5)", {0, 0});
    EXPECT_EQ(mixed.rational, (std::vector<Values>{{1}}));
    EXPECT_EQ(components_of(mixed), std::vector<std::string>{"t^2-2"});
    EXPECT_EQ(mixed.count, mpz_class(3));
    const Preimages pairs = preimages_of("x = s+t\ny = s*t\nz = s^2+t^2", {0, -2, 4});
    EXPECT_EQ(components_of(pairs), std::vector<std::string>{"t^2-2\ns+t"});
    const Preimages angle = preimages_of("x = cos(u)\ny = sin(u)", {mpq_class(3, 5), mpq_class(4, 5)});
    EXPECT_EQ(angle.rational, (std::vector<Values>{{mpq_class(3, 5), mpq_class(4, 5)}}));
}

TEST(Preimages, MayBeInfinitelyManyOrNone) {
    const Preimages line = preimages_of("x = s*t\ny = s\nz = s^2", {0, 0, 0});
    EXPECT_EQ(line.dimension, 1);
    EXPECT_FALSE(line.count);
    EXPECT_EQ(components_of(line), std::vector<std::string>{"s"});
    // The point of the circle that no parameter reaches, though it is on the closure.
    const std::string circle = "x = (1-t^2)/(1+t^2)\ny = 2*t/(1+t^2)";
    EXPECT_EQ(preimages_of(circle, {-1, 0}).dimension, -1);
    EXPECT_EQ(preimages_of(circle, {-1, 0}).count, mpz_class(0));
    base::Run run;
    EXPECT_TRUE(closure_contains(implicitized(circle), Values{-1, 0}, run));
    EXPECT_FALSE(closure_contains(implicitized(circle), Values{1, 1}, run));
    // At the base point s = t = 0 all numerators and denominators vanish; it has no image.
    EXPECT_EQ(preimages_of("x = s/t\ny = (s^2+t)/t", {1, 1}).dimension, -1);
    EXPECT_EQ(preimages_of("relation s^2+t^2 = 1\nx = s\ny = t", {2, 0}).dimension, -1);
}

TEST(Preimages, RefuseWhatHasNoAnswer) {
    EXPECT_THROW(preimages_of("x = t\ny = t^2", {1}), DomainError);
    EXPECT_THROW(preimages_of("constants r\nx = r*t\ny = t^2", {1, 1}), DomainError);
    base::Run run;
    EXPECT_THROW(closure_contains(implicitized("x = t\ny = t^2"), Values{1, 1, 1}, run), DomainError);
}

} // namespace
} // namespace eliminant::implicit
