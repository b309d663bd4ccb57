#include "eliminant/algebra/parse.hpp"
#include "eliminant/algebra/print.hpp"

#include <gtest/gtest.h>

using namespace eliminant;

namespace {

const Ring rational_ring(CoefficientField::rationals(), {"x", "y", "z", "e"});

std::string reread(std::string_view text) { return to_string(parse_polynomial(rational_ring, text)); }

TEST(Parse, ReadsTheOperators) {
    EXPECT_EQ(reread("x+y-z"), "x+y-z");
    EXPECT_EQ(reread("-x^2"), "-x^2");
    EXPECT_EQ(reread("(x+1)*(x-1)"), "x^2-1");
    EXPECT_EQ(reread("3(x+1)/2"), "3/2*x+3/2");
}

} // namespace
