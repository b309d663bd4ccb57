// The choice of a method: it must not change answers, and it must see what shapes are made for.
#include "support.hpp"

#include <gtest/gtest.h>

#include <string>

namespace eliminant::implicit {
namespace {

ImplicitResult chosen(const std::string& text) { return implicitized(text); }

/// The method whose prediction is the least, or the one that needed none to compare with.
void expect_chosen(const std::string& text, Method method) {
    const ImplicitResult result = chosen(text);
    EXPECT_EQ(result.method, method) << text << result.choice;
    ASSERT_FALSE(result.predicted.empty()) << text;
    EXPECT_EQ(result.predicted.front().method, method) << result.choice;
    EXPECT_FALSE(result.predicted.front().at_least) << result.choice;
    EXPECT_NE(result.choice.find("predicted: "), std::string::npos) << result.choice;
    for (const Method other : {Method::groebner, Method::linear, Method::resultant})
        EXPECT_EQ(joined(result.equations), equations_of(text, {.method = other})) << text;
}

TEST(MethodChoice, FewCoefficientsOfAnyDegreeAreFoundByLinearAlgebra) {
    const std::string u = "(s^2+2*s*t-t+1)";
    const std::string v = "(t^2-s*t+3*s)";
    const std::string w = std::string("(1+").append(u).append("^2+").append(v).append("^2)");
    std::string sphere = "parameters s, t\nx = 2*";
    sphere.append(u).append("/").append(w).append("\ny = 2*").append(v).append("/").append(w);
    sphere.append("\nz = (1-").append(u).append("^2-").append(v).append("^2)/").append(w);
    expect_chosen(sphere, Method::linear);
    EXPECT_EQ(equations_of(sphere), "x^2+y^2+z^2-1");
}

TEST(MethodChoice, DensePatchesAndCurvesAreFoundByResultants) {
    expect_chosen("x = 3*t^12-t^7+2*t^3-t+5\ny = t^11+4*t^8-t^5+t^2+7", Method::resultant);
    expect_chosen("parameters s, t\nx = s^2*t^2-3*s^2*t+s-t+2\ny = 2*s^2*t^2+s*t^2-t+s^2-1\n"
                  "z = s^2*t^2+5*s*t-s+3*t+t^2",
                  Method::resultant);
}

TEST(MethodChoice, MonomialMapsAreReadOffAndGraphsAreEliminated) {
    // Resultants and linear algebra would take minutes: the equation has degree 1020 in the first case.
    const ImplicitResult monomial = chosen("parameters s, t\nx = s^30*t^7\ny = s^5*t^30\nz = s^17*t^13");
    EXPECT_EQ(monomial.method, Method::toric) << monomial.choice;
    ASSERT_EQ(monomial.equations.size(), 1U);
    EXPECT_EQ(monomial.equations.front().size(), 2U);

    std::string height;
    for (int i = 0; i <= 30; ++i)
        for (int j = 0; i + j <= 30; ++j)
            height.append(height.empty() ? "" : "+")
                .append(std::to_string(1 + (7 * i + 11 * j) % 13))
                .append("*s^")
                .append(std::to_string(i))
                .append("*t^")
                .append(std::to_string(j));
    const ImplicitResult graph = chosen("parameters s, t\nx = s\ny = t\nz = " + height);
    EXPECT_EQ(graph.method, Method::groebner) << graph.choice;
    EXPECT_EQ(graph.equations.front().total_degree(), 30);
    EXPECT_EQ(graph.predicted.front().method, Method::groebner);
}

TEST(MethodChoice, WhatWasAskedForIsNotPredicted) {
    for (const Method method : {Method::groebner, Method::linear, Method::resultant}) {
        const ImplicitResult result = implicitized("x = t^2-1\ny = t^3-t", {.method = method});
        EXPECT_EQ(result.method, method);
        EXPECT_TRUE(result.predicted.empty());
    }
}

} // namespace
} // namespace eliminant::implicit
