#include "eliminant/implicit/verify.hpp"

#include "eliminant/algebra/gcd.hpp"
#include "eliminant/algebra/parse.hpp"
#include "eliminant/base/error.hpp"
#include "implicit/verify_hypersurface.hpp"

#include <algorithm>
#include <numeric>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::RationalFunction;
using algebra::Ring;

namespace {

/// What a certificate is about, read from its text.
struct Subject {
    RationalMap map;
    Ring ring; ///< of coordinates, then constants
    std::vector<Polynomial> equations;
};

std::size_t index_of(const Ring& ring, const std::string& name, const std::string& where) {
    const auto index = ring.index_of(name);
    if (!index) throw base::DomainError("certificate: " + where + ": unknown name " + name);
    return *index;
}

RationalMap read_map(const CertificateInput& input, base::Run& run) {
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
    return rational_map(ring, constants, rotations, functions, run);
}

Subject read(const Certificate& certificate, base::Run& run) {
    RationalMap map = read_map(certificate.input, run);
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
        : certificate_(certificate), claims_(certificate.claims), run_(run), subject_(read(certificate, run)),
          coordinates_(certificate.input.coordinates.size()) {}

    Verdict verdict() {
        const bool holds = is_possible() && dimension_holds() && equations_hold() && theorem_holds();
        verdict_.holds = holds;
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
        if (!certificate_.input.relations.empty())
            return fail("a certificate of an input with relations cannot be checked by this version");
        const std::size_t count = subject_.equations.size();
        if (claims_.degrees.size() != count || claims_.vanishing.size() != count)
            return fail("the claims are of another number of equations");
        if ((claims_.theorem == Theorem::dense) != (count == 0))
            return fail("an image is dense if and only if it has no equations");
        if (claims_.theorem == Theorem::hypersurface && count != 1)
            return fail("a hypersurface has one equation");
        if ((claims_.theorem == Theorem::hypersurface) != claims_.irreducible.has_value())
            return fail("irreducibility is claimed of hypersurfaces, and only of them");
        return true;
    }

    bool dimension_holds() {
        const RankClaim& rank = claims_.rank;
        if (!holds(subject_.map, rank, run_))
            return fail("the rank of the differential at the point is not as claimed");
        if (rank.rank + claims_.codimension != coordinates_)
            return fail("rank and codimension do not add up to the number of coordinates");
        return found("the image has dimension at least " + std::to_string(rank.rank) +
                     ": the differential has that rank at a point modulo " + std::to_string(rank.prime));
    }

    bool equations_hold() {
        for (std::size_t i = 0; i < subject_.equations.size(); ++i)
            if (!equation_holds(subject_.equations[i], claims_.degrees[i], claims_.vanishing[i],
                                "equation " + std::to_string(i + 1)))
                return false;
        return true;
    }

    bool equation_holds(const Polynomial& f, std::uint64_t degree, const VanishingClaim& claim,
                        const std::string& name) {
        // A factor in the constants would make it another equation of the same image. Of several equations,
        // the leading terms, and so the signs, are by an order that need not be this one.
        const Polynomial primitive = f.is_zero() ? f : primitive_part(f, coordinate_variables(), run_);
        if (f.is_zero() || (f != primitive && (subject_.equations.size() == 1 || f != -primitive)))
            return fail(name + " is not primitive with integer coefficients, or its leading one is negative");
        if (degree_in_coordinates(f, coordinates_) != degree) return fail(name + " has another degree");
        if (vanishing_claim(subject_.map, f) != claim)
            return fail(name + ": bounds or primes are not those of this equation on this parametrization");
        if (!vanishes(subject_.map, f, claim, run_))
            return fail(name + " does not vanish on the parametrization");
        return found(name + " vanishes on the parametrization: at enough points for its degrees, modulo " +
                     (claim.primes.size() == 1
                          ? "a prime that exceeds"
                          : std::to_string(claim.primes.size()) + " primes whose product exceeds") +
                     " the coefficients of what is zero");
    }

    std::vector<std::size_t> coordinate_variables() const {
        std::vector<std::size_t> variables(coordinates_);
        std::iota(variables.begin(), variables.end(), std::size_t{0});
        return variables;
    }

    bool theorem_holds() {
        switch (claims_.theorem) {
        case Theorem::dense:
            verdict_.statement = "proved: the image is dense";
            return claims_.codimension == 0 || fail("a dense image has codimension 0");
        case Theorem::hypersurface:
            return irreducibility_holds();
        case Theorem::elimination:
            verdict_.statement =
                "the equations vanish on the parametrization, and the image has at least the dimension "
                "claimed; that they generate the ideal of the image rests on the elimination theorem and on "
                "the "
                "Groebner basis computation, which is not repeated here";
            return true;
        }
        return fail("no such theorem");
    }

    bool irreducibility_holds() {
        if (claims_.codimension != 1) return fail("a hypersurface has codimension 1");
        if (!holds(subject_.equations.front(), coordinates_, *claims_.irreducible, run_))
            return fail("the equation is not irreducible on the line, or not the polynomial claimed there");
        verdict_.statement = "proved: the equation generates the ideal of the image";
        return found("the equation is irreducible: it keeps its degree and is irreducible on a line modulo " +
                     std::to_string(claims_.irreducible->prime));
    }

    const Certificate& certificate_;
    const Claims& claims_;
    base::Run& run_;
    Subject subject_;
    std::size_t coordinates_;
    Verdict verdict_;
};

} // namespace

Verdict verify(const Certificate& certificate, base::Run& run) { return Check(certificate, run).verdict(); }

} // namespace eliminant::implicit
