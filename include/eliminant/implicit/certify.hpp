/// \file
/// From a result to its certificate.
#pragma once

#include "eliminant/implicit/certificate.hpp"
#include "eliminant/implicit/implicitize.hpp"

#include <optional>

namespace eliminant::implicit {

/// The certificate of a result of implicitize() for this parametrization. What the result does not bring
/// along is computed: values of the equations, a point of the right rank, an irreducible section.
///
/// \returns nullopt if there is none: for inputs with relations, whose domains verify() cannot check
/// \throws Stopped
std::optional<Certificate> certify(const Parametrization& parametrization, const ImplicitResult& result,
                                   base::Run& run);

} // namespace eliminant::implicit

namespace eliminant {
using implicit::certify;
} // namespace eliminant
