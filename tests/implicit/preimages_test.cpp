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

TEST(RationalZeros, RealOnesAreCountedBySturmsTheorem) {
    std::mt19937_64 random(3);
    const Ring ring(CoefficientField::rationals(), {"t"});
    const Polynomial t = Polynomial::variable(ring, 0);
    const auto constant = [&](int value) { return Polynomial::constant(ring, value); };
    base::Run run;
    for (int i = 0; i < 60; ++i) {
        Polynomial f = constant(random() % 2 == 0 ? 3 : -5);
        std::set<int> roots; // doubled, and squared with a sign
        for (std::size_t k = random() % 4; k-- > 0;) {
            const int root = static_cast<int>(random() % 21) - 10;
            roots.insert(4 * root * std::abs(root));
            f *= pow(t - constant(root), 1 + random() % 3);
        }
        for (std::size_t k = random() % 3; k-- > 0;) {
            const int square = 1 + static_cast<int>(random() % 60); // t = ±√(square/4) − no integers
            if (square % 2 == 0) continue;
            roots.insert({square, -square});
            f *= constant(4) * t * t - constant(square);
        }
        for (std::size_t k = random() % 3; k-- > 0;)
            f *= t * t + t + constant(1 + static_cast<int>(random() % 9));
        EXPECT_EQ(count_real_zeros(f, run), roots.size()) << to_string(f);
    }
    EXPECT_EQ(count_real_zeros(constant(7), run), 0U);
}

TEST(Preimages, SayWhichAreReal) {
    const std::string whitney = "x = s*t\ny = s\nz = t^2";
    const Preimages stick = preimages_of(whitney, {0, 0, -1});
    EXPECT_EQ(stick.count, mpz_class(2));
    EXPECT_EQ(stick.real_count, mpz_class(0));
    EXPECT_EQ(stick.has_real, false);
    EXPECT_EQ(preimages_of(whitney, {0, 0, 2}).real_count, mpz_class(2));
    EXPECT_EQ(preimages_of(whitney, {6, 2, 9}).real_count, mpz_class(1));
    EXPECT_EQ(preimages_of(whitney, {6, 2, 8}).has_real, false);
    // t³ = 2 once, not three times; and pairs of conjugate numbers with equal first coordinates.
    EXPECT_EQ(preimages_of("x = t^3\ny = t^6", {2, 4}).real_count, mpz_class(1));
    EXPECT_EQ(preimages_of("x = s^2\ny = t^2", {2, 3}).real_count, mpz_class(4));
    EXPECT_EQ(preimages_of("x = s^2\ny = t^2", {2, -3}).real_count, mpz_class(0));
    // Infinitely many: a real line, and two complex ones that meet in a real point.
    EXPECT_EQ(preimages_of("x = s*t\ny = s\nz = s^2", {0, 0, 0}).has_real, true);
    const Preimages conjugate_lines = preimages_of("x = s^2+t^2\ny = x1*(s^2+t^2)", {-1, 0});
    EXPECT_NE(conjugate_lines.has_real, true);
}

TEST(Preimages, LeaveOutBasePointsAndInfinity) {
    const Preimages line = preimages_of("x = s/t\ny = s^2/t^2", {1, 1});
    EXPECT_EQ(line.dimension, 1);
    EXPECT_EQ(components_of(line), std::vector<std::string>{"s-t"});
    EXPECT_EQ(joined(line.excluded), "t");
    EXPECT_EQ(line.has_real, true);
    const std::string circle = "x = (1-t^2)/(1+t^2)\ny = 2*t/(1+t^2)";
    EXPECT_TRUE(preimages_of(circle, {-1, 0}).is_limit_at_infinity);
    EXPECT_FALSE(preimages_of(circle, {1, 0}).is_limit_at_infinity);
    EXPECT_FALSE(preimages_of("x = t\ny = 1/t", {0, 0}).is_limit_at_infinity);
    // Reached, and the limit too.
    const Preimages both = preimages_of("x = 1/(t^2+1)\ny = (t-1)/(t^3+1)", {0, 0});
    EXPECT_TRUE(both.is_limit_at_infinity);
    EXPECT_EQ(both.dimension, -1);
    const Preimages twice = preimages_of("x = t/(t^2+1)\ny = t^2/(t^4+1)", {0, 0});
    EXPECT_TRUE(twice.is_limit_at_infinity);
    EXPECT_EQ(twice.rational, (std::vector<Values>{{0}}));
}

TEST(Preimages, RefuseWhatHasNoAnswer) {
    EXPECT_THROW(preimages_of("x = t\ny = t^2", {1}), DomainError);
    EXPECT_THROW(preimages_of("constants r\nx = r*t\ny = t^2", {1, 1}), DomainError);
    base::Run run;
    EXPECT_THROW(closure_contains(implicitized("x = t\ny = t^2"), Values{1, 1, 1}, run), DomainError);
}

} // namespace
} // namespace eliminant::implicit
