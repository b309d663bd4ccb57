// Certificates of the program.
#include "program.hpp"

#include <nlohmann/json.hpp>

#include <random>

namespace eliminant::test {
namespace {

using Json = nlohmann::ordered_json;

std::string certificate_of(std::vector<std::string> input) {
    const ScratchDirectory scratch;
    input.insert(input.begin(), "implicitize");
    input.insert(input.end(), {"--certificate", scratch.path("certificate")});
    EXPECT_EQ(run(input).status, 0);
    std::ifstream file(scratch.path("certificate"));
    return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Verify, ACertificateIsAcceptedAndSaysWhatWasChecked) {
    const ProcessResult cusp = run_with_input({"verify", "-"}, certificate_of({"x = t^2", "y = t^3"}));
    EXPECT_EQ(cusp.status, 0);
    EXPECT_EQ(cusp.errors, "");
    for (const char* part : {"vanishes", "irreducible", "dimension", "valid: proved"})
        EXPECT_NE(cusp.output.find(part), std::string::npos) << part;
    for (const std::vector<std::string>& input : {std::vector<std::string>{"x = cos(u)", "y = sin(u)"},
                                                  {"x = t", "y = t^2", "z = t^3"},
                                                  {"x = s", "y = t"},
                                                  {"constants r", "x = r*t", "y = t^2/(t+r)"}})
        EXPECT_EQ(run_with_input({"verify", "-"}, certificate_of(input)).status, 0);
}

/// What each value may be replaced by: numbers by their neighbours, texts by the same with one character
/// more, or another one at a random place.
std::vector<Json> replacements(const Json& value, std::mt19937_64& random) {
    if (value.is_number()) {
        const auto number = value.get<std::uint64_t>();
        return {number + 1, number == 0 ? number + 2 : number - 1, random() >> 32, -1, "1"};
    }
    if (!value.is_string()) return {"1", 7};
    const auto text = value.get<std::string>();
    std::string other = text;
    if (!other.empty()) {
        char& character = other[random() % other.size()];
        character = character == '7' ? '8' : '7';
    }
    return {text + "1", other.empty() ? "7" : other, 1};
}

TEST(Verify, EveryChangedValueIsRejected) {
    std::mt19937_64 random(6);
    for (const std::vector<std::string>& input : {std::vector<std::string>{"x = 2*t^2/(t+1)", "y = t^3"},
                                                  {"x = u+v", "y = u^2", "relation u^2+v^2 = 1"},
                                                  {"constants r", "x = r*cos(u)", "y = sin(u)", "z = u*r"},
                                                  {"x = 2*t^9", "y = -3*t^12"}}) {
        const Json original = Json::parse(certificate_of(input));
        const Json flat = original.flatten();
        EXPECT_GT(flat.size(), 15U);
        for (const auto& [path, value] : flat.items())
            for (const Json& other : replacements(value, random)) {
                if (other == value) continue;
                Json changed = original;
                changed[Json::json_pointer(path)] = other;
                const int status = run_with_input({"verify", "-"}, changed.dump()).status;
                EXPECT_TRUE(status == 1 || status == 2) << path << ": " << other << ": " << status;
            }
        Json longer = original;
        longer["claims"]["more"] = 1;
        EXPECT_EQ(run_with_input({"verify", "-"}, longer.dump()).status, 2);
    }
}

TEST(Verify, WhatIsNoCertificateIsBadInput) {
    const std::string text = certificate_of({"x = t^2", "y = t^3"});
    expect_error_with(run_with_input({"verify", "-"}, "{\"input\":"), 2, "expected JSON");
    expect_error_with(run_with_input({"verify", "-"}, "[]"), 2, "expected an object");
    for (const char* member : {"input", "equations", "claims", "digest"}) {
        Json json = Json::parse(text);
        json.erase(member);
        EXPECT_EQ(run_with_input({"verify", "-"}, json.dump()).status, 2) << member;
        json[member] = -1;
        EXPECT_EQ(run_with_input({"verify", "-"}, json.dump()).status, 2) << member;
    }
    EXPECT_EQ(run({"verify", "no/such/file"}).status, 2);
}

TEST(Verify, AVerdictInJson) {
    const ProcessResult cusp =
        run_with_input({"verify", "-", "--format", "json"}, certificate_of({"x = t^2", "y = t^3"}));
    const Json verdict = Json::parse(cusp.output);
    EXPECT_EQ(verdict["valid"], true);
    EXPECT_EQ(verdict["checked"].size(), 3U);
    expect_error(run({"verify", "-", "--format", "latex"}), 2,
                 "--format: expected text or json, as the result is no polynomial");
}

TEST(Verify, CertificateAndResultDoNotGoToOnePlace) {
    const ScratchDirectory scratch;
    const std::string file = scratch.path("same");
    for (const std::vector<std::string>& places :
         {std::vector<std::string>{"--certificate", file, "-o", file}, {"--certificate", "-"}}) {
        std::vector<std::string> command = {"implicitize", "x = t", "y = t^2"};
        command.insert(command.end(), places.begin(), places.end());
        const ProcessResult result = run(command);
        EXPECT_EQ(result.status, 2);
        EXPECT_EQ(result.output, "");
        EXPECT_NE(result.errors.find("another place than that of the result"), std::string::npos);
    }
    EXPECT_TRUE(scratch.names().empty());
}

TEST(Verify, RelationsAreCertifiedOrTheReasonIsSaid) {
    const ProcessResult parabola =
        run_with_input({"verify", "-"}, certificate_of({"x = s", "y = t", "relation s^2 = t"}));
    EXPECT_EQ(parabola.status, 0);
    EXPECT_NE(parabola.output.find("lower degree"), std::string::npos);

    const ScratchDirectory scratch;
    const ProcessResult result =
        run({"implicitize", "x = s", "y = t", "relation s^2-s = 0", "relation t*(t-1)*(t-s) = 0",
             "--certificate", scratch.path("certificate")});
    EXPECT_EQ(result.output, "y^2-y\nx^2-x\n");
    EXPECT_NE(result.errors.find("no certificate was written: an equation"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(scratch.path("certificate")));
}

} // namespace
} // namespace eliminant::test
