// Claims on results for inputs with relations.
#pragma once

#include "implicit/verify_domain.hpp"

#include <string>
#include <variant>

namespace eliminant::implicit {

/// Why there are no claims on a result, as a clause.
struct NoClaims {
    std::string reason;
};

/// The claims on equations of this codimension, or why there are none: relations that are no Groebner basis
/// for any weights tried, equations that are not in their ideal (of several, it need not be that of the
/// domain), a hypersurface of more than some thousand coefficients, or no smooth points of the rank needed
/// found. A hypersurface for which there are no points enough is claimed as by elimination.
std::variant<Claims, NoClaims> domain_claims(const DomainMap& map,
                                             std::span<const algebra::Polynomial> equations,
                                             std::size_t codimension, base::Run& run);

} // namespace eliminant::implicit
