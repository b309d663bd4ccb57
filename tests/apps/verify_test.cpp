// Certificates of the program.
#include "program.hpp"

#include <nlohmann/json.hpp>

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

TEST(Verify, EveryChangedValueIsRejected) {
    const Json original = Json::parse(certificate_of({"x = 2*t^2/(t+1)", "y = t^3"}));
    const Json flat = original.flatten();
    EXPECT_GT(flat.size(), 25U);
    for (const auto& [path, value] : flat.items()) {
        Json changed = original;
        Json& place = changed[Json::json_pointer(path)];
        if (value.is_number())
            place = value.get<std::uint64_t>() + 1;
        else if (value.is_string())
            place = value.get<std::string>() + "1";
        else
            place = "1";
        const int status = run_with_input({"verify", "-"}, changed.dump()).status;
        EXPECT_TRUE(status == 1 || status == 2) << path << ": " << status;
    }
    Json longer = original;
    longer["claims"]["more"] = 1;
    EXPECT_EQ(run_with_input({"verify", "-"}, longer.dump()).status, 2);
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

TEST(Verify, NoCertificateIsWrittenForRelations) {
    const ScratchDirectory scratch;
    const ProcessResult result = run(
        {"implicitize", "x = s", "y = t", "relation s^2 = t", "--certificate", scratch.path("certificate")});
    EXPECT_EQ(result.output, "x^2-y\n");
    EXPECT_NE(result.errors.find("no certificate"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists(scratch.path("certificate")));
}

} // namespace
} // namespace eliminant::test
