#include "results.hpp"

#include "eliminant/algebra/print.hpp"
#include "eliminant/export/formats.hpp"

#include <array>
#include <cstdio>

namespace eliminant::app {

namespace {

exporting::Format syntax(ResultFormat format) {
    switch (format) {
    case ResultFormat::latex:
        return exporting::Format::latex;
    case ResultFormat::singular:
        return exporting::Format::singular;
    case ResultFormat::macaulay2:
        return exporting::Format::macaulay2;
    case ResultFormat::sage:
        return exporting::Format::sage;
    case ResultFormat::maple:
        return exporting::Format::maple;
    case ResultFormat::text:
    case ResultFormat::json:
        break; // whose polynomials are strings of text
    }
    return exporting::Format::text;
}

} // namespace

void require_text_or_json(const Session& session) {
    if (session.format() != ResultFormat::text && session.format() != ResultFormat::json)
        throw UsageError("--format: expected text or json, as the result is no polynomial");
}

std::string to_text(const Json& json) { return json.dump() + "\n"; }

Json strings(std::span<const Polynomial> polynomials, const Run& run) {
    Json list = Json::array();
    for (const Polynomial& f : polynomials) list.push_back(to_string(f, run));
    return list;
}

Json ring_fields(const Ring& ring) {
    return {{"variables", ring.names()},
            {"field", ring.field().to_string()},
            {"order", ring.order().to_string(ring.names())}};
}

std::string ideal_in(ResultFormat format, const Ring& ring, std::span<const Polynomial> generators,
                     Run& run) {
    if (generators.empty() && format == ResultFormat::text) return "0\n";
    return declared(ring, generators, syntax(format), run);
}

std::string polynomial_in(ResultFormat format, const Polynomial& f, const Run& run) {
    return declared(f, syntax(format), run);
}

std::string comment_in(ResultFormat format, const std::string& text) {
    std::string_view sign = "# ";
    if (format == ResultFormat::latex) sign = "% ";
    if (format == ResultFormat::singular) sign = "// ";
    if (format == ResultFormat::macaulay2) sign = "-- ";
    return std::string(sign).append(text).append("\n");
}

std::string assignment_in(ResultFormat format, const std::string& name, const Polynomial& value,
                          const Run& run) {
    const std::string text = formula(value, syntax(format), run);
    switch (format) {
    case ResultFormat::singular:
        return "poly " + name + " = " + text + ";\n";
    case ResultFormat::maple:
        return name + " := " + text + ";\n";
    default:
        return name + " = " + text + "\n";
    }
}

std::string ideal_in(ResultFormat format, const Ideal& I, Run& run) {
    const std::vector<Polynomial>& basis = I.groebner_basis(run);
    if (format != ResultFormat::json) return ideal_in(format, I.ring(), basis, run);
    Json result = ring_fields(I.ring());
    result["basis"] = strings(basis, run);
    return to_text(result);
}

std::vector<std::string> matrix_table(std::span<const groebner::MatrixStatistics> matrices) {
    if (matrices.empty()) return {};
    const auto line = [](const std::array<std::string, 8>& cells) {
        std::string text;
        for (const std::string& cell : cells) {
            constexpr std::size_t width = 9;
            text.append(cell.size() < width ? width - cell.size() : 1, ' ').append(cell);
        }
        return text;
    };
    std::vector<std::string> lines{
        "matrices of F4, one for each batch of pairs. degree: the largest of its pairs; pairs: reduced "
        "together "
        "(and generators); rows: those to be reduced and those they are reduced by; columns: monomials; "
        "density: share of entries that are not 0; new: elements of the basis found; zero: pairs that gave "
        "none",
        line({"matrix", "degree", "pairs", "rows", "columns", "density", "new", "zero"})};
    for (std::size_t i = 0; i < matrices.size(); ++i) {
        const groebner::MatrixStatistics& matrix = matrices[i];
        std::array<char, 16> percent{};
        std::snprintf(percent.data(), percent.size(), "%.2f%%", 100 * matrix.density());
        lines.push_back(
            line({std::to_string(i + 1), std::to_string(matrix.degree), std::to_string(matrix.pairs),
                  std::to_string(matrix.rows), std::to_string(matrix.columns), percent.data(),
                  std::to_string(matrix.new_elements), std::to_string(matrix.zero_reductions)}));
    }
    return lines;
}

std::string statistics_line(const groebner::Statistics& statistics, double seconds) {
    const auto count = [](std::uint64_t number) { return std::to_string(number); };
    std::string matrices;
    if (const auto* const largest = statistics.largest_matrix())
        matrices = "; matrices: " + count(statistics.matrices.size()) + ", the largest " +
                   count(largest->rows) + " x " + count(largest->columns) + " with " +
                   count(largest->entries) + " entries";
    if (statistics.primes != 0) matrices += "; primes: " + count(statistics.primes);
    return "pairs treated: " + count(statistics.pairs_treated) +
           "; skipped by the product criterion: " + count(statistics.skipped_by_product) +
           ", by chain criterion M: " + count(statistics.skipped_by_chain_m) +
           ", F: " + count(statistics.skipped_by_chain_f) + ", B: " + count(statistics.skipped_by_chain_b) +
           "; zero reductions: " + count(statistics.zero_reductions) + matrices +
           "; seconds: " + std::to_string(seconds) + "; peak memory: " + count(peak_memory() >> 20) + " MiB";
}

} // namespace eliminant::app
