#include "names.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace eliminant::exporting {

namespace {

using Words = std::span<const std::string_view>;

// Words that cannot be, or should not be, variables: keywords, constants, and the commands most used.
constexpr std::array<std::string_view, 62> singular_words = {
    "def",    "bigint",   "ideal",     "int",       "intmat",   "intvec", "link",  "list",       "map",
    "matrix", "module",   "number",    "package",   "poly",     "proc",   "qring", "resolution", "ring",
    "string", "vector",   "if",        "else",      "for",      "while",  "break", "continue",   "return",
    "export", "quit",     "exit",      "LIB",       "and",      "or",     "not",   "div",        "mod",
    "std",    "groebner", "dim",       "deg",       "size",     "lead",   "gcd",   "det",        "rank",
    "jacob",  "reduce",   "eliminate", "intersect", "quotient", "res",    "vdim",  "mult",       "hilb",
    "trace",  "minor",    "coef",      "var",       "par",      "short",  "QQ",    "ZZ"};
constexpr std::array<std::string_view, 43> macaulay2_words = {
    "and",  "break",  "catch", "continue", "do",   "elapsedTime", "else", "false", "for", "from",   "global",
    "if",   "in",     "list",  "local",    "new",  "not",         "null", "of",    "or",  "return", "shield",
    "step", "symbol", "then",  "throw",    "time", "timing",      "to",   "true",  "try", "when",   "while",
    "xor",  "ideal",  "ring",  "pi",       "ii",   "QQ",          "ZZ",   "RR",    "CC",  "GF"};
constexpr std::array<std::string_view, 48> sage_words = {
    "False",     "None",     "True",  "and",    "as",   "assert", "async",  "await",    "break",
    "class",     "continue", "def",   "del",    "elif", "else",   "except", "finally",  "for",
    "from",      "global",   "if",    "import", "in",   "is",     "lambda", "nonlocal", "not",
    "or",        "pass",     "raise", "return", "try",  "while",  "with",   "yield",    "print",
    "exec",      "QQ",       "ZZ",    "GF",     "RR",   "CC",     "pi",     "I",        "PolynomialRing",
    "TermOrder", "matrix",   "R"};
constexpr std::array<std::string_view, 62> maple_words = {
    "I",        "Pi",       "D",         "O",     "gamma",  "Gamma",  "Zeta",    "Beta",  "Catalan",
    "infinity", "true",     "false",     "FAIL",  "NULL",   "and",    "or",      "not",   "xor",
    "implies",  "union",    "intersect", "minus", "subset", "in",     "mod",     "if",    "then",
    "elif",     "else",     "fi",        "for",   "from",   "by",     "to",      "while", "do",
    "od",       "end",      "proc",      "local", "global", "option", "options", "error", "return",
    "try",      "catch",    "finally",   "use",   "module", "export", "quit",    "stop",  "next",
    "break",    "assuming", "done",      "read",  "save",   "list",   "set",     "norm"};

Words reserved_words(Format format) {
    switch (format) {
    case Format::singular:
        return singular_words;
    case Format::macaulay2:
        return macaulay2_words;
    case Format::sage:
        return sage_words;
    case Format::maple:
        return maple_words;
    default:
        return {};
    }
}

/// What declared() defines.
Words declared_names(Format format) {
    static constexpr std::array<std::string_view, 3> singular = {"r", "f", "I"};
    static constexpr std::array<std::string_view, 3> others = {"R", "f", "I"};
    static constexpr std::array<std::string_view, 3> maple = {"F", "f", "T"};
    switch (format) {
    case Format::singular:
        return singular;
    case Format::macaulay2:
    case Format::sage:
        return others;
    case Format::maple:
        return maple;
    default:
        return {};
    }
}

constexpr std::array<std::string_view, 34> greek = {
    "alpha",   "beta",   "gamma", "delta",   "epsilon", "zeta",  "eta",   "theta", "iota",
    "kappa",   "lambda", "mu",    "nu",      "xi",      "pi",    "rho",   "sigma", "tau",
    "upsilon", "phi",    "chi",   "psi",     "omega",   "Gamma", "Delta", "Theta", "Lambda",
    "Xi",      "Pi",     "Sigma", "Upsilon", "Phi",     "Psi",   "Omega"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string escaped(std::string_view name) {
    std::string text;
    for (const char c : name) text.append(c == '_' ? "\\" : "").push_back(c);
    return text;
}

} // namespace

std::vector<std::string> legal_names(const algebra::Ring& ring, Format format) {
    std::set<std::string, std::less<>> taken;
    for (const Words words : {reserved_words(format), declared_names(format)})
        taken.insert(words.begin(), words.end());
    std::vector<std::string> names = ring.names();
    std::vector<std::size_t> to_replace;
    for (std::size_t i = 0; i < names.size(); ++i) {
        // A name that can stay as it is goes before all that are made up.
        const bool is_writable = format != Format::macaulay2 || names[i].find('_') == std::string::npos;
        if (!is_writable || !taken.insert(names[i]).second) to_replace.push_back(i);
    }
    for (const std::size_t i : to_replace) {
        std::erase(names[i], '_');
        while (!taken.insert(names[i]).second) names[i].push_back('v');
    }
    return names;
}

std::string latex_name(std::string_view name) {
    const std::size_t underscore = std::min(name.find('_'), name.size());
    std::size_t stem_end = underscore;
    if (underscore == name.size()) {
        while (is_digit(name[stem_end - 1])) --stem_end; // a name begins with a letter
    }
    const std::string_view stem = name.substr(0, stem_end);
    std::string_view index = name.substr(stem_end);
    if (index.starts_with('_')) index.remove_prefix(1);
    std::string text;
    if (std::ranges::find(greek, stem) != greek.end())
        text.append("\\").append(stem);
    else if (stem.size() == 1)
        text.append(stem);
    else
        text.append("\\mathrm{").append(escaped(stem)).append("}");
    if (index.empty()) return text;
    const bool is_number = std::ranges::all_of(index, is_digit);
    return text.append(is_number || index.size() == 1 ? "_{" : "_{\\mathrm{")
        .append(escaped(index))
        .append(is_number || index.size() == 1 ? "}" : "}}");
}

std::vector<std::string> latex_names(const algebra::Ring& ring) {
    std::vector<std::string> names;
    for (const std::string& name : ring.names()) names.push_back(latex_name(name));
    std::vector<std::string> result = names;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (std::ranges::count(names, names[i]) > 1)
            result[i] = std::string("\\mathtt{").append(escaped(ring.names()[i])).append("}");
    }
    return result;
}

} // namespace eliminant::exporting
