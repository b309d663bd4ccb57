/// \file
/// From a result to its certificate.
#pragma once

#include "eliminant/implicit/certificate.hpp"
#include "eliminant/implicit/implicitize.hpp"

#include <optional>
#include <string>

namespace eliminant::implicit {

/// A certificate, or why there is none.
struct Certified {
    std::optional<Certificate> certificate;
    std::string reason; ///< a clause, if there is no certificate
};

/// The certificate of a result of implicitize() for this parametrization. What the result does not bring
/// along is computed: values of the equations, a point of the right rank, an irreducible section; with
/// relations, smooth points of the domain. There may be none with relations, where no proof is found that
/// polynomial arithmetic alone can check.
///
/// \throws Stopped
Certified certify(const Parametrization& parametrization, const ImplicitResult& result, base::Run& run);

} // namespace eliminant::implicit

namespace eliminant {
using implicit::Certified;
using implicit::certify;
} // namespace eliminant
