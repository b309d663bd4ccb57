// Whole reduced bases and the operations on ideals against Singular.
#include "eliminant/ideal/dimension.hpp"
#include "eliminant/ideal/hilbert.hpp"
#include "eliminant/ideal/operations.hpp"
#include "eliminant/ideal/radical.hpp"
#include "ideal/support.hpp"
#include "support/singular.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace eliminant::ideal {
namespace {

using testing::Singular;

/// The sample rings that Singular has too.
std::vector<Ring> common_rings() {
    std::vector<Ring> rings = testing::sample_rings();
    std::erase_if(rings, [](const Ring& ring) { return ring.field().characteristic() > (1U << 29); });
    return rings;
}

struct Question {
    std::size_t number;
    std::vector<Ideal> arguments;
    std::function<Ideal()> ours;
};

/// Checks that our ideals have the reduced bases that Singular finds.
void compare(Singular& singular, const std::vector<Question>& questions) {
    base::Run run;
    const auto answers = singular.answers();
    for (const Question& question : questions) {
        std::string text;
        for (const Ideal& I : question.arguments) text.append("\n").append(describe(I));
        EXPECT_EQ(question.ours().groebner_basis(run), answers[question.number]) << text;
    }
}

TEST(SingularAgrees, OnReducedBases) {
    ELIMINANT_REQUIRE_SINGULAR();
    Random random(91);
    Singular singular;
    std::vector<Question> questions;
    for (int round = 0; round < 4; ++round) {
        for (const Ring& ring : common_rings()) {
            Ideal I = random_ideal(ring, random, 2 + random() % 2, 3, 2 + random() % 2);
            questions.push_back({singular.ask({I}, "std(A)"), {I}, [I] { return Ideal(I); }});
        }
    }
    compare(singular, questions);
}

TEST(SingularAgrees, OnOperations) {
    ELIMINANT_REQUIRE_SINGULAR();
    Random random(92);
    Singular singular;
    std::vector<Question> questions;
    base::Run run;
    for (int round = 0; round < 2; ++round) {
        for (const Ring& ring : common_rings()) {
            const Ideal I = random_ideal(ring, random, 2, 2, 3, random() % 2 == 0);
            const Ideal J = random_ideal(ring, random, 2, 2, 2, random() % 2 == 0);
            const std::vector<Ideal> both{I, J};
            const auto ask = [&](const std::string& expression, auto ours) {
                questions.push_back(
                    {singular.ask(both, expression), both, [&run, I, J, ours] { return ours(I, J, run); }});
            };
            ask("std(intersect(A, B))", [](auto& A, auto& B, auto& r) { return intersect(A, B, r); });
            ask("std(quotient(A, B))", [](auto& A, auto& B, auto& r) { return quotient(A, B, r); });
            ask("saturated(A, B)", [](auto& A, auto& B, auto& r) { return saturate(A, B, r); });
            ask("saturated(A, ideal(var(2)))",
                [](auto& A, auto&, auto& r) { return saturate(A, Polynomial::variable(A.ring(), 1), r); });
            ask("std(A * B)", [](auto& A, auto& B, auto& r) { return product(A, B, r); });
            ask("std(eliminate(A, var(1)))", [](auto& A, auto&, auto& r) {
                const Ideal E = eliminate(A, std::vector<std::size_t>{0}, r);
                std::vector<Polynomial> generators;
                for (const Polynomial& f : E.generators()) generators.push_back(f.in_ring(A.ring()));
                return Ideal(A.ring(), generators);
            });
        }
    }
    compare(singular, questions);
}

TEST(SingularAgrees, OnRadicals) {
    ELIMINANT_REQUIRE_SINGULAR();
    Random random(93);
    Singular singular;
    std::vector<Question> questions;
    base::Run run;
    const std::vector<std::string> names{"x", "y", "z"};
    for (const Ring& ring :
         {Ring(CoefficientField::rationals(), names), Ring(CoefficientField::prime(32003), names)}) {
        for (int round = 0; round < 10; ++round) {
            const Ideal I =
                product(random_ideal(ring, random, 2, 2, 2), random_ideal(ring, random, 2, 2, 2), run);
            questions.push_back(
                {singular.ask({I}, "std(radical(A))"), {I}, [&run, I] { return radical(I, run); }});
        }
    }
    compare(singular, questions);
}

} // namespace
} // namespace eliminant::ideal
