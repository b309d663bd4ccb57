// Random parametrizations of every small shape against elimination by the definition.
#include "implicit/direct_elimination.hpp"

namespace eliminant::implicit {
namespace {

struct Shape {
    const char* description;
    std::size_t coordinates;
    std::vector<std::string> atoms; ///< what formulas are made of
    int degree;                     ///< largest degree of a term in the atoms
    bool rational;
    const char* declarations;
    int rounds;
    int relations = 0;
};

class RandomText {
  public:
    explicit RandomText(std::uint64_t seed) : random_(seed) {}

    std::string parametrization(const Shape& shape) {
        std::string text = shape.declarations;
        for (std::size_t i = 0; i < shape.coordinates; ++i) {
            text.append("x").append(std::to_string(i + 1)).append(" = (").append(sum(shape)).append(")");
            if (shape.rational && below(3) != 0) text.append("/(1+").append(product(shape)).append(")");
            text.append("\n");
        }
        for (int i = 0; i < shape.relations; ++i)
            text.append("relation ").append(product(shape)).append("*(").append(sum(shape)).append(") = 0\n");
        return text;
    }

  private:
    std::uint64_t below(std::uint64_t bound) { return random_() % bound; }

    std::string product(const Shape& shape) {
        std::string text = std::to_string(1 + below(3));
        const auto degree = static_cast<int>(below(static_cast<std::uint64_t>(shape.degree) + 1));
        for (int i = 0; i < degree; ++i) text.append("*").append(shape.atoms[below(shape.atoms.size())]);
        return text;
    }

    std::string sum(const Shape& shape) {
        std::string text = product(shape);
        for (std::uint64_t i = below(3); i > 0; --i)
            text.append(below(2) == 0 ? "+" : "-").append(product(shape));
        return text;
    }

    std::mt19937_64 random_;
};

void compare(const Shape& shape) {
    for (int round = 0; round < shape.rounds; ++round) {
        const auto seed = static_cast<std::uint64_t>(round) + 1;
        const std::string text = RandomText(seed).parametrization(shape);
        SCOPED_TRACE(std::string(shape.description)
                         .append(", seed ")
                         .append(std::to_string(seed))
                         .append("\n")
                         .append(text));
        const ImplicitResult result = implicitized(text, {.method = Method::groebner});
        EXPECT_TRUE(agrees_with_direct_elimination(parametrization_of(text), result));
        for (const Method method : {Method::linear, Method::automatic}) {
            const ImplicitResult other = implicitized(text, {.method = method});
            EXPECT_EQ(joined(other.equations), joined(result.equations)) << to_string(method);
            EXPECT_EQ(other.codimension, result.codimension) << to_string(method);
            EXPECT_EQ(other.assurance, Assurance::proved);
        }
    }
}

TEST(DirectElimination, AgreesOnPolynomialCurves) {
    compare({"plane curves", 2, {"t"}, 4, false, "parameters t\n", 20});
    compare({"space curves", 3, {"t"}, 3, false, "parameters t\n", 20});
    compare({"curves in four coordinates", 4, {"t"}, 2, false, "parameters t\n", 10});
    compare({"functions of one parameter", 1, {"t"}, 3, true, "parameters t\n", 5});
}

TEST(DirectElimination, AgreesOnRationalCurves) {
    compare({"plane curves", 2, {"t"}, 3, true, "parameters t\n", 20});
    compare({"space curves", 3, {"t"}, 2, true, "parameters t\n", 20});
}

TEST(DirectElimination, AgreesOnSurfaces) {
    compare({"polynomial surfaces", 3, {"s", "t"}, 2, false, "parameters s, t\n", 30});
    compare({"rational surfaces", 3, {"s", "t"}, 2, true, "parameters s, t\n", 20});
    compare({"surfaces in four coordinates", 4, {"s", "t"}, 2, false, "parameters s, t\n", 15});
    compare({"more parameters than needed", 2, {"s", "t", "u"}, 2, true, "parameters s, t, u\n", 10});
}

TEST(DirectElimination, AgreesWithConstants) {
    compare({"plane curves", 2, {"t", "r"}, 3, false, "constants r\nparameters t\n", 20});
    compare({"rational plane curves", 2, {"t", "r"}, 2, true, "constants r\nparameters t\n", 20});
    compare({"space curves", 3, {"t", "a", "b"}, 2, false, "constants a, b\nparameters t\n", 20});
    compare({"rational space curves", 3, {"t", "r"}, 2, true, "constants r\nparameters t\n", 12});
    compare({"surfaces", 3, {"s", "t", "r"}, 2, true, "constants r\nparameters s, t\n", 12});
    compare({"points", 2, {"r", "q"}, 2, true, "constants r, q\n", 8});
}

TEST(DirectElimination, AgreesWithAngles) {
    compare({"plane curves", 2, {"cos(u)", "sin(u)"}, 2, false, "parameters u\n", 20});
    compare({"multiples", 2, {"cos(2u)", "sin(u)", "cos(u)"}, 2, false, "", 10});
    compare({"rational curves", 2, {"cos(u)", "sin(u)"}, 1, true, "parameters u\n", 15});
    compare({"space curves", 3, {"cos(u)", "sin(u)"}, 2, false, "parameters u\n", 10});
    compare({"surfaces", 3, {"cos(u)", "sin(v)", "t"}, 2, false, "", 15});
    compare({"with a constant", 2, {"cos(u)", "sin(u)", "r"}, 2, false, "constants r\n", 10});
}

TEST(DirectElimination, AgreesWithRelations) {
    compare({"one relation", 2, {"s", "t"}, 2, false, "parameters s, t\n", 25, 1});
    compare({"a relation and denominators", 2, {"s", "t"}, 1, true, "parameters s, t\n", 25, 1});
    compare({"more coordinates", 3, {"s", "t"}, 1, true, "parameters s, t\n", 15, 1});
    compare({"two relations", 2, {"s", "t", "u"}, 1, false, "parameters s, t, u\n", 15, 2});
    compare({"angles", 2, {"cos(u)", "sin(u)", "t"}, 1, false, "", 10, 1});
}

} // namespace
} // namespace eliminant::implicit
