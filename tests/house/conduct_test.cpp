// What the library promises its callers and can be read off its text: it never prints, exits, or reads the
// clock or the environment; headers can be included twice; public types say what they are.
#include "house/source_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>
#include <vector>

namespace eliminant::house {
namespace {

std::size_t line_at(const std::string& text, std::size_t position) {
    return 1 + static_cast<std::size_t>(
                   std::count(text.begin(), text.begin() + static_cast<long>(position), '\n'));
}

/// The places in the code of `text`, comments and strings aside, where `pattern` is found.
std::vector<std::string> places(const std::string& text, const std::regex& pattern) {
    const std::string code = code_of(text);
    std::vector<std::string> found;
    for (std::sregex_iterator it(code.begin(), code.end(), pattern), end; it != end; ++it)
        found.push_back(std::to_string(line_at(code, static_cast<std::size_t>(it->position()))) + ": " +
                        it->str());
    return found;
}

const std::regex prints_or_exits(
    R"re(\bstd::(cout|cerr|clog)\b|\b(v?f?printf|puts|fputs|putchar|exit|_exit|quick_exit|abort|system|getenv|secure_getenv)\s*\()re");
const std::regex
    reads_the_clock(R"re(\b(steady|system|high_resolution)_clock\b|\b(clock_gettime|gettimeofday)\s*\()re");

TEST(Conduct, TheLibraryNeverPrintsExitsOrReadsTheEnvironment) {
    for (const SourceFile& file : source_files()) {
        if (file.layer == "apps") continue;
        for (const std::string& place : places(file.text, prints_or_exits))
            ADD_FAILURE() << file.name << ":" << place;
    }
}

TEST(Conduct, OnlyTheWatchdogOfARunReadsTheClock) {
    for (const SourceFile& file : source_files()) {
        if (file.layer == "apps" || file.name == "base/run.cpp") continue;
        for (const std::string& place : places(file.text, reads_the_clock))
            ADD_FAILURE() << file.name << ":" << place;
    }
}

TEST(Conduct, ViolationsAreSeen) {
    EXPECT_EQ(places("a();\nstd::cout << 1;", prints_or_exits), std::vector<std::string>{"2: std::cout"});
    EXPECT_EQ(places("char c = '\"'; exit(1'000); // \"", prints_or_exits).size(), 1U);
    EXPECT_EQ(places("std::printf(\"x\"); exit (1);", prints_or_exits).size(), 2U);
    EXPECT_EQ(places("auto t = std::chrono::steady_clock::now();", reads_the_clock).size(), 1U);
    EXPECT_TRUE(places("// exit(1)\n/* std::cerr\n */ text(\"printf(\"); snprintf(b, n, f);", prints_or_exits)
                    .empty());
}

TEST(Conduct, EveryHeaderMayBeIncludedTwice) {
    for (const SourceFile& file : source_files()) {
        if (!file.name.ends_with(".hpp")) continue;
        EXPECT_NE(file.text.find("#pragma once\n"), std::string::npos) << file.name;
    }
}

TEST(Conduct, EveryPublicTypeSaysWhatItIs) {
    // A definition at the left margin, with its template line, and whatever line stands before it.
    const std::regex definition(R"re(([^\n]*)\n(?:template\s*<[^\n]*\n(?:\s+requires[^\n]*\n)?)?)re"
                                R"re((?:class|struct|enum class|union|concept)\s+(\w+)[^;{\n]*\{)re");
    for (const SourceFile& file : source_files()) {
        if (!file.is_public) continue;
        for (std::sregex_iterator it(file.text.begin(), file.text.end(), definition), end; it != end; ++it)
            EXPECT_TRUE((*it)[1].str().starts_with("///"))
                << file.name << ":" << line_at(file.text, static_cast<std::size_t>(it->position())) + 1
                << ": " << (*it)[2];
    }
}

} // namespace
} // namespace eliminant::house
