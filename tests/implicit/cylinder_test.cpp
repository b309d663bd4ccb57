// Cylinders: with a parameter that only translates, against elimination.
#include "implicit/cylinder.hpp"

#include "implicit/map_of.hpp"
#include "implicit/support.hpp"

namespace eliminant::implicit {
namespace {

TEST(Cylinder, IsSeenWhereAParameterTranslatesAndOnlyThere) {
    base::Run run;
    const auto is_cylinder = [&](const char* text) {
        return as_cylinder(map_of(parametrization_of(text), run)).has_value();
    };
    EXPECT_TRUE(is_cylinder("x = s+t\ny = s^2+2*t\nz = s^3-t/3"));
    EXPECT_TRUE(is_cylinder("x = 1/s\ny = s^2+2*t\nz = t"));
    EXPECT_TRUE(is_cylinder("x = 1/(t+1)\ny = s\nz = t"));
    EXPECT_FALSE(is_cylinder("x = t\ny = 3"));
    EXPECT_FALSE(is_cylinder("x = s^2\ny = s^3"));
    EXPECT_FALSE(is_cylinder("x = s*t\ny = t\nz = s^2+t"));
    EXPECT_FALSE(is_cylinder("x = t/(s+1)\ny = s^2\nz = s"));
    EXPECT_FALSE(is_cylinder("constants r\nx = r*t\ny = t+s^2\nz = s^3"));
    EXPECT_FALSE(is_cylinder("x = t"));
}

TEST(Cylinder, TheEquationIsThatOfElimination) {
    for (const char* text :
         {"x = s+t\ny = s^2+2*t\nz = s^3-t/3", "x = 1/s\ny = s^2+2*t\nz = 5*t", "x = t\ny = 3",
          "x = s+t\ny = 2*s+2*t\nz = u", "constants a\nx = a*s+t\ny = s^2+2*t\nz = s^3-t/3",
          "constants a\nx = s^2*a+7*t\ny = s^3/a-2*t", "x = s^2+w\ny = s*t-w\nz = t^3+v\nu = t^2-2*v+w",
          "x = cos(u)+t\ny = sin(u)-t\nz = cos(u)*sin(u)+2*t"}) {
        for (const Method method : {Method::linear, Method::automatic})
            EXPECT_EQ(equations_of(text, {.method = method}),
                      equations_of(text, {.method = Method::groebner}))
                << text;
    }
}

} // namespace
} // namespace eliminant::implicit
