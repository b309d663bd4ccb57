/// \file
/// Results as text in the format that was asked for.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"
#include "eliminant/groebner/buchberger.hpp"
#include "eliminant/ideal/ideal.hpp"

#include "session.hpp"

#include <nlohmann/json.hpp>

#include <span>
#include <string>
#include <string_view>

namespace eliminant::app {

/// Fields appear in the order in which they are set, which is the documented one.
using Json = nlohmann::ordered_json;

/// For results that are no polynomials. \throws UsageError if another format was asked for
void require_text_or_json(const Session& session);

/// On one line.
std::string to_text(const Json& json);

/// The polynomials as strings in text format.
Json strings(std::span<const Polynomial> polynomials, const Run& run);

/// `{"variables": …, "field": …, "order": …}`, to which results are added.
Json ring_fields(const Ring& ring);

/// Generators of an ideal, in text a line each, `0` for none; otherwise with what the other system must be
/// told of their ring. Not for JSON.
std::string ideal_in(ResultFormat format, const Ring& ring, std::span<const Polynomial> generators, Run& run);

/// A polynomial on its own, in the same way.
std::string polynomial_in(ResultFormat format, const Polynomial& f, const Run& run);

/// A comment in the syntax of the format, a line. Not for JSON.
std::string comment_in(ResultFormat format, const std::string& text);

/// `NAME = FORMULA`, a line, without the ring. Not for JSON.
std::string assignment_in(ResultFormat format, const std::string& name, const Polynomial& value,
                          const Run& run);

/// An ideal by its reduced Groebner basis in the order of its ring.
std::string ideal_in(ResultFormat format, const Ideal& I, Run& run);

/// The matrices of F4, a line each, under a line that explains the columns; for --verbose.
std::vector<std::string> matrix_table(std::span<const groebner::MatrixStatistics> matrices);

/// What a basis computation did, for --verbose.
std::string statistics_line(const groebner::Statistics& statistics, double seconds);

} // namespace eliminant::app
