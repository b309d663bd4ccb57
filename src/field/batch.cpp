#include "field/batch.hpp"

#include "eliminant/base/error.hpp"

#include "field/batch_kernel.hpp"
#include "field/compiled_data.hpp"

#include <algorithm>
#include <string>

namespace eliminant::field {

namespace {

template <class Real>
void check_lengths(const PointArrays<Real>& points, const JetArrays<Real>& jets, bool needs_z) {
    const std::size_t count = points.x.size();
    const auto fits = [&](const auto& span) { return span.size() == count; };
    if (fits(points.y) && (fits(points.z) || (points.z.empty() && !needs_z)) && fits(jets.value) &&
        std::ranges::all_of(jets.gradient, fits) && std::ranges::all_of(jets.hessian, fits))
        return;
    throw base::DomainError("evaluating a batch: expected all spans as long as that of x, which has " +
                            std::to_string(count) + " elements");
}

template <class Real>
void evaluate_batch(base::VectorUnit unit, const CompiledPolynomial& f, const Real* coefficients,
                    const PointArrays<Real>& points, const JetArrays<Real>& jets) {
    const CompiledData& data = f.data();
    check_lengths(points, jets, data.exact.degree(2) > 0);
    // Without z, any numbers do in its place: its powers do not occur.
    const std::span<const Real> z = points.z.empty() ? points.x : points.z;
    const std::span<const Real> columns[] = {points.x, points.y, z};
    const std::span<Real> results[] = {jets.value,      jets.gradient[0], jets.gradient[1], jets.gradient[2],
                                       jets.hessian[0], jets.hessian[1],  jets.hessian[2],  jets.hessian[3],
                                       jets.hessian[4], jets.hessian[5]};
    BatchArrays<Real> arrays{};
    const ProgramView& program = data.program_view;
    const SchemeView& scheme = program.leaves[0].scheme;
    for (std::size_t i = 0; i < 3; ++i)
        arrays.point[i] = columns[program.is_plain() ? scheme.coordinates[i] : i].data();
    for (std::size_t k = 0; k < jet_size; ++k)
        arrays.jet[k] = results[program.is_plain() ? scheme.components[k] : k].data();
    base::with_unit(unit,
                    [&](auto u) { evaluate_arrays<u()>(program, coefficients, arrays, points.x.size()); });
}

} // namespace

void evaluate_with(base::VectorUnit unit, const CompiledPolynomial& f, const PointArrays<double>& points,
                   const JetArrays<double>& jets) {
    evaluate_batch(unit, f, f.data().program.coefficients.data(), points, jets);
}

void evaluate_with(base::VectorUnit unit, const CompiledPolynomial& f, const PointArrays<float>& points,
                   const JetArrays<float>& jets) {
    evaluate_batch(unit, f, f.data().program.floats.data(), points, jets);
}

void CompiledPolynomial::evaluate(const PointArrays<double>& points, const JetArrays<double>& jets) const {
    evaluate_with(base::best_vector_unit(), *this, points, jets);
}

void CompiledPolynomial::evaluate(const PointArrays<float>& points, const JetArrays<float>& jets) const {
    evaluate_with(base::best_vector_unit(), *this, points, jets);
}

} // namespace eliminant::field
