// The project's own sources as data, for the tests that read them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace eliminant::house {

struct SourceFile {
    std::string layer;      ///< `algebra`; `apps` for what is in apps/ and for include/eliminant/x.hpp
    std::string name;       ///< `algebra/ring.hpp`: the path below include/eliminant/, src/ or apps/
    bool is_public = false; ///< lives below include/
    std::string text;
};

struct Include {
    std::size_t line = 0;
    bool quoted = false; ///< "name", not <name>
    std::string name;
};

inline std::vector<Include> includes_of(const std::string& text) {
    static const std::regex pattern(R"re(^\s*#\s*include\s*([<"])([^>"]+)[>"])re");
    std::vector<Include> includes;
    std::istringstream lines(text);
    std::string line;
    for (std::size_t number = 1; std::getline(lines, line); ++number) {
        std::smatch match;
        if (std::regex_search(line, match, pattern)) includes.push_back({number, match[1] == "\"", match[2]});
    }
    return includes;
}

/// The text with comments and the contents of literals blanked, line breaks kept. (Raw strings are not
/// understood.)
inline std::string code_of(std::string text) {
    const auto blank = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < std::min(to, text.size()); ++i)
            if (text[i] != '\n') text[i] = ' ';
        return to;
    };
    const auto past = [&](std::string_view end, std::size_t from) {
        const std::size_t at = text.find(end, from);
        return at == std::string::npos ? text.size() : at + end.size();
    };
    const auto literal_end = [&](std::size_t quote) {
        std::size_t i = quote + 1;
        while (i < text.size() && text[i] != text[quote] && text[i] != '\n') i += text[i] == '\\' ? 2 : 1;
        return i + 1;
    };
    const auto digit_separator = [&](std::size_t i) {
        return i > 0 && std::isalnum(static_cast<unsigned char>(text[i - 1])) != 0;
    };
    for (std::size_t i = 0; i < text.size();) {
        if (text.compare(i, 2, "//") == 0)
            i = blank(i, past("\n", i));
        else if (text.compare(i, 2, "/*") == 0)
            i = blank(i, past("*/", i + 2));
        else if (text[i] == '"' || (text[i] == '\'' && !digit_separator(i)))
            i = blank(i, literal_end(i));
        else
            ++i;
    }
    return text;
}

inline std::string text_of(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    EXPECT_TRUE(file) << "cannot read " << path;
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Every header and source below include/, src/ and apps/.
inline std::vector<SourceFile> source_files() {
    namespace fs = std::filesystem;
    const fs::path root = ELIMINANT_SOURCE_DIR;
    std::vector<SourceFile> files;
    for (const char* folder : {"include/eliminant", "src", "apps"}) {
        for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
            const std::string extension = entry.path().extension().string();
            if (extension != ".hpp" && extension != ".cpp") continue;
            const std::string name = fs::relative(entry.path(), root / folder).generic_string();
            const bool is_app = folder == std::string("apps") || name.find('/') == std::string::npos;
            files.push_back({is_app ? "apps" : name.substr(0, name.find('/')), name,
                             folder == std::string("include/eliminant"), text_of(entry.path())});
        }
    }
    return files;
}

} // namespace eliminant::house
