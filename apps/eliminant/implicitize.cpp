/// \file
/// `eliminant implicitize`.
#include "certificate_json.hpp"
#include "command.hpp"
#include "input.hpp"
#include "results.hpp"

#include "eliminant/algebra/parse.hpp"
#include "eliminant/implicit/certify.hpp"
#include "eliminant/implicit/implicitize.hpp"

#include <algorithm>
#include <optional>

namespace eliminant::app {

namespace {

Parametrization read_parametrization(std::span<const std::string> operands, Run& run) {
    const Input input = input_of(operands, looks_like_equation, run);
    if (!input.is_expressions) {
        const Input::Part& file = input.parts.front();
        return parse_parametrization(SourceText(file.text, file.name), run);
    }
    std::vector<SourceText> statements;
    for (const Input::Part& part : input.parts) statements.emplace_back(part.text, part.name);
    return parse_parametrization(statements, run);
}

std::vector<std::string> coordinate_names(const Parametrization& parametrization) {
    std::vector<std::string> names;
    for (const Coordinate& coordinate : parametrization.coordinates()) names.push_back(coordinate.name);
    return names;
}

/// Degree in the coordinates, which are the first variables: constants are elements of the field.
std::uint64_t degree_in_coordinates(const Polynomial& f, std::size_t coordinates) {
    std::uint64_t degree = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
        std::uint64_t sum = 0;
        for (std::size_t variable = 0; variable < coordinates; ++variable) sum += f.exponent(i, variable);
        degree = std::max(degree, sum);
    }
    return degree;
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

std::string json(const ImplicitResult& result, std::size_t coordinates, double seconds) {
    std::vector<std::uint64_t> degrees;
    std::vector<std::uint64_t> terms;
    for (const Polynomial& f : result.equations) {
        degrees.push_back(degree_in_coordinates(f, coordinates));
        terms.push_back(f.size());
    }
    Json report;
    report["variables"] = result.ring.names();
    report["equations"] = strings(result.equations);
    report["codimension"] = result.codimension;
    report["degree"] = one_or_list(std::move(degrees));
    report["terms"] = one_or_list(std::move(terms));
    report["max_coefficient_digits"] = largest_coefficient_digits(result.equations);
    report["method"] = to_string(result.method);
    report["assurance"] = to_string(result.assurance);
    report["parametrization_degree"] = nullptr;
    if (result.parametrization_degree) report["parametrization_degree"] = *result.parametrization_degree;
    report["seconds"] = seconds;
    return to_text(report);
}

/// A polynomial for a hypersurface and, being 0, for a dense image; otherwise an ideal.
std::string equations_in(ResultFormat format, const ImplicitResult& result) {
    if (result.equations.size() > 1) return ideal_in(format, result.ring, result.equations);
    return polynomial_in(format,
                         result.equations.empty() ? Polynomial(result.ring) : result.equations.front());
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
               "Examples:\n"
               "  eliminant implicitize 'x = (1-t^2)/(1+t^2)' 'y = 2t/(1+t^2)'\n"
               "  eliminant implicitize --format json 'constants R, r' 'x = (R+r*cos(u))*cos(v)' "
               "'y = (R+r*cos(u))*sin(v)' 'z = r*sin(u)'\n";
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
        const Parametrization parametrization = read_parametrization(operands, session.run());
        const std::vector<std::string> coordinates = coordinate_names(parametrization);
        if (order_) options.order = parse_order(SourceText(*order_, "--order"), coordinates);

        std::optional<Destination> certificate;
        if (certificate_) certificate.emplace(*certificate_);
        const ImplicitResult result = implicitize(parametrization, options, session.run());
        for (const std::string& warning : result.warnings) session.console().warning(warning);
        describe(result, session);
        if (certificate) write_certificate(*certificate, parametrization, result, session);
        session.write_result(session.format() == ResultFormat::json
                                 ? json(result, coordinates.size(), session.seconds())
                                 : equations_in(session.format(), result));
        return exit_done;
    }

  private:
    static void write_certificate(const Destination& file, const Parametrization& parametrization,
                                  const ImplicitResult& result, Session& session) {
        const auto certificate = certify(parametrization, result, session.run());
        if (certificate)
            file.write(certificate_to_json(*certificate), session.run());
        else
            session.console().warning("no certificate was written: there is none for inputs with relations");
    }

    static void describe(const ImplicitResult& result, Session& session) {
        Console& console = session.console();
        for (const std::string& note : result.notes) console.detail("note: " + note);
        console.detail("method: " + std::string(to_string(result.method)));
        if (!result.choice.empty()) console.detail(result.choice);
        console.detail("assurance: " + std::string(to_string(result.assurance)) + ": " + result.proof);
        console.detail("primes used: " + std::to_string(result.statistics.primes_used));
        console.detail(statistics_line(result.statistics.basis, session.seconds()));
    }

    Method method_ = Method::automatic;
    Assurance assurance_ = Assurance::proved; // what is proved serves those who ask for less, too
    std::optional<std::string> order_;
    std::optional<std::string> certificate_;
};

} // namespace

std::unique_ptr<Command> make_implicitize() { return std::make_unique<ImplicitizeCommand>(); }

} // namespace eliminant::app
