/// \file
/// `eliminant implicitize`.
#include "certificate_json.hpp"
#include "command.hpp"
#include "input.hpp"
#include "results.hpp"

#include "eliminant/algebra/coefficients.hpp"
#include "eliminant/algebra/parse.hpp"
#include "eliminant/implicit/batch.hpp"
#include "eliminant/implicit/certify.hpp"

#include <algorithm>
#include <exception>
#include <optional>

namespace eliminant::app {

namespace {

/// The shapes that a text is taken apart into.
std::vector<ShapeSource> sources_of(const Input& input, Run& run) {
    return shape_sources(SourceText(input.parts.front().text, input.parts.front().name), run);
}

/// The only shape of an input that gives it no name; nullopt for a batch. Several arguments are the
/// statements of one.
std::optional<Parametrization> single_shape(const Input& input, Run& run) {
    if (input.parts.size() > 1) {
        std::vector<SourceText> statements;
        for (const Input::Part& part : input.parts) statements.emplace_back(part.text, part.name);
        return parse_parametrization(statements, run);
    }
    const std::vector<ShapeSource> sources = sources_of(input, run);
    if (sources.size() > 1 || !sources.front().name.empty()) return std::nullopt;
    std::vector<Shape> shapes = parse_shapes(sources.front(), run);
    if (shapes.size() > 1) return std::nullopt;
    return std::move(shapes.front().parametrization);
}

std::vector<std::string> coordinate_names(const Parametrization& parametrization) {
    std::vector<std::string> names;
    for (const Coordinate& coordinate : parametrization.coordinates()) names.push_back(coordinate.name);
    return names;
}

/// The coordinates of the first shape of a batch that can be read.
std::vector<std::string> first_coordinate_names(std::span<const ShapeSource> sources, Run& run) {
    for (const ShapeSource& source : sources) {
        try {
            return coordinate_names(parse_shapes(source, run).front().parametrization);
        } catch (const ParseError&) { // it is reported when it is this shape's turn
            continue;
        }
    }
    return {};
}

/// Decimal digits of the largest coefficient; 0 if there is none.
std::size_t largest_coefficient_digits(std::span<const Polynomial> equations) {
    Integer largest;
    for (const Polynomial& f : equations)
        for (const Integer& coefficient : f.integer_terms().coefficients)
            if (compare_magnitude(coefficient, largest) > 0) largest = abs(coefficient);
    return largest.is_zero() ? 0 : largest.to_string().size();
}

/// A number for one equation, otherwise a list.
Json one_or_list(std::vector<std::uint64_t> numbers) {
    if (numbers.size() == 1) return numbers.front();
    return numbers;
}

/// Adds what was found to a report.
void describe_in_json(Json& report, const ImplicitResult& result, std::size_t coordinates, Session& session) {
    std::vector<std::uint64_t> degrees;
    std::vector<std::uint64_t> terms;
    for (const Polynomial& f : result.equations) {
        degrees.push_back(algebra::degree_in_first(f, coordinates)); // constants are elements of the field
        terms.push_back(f.size());
    }
    report["variables"] = result.ring.names();
    report["equations"] = strings(result.equations, session.run());
    report["codimension"] = result.codimension;
    report["degree"] = one_or_list(std::move(degrees));
    report["terms"] = one_or_list(std::move(terms));
    report["max_coefficient_digits"] = largest_coefficient_digits(result.equations);
    report["method"] = to_string(result.method);
    report["assurance"] = to_string(result.assurance);
    report["parametrization_degree"] = nullptr;
    if (result.parametrization_degree) report["parametrization_degree"] = *result.parametrization_degree;
    report["seconds"] = session.seconds();
}

/// A polynomial for a hypersurface and, being 0, for a dense image; otherwise an ideal.
std::string equations_in(const ImplicitResult& result, Session& session) {
    if (result.equations.size() > 1)
        return ideal_in(session.format(), result.ring, result.equations, session.run());
    return polynomial_in(session.format(),
                         result.equations.empty() ? Polynomial(result.ring) : result.equations.front(),
                         session.run());
}

class ImplicitizeCommand : public Command {
  public:
    std::string_view usage() const override { return "[FILE | - | 'x = …' 'y = …' …]"; }

    std::string_view description() const override {
        return "The exact implicit equation of the closure of the image of a parametrization: one primitive "
               "integer\n"
               "polynomial for a hypersurface; the reduced Groebner basis of its ideal, one polynomial a "
               "line, if the\n"
               "image has higher codimension; 0 if it is dense.\n"
               "\n"
               "A file holds a statement a line; on the command line each argument is one:\n"
               "  x = (1-t^2)/(1+t^2)      a coordinate as a rational function\n"
               "  parameters s, t          optional; otherwise all names on the right-hand sides that are "
               "neither\n"
               "                           coordinates nor constants\n"
               "  constants r              elements of the coefficient field, kept as symbols\n"
               "  relation u^2+v^2 = 1     an equation that the parameters satisfy\n"
               "  # …                      a comment\n"
               "cos(k*u) and sin(k*u) of a parameter u and an integer k are allowed and treated exactly.\n"
               "\n"
               "Instead of formulas a file may hold a control net: a first line\n"
               "  bezier 3 3               degrees, one for a curve; also rational bezier, bspline, nurbs\n"
               "  triangle 3               a triangular Bézier patch; also rational triangle\n"
               "then for bspline and nurbs a line 'knots 0 0 0 1 2 2 2' a degree, then a control point a "
               "line, those\n"
               "along the last degree first; points of rational nets and nurbs end with their weight.\n"
               "Several shapes in a file, each behind a line 'patch NAME', or several nets, are a batch: "
               "each result is\n"
               "printed when it is there, behind a comment with the name (in JSON an object a line); the "
               "exit status is\n"
               "2 if one of them failed. A spline has a result for each of its polynomial pieces.\n"
               "\n"
               "Examples:\n"
               "  eliminant implicitize 'x = (1-t^2)/(1+t^2)' 'y = 2t/(1+t^2)'\n"
               "  eliminant implicitize --format json 'constants R, r' 'x = (R+r*cos(u))*cos(v)' "
               "'y = (R+r*cos(u))*sin(v)' 'z = r*sin(u)'\n"
               "  eliminant implicitize data/teapot/teapot.net\n";
    }

    void declare(OptionSet& options) override {
        options.choice<Method>("method", "how it is computed (default auto)",
                               {{"auto", Method::automatic},
                                {"groebner", Method::groebner},
                                {"linear", Method::linear},
                                {"resultant", Method::resultant}},
                               method_);
        options.value("order", 0, "ORDER",
                      "order of the basis when there are several equations: lex, deglex,\n"
                      "degrevlex (default), weight(w1,…;lex|revlex), elim(x,y) or matrix(1,1;0,-1)",
                      [this](std::string_view text) { order_ = text; });
        options.choice<Assurance>("assurance", "how sure the result must be at least (default proved)",
                                  {{"proved", Assurance::proved}, {"probable", Assurance::probable}},
                                  assurance_);
        options.value("certificate", 0, "FILE", "write a certificate that `eliminant verify` checks",
                      [this](std::string_view text) { certificate_ = text; });
    }

    ExitStatus run(std::span<const std::string> operands, Session& session) override {
        ImplicitizeOptions options;
        options.method = method_;
        options.assurance = assurance_;
        options.parametrization_degree = session.format() == ResultFormat::json;
        const Input input = input_of(operands, looks_like_equation, session.run());
        const auto parametrization = single_shape(input, session.run());
        if (!parametrization) return run_batch(sources_of(input, session.run()), options, session);
        const std::vector<std::string> coordinates = coordinate_names(*parametrization);
        if (order_) options.order = parse_order(SourceText(*order_, "--order"), coordinates);

        std::optional<Destination> certificate;
        if (certificate_) certificate = session.destination_beside_result("--certificate", *certificate_);
        const ImplicitResult result = implicitize(*parametrization, options, session.run());
        describe(result, "", session);
        if (certificate) write_certificate(*certificate, *parametrization, result, session);
        if (session.format() == ResultFormat::json) {
            Json report;
            describe_in_json(report, result, coordinates.size(), session);
            session.write_result(to_text(report));
        } else {
            session.write_result(equations_in(result, session));
        }
        return exit_done;
    }

  private:
    static void write_certificate(const Destination& file, const Parametrization& parametrization,
                                  const ImplicitResult& result, Session& session) {
        const Certified certified = certify(parametrization, result, session.run());
        if (certified.certificate)
            file.write(certificate_to_json(*certified.certificate), session.run());
        else
            session.console().warning("no certificate was written: " + certified.reason);
    }

    /// Results are printed as they come, errors named and passed over.
    ExitStatus run_batch(std::span<const ShapeSource> sources, ImplicitizeOptions options, Session& session) {
        if (certificate_) throw UsageError("--certificate", "an input of one shape", "a batch");
        if (order_)
            options.order =
                parse_order(SourceText(*order_, "--order"), first_coordinate_names(sources, session.run()));
        ExitStatus status = exit_done;
        OutputStream output = session.open_result();
        implicitize_shapes(sources, options, session.run(), [&](const ShapeResult& shape) {
            if (!shape.result) status = exit_usage;
            const std::string report = shape.result ? found(shape, session) : failed(shape, session);
            session.console().clear_progress();
            output.write(report);
        });
        output.finish();
        return status;
    }

    static std::string found(const ShapeResult& shape, Session& session) {
        describe(*shape.result, shape.name + ": ", session);
        if (session.format() != ResultFormat::json)
            return comment_in(session.format(), shape.name) + equations_in(*shape.result, session);
        Json report;
        report["name"] = shape.name;
        describe_in_json(report, *shape.result, shape.coordinate_count, session);
        return to_text(report);
    }

    static std::string failed(const ShapeResult& shape, Session& session) {
        std::string message;
        try {
            std::rethrow_exception(shape.error);
        } catch (const ParseError& error) {
            session.console().error(error);
            message = error.what();
        } catch (const Error& error) {
            message = error.what();
            session.console().error(shape.name + ": " + message);
        }
        if (session.format() != ResultFormat::json) return {};
        Json report;
        report["name"] = shape.name;
        report["error"] = message;
        return to_text(report);
    }

    /// \param prefix of what is said, where there are several results
    static void describe(const ImplicitResult& result, const std::string& prefix, Session& session) {
        Console& console = session.console();
        for (const std::string& warning : result.warnings) console.warning(prefix + warning);
        for (const std::string& note : result.notes)
            console.detail(std::string(prefix).append("note: ").append(note));
        console.detail(std::string(prefix).append("method: ").append(to_string(result.method)));
        if (!result.choice.empty()) console.detail(prefix + result.choice);
        console.detail(std::string(prefix)
                           .append("assurance: ")
                           .append(to_string(result.assurance))
                           .append(": ")
                           .append(result.proof));
        console.detail(prefix + "primes used: " + std::to_string(result.statistics.primes_used));
        console.detail(prefix + statistics_line(result.statistics.basis, session.seconds()));
    }

    Method method_ = Method::automatic;
    Assurance assurance_ = Assurance::proved;
    std::optional<std::string> order_;
    std::optional<std::string> certificate_;
};

} // namespace

std::unique_ptr<Command> make_implicitize() { return std::make_unique<ImplicitizeCommand>(); }

} // namespace eliminant::app
