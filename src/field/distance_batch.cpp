#include "field/distance_batch.hpp"

#include "eliminant/base/error.hpp"

#include "field/batch.hpp"
#include "field/compiled_data.hpp"
#include "field/distance_data.hpp"
#include "field/expansion_rows.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace eliminant::field {

namespace {

void check_lengths(const PointArrays<double>& points, const DistanceArrays& result, bool needs_z) {
    const std::size_t count = points.x.size();
    if (points.y.size() == count && (points.z.size() == count || (points.z.empty() && !needs_z)) &&
        result.value.size() == count && result.sign.size() == count)
        return;
    throw base::DomainError("distances of a batch: expected all spans as long as that of x, which has " +
                            std::to_string(count) + " elements");
}

/// One batch: blocks of points are expanded together, and finished one by one.
class Batch {
  public:
    Batch(base::VectorUnit unit, const DistanceField& field, const PointArrays<double>& points,
          DistanceLevel level, const DistanceArrays& result)
        : unit_(unit), field_(field), points_(points), level_(level), result_(result),
          forms_(field.polynomial().degree()) {}

    void run() {
        if (field_.polynomial().is_zero()) {
            for (std::size_t i = 0; i < points_.x.size(); ++i) put(i, distance(field_, point(i), level_));
        } else if (level_ != DistanceLevel::guaranteed) {
            by_jets();
        } else if (field_.data().taylor.is_complete) {
            by_expansions();
        } else {
            for (std::size_t i = 0; i < points_.x.size(); ++i) put(i, distance(field_, point(i), level_));
        }
    }

  private:
    static constexpr std::size_t block = 64; ///< points whose jets stay in the first-level cache

    glm::dvec3 point(std::size_t i) const {
        return {points_.x[i], points_.y[i], points_.z.empty() ? 0.0 : points_.z[i]};
    }
    void put(std::size_t i, const Distance& found) {
        result_.value[i] = found.value;
        result_.sign[i] = static_cast<std::int8_t>(found.sign);
    }
    static bool is_finite(const glm::dvec3& p) {
        return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
    }
    /// From forms_.
    void finish(std::size_t i) {
        const glm::dvec3 p = point(i);
        if (!is_finite(p)) return put(i, distance(field_, p, level_));
        const Estimate<double> result = level_ == DistanceLevel::guaranteed
                                            ? guaranteed_bound(forms_)
                                            : estimate(forms_, level_, fast_spectral_norm);
        put(i, trusted_or_precise(result, forms_, field_, p, level_));
    }
    /// Value, gradient and half Hessian, these by x, y, z; xx, xy, xz, yy, yz, zz of the matrix.
    void set_low(const std::array<double, 10>& jet) {
        forms_.value = jet[0];
        for (std::size_t i = 0; i < 3; ++i) forms_.gradient[i] = jet[1 + i];
        forms_.half_hessian = {jet[4], jet[5], jet[6], jet[7], jet[8], jet[9]};
    }

    void by_jets() {
        std::array<std::array<double, block>, 10> jets{};
        const std::size_t count = points_.x.size();
        for (std::size_t first = 0; first < count; first += block) {
            const std::size_t size = std::min(block, count - first);
            const auto in = [&](std::span<const double> column) {
                return column.empty() ? column : column.subspan(first, size);
            };
            const auto out = [&](std::size_t k) { return std::span(jets[k]).first(size); };
            evaluate_with(
                unit_, field_.polynomial(), {in(points_.x), in(points_.y), in(points_.z)},
                {out(0), {out(1), out(2), out(3)}, {out(4), out(5), out(6), out(7), out(8), out(9)}});
            for (std::size_t i = 0; i < size; ++i) {
                std::array<double, 10> jet{};
                for (std::size_t k = 0; k < 10; ++k) jet[k] = k < 4 ? jets[k][i] : 0.5 * jets[k][i];
                set_low(jet);
                const JetError error = field_.polynomial().error_bound(point(first + i));
                forms_.errors[0] = error.value;
                if (forms_.size() > 1) forms_.errors[1] = error.gradient;
                if (forms_.size() > 2) forms_.errors[2] = error.hessian / 2;
                finish(first + i);
            }
        }
    }

    void by_expansions() {
        const ExpansionView view = field_.data().view(field_.polynomial().data());
        const Expander kernel = expander(unit_);
        const std::size_t lanes = kernel.lanes;
        std::vector<double> workspace((view.size + view.degree + 1) * lanes);
        std::vector<double> rows(ExpansionRows::count(view.degree) * lanes);
        const std::size_t count = points_.x.size();
        for (std::size_t first = 0; first < count; first += lanes) {
            const std::size_t size = std::min(lanes, count - first);
            std::array<std::array<double, 8>, 3> columns{}; // spare lanes are at the origin
            for (std::size_t i = 0; i < size; ++i)
                for (std::size_t k = 0; k < 3; ++k) columns[k][i] = point(first + i)[static_cast<int>(k)];
            const double* const pointers[] = {columns[0].data(), columns[1].data(), columns[2].data()};
            kernel.expand(view, pointers, workspace.data(), rows.data());
            for (std::size_t i = 0; i < size; ++i) {
                set_from_rows(rows.data() + i, lanes);
                finish(first + i);
            }
        }
    }
    void set_from_rows(const double* rows, std::size_t lanes) {
        const auto degree = forms_.size() - 1;
        std::array<double, 10> low{};
        for (std::size_t k = 0; k < 10; ++k) low[k] = rows[k * lanes];
        for (const std::size_t mixed : {5U, 6U, 8U})
            low[mixed] /= 2; // the coefficient of xy is twice the entry
        set_low(low);
        for (std::size_t k = 3; k <= degree; ++k)
            forms_.norms[k] = std::sqrt(rows[ExpansionRows::square(k) * lanes]);
        for (std::size_t k = 0; k <= degree; ++k)
            forms_.errors[k] = rows[ExpansionRows::error(degree, k) * lanes];
    }

    base::VectorUnit unit_;
    const DistanceField& field_;
    const PointArrays<double>& points_;
    DistanceLevel level_;
    const DistanceArrays& result_;
    LocalForms<double> forms_;
};

} // namespace

void distances_with(base::VectorUnit unit, const DistanceField& field, const PointArrays<double>& points,
                    DistanceLevel level, const DistanceArrays& result) {
    check_lengths(points, result, field.polynomial().polynomial().degree(2) > 0);
    Batch(unit, field, points, level, result).run();
}

void distances(const DistanceField& field, const PointArrays<double>& points, DistanceLevel level,
               const DistanceArrays& result) {
    distances_with(base::best_vector_unit(), field, points, level, result);
}

} // namespace eliminant::field
