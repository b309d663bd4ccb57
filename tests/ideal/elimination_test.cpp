#include "eliminant/ideal/operations.hpp"

#include "ideal/support.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace eliminant::ideal {
namespace {

const Ring xyz(CoefficientField::rationals(), {"x", "y", "z"});

TEST(Elimination, IsTheIntersectionWithTheSubring) {
    base::Run run;
    for_random_pairs(41, [&](const Ideal& I, const Ideal&, Random& random) {
        const std::vector<std::size_t> gone = random() % 2 == 0
                                                  ? std::vector<std::size_t>{random() % 3}
                                                  : std::vector<std::size_t>{2, random() % 3, 2};
        const Ideal E = eliminate(I, gone, run);
        std::vector<Polynomial> back;
        for (const Polynomial& f : E.generators()) back.push_back(f.in_ring(I.ring()));
        EXPECT_TRUE(I.contains(Ideal(I.ring(), back), run));
        // The lex basis with the eliminated variables first has the same elimination ideal (the theorem).
        std::vector<std::string> names;
        for (const std::size_t i : gone) {
            if (std::ranges::find(names, I.ring().names()[i]) == names.end())
                names.push_back(I.ring().names()[i]);
        }
        names.insert(names.end(), E.ring().names().begin(), E.ring().names().end());
        const Ring lex(I.ring().field(), names, MonomialOrder::lex());
        std::vector<Polynomial> generators;
        for (const Polynomial& f : I.generators()) generators.push_back(f.in_ring(lex));
        std::vector<Polynomial> expected;
        for (const Polynomial& f : Ideal(lex, generators).groebner_basis(run)) {
            const std::size_t k = names.size() - E.ring().variable_count();
            bool free = true;
            for (std::size_t i = 0; i < k; ++i) free = free && f.degree(i) == 0;
            if (free) expected.push_back(f.in_ring(E.ring()));
        }
        EXPECT_TRUE(E.equals(Ideal(E.ring(), expected), run));
    });
}

TEST(Elimination, TextbookExamples) {
    base::Run run;
    const auto [x, y, z] = variables<3>(xyz);
    const Polynomial one = number(xyz, 1);
    {
        // Cox, Little, O'Shea, §3.1, (4): elimination of x and y gives z⁶ − 4z⁴ + 4z³ − z².
        const Ideal I = ideal_of({x * x + y + z - one, x + y * y + z - one, x + y + z * z - one});
        const Ideal E = eliminate(I, std::vector<std::size_t>{0, 1}, run);
        const Polynomial t = Polynomial::variable(E.ring(), "z");
        EXPECT_EQ(E.generators(), std::vector{pow(t, 6) - number(E.ring(), 4) * pow(t, 4) +
                                              number(E.ring(), 4) * pow(t, 3) - t * t});
    }
    {
        // §3.1, (7): xy = 1, xz = 1; elimination of x gives y − z, but (0, 0) does not extend.
        const Ideal I = ideal_of({x * y - one, x * z - one});
        const Ideal E = eliminate(I, std::vector<std::size_t>{0}, run);
        EXPECT_EQ(E.generators(),
                  std::vector{Polynomial::variable(E.ring(), "y") - Polynomial::variable(E.ring(), "z")});
        EXPECT_TRUE(sum(I, ideal_of({y, z})).is_unit(run));
        EXPECT_FALSE(sum(I, ideal_of({y - one, z - one})).is_unit(run));
    }
    {
        // The tangent surface of the twisted cubic, §3.3, (3).
        const Ring ring(CoefficientField::rationals(), {"t", "u", "x", "y", "z"});
        const auto [t, u, X, Y, Z] = variables<5>(ring);
        const Polynomial two = number(ring, 2);
        const Polynomial three = number(ring, 3);
        const Ideal I(ring, {X - t - u, Y - t * t - two * t * u, Z - t * t * t - three * t * t * u});
        const Ideal E = eliminate(I, std::vector<std::size_t>{0, 1}, run);
        const auto [a, b, c] = variables<3>(E.ring());
        const auto n = [&](long value) { return number(E.ring(), value); };
        EXPECT_EQ(E.generators(), std::vector{(n(-3) * a * a * b * b + n(4) * b * b * b +
                                               n(4) * a * a * a * c - n(6) * a * b * c + c * c)
                                                  .primitive_part()});
    }
}

TEST(Elimination, OfAllOrNoneOfTheVariables) {
    base::Run run;
    for (const Ring& ring : testing::sample_rings()) {
        const Polynomial x = Polynomial::variable(ring, 0);
        std::vector<std::size_t> all(3);
        std::iota(all.begin(), all.end(), std::size_t{0});
        const Ideal I(ring, {x * x});
        EXPECT_TRUE(eliminate(I, all, run).is_zero());
        EXPECT_EQ(eliminate(I, all, run).ring().variable_count(), 0U);
        EXPECT_TRUE(eliminate(Ideal::unit(ring), all, run).is_unit(run));
        EXPECT_TRUE(eliminate(I, {}, run).equals(I, run));
        EXPECT_THROW(static_cast<void>(eliminate(I, std::vector<std::size_t>{3}, run)), DomainError);
    }
}

} // namespace
} // namespace eliminant::ideal
