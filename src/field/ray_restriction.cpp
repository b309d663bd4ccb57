#include "eliminant/field/ray_restriction.hpp"

#include "field/exact_beam.hpp"

#include "eliminant/base/error.hpp"

#include <cmath>

namespace eliminant::field {

std::vector<mpz_class> restrict_to_ray(const algebra::Polynomial& f, const glm::dvec3& origin,
                                       const glm::dvec3& direction, base::Run& run) {
    if (!f.ring().field().is_rationals())
        throw base::DomainError("restriction to a ray: a polynomial over the rationals is expected");
    if (f.ring().variable_count() > 3)
        throw base::DomainError("restriction to a ray: a polynomial in at most three variables is expected");
    BeamForms forms;
    for (int axis = 0; axis < 3; ++axis) {
        if (!std::isfinite(origin[axis]) || !std::isfinite(direction[axis]))
            throw base::DomainError("restriction to a ray: origin and direction must be finite");
        const auto i = static_cast<std::size_t>(axis);
        forms[i] = {mpq_class(origin[axis]), 0, 0, mpq_class(direction[axis])};
    }
    forms[3] = {1, 0, 0, 0};
    const ExactBeam beam(f, forms, run);
    return beam.coefficients();
}

} // namespace eliminant::field
