#include "scene/grid_tracer.hpp"

#include "scene/beam_frame.hpp"
#include "scene/clip_rows.hpp"
#include "scene/finite.hpp"

#include "base/vector_unit.hpp"
#include "field/beam.hpp"
#include "field/beam_rows.hpp"
#include "field/exact_beam.hpp"
#include "field/ray_roots_data.hpp"

#include "eliminant/base/error.hpp"
#include "eliminant/field/real_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace eliminant::scene {
namespace {

void require_tile(const RayGrid& rays, const Tile& tile, std::size_t hits) {
    if (tile.column > rays.width || tile.width > rays.width - tile.column || tile.row > rays.height ||
        tile.height > rays.height - tile.row)
        throw base::DomainError("trace: the tile does not lie in the grid");
    if (hits != tile.size())
        throw base::DomainError("trace: as many hits as pixels of the tile are expected");
}

void require_grid(const RayGrid& rays, const ClipRegion& clip) {
    if (!clip.bounding_ball()) throw base::DomainError("trace: a grid of rays needs a bounded clip region");
    for (const glm::dvec3& v :
         {rays.origin, rays.origin_dx, rays.origin_dy, rays.direction, rays.direction_dx, rays.direction_dy})
        if (!is_finite(v)) throw base::DomainError("trace: the rays must be finite");
    if (rays.width == 0 || rays.height == 0) throw base::DomainError("trace: the grid has no rays");
}

/// Any grid: every ray by itself.
class RayByRayTracer final : public GridTracer {
  public:
    RayByRayTracer(const Surface& surface, const RayGrid& rays, ClipRegion clip)
        : surface_(surface), rays_(rays), clip_(std::move(clip)) {}

    void trace(const Tile& tile, std::span<Hit> hits, base::Run& run) const override {
        require_tile(rays_, tile, hits.size());
        for (std::size_t r = 0; r < tile.height; ++r)
            for (std::size_t c = 0; c < tile.width; ++c) {
                run.poll();
                const Ray ray =
                    rays_.ray(static_cast<double>(tile.column + c), static_cast<double>(tile.row + r));
                hits[r * tile.width + c] = surface_.first_hit(ray, clip_.interval(ray), run);
            }
    }

  private:
    const Surface& surface_;
    RayGrid rays_;
    ClipRegion clip_;
};

/// Blocks lie at multiples of their size, whatever tile is asked for, so that answers do not depend on tiles.
constexpr std::size_t block_size = BeamFrame::block_size;
using BlockRow = std::array<double, block_size>;

/// Where a ray stands between two slabs.
enum class Progress : std::uint8_t { done, walking, undecided };

/// One row of a block on its way through the slabs.
struct Row {
    BlockRow lower; ///< of w, in the frame; lower > upper where the ray misses the region
    BlockRow upper;
    std::array<Progress, block_size> progress;
    Hit* hits = nullptr; ///< of the block's columns
    bool walking = false;
};

class BeamTracer final : public GridTracer {
  public:
    BeamTracer(const algebra::Polynomial& f, const field::CompiledPolynomial& compiled,
               const field::RayRoots& roots, const RayGrid& rays, ClipRegion clip, BeamFrame frame,
               base::Run& run)
        : compiled_(compiled), roots_(roots), rays_(rays), clip_(std::move(clip)), frame_(std::move(frame)),
          exact_(f, frame_.forms(), run), wide_(exact_), degree_(exact_.layout().degree()),
          bernstein_(field::bernstein_matrix(degree_)),
          solve_row_(field::beam_row_solver(base::best_vector_unit())),
          clip_row_(row_clipper(base::best_vector_unit())) {}

    void trace(const Tile& tile, std::span<Hit> hits, base::Run& run) const override {
        require_tile(rays_, tile, hits.size());
        const std::size_t first_column = tile.column - tile.column % block_size;
        for (std::size_t row = tile.row - tile.row % block_size; row < tile.row + tile.height;
             row += block_size)
            for (std::size_t column = first_column; column < tile.column + tile.width; column += block_size) {
                run.poll();
                const Tile block{column, row, std::min(block_size, rays_.width - column),
                                 std::min(block_size, rays_.height - row)};
                trace_block(block, tile, hits, run);
            }
    }

  private:
    using Rows = std::array<Row, block_size>;

    void trace_block(const Tile& block, const Tile& tile, std::span<Hit> hits, base::Run& run) const {
        const bool inside = block.column >= tile.column && block.row >= tile.row &&
                            block.column + block.width <= tile.column + tile.width &&
                            block.row + block.height <= tile.row + tile.height;
        if (inside) {
            Hit* const first = &hits[(block.row - tile.row) * tile.width + block.column - tile.column];
            return trace_block(block, first, tile.width, run);
        }
        std::array<Hit, block_size * block_size> whole;
        trace_block(block, whole.data(), block_size, run);
        const std::size_t first_row = std::max(block.row, tile.row);
        const std::size_t last_row = std::min(block.row + block.height, tile.row + tile.height);
        const std::size_t first_column = std::max(block.column, tile.column);
        const std::size_t last_column = std::min(block.column + block.width, tile.column + tile.width);
        for (std::size_t r = first_row; r < last_row; ++r)
            std::copy_n(&whole[(r - block.row) * block_size + first_column - block.column],
                        last_column - first_column,
                        &hits[(r - tile.row) * tile.width + first_column - tile.column]);
    }

    /// \param hits of the block's first pixel; those of the next row are `stride` further on
    void trace_block(const Tile& block, Hit* hits, std::size_t stride, base::Run& run) const {
        Rows rows;
        for (std::size_t r = 0; r < block.height; ++r) {
            rows[r].hits = hits + r * stride;
            std::fill_n(rows[r].hits, block.width, Hit{});
        }
        const Interval range = clip(block, rows);
        if (range.empty()) return;
        const auto size = static_cast<double>(block_size);
        const field::Span in_u{frame_.u(static_cast<double>(block.column) + 0.5 * (size - 1.0)),
                               0.5 * size / frame_.half_width()};
        const field::Span in_v{frame_.v(static_cast<double>(block.row) + 0.5 * (size - 1.0)),
                               0.5 * size / frame_.half_height()};
        const field::WideBeam part = wide_.part(in_u, in_v);
        for (const field::Span& slab : slabs(range)) trace_slab(part, block, in_u, in_v, slab, rows);
        for (std::size_t r = 0; r < block.height; ++r)
            for (std::size_t c = 0; c < block.width; ++c)
                if (rows[r].progress[c] == Progress::undecided) {
                    run.poll();
                    decide(block.column + c, block.row + r, {rows[r].lower[c], rows[r].upper[c]},
                           rows[r].hits[c], run);
                }
    }

    /// The intervals of all rays of the block in w; the least interval that contains them.
    Interval clip(const Tile& block, Rows& rows) const {
        Interval range{2.0, -2.0};
        for (std::size_t r = 0; r < block.height; ++r) {
            Row& row = rows[r];
            clip_row_(
                {.first = rays_.ray(static_cast<double>(block.column), static_cast<double>(block.row + r)),
                 .origin_dx = rays_.origin_dx,
                 .direction_dx = rays_.direction_dx,
                 .region = RegionParts::of(clip_),
                 .is_pencil = frame_.is_pencil(),
                 .middle_w = frame_.middle_w(),
                 .radius_w = frame_.radius_w(),
                 .count = block_size,
                 .lower = row.lower.data(),
                 .upper = row.upper.data()});
            for (std::size_t c = 0; c < block_size; ++c) {
                const bool meets = row.lower[c] <= row.upper[c] && c < block.width;
                row.progress[c] = meets ? Progress::walking : Progress::done;
                row.walking |= meets;
                range.lower = std::min(range.lower, meets ? row.lower[c] : 2.0);
                range.upper = std::max(range.upper, meets ? row.upper[c] : -2.0);
            }
        }
        return range;
    }

    /// The range of w in pieces, front to back: where the degree is high, values differ by so many orders of
    /// magnitude along a ray that one rounding error for all of it would be too coarse.
    std::vector<field::Span> slabs(Interval range) const {
        const std::size_t count = degree_ <= 12 ? 1 : 2;
        const double step = (range.upper - range.lower) / static_cast<double>(count);
        std::vector<field::Span> result;
        for (std::size_t i = 0; i < count; ++i) {
            const double lower = range.lower + static_cast<double>(i) * step;
            const double upper = i + 1 == count ? range.upper : lower + step;
            // Slightly too wide, so that slabs overlap; the last bits would else be lost between them.
            result.push_back({0.5 * (lower + upper), 0.5 * (upper - lower) * (1.0 + 0x1p-40) + 0x1p-40});
        }
        return result;
    }

    void trace_slab(const field::WideBeam& part, const Tile& block, field::Span in_u, field::Span in_v,
                    field::Span in_w, Rows& rows) const {
        if (std::none_of(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(block.height),
                         [](const Row& row) { return row.walking; }))
            return;
        const field::Beam beam = part.slab(in_w);
        if (beam.has_no_zero()) return pass(beam, block, rows);
        for (std::size_t r = 0; r < block.height; ++r)
            if (rows[r].walking) trace_row(beam, block, r, in_u, in_v, in_w, rows[r]);
    }

    /// All rays pass a slab without zeros.
    static void pass(const field::Beam& beam, const Tile& block, Rows& rows) {
        for (std::size_t r = 0; r < block.height; ++r)
            for (std::size_t c = 0; c < block.width; ++c)
                if (Hit& hit = rows[r].hits[c]; rows[r].progress[c] == Progress::walking && hit.side == 0)
                    hit.side = beam.coefficients[0] < 0.0 ? std::int8_t{-1} : std::int8_t{1};
    }

    void trace_row(const field::Beam& beam, const Tile& block, std::size_t r, field::Span in_u,
                   field::Span in_v, field::Span in_w, Row& row) const {
        std::array<double, field::BeamRow::most_coefficients> coefficients;
        std::array<double, field::BeamRow::most_coefficients> v_derivative;
        const double v = frame_.v(static_cast<double>(block.row + r));
        beam.collapse_rows(exact_.layout(), (v - in_v.center) / in_v.radius, coefficients.data(),
                           v_derivative.data());
        BlockRow u;
        BlockRow lower;
        BlockRow upper;
        const double first_u = (frame_.u(static_cast<double>(block.column)) - in_u.center) / in_u.radius;
        const double step_u = 1.0 / (in_u.radius * frame_.half_width());
        const double per_w = 1.0 / in_w.radius;
        for (std::size_t c = 0; c < block_size; ++c) {
            u[c] = first_u + static_cast<double>(c) * step_u; // exact
            const double from = (row.lower[c] - in_w.center) * per_w - 0x1p-50;
            const double to = (row.upper[c] - in_w.center) * per_w + 0x1p-50;
            const bool walking = row.progress[c] == Progress::walking;
            lower[c] = walking ? std::max(from, -1.0) : 1.0;
            upper[c] = walking ? std::min(to, 1.0) : -1.0;
        }
        std::array<field::RayState, block_size> state;
        std::array<std::int8_t, block_size> side;
        std::array<std::uint8_t, block_size> steps;
        BlockRow root;
        BlockRow du;
        BlockRow dv;
        BlockRow dw;
        solve_row_({.degree = degree_,
                    .coefficients = coefficients.data(),
                    .v_derivative = v_derivative.data(),
                    .bernstein = bernstein_,
                    .error = beam.error + field::beam_row_rounding(degree_) * beam.magnitude,
                    .count = block_size,
                    .u = u.data(),
                    .lower = lower.data(),
                    .upper = upper.data(),
                    .state = state.data(),
                    .root = root.data(),
                    .du = du.data(),
                    .dv = dv.data(),
                    .dw = dw.data(),
                    .side = side.data(),
                    .steps = steps.data()});
        row.walking = false;
        for (std::size_t c = 0; c < block.width; ++c) {
            if (row.progress[c] != Progress::walking) continue;
            row.walking = true;
            if (lower[c] > upper[c]) continue; // later
            Hit& hit = row.hits[c];
            hit.decision = Decision::vector;
            hit.steps = static_cast<std::uint8_t>(std::min(hit.steps + steps[c], 255));
            if (hit.side == 0) hit.side = side[c];
            if (state[c] == field::RayState::no_root) continue;
            if (state[c] == field::RayState::undecided) {
                row.progress[c] = Progress::undecided;
                continue;
            }
            row.progress[c] = Progress::done;
            hit.t = frame_.t_from_w(in_w.center + in_w.radius * root[c]);
            hit.gradient = frame_.gradient(in_u.center + in_u.radius * u[c], v, hit.t, du[c] / in_u.radius,
                                           dv[c] / in_v.radius, dw[c] * per_w);
            hit.kind = HitKind::crossing;
        }
    }

    /// A ray that the beam in doubles could not decide: the beam in twice the precision; the polynomial on
    /// the ray itself, where the beam's common bounds are too coarse; integers.
    void decide(std::size_t column, std::size_t row, Interval w, Hit& hit, base::Run& run) const {
        hit = {};
        const Ray ray = rays_.ray(static_cast<double>(column), static_cast<double>(row));
        double error = 0.0;
        const auto restricted =
            wide_.on_ray(frame_.u(static_cast<double>(column)), frame_.v(static_cast<double>(row)), error);
        const field::FirstRootAnswer answer = field::first_root(restricted, error, w.lower, w.upper);
        if (answer.state != field::RayState::undecided) {
            hit.decision = Decision::wide;
            hit.steps = static_cast<std::uint8_t>(std::min(answer.steps, 255));
            hit.side = static_cast<std::int8_t>(answer.side);
            if (answer.state == field::RayState::root)
                meet(ray, frame_.t_from_w(answer.root), HitKind::crossing, hit);
            return;
        }
        const Interval t = clip_.interval(ray);
        const auto found = field::first_root_on_ray(roots_.data(), wide_ray(column, row), t.lower, t.upper);
        if (found && !t.empty()) {
            hit.decision = Decision::wide;
            hit.steps = static_cast<std::uint8_t>(std::min(found->steps, 255));
            hit.side = static_cast<std::int8_t>(found->side);
            if (found->kind == field::RayRoot::Kind::crossing) meet(ray, found->t, HitKind::crossing, hit);
            return;
        }
        decide_exactly(column, row, w, ray, hit, run);
    }

    void decide_exactly(std::size_t column, std::size_t row, Interval w, const Ray& ray, Hit& hit,
                        base::Run& run) const {
        hit.decision = Decision::exact;
        const auto exact = exact_.on_ray(frame_.exact_u(column), frame_.exact_v(row));
        if (std::ranges::all_of(exact, [](const mpz_class& c) { return c == 0; })) {
            hit.kind = HitKind::contained;
            hit.t = frame_.t_from_w(w.lower);
            return;
        }
        const auto root = field::first_real_root(exact, w.lower, w.upper, run);
        if (!root) return;
        hit.side = static_cast<std::int8_t>(root->sign_before);
        meet(ray, frame_.t_from_w(root->value),
             root->multiplicity % 2 != 0 ? HitKind::crossing : HitKind::tangency, hit);
    }

    void meet(const Ray& ray, double t, HitKind kind, Hit& hit) const {
        hit.t = t;
        hit.kind = kind;
        hit.gradient = compiled_.jet(ray.at(t)).gradient;
    }

    /// The ray without the rounding of RayGrid::ray().
    field::WideRay wide_ray(std::size_t column, std::size_t row) const {
        const field::DoubleDouble c(static_cast<double>(column));
        const field::DoubleDouble r(static_cast<double>(row));
        field::WideRay ray;
        for (int axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<std::size_t>(axis);
            const auto sum = [&](const glm::dvec3& start, const glm::dvec3& dx, const glm::dvec3& dy,
                                 double& size) {
                size = std::abs(start[axis]) + c.high * std::abs(dx[axis]) + r.high * std::abs(dy[axis]);
                return field::DoubleDouble(start[axis]) + c * field::DoubleDouble(dx[axis]) +
                       r * field::DoubleDouble(dy[axis]);
            };
            ray.origin[i] = sum(rays_.origin, rays_.origin_dx, rays_.origin_dy, ray.origin_size[i]);
            ray.direction[i] =
                sum(rays_.direction, rays_.direction_dx, rays_.direction_dy, ray.direction_size[i]);
        }
        return ray;
    }

    const field::CompiledPolynomial& compiled_;
    const field::RayRoots& roots_;
    RayGrid rays_;
    ClipRegion clip_;
    BeamFrame frame_;
    field::ExactBeam exact_;
    field::WideBeam wide_;
    std::size_t degree_;
    const double* bernstein_;
    field::BeamRowSolver solve_row_;
    RowClipper clip_row_;
};

} // namespace

std::unique_ptr<GridTracer> make_ray_by_ray_tracer(const Surface& surface, const RayGrid& rays,
                                                   const ClipRegion& clip) {
    require_grid(rays, clip);
    return std::make_unique<RayByRayTracer>(surface, rays, clip);
}

std::unique_ptr<GridTracer> make_grid_tracer(const algebra::Polynomial& f,
                                             const field::CompiledPolynomial& compiled,
                                             const field::RayRoots& roots, const Surface& surface,
                                             const RayGrid& rays, const ClipRegion& clip, base::Run& run) {
    require_grid(rays, clip);
    if (!roots.data().sparse && f.total_degree() <= static_cast<std::int64_t>(field::max_kernel_degree)) {
        const double free_radius = surface.distance(rays.origin, field::DistanceLevel::guaranteed);
        if (auto frame = BeamFrame::make(rays, *clip.bounding_ball(), free_radius))
            return std::make_unique<BeamTracer>(f, compiled, roots, rays, clip, std::move(*frame), run);
    }
    return std::make_unique<RayByRayTracer>(surface, rays, clip);
}

} // namespace eliminant::scene
