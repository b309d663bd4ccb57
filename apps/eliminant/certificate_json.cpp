#include "certificate_json.hpp"

#include "results.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace eliminant::app {

namespace {

struct TheoremName {
    Theorem theorem;
    std::string_view name;
};

constexpr std::array theorem_names = {
    TheoremName{Theorem::hypersurface, "hypersurface"},
    TheoremName{Theorem::toric, "toric"},
    TheoremName{Theorem::dense, "dense"},
    TheoremName{Theorem::elimination, "elimination"},
};

std::string hexadecimal(std::uint64_t number) {
    std::array<char, 16> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number, 16).ptr;
    return {digits.data(), end};
}

Json json_of(const Claims& claims) {
    const auto named = [&](const TheoremName& entry) { return entry.theorem == claims.theorem; };
    Json result;
    result["theorem"] = std::ranges::find_if(theorem_names, named)->name;
    result["codimension"] = claims.codimension;
    result["degrees"] = claims.degrees;
    if (claims.domain) {
        result["domain"] = {{"weights", claims.domain->weights},
                            {"prime", claims.domain->prime},
                            {"rank", claims.domain->rank},
                            {"points", claims.domain->points}};
        return result;
    }
    result["vanishing"] = Json::array();
    for (const VanishingClaim& claim : claims.vanishing)
        result["vanishing"].push_back({{"degrees", claim.degrees},
                                       {"total_degree", claim.total_degree},
                                       {"height", claim.height.get_str()},
                                       {"primes", claim.primes}});
    result["rank"] = {{"prime", claims.rank.prime},
                      {"point", claims.rank.point},
                      {"rank", claims.rank.rank},
                      {"minor", claims.rank.minor}};
    if (claims.irreducible)
        result["irreducible"] = {{"prime", claims.irreducible->prime},
                                 {"base", claims.irreducible->base},
                                 {"direction", claims.irreducible->direction},
                                 {"section", claims.irreducible->section}};
    return result;
}

/// Reads values of a certificate by their path, and complains of it by that name.
class Reader {
  public:
    Reader(const Json& json, std::string path) : json_(json), path_(std::move(path)) {
        if (!json_.is_object()) fail("an object");
    }

    Reader object(const char* key) const { return {member(key), path_ + "." + key}; }
    bool has(const char* key) const { return json_.contains(key); }
    void only(std::initializer_list<const char*> keys) const {
        for (const auto& [key, value] : json_.items())
            if (std::ranges::find(keys, key) == keys.end())
                throw DomainError("certificate: " + path_ + " has an unknown member " + key);
    }

    std::string text(const char* key) const {
        if (!member(key).is_string()) fail("a text", key);
        return member(key).get<std::string>();
    }
    std::vector<std::string> texts(const char* key) const {
        return list<std::string>(key, "a list of texts", [](const Json& j) { return j.is_string(); });
    }
    std::vector<std::pair<std::string, std::string>> pairs(const char* key) const {
        return list<std::pair<std::string, std::string>>(key, "a list of pairs of texts", [](const Json& j) {
            return j.is_array() && j.size() == 2 && j[0].is_string() && j[1].is_string();
        });
    }
    template <class T>
    T number(const char* key) const {
        if (!is_number<T>(member(key))) fail("a natural number", key);
        return member(key).get<T>();
    }
    template <class T>
    std::vector<T> numbers(const char* key) const {
        return list<T>(key, "a list of natural numbers", is_number<T>);
    }
    std::vector<std::vector<std::uint32_t>> points(const char* key) const {
        return list<std::vector<std::uint32_t>>(key, "a list of lists of natural numbers", [](const Json& j) {
            return j.is_array() && std::ranges::all_of(j, is_number<std::uint32_t>);
        });
    }
    template <class F>
    void for_each(const char* key, const F& visit) const {
        const Json& all = member(key);
        if (!all.is_array()) fail("a list", key);
        for (const Json& element : all) visit(Reader(element, path_ + "." + key));
    }
    [[noreturn]] void fail(const std::string& expected, const char* key = nullptr) const {
        throw DomainError("certificate: " + path_ + (key == nullptr ? "" : std::string(".") + key) +
                          ": expected " + expected);
    }

  private:
    template <class T>
    static bool is_number(const Json& json) {
        return json.is_number_unsigned() && json.get<std::uint64_t>() <= std::numeric_limits<T>::max();
    }
    template <class T, class Test>
    std::vector<T> list(const char* key, const char* expected, const Test& fits) const {
        const Json& all = member(key);
        if (!all.is_array() || !std::ranges::all_of(all, fits)) fail(expected, key);
        return all.get<std::vector<T>>();
    }
    const Json& member(const char* key) const {
        const auto found = json_.find(key);
        if (found == json_.end()) fail("a member of this name", key);
        return *found;
    }

    const Json& json_;
    std::string path_;
};

CertificateInput read_input(const Reader& reader) {
    reader.only({"parameters", "constants", "angles", "relations", "coordinates"});
    return {reader.texts("parameters"), reader.texts("constants"), reader.pairs("angles"),
            reader.texts("relations"), reader.pairs("coordinates")};
}

VanishingClaim read_vanishing(const Reader& reader) {
    reader.only({"degrees", "total_degree", "height", "primes"});
    VanishingClaim claim;
    claim.degrees = reader.numbers<std::uint64_t>("degrees");
    claim.total_degree = reader.number<std::uint64_t>("total_degree");
    const std::string height = reader.text("height");
    if (height.empty() || height.find_first_not_of("0123456789") != std::string::npos)
        reader.fail("a text of decimal digits", "height");
    claim.height = mpz_class(height);
    claim.primes = reader.numbers<std::uint64_t>("primes");
    return claim;
}

Claims read_claims(const Reader& reader) {
    const bool has_domain = reader.has("domain");
    if (has_domain)
        reader.only({"theorem", "codimension", "degrees", "domain"});
    else
        reader.only({"theorem", "codimension", "degrees", "vanishing", "rank", "irreducible"});
    Claims claims;
    const std::string theorem = reader.text("theorem");
    const auto* named = std::ranges::find(theorem_names, theorem, &TheoremName::name);
    if (named == theorem_names.end()) reader.fail("hypersurface, toric, dense or elimination", "theorem");
    claims.theorem = named->theorem;
    claims.codimension = reader.number<std::uint64_t>("codimension");
    claims.degrees = reader.numbers<std::uint64_t>("degrees");
    if (has_domain) {
        const Reader domain = reader.object("domain");
        domain.only({"weights", "prime", "rank", "points"});
        claims.domain = {domain.numbers<std::uint64_t>("weights"), domain.number<std::uint64_t>("prime"),
                         domain.number<std::uint64_t>("rank"), domain.points("points")};
        return claims;
    }
    reader.for_each("vanishing",
                    [&](const Reader& element) { claims.vanishing.push_back(read_vanishing(element)); });
    const Reader rank = reader.object("rank");
    rank.only({"prime", "point", "rank", "minor"});
    claims.rank = {rank.number<std::uint64_t>("prime"), rank.numbers<std::uint32_t>("point"),
                   rank.number<std::uint64_t>("rank"), rank.number<std::uint32_t>("minor")};
    if (!reader.has("irreducible")) return claims;
    const Reader section = reader.object("irreducible");
    section.only({"prime", "base", "direction", "section"});
    claims.irreducible = {section.number<std::uint64_t>("prime"), section.numbers<std::uint32_t>("base"),
                          section.numbers<std::uint32_t>("direction"),
                          section.numbers<std::uint32_t>("section")};
    return claims;
}

Json parsed(const SourceText& source) {
    try {
        return Json::parse(source.text());
    } catch (const Json::parse_error& error) {
        const std::size_t offset = error.byte == 0 ? 0 : error.byte - 1;
        source.fail(std::min(offset, source.text().size()), "JSON");
    }
}

} // namespace

std::string certificate_to_json(const Certificate& certificate) {
    const CertificateInput& input = certificate.input;
    Json json;
    json["input"] = {{"parameters", input.parameters},
                     {"constants", input.constants},
                     {"angles", input.angles},
                     {"relations", input.relations},
                     {"coordinates", input.coordinates}};
    json["equations"] = certificate.equations;
    json["claims"] = json_of(certificate.claims);
    json["digest"] = hexadecimal(digest(certificate));
    return to_text(json);
}

CertificateText certificate_from_json(const SourceText& source) {
    const Json json = parsed(source);
    const Reader reader(json, "the file");
    reader.only({"input", "equations", "claims", "digest"});
    CertificateText result{
        {read_input(reader.object("input")), reader.texts("equations"), read_claims(reader.object("claims"))},
        false};
    result.digest_matches = reader.text("digest") == hexadecimal(digest(result.certificate));
    return result;
}

} // namespace eliminant::app
