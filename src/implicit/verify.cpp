#include "eliminant/implicit/verify.hpp"

#include "eliminant/algebra/coefficients.hpp"
#include "eliminant/algebra/gcd.hpp"
#include "eliminant/algebra/parse.hpp"
#include "eliminant/base/error.hpp"
#include "implicit/verify_domain.hpp"
#include "implicit/verify_hypersurface.hpp"
#include "implicit/verify_monomials.hpp"

#include <algorithm>
#include <numeric>
#include <variant>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::RationalFunction;
using algebra::Ring;

namespace {

/// What a certificate is about, read from its text.
struct Subject {
    std::variant<RationalMap, DomainMap> map; ///< the latter with relations
    Ring ring;                                ///< of coordinates, then constants
    std::vector<Polynomial> equations;
};

std::size_t index_of(const Ring& ring, const std::string& name, const std::string& where) {
    const auto index = ring.index_of(name);
    if (!index) throw base::DomainError("certificate: " + where + ": unknown name " + name);
    return *index;
}

std::variant<RationalMap, DomainMap> read_map(const CertificateInput& input, base::Run& run) {
    std::vector<std::string> names = input.parameters;
    names.insert(names.end(), input.constants.begin(), input.constants.end());
    const Ring ring(algebra::CoefficientField::rationals(), std::move(names));
    std::vector<std::size_t> constants(input.constants.size());
    std::iota(constants.begin(), constants.end(), input.parameters.size());
    std::vector<bool> used(input.parameters.size(), false);
    std::vector<CosineSine> rotations;
    for (const auto& [cosine, sine] : input.angles) {
        rotations.emplace_back(index_of(ring, cosine, "angles"), index_of(ring, sine, "angles"));
        for (const std::size_t i : {rotations.back().first, rotations.back().second}) {
            if (i >= used.size() || used[i])
                throw base::DomainError("certificate: angles: each is a pair of parameters of its own");
            used[i] = true;
        }
    }
    std::vector<RationalFunction> functions;
    for (const auto& [name, text] : input.coordinates)
        functions.push_back(parse_rational_function(ring, base::SourceText(text, "coordinate " + name), run));
    if (input.relations.empty()) return rational_map(ring, constants, rotations, functions, run);
    std::vector<Polynomial> relations;
    for (const std::string& text : input.relations) {
        relations.push_back(parse_polynomial(ring, base::SourceText(text, "relation"), run));
        if (relations.back().is_zero()) throw base::DomainError("certificate: relations: 0 is none");
    }
    return domain_map(ring, input.parameters.size(), rotations, relations, functions, run);
}

Subject read(const Certificate& certificate, base::Run& run) {
    std::variant<RationalMap, DomainMap> map = read_map(certificate.input, run);
    std::vector<std::string> names;
    for (const auto& coordinate : certificate.input.coordinates) names.push_back(coordinate.first);
    names.insert(names.end(), certificate.input.constants.begin(), certificate.input.constants.end());
    // Signs are by the leading coefficient, coordinates being compared before constants.
    auto order = algebra::MonomialOrder::degrevlex();
    if (!certificate.input.constants.empty()) {
        std::vector<std::size_t> coordinates(certificate.input.coordinates.size());
        std::iota(coordinates.begin(), coordinates.end(), std::size_t{0});
        order = algebra::MonomialOrder::blocks({std::move(coordinates)});
    }
    Subject subject{
        std::move(map), Ring(algebra::CoefficientField::rationals(), std::move(names), order), {}};
    for (const std::string& equation : certificate.equations)
        subject.equations.push_back(
            parse_polynomial(subject.ring, base::SourceText(equation, "equation"), run));
    return subject;
}

class Check {
  public:
    Check(const Certificate& certificate, base::Run& run)
        : claims_(certificate.claims), run_(run), subject_(read(certificate, run)),
          coordinates_(certificate.input.coordinates.size()) {}

    Verdict verdict() {
        const auto* map = std::get_if<RationalMap>(&subject_.map);
        verdict_.holds = is_possible() && equations_are_normal() &&
                         (map != nullptr ? holds_on(*map) : holds_on(std::get<DomainMap>(subject_.map)));
        return std::move(verdict_);
    }

  private:
    bool fail(std::string what) {
        verdict_.statement = std::move(what);
        return false;
    }
    bool found(std::string what) {
        verdict_.checked.push_back(std::move(what));
        return true;
    }

    bool is_possible() {
        const std::size_t count = subject_.equations.size();
        if (claims_.degrees.size() != count) return fail("the claims are of another number of equations");
        if ((claims_.theorem == Theorem::dense) != (count == 0))
            return fail("an image is dense if and only if it has no equations");
        const bool one = claims_.theorem == Theorem::hypersurface || claims_.theorem == Theorem::toric;
        if (one && count != 1) return fail("a hypersurface has one equation");
        if ((claims_.theorem == Theorem::dense) != (claims_.codimension == 0))
            return fail("an image is dense if and only if it has codimension 0");
        if (one && claims_.codimension != 1) return fail("a hypersurface has codimension 1");
        return true;
    }

    bool equations_are_normal() {
        for (std::size_t i = 0; i < subject_.equations.size(); ++i) {
            const Polynomial& f = subject_.equations[i];
            // A factor in the constants would make it another equation of the same image. Of several
            // equations, the leading terms, and so the signs, are by an order that need not be this one.
            const Polynomial primitive = f.is_zero() ? f : primitive_part(f, coordinate_variables(), run_);
            if (f.is_zero() || (f != primitive && (subject_.equations.size() == 1 || f != -primitive)))
                return fail(name_of(i) +
                            " is not primitive with integer coefficients, or its leading one is negative");
            if (algebra::degree_in_first(f, coordinates_) != claims_.degrees[i])
                return fail(name_of(i) + " has another degree");
        }
        return true;
    }

    bool holds_on(const RationalMap& map) {
        const bool is_toric = claims_.theorem == Theorem::toric;
        if (claims_.vanishing.size() != (is_toric ? 0 : subject_.equations.size()))
            return fail("the claims are of another number of equations");
        if ((claims_.theorem == Theorem::hypersurface) != claims_.irreducible.has_value())
            return fail("irreducibility is claimed of hypersurfaces, and only of them");
        if (claims_.domain) return fail("a domain is claimed of an input without relations");
        return dimension_holds(map) && (is_toric ? is_binomial_on(map) : equations_vanish(map)) &&
               theorem_holds();
    }

    bool holds_on(const DomainMap& map) {
        if (!claims_.domain || claims_.irreducible || !claims_.vanishing.empty() ||
            claims_.rank != RankClaim{} || claims_.theorem == Theorem::toric)
            return fail("for an input with relations the claims are others");
        const DomainClaim& domain = *claims_.domain;
        if (!is_dimension(domain.rank)) return false;
        const auto basis = as_basis(map, domain.weights);
        if (!basis) return fail("with these weights the leading monomials of the relations are not coprime");
        for (std::size_t i = 0; i < subject_.equations.size(); ++i) {
            if (!vanishes(map, subject_.equations[i], *basis, run_))
                return fail(name_of(i) + " is not zero modulo the relations");
            found(name_of(i) + " vanishes on the domain: put in and divided by the relations, which are a "
                               "Groebner basis by Buchberger's first criterion, it leaves no remainder");
        }
        const bool minimal = claims_.theorem == Theorem::hypersurface;
        std::optional<std::uint64_t> lower_degree;
        if (minimal) lower_degree = claims_.degrees.front() - 1;
        if (std::string what = refutation(map, domain, lower_degree, run_); !what.empty())
            return fail(std::move(what));
        found(
            "the image has dimension at least " + std::to_string(domain.rank) +
            ": the differential on the tangent space has that rank at a smooth point of the domain modulo " +
            std::to_string(domain.prime));
        if (minimal)
            found("no polynomial of lower degree vanishes on the images of the components of the domain with "
                  "that dimension: none does so at " +
                  std::to_string(domain.points.size()) + " points of them modulo the prime");
        state_theorem();
        return true;
    }

    bool is_dimension(std::uint64_t rank) {
        return rank + claims_.codimension == coordinates_ ||
               fail("rank and codimension do not add up to the number of coordinates");
    }

    bool dimension_holds(const RationalMap& map) {
        const RankClaim& rank = claims_.rank;
        if (!holds(map, rank, run_))
            return fail("the rank of the differential at the point is not as claimed");
        return is_dimension(rank.rank) &&
               found("the image has dimension at least " + std::to_string(rank.rank) +
                     ": the differential has that rank at a point modulo " + std::to_string(rank.prime));
    }

    static std::string name_of(std::size_t i) { return "equation " + std::to_string(i + 1); }

    bool equations_vanish(const RationalMap& map) {
        for (std::size_t i = 0; i < subject_.equations.size(); ++i) {
            const Polynomial& f = subject_.equations[i];
            const VanishingClaim& claim = claims_.vanishing[i];
            if (vanishing_claim(map, f) != claim)
                return fail(name_of(i) +
                            ": bounds or primes are not those of this equation on this parametrization");
            if (!vanishes(map, f, claim, run_))
                return fail(name_of(i) + " does not vanish on the parametrization");
            found(name_of(i) + " vanishes on the parametrization: at enough points for its degrees, modulo " +
                  (claim.primes.size() == 1
                       ? "a prime that exceeds"
                       : std::to_string(claim.primes.size()) + " primes whose product exceeds") +
                  " the coefficients of what is zero");
        }
        return true;
    }

    bool is_binomial_on(const RationalMap& map) {
        const auto terms = term_map(map);
        if (!terms) return fail("a coordinate is not a single term");
        if (!is_irreducible_binomial_on(*terms, subject_.equations.front()))
            return fail("the equation is not an irreducible binomial that vanishes on the parametrization");
        found(name_of(0) + " vanishes on the parametrization: it is a binomial, and its exponents are a "
                           "relation of those of the coordinates");
        return found("the equation is irreducible: its two monomials are coprime, and their exponents have "
                     "no common factor");
    }

    std::vector<std::size_t> coordinate_variables() const {
        std::vector<std::size_t> variables(coordinates_);
        std::iota(variables.begin(), variables.end(), std::size_t{0});
        return variables;
    }

    bool theorem_holds() {
        if (claims_.theorem == Theorem::hypersurface && !irreducibility_holds()) return false;
        state_theorem();
        return true;
    }

    bool irreducibility_holds() {
        if (!holds(subject_.equations.front(), coordinates_, *claims_.irreducible, run_))
            return fail("the equation is not irreducible on the line, or not the polynomial claimed there");
        return found("the equation is irreducible: it keeps its degree and is irreducible on a line modulo " +
                     std::to_string(claims_.irreducible->prime));
    }

    void state_theorem() {
        switch (claims_.theorem) {
        case Theorem::dense:
            verdict_.statement = "proved: the image is dense";
            break;
        case Theorem::hypersurface:
        case Theorem::toric:
            verdict_.statement = "proved: the equation generates the ideal of the image";
            break;
        case Theorem::elimination:
            verdict_.statement =
                "the equations vanish on the parametrization, and the image has at least the dimension "
                "claimed; that they generate the ideal of the image rests on the elimination theorem and on "
                "the Groebner basis computation, which is not repeated here";
            break;
        }
    }

    const Claims& claims_;
    base::Run& run_;
    Subject subject_;
    std::size_t coordinates_;
    Verdict verdict_;
};

} // namespace

Verdict verify(const Certificate& certificate, base::Run& run) { return Check(certificate, run).verdict(); }

} // namespace eliminant::implicit
