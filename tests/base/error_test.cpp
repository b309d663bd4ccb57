#include "eliminant/base/error.hpp"
#include "eliminant/base/version.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string_view>

namespace eliminant {
namespace {

TEST(ParseError, CarriesThePlaceAndPrintsItOnOneLine) {
    const ParseError error({"patch.par", 3, 17}, "an exponent", "'x'", "x = t^x + 1");
    EXPECT_STREQ(error.what(), "patch.par:3:17: expected an exponent, found 'x'");
    EXPECT_EQ(error.where().source, "patch.par");
    EXPECT_EQ(error.where().line, 3U);
    EXPECT_EQ(error.where().column, 17U);
    EXPECT_EQ(error.expected(), "an exponent");
    EXPECT_EQ(error.found(), "'x'");
    EXPECT_EQ(error.line_text(), "x = t^x + 1");
}

TEST(Stopped, KeepsItsReason) {
    EXPECT_EQ(Stopped(StopReason::memory_limit).reason(), StopReason::memory_limit);
    EXPECT_STREQ(Stopped(StopReason::interrupted).what(), "interrupted");
    EXPECT_STREQ(Stopped(StopReason::time_limit).what(), "time limit reached");
    EXPECT_STREQ(Stopped(StopReason::memory_limit).what(), "memory limit reached");
}

TEST(Error, CatchesEveryErrorOfTheLibrary) {
    EXPECT_THROW(throw ParseError({}, "a", "b", ""), Error);
    EXPECT_THROW(throw RingMismatchError("addition in different rings"), Error);
    EXPECT_THROW(throw OverflowError("exponent"), Error);
    EXPECT_THROW(throw DomainError("division by zero"), Error);
    EXPECT_THROW(throw Stopped(StopReason::interrupted), Error);
}

TEST(Version, HasThreeNumbers) {
    EXPECT_EQ(std::count(version_string.begin(), version_string.end(), '.'), 2);
    EXPECT_EQ(version_string.find_first_not_of("0123456789."), std::string_view::npos);
}

} // namespace
} // namespace eliminant
