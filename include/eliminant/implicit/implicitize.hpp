/// \file
/// From parametric equations to implicit ones.
#pragma once

#include "eliminant/groebner/buchberger.hpp"
#include "eliminant/implicit/certificate.hpp"
#include "eliminant/implicit/parametrization.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eliminant::implicit {

/// How the implicit equations are found; the answer does not depend on it.
enum class Method {
    automatic, ///< chosen from the shape of the input; never the method of a result
    toric,     ///< read off the exponents, where all coordinates are single terms: by `automatic` only
    groebner,  ///< elimination of the parameters by Groebner bases
    linear,    ///< linear algebra on values of monomials at points of the image; for hypersurfaces
    resultant, ///< resultants on parallel lines, for plane curves and for surfaces in space
};

/// The name on the command line: `auto`, `groebner`, `linear`, `resultant`; of results also `toric`.
std::string_view to_string(Method method);

/// How sure a result is.
enum class Assurance {
    proved,   ///< a theorem, see ImplicitResult::proof
    probable, ///< a test passed that a wrong result may pass too
};

/// `proved`, `probable`.
std::string_view to_string(Assurance assurance);

/// What implicitize() may be asked for.
struct ImplicitizeOptions {
    /// One for hypersurfaces only is replaced by elimination where the image is none, or where it gives up;
    /// ImplicitResult::method and `choice` tell.
    Method method = Method::automatic;
    /// Of the reduced basis where there are several equations; on the coordinates alone.
    algebra::MonomialOrder order = algebra::MonomialOrder::degrevlex();
    /// What is enough. `probable` spares hypersurfaces the proof; what comes proved anyway is returned as
    /// such.
    Assurance assurance = Assurance::proved;
    /// Whether to count how many parameter values reach a general point of the image.
    bool parametrization_degree = false;
};

/// What a method was predicted to take for a hypersurface, without the proof.
struct MethodCost {
    Method method = Method::automatic;
    /// Of one thread of the machine that the models were measured on; elsewhere only the ratios mean
    /// something.
    double seconds = 0;
    bool at_least = false; ///< Whether it would be more, nobody knows how much.
};

/// What it took.
struct ImplicitStatistics {
    std::uint64_t primes_used = 0; ///< images modulo primes that the result was put together from; 0: over ℚ
    groebner::Statistics basis;    ///< of all basis computations together
};

/// The closure of the image of a parametrization.
struct ImplicitResult {
    /// Coordinates in the order given, then the constants. Its order compares coordinates first, by degrevlex
    /// (by ImplicitizeOptions::order where there are several equations), then constants by degrevlex.
    algebra::Ring ring;
    /// The reduced Groebner basis, ascending by leading monomial, of the radical ideal of the closure over
    /// the field of constants; each element cleared to integer coefficients, over ℤ[constants] without common
    /// factor, with positive leading coefficient. Empty for a dense image, {1} for an empty one.
    std::vector<algebra::Polynomial> equations;
    /// Number of coordinates minus the dimension of the closure; one more than the number of coordinates if
    /// the image is empty.
    std::size_t codimension = 0;
    Method method = Method::groebner;
    Assurance assurance = Assurance::proved;
    std::string proof; ///< The theorem that the result rests on, or the test made.
    /// What may surprise in this very answer, a sentence each.
    std::vector<std::string> warnings;
    /// How many parameter values over the algebraic closure reach a general point of the image; nullopt if
    /// infinitely many, or not computed: it was not asked for, or there are relations. Counted in the fibres
    /// over two random points modulo two primes, which agreed; by `toric` read off the exponents.
    std::optional<std::uint64_t> parametrization_degree;
    ImplicitStatistics statistics;
    /// What holds of most answers and is easily forgotten, a sentence each: that a closure may be larger than
    /// an image.
    std::vector<std::string> notes = {};
    /// What the proof of a hypersurface is made of, if the method came with one; certify() makes a
    /// certificate of any result.
    std::optional<Claims> claims = {};
    /// If the method was chosen for a hypersurface: what was predicted, the least first, lower
    /// bounds last.
    std::vector<MethodCost> predicted = {};
    std::string choice = {}; ///< Why this method, and what it did, where there is something to say.
};

/// The equations of the (Zariski) closure of the image of a parametrization, over the algebraic closure of
/// the field of constants.
///
/// \throws DomainError if the order does not fit the coordinates; Stopped
ImplicitResult implicitize(const Parametrization& parametrization, const ImplicitizeOptions& options,
                           base::Run& run);

} // namespace eliminant::implicit

namespace eliminant {
using implicit::Assurance;
using implicit::implicitize;
using implicit::ImplicitizeOptions;
using implicit::ImplicitResult;
using implicit::ImplicitStatistics;
using implicit::Method;
using implicit::MethodCost;
} // namespace eliminant
