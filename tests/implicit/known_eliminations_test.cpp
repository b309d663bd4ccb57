// The parametrizations of data/implicit/ against their known equations.
#include "implicit/irreducible.hpp"
#include "implicit/support.hpp"

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

namespace eliminant::implicit {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& path) {
    std::ifstream file(path);
    EXPECT_TRUE(file.is_open()) << path;
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string without_trailing_newlines(std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    return text;
}

/// Too long for a test: over a second each by elimination, or nobody's answer.
const std::set<std::string> left_to_benchmarks = {
    "ES_1",           "ES_2",      "ES_8",         "L6",           "bicubic_hoffmann",
    "bicubic_random", "henneberg", "teapot_spout", "dense40_curve"};

std::vector<std::string> case_names() {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(fs::path(ELIMINANT_DATA_DIR) / "implicit")) {
        const std::string name = entry.path().stem().string();
        if (entry.path().extension() == ".par" && !left_to_benchmarks.contains(name)) names.push_back(name);
    }
    std::ranges::sort(names);
    return names;
}

class KnownElimination : public ::testing::TestWithParam<std::string> {};

TEST_P(KnownElimination, IsFound) {
    const fs::path stem = fs::path(ELIMINANT_DATA_DIR) / "implicit" / GetParam();
    const std::string text = read_file(stem.string() + ".par");
    ASSERT_TRUE(text.starts_with("# ")) << "the first line names the source";
    const ImplicitResult result = implicitized(text);
    EXPECT_EQ(joined(result.equations), without_trailing_newlines(read_file(stem.string() + ".expected")));
    EXPECT_EQ(result.codimension, result.equations.size() == 1 ? 1U : 2U);
    EXPECT_EQ(result.assurance, Assurance::proved);

    const ImplicitResult eliminated = implicitized(text, {.method = Method::groebner});
    EXPECT_EQ(joined(eliminated.equations), joined(result.equations));

    std::mt19937_64 random(1);
    const Parametrization parametrization = parametrization_of(text);
    for (const Polynomial& f : result.equations) {
        EXPECT_TRUE(vanishes_on_image(f, parametrization, random));
        EXPECT_TRUE(f.total_degree() > 12 || is_proved_irreducible(f, random));
    }
}

INSTANTIATE_TEST_SUITE_P(Data, KnownElimination, ::testing::ValuesIn(case_names()),
                         [](const auto& instance) { return instance.param; });

} // namespace
} // namespace eliminant::implicit
