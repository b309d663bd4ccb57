// Dependencies point one way. This test reads the #include lines of every source and fails on one that points
// up or across, that a public header takes from the private side, or that brings in a library nobody decided
// on.
#include "house/source_tree.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace eliminant::house {
namespace {

/// What each layer may include besides itself. The exact tower (groebner, ideal, implicit) and the numeric
/// one (field, scene, render) meet only in export and apps; render sees surfaces that answer queries, no
/// polynomials.
const std::map<std::string, std::set<std::string>> allowed_layers = {
    {"base", {}},
    {"algebra", {"base"}},
    {"groebner", {"base", "algebra"}},
    {"ideal", {"base", "algebra", "groebner"}},
    {"implicit", {"base", "algebra", "groebner", "ideal"}},
    {"field", {"base", "algebra"}},
    {"scene", {"base", "algebra", "field"}},
    {"render", {"base", "field", "scene"}},
    {"export", {"base", "algebra", "groebner", "ideal", "implicit", "field", "scene", "render"}},
    {"apps", {"base", "algebra", "groebner", "ideal", "implicit", "field", "scene", "render", "export"}},
};

/// The only headers of the library that are not the project's or the C++ standard's: single ones, and whole
/// libraries by the folder of their headers.
const std::set<std::string> allowed_foreign_headers = {"arm_neon.h",  "fcntl.h", "gmp.h",   "gmpxx.h",
                                                       "immintrin.h", "png.h",   "unistd.h"};
const std::set<std::string> allowed_foreign_libraries = {"boost/multiprecision", "glm", "tbb"};

bool is_allowed_foreign(const std::string& header) {
    return allowed_foreign_headers.contains(header) ||
           std::any_of(allowed_foreign_libraries.begin(), allowed_foreign_libraries.end(),
                       [&](const std::string& library) { return header.starts_with(library + "/"); });
}

/// The file that `include` of `file` names, as `layer/name`, or nothing if there is no such file of ours.
std::string resolve(const SourceFile& file, const Include& include, const std::set<std::string>& names) {
    const std::string project_prefix = "eliminant/";
    std::vector<std::string> candidates;
    if (include.name.starts_with(project_prefix))
        candidates.push_back(include.name.substr(project_prefix.size()));
    candidates.push_back(file.name.substr(0, file.name.rfind('/') + 1) + include.name);
    candidates.push_back(include.name);
    for (const std::string& candidate : candidates)
        if (names.contains(candidate)) return candidate;
    return {};
}

std::string layer_of(const std::string& name) {
    const std::string folder = name.substr(0, name.find('/'));
    return allowed_layers.contains(folder) ? folder : "apps";
}

/// What is wrong with the includes of `file`, one sentence each.
std::vector<std::string> violations(const SourceFile& file, const std::set<std::string>& public_names,
                                    const std::set<std::string>& names) {
    std::vector<std::string> found;
    for (const Include& include : includes_of(file.text)) {
        const auto complain = [&](const std::string& what) {
            found.push_back(file.name + ":" + std::to_string(include.line) + ": " + include.name + " " +
                            what);
        };
        if (!include.quoted) {
            const bool standard = include.name.find_first_of("./") == std::string::npos;
            if (file.layer != "apps" && !standard && !is_allowed_foreign(include.name))
                complain("is not among the headers the library may depend on");
            if (include.name.starts_with("eliminant/")) complain("is ours and is included with quotes");
            continue;
        }
        const std::string target = resolve(file, include, names);
        if (target.empty()) {
            complain("is no file of the project");
        } else {
            const std::string layer = layer_of(target);
            if (layer != file.layer && !allowed_layers.at(file.layer).contains(layer))
                complain("points from " + file.layer + " to " + layer);
            if (file.is_public && !public_names.contains(target))
                complain("is private and included by a public header");
        }
    }
    return found;
}

struct Names {
    std::set<std::string> all;
    std::set<std::string> of_public_headers;
};

Names names_of(const std::vector<SourceFile>& files) {
    Names names;
    for (const SourceFile& file : files) {
        names.all.insert(file.name);
        if (file.is_public) names.of_public_headers.insert(file.name);
    }
    return names;
}

TEST(Layers, EveryIncludePointsDown) {
    const std::vector<SourceFile> files = source_files();
    ASSERT_GT(files.size(), 5U) << "the sources were not found below " << ELIMINANT_SOURCE_DIR;
    const Names names = names_of(files);
    for (const SourceFile& file : files) {
        ASSERT_TRUE(allowed_layers.contains(file.layer)) << file.name << " is in no layer of the design";
        for (const std::string& violation : violations(file, names.of_public_headers, names.all))
            ADD_FAILURE() << violation;
    }
}

/// Everything that `name` includes, directly or not.
std::set<std::string> closure(const std::string& name, const std::vector<SourceFile>& files) {
    const Names names = names_of(files);
    std::set<std::string> reached;
    std::vector<std::string> open = {name};
    while (!open.empty()) {
        const std::string current = open.back();
        open.pop_back();
        for (const SourceFile& file : files) {
            if (file.name != current) continue;
            for (const Include& include : includes_of(file.text)) {
                const std::string target = resolve(file, include, names.all);
                if (!target.empty() && reached.insert(target).second) open.push_back(target);
            }
        }
    }
    return reached;
}

// A proof checked by the code that found it proves little: verify sees polynomials and the certificate, no
// engine.
TEST(Layers, VerifySeesOnlyAlgebraAndTheCertificate) {
    const std::vector<SourceFile> files = source_files();
    for (const SourceFile& file : files) {
        if (!file.name.starts_with("implicit/verify")) continue;
        for (const std::string& target : closure(file.name, files)) {
            const std::string layer = layer_of(target);
            EXPECT_TRUE(layer == "base" || layer == "algebra" || target.starts_with("implicit/certificate") ||
                        target.starts_with("implicit/verify"))
                << file.name << " reaches " << target;
        }
    }
}

// The test of the test: each kind of violation, in a tree made up for it.
TEST(Layers, ViolationsAreSeen) {
    const std::set<std::string> public_names = {"base/run.hpp", "groebner/basis.hpp", "field/field.hpp"};
    std::set<std::string> names = public_names;
    names.insert({"algebra/terms.hpp", "algebra/ring.hpp"});
    const auto count = [&](const SourceFile& file) { return violations(file, public_names, names).size(); };

    EXPECT_EQ(count({"algebra", "algebra/ring.cpp", false, "#include \"eliminant/base/run.hpp\"\n"}), 0U);
    EXPECT_EQ(count({"algebra", "algebra/ring.cpp", false, "#include \"terms.hpp\"\n#include <vector>\n"}),
              0U);
    EXPECT_EQ(count({"algebra", "algebra/ring.cpp", false, "#include \"algebra/terms.hpp\"\n"}), 0U);
    EXPECT_EQ(count({"algebra", "algebra/ring.cpp", false, "# include \"eliminant/groebner/basis.hpp\"\n"}),
              1U);
    EXPECT_EQ(count({"groebner", "groebner/f4.cpp", false, "#include \"eliminant/field/field.hpp\"\n"}), 1U);
    EXPECT_EQ(count({"algebra", "algebra/ring.hpp", true, "#include \"terms.hpp\"\n"}), 1U);
    EXPECT_EQ(count({"algebra", "algebra/ring.hpp", true, "#include \"missing.hpp\"\n"}), 1U);
    EXPECT_EQ(count({"algebra", "algebra/ring.cpp", false, "#include <flint/fmpz.h>\n"}), 1U);
    EXPECT_EQ(count({"apps", "eliminant/main.cpp", false, "#include <CLI/CLI.hpp>\n"}), 0U);
    EXPECT_EQ(count({"algebra", "algebra/ring.cpp", false, "#include <eliminant/base/run.hpp>\n"}), 2U);
}

} // namespace
} // namespace eliminant::house
