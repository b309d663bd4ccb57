/// \file
/// Many shapes in one text, and their implicit equations as they come.
#pragma once

#include "eliminant/implicit/implicitize.hpp"
#include "eliminant/implicit/parametrization.hpp"

#include <exception>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace eliminant::implicit {

/// The part of a text that holds one shape: formulas or a control net.
struct ShapeSource {
    std::string name; ///< empty if it has none
    base::SourceText text;
};

/// Takes a text apart:
///
///     patch lid            the name of the shape that follows
///     bezier 3 3           its control net, or formulas
///     …
///     patch rim
///     …
///
/// Without `patch` lines each control net is a shape, named by its number, counted from 1; a text with one
/// shape, or with formulas, is one source without a name. The shapes themselves are not read yet, so a fault
/// in one leaves the others alone.
///
/// \throws ParseError if a name is missing or given twice, or if something stands before the first one
/// \throws Stopped
std::vector<ShapeSource> shape_sources(const base::SourceText& source, base::Run& run);

/// A parametrization with a name.
struct Shape {
    std::string name;
    Parametrization parametrization;
};

/// Reads one shape, see parse_parametrization() and parse_control_net(). A spline of several pieces has the
/// name of each followed by its knot spans, as `wing[0,2]`.
/// \throws ParseError, Stopped
std::vector<Shape> parse_shapes(const ShapeSource& source, base::Run& run);

/// What became of one shape: a result, or the Error for which there is none.
struct ShapeResult {
    std::string name;
    std::optional<ImplicitResult> result;
    std::exception_ptr error;
    std::size_t coordinate_count = 0; ///< how many of the result's variables are not constants
};

/// Implicitizes all shapes, several at a time where there are threads, and passes each result on as soon as
/// it and all before it are there: in the sequence of the shapes, one call at a time, but from any thread. A
/// shape that cannot be read or treated has an error as its result.
/// \throws Stopped; what `sink` throws, which ends everything
void implicitize_shapes(std::span<const ShapeSource> sources, const ImplicitizeOptions& options,
                        base::Run& run, const std::function<void(const ShapeResult&)>& sink);

} // namespace eliminant::implicit

namespace eliminant {
using implicit::implicitize_shapes;
using implicit::parse_shapes;
using implicit::Shape;
using implicit::shape_sources;
using implicit::ShapeResult;
using implicit::ShapeSource;
} // namespace eliminant
