/// \file
/// LocalForms by Taylor expansion in any arithmetic.
#pragma once

#include "field/compiled_data.hpp"
#include "field/distance_data.hpp"
#include "field/local_forms.hpp"
#include "field/nested_horner.hpp"

namespace eliminant::field {

/// Value, gradient and half Hessian from a jet in the order of JetComponent.
template <class Real, class Number, class Convert>
void set_jet(LocalForms<Real>& forms, const Number* jet, const Convert& convert) {
    forms.value = convert(jet[at_value]);
    for (int i = 0; i < 3; ++i) forms.gradient[i] = convert(jet[at_x + i]);
    const Symmetric<Real> hessian = {convert(jet[at_xx]), convert(jet[at_xy]), convert(jet[at_xz]),
                                     convert(jet[at_yy]), convert(jet[at_yz]), convert(jet[at_zz])};
    forms.half_hessian = Real(0.5) * hessian;
}

inline constexpr auto never_poll = [] {};

/// All parts, from `entries` as shift_to() takes them, which are replaced. Errors are left to the caller.
template <class Real, class Number, class Convert, class Poll = decltype(never_poll)>
void set_parts(LocalForms<Real>& forms, const TaylorScheme& scheme, const Number* point, Number* entries,
               const Convert& convert, const Poll& poll = never_poll) {
    using std::sqrt;
    shift_to(scheme, point, entries, poll);
    const auto low = [&](std::size_t i) {
        return scheme.low[i] == TaylorScheme::none ? Real(0) : Real(convert(entries[scheme.low[i]]));
    };
    forms.value = low(0);
    for (std::size_t i = 0; i < 3; ++i) forms.gradient[i] = low(1 + i);
    // The coefficient of xy is twice the entry of the matrix.
    forms.half_hessian = {low(4), low(5) / 2, low(6) / 2, low(7), low(8) / 2, low(9)};
    for (std::size_t k = 3; k < scheme.parts.size(); ++k) {
        Real sum = 0;
        for (const TaylorScheme::Component& component : scheme.parts[k]) {
            const Real c = convert(entries[component.entry]);
            sum = sum + Real(component.weight) * (c * c);
        }
        forms.norms[k] = sqrt(sum);
    }
}

/// Without an expansion: the error bounds' majorant bounds the parts themselves as well, only much more
/// coarsely.
template <class Real>
void set_parts_by_majorant(LocalForms<Real>& forms, const CompiledData& data, const Real& r) {
    shifted_majorant(data.majorant.data(), data.majorant.size(), r, Real(1), &forms.norms[0]);
}

} // namespace eliminant::field
