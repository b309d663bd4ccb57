#include "ray_stars.hpp"

#include "field/compiled_data.hpp"
#include "field/distance_data.hpp"

namespace eliminant::field {

StarRoots::StarRoots(const DistanceField& f) {
    const CompiledData& data = f.polynomial().data();
    const TaylorScheme& scheme = f.data().taylor;
    if (!scheme.is_complete || data.degree < 1 || data.degree > static_cast<int>(max_kernel_degree)) return;
    for (const DoubleDouble& entry : f.data().double_doubles) {
        high_.push_back(entry.high);
        low_.push_back(entry.low);
    }
    for (const TaylorScheme::Line& line : scheme.lines) lines_.push_back({line.first, line.count, 0, 0});
    for (const TaylorScheme::Step& step : scheme.steps)
        steps_.push_back({step.to, step.from, step.count, step.level});
    for (const TaylorScheme::FilledLine& line : scheme.filled)
        filled_.push_back({line.first, line.count, line.i, line.j});
    majorant_ = data.majorant;
    polynomial_.degree = static_cast<std::size_t>(data.degree);
    polynomial_.size = scheme.size;
    for (std::size_t level = 0; level < 3; ++level)
        polynomial_.coordinates[level] = scheme.coordinates[level];
    polynomial_.high = high_.data();
    polynomial_.low = low_.data();
    polynomial_.lines = lines_.data();
    polynomial_.line_count = lines_.size();
    polynomial_.steps = steps_.data();
    polynomial_.step_count = steps_.size();
    polynomial_.filled = filled_.data();
    polynomial_.filled_count = filled_.size();
    polynomial_.majorant = majorant_.data();
    polynomial_.bernstein = bernstein_matrix(polynomial_.degree);
}

void StarRoots::solve(base::VectorUnit unit, const StarRays& rays, base::Run& run) const {
    const StarSolver solver = star_solver(unit);
    std::vector<double> workspace(3 * solver.lanes * polynomial_.size);
    for (std::size_t first = 0; first < rays.count; first += solver.lanes) {
        run.poll();
        solver.solve(polynomial_, rays, first, workspace.data());
    }
}

} // namespace eliminant::field
