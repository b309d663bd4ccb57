#include "eliminant/implicit/certify.hpp"

#include "eliminant/algebra/coefficients.hpp"
#include "eliminant/algebra/print.hpp"
#include "implicit/certify_domain.hpp"
#include "implicit/map_of.hpp"
#include "implicit/verify_hypersurface.hpp"

#include <utility>

namespace eliminant::implicit {

namespace {

CertificateInput input_of(const Parametrization& parametrization) {
    const std::vector<std::string>& names = parametrization.ring().names();
    CertificateInput input;
    for (const std::size_t i : parametrization.parameters()) input.parameters.push_back(names[i]);
    for (const std::size_t i : parametrization.constants()) input.constants.push_back(names[i]);
    for (const auto& [cosine, sine] : parametrization.rotations())
        input.angles.emplace_back(names[cosine], names[sine]);
    for (const auto& [name, value] : parametrization.coordinates())
        input.coordinates.emplace_back(name, algebra::to_string(value));
    for (const algebra::Polynomial& f : parametrization.relations()) input.relations.push_back(to_string(f));
    return input;
}

std::optional<Claims> toric_claims(const RationalMap& map, const ImplicitResult& result, base::Run& run) {
    const std::size_t n = map.components.size() - map.constants.size();
    auto rank = rank_claim(map, n - 1, run);
    if (!rank) return std::nullopt;
    Claims claims;
    claims.theorem = Theorem::toric;
    claims.codimension = 1;
    claims.degrees = {algebra::degree_in_first(result.equations.front(), n)};
    claims.rank = *std::move(rank);
    return claims;
}

/// Claims of equations that elimination found, or of none.
std::optional<Claims> claims_of(const RationalMap& map, const ImplicitResult& result, base::Run& run) {
    const std::size_t n = map.components.size() - map.constants.size();
    auto rank = rank_claim(map, n - result.codimension, run);
    if (!rank) return std::nullopt;
    Claims claims;
    claims.theorem = result.equations.empty() ? Theorem::dense : Theorem::elimination;
    claims.codimension = result.codimension;
    claims.rank = std::move(*rank);
    for (const algebra::Polynomial& f : result.equations) {
        claims.degrees.push_back(algebra::degree_in_first(f, n));
        claims.vanishing.push_back(vanishing_claim(map, f));
    }
    return claims;
}

} // namespace

Certified certify(const Parametrization& parametrization, const ImplicitResult& result, base::Run& run) {
    std::optional<Claims> claims = result.claims;
    if (!parametrization.relations().empty()) {
        auto found =
            domain_claims(domain_of(parametrization, run), result.equations, result.codimension, run);
        if (const auto* none = std::get_if<NoClaims>(&found)) return {std::nullopt, none->reason};
        claims = std::get<Claims>(std::move(found));
    }
    if (!claims) {
        const RationalMap map = map_of(parametrization, run);
        if (result.method == Method::toric)
            claims = toric_claims(map, result, run);
        else if (result.equations.size() == 1)
            claims = prove_hypersurface(map, result.equations.front(), run);
        if (!claims) claims = claims_of(map, result, run);
        if (!claims) return {std::nullopt, "no point was found at which the differential has its full rank"};
    }
    Certificate certificate{input_of(parametrization), {}, std::move(*claims)};
    for (const algebra::Polynomial& f : result.equations) certificate.equations.push_back(to_string(f));
    return {std::move(certificate), {}};
}

} // namespace eliminant::implicit
