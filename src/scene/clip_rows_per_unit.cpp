/// \file
/// The formulas and their margins are explained in clip_region.cpp.
#include "clip_rows.hpp"

#include "base/pack.hpp"

#include <cmath>
#include <limits>

namespace eliminant::scene {
namespace {

using Pack = base::Doubles;

struct Vector {
    Pack x, y, z;
};

Vector along(const glm::dvec3& start, const glm::dvec3& step, Pack i) {
    return {fma(Pack::all(step.x), i, Pack::all(start.x)), fma(Pack::all(step.y), i, Pack::all(start.y)),
            fma(Pack::all(step.z), i, Pack::all(start.z))};
}
Pack dot(const Vector& a, const Vector& b) { return fma(a.x, b.x, fma(a.y, b.y, a.z * b.z)); }
Vector all(const glm::dvec3& v) { return {Pack::all(v.x), Pack::all(v.y), Pack::all(v.z)}; }
Vector abs(const Vector& v) { return {abs(v.x), abs(v.y), abs(v.z)}; }

/// The part of rays that lies in a region, cut by one ball or half-space after the other.
class PackClip {
    using Mask = Pack::Mask;
    static constexpr double slack = 0x1p-48;

  public:
    PackClip(const Vector& origin, const Vector& direction, double reach)
        : origin_(origin), direction_(direction),
          inverse_length_(Pack::all(1.0) / sqrt(dot(direction, direction))), lower_(Pack::all(0.0)),
          upper_(Pack::all(reach)) {}

    void intersect(const RegionParts& region) {
        for (std::size_t b = 0; b < region.ball_count; ++b) intersect(region.balls[b]);
        for (std::size_t h = 0; h < region.half_space_count; ++h) intersect(region.half_spaces[h]);
    }
    Pack lower() const { return lower_; } ///< of t
    Pack upper() const { return upper_; } ///< less than lower() for a ray that misses

  private:
    void intersect(const Ball& ball) {
        const Vector center = all(ball.center);
        const Vector from{origin_.x - center.x, origin_.y - center.y, origin_.z - center.z};
        const Pack nearest = Pack::all(0.0) - dot(from, direction_) * inverse_length_ * inverse_length_;
        const Vector offset{fma(nearest, direction_.x, from.x), fma(nearest, direction_.y, from.y),
                            fma(nearest, direction_.z, from.z)};
        // The sum norm is at least the length that the margin needs.
        const Vector sizes = abs(origin_);
        const Pack scale = sizes.x + sizes.y + sizes.z +
                           Pack::all(std::fabs(ball.center.x) + std::fabs(ball.center.y) +
                                     std::fabs(ball.center.z) + ball.radius);
        const Pack margin = Pack::all(slack) * scale;
        const Pack radius = Pack::all(ball.radius) + margin;
        const Pack squared = radius * radius - dot(offset, offset);
        const Pack zero = Pack::all(0.0);
        const Pack reach = (sqrt(max(squared, zero)) + margin) * inverse_length_;
        const Mask misses = zero > squared;
        lower_ = select(misses, Pack::all(1.0), max(lower_, nearest - reach));
        upper_ = select(misses, zero - Pack::all(1.0), min(upper_, nearest + reach));
    }

    void intersect(const HalfSpace& half_space) {
        const Vector normal = all(half_space.normal);
        const Vector sizes = abs(normal);
        const Pack slope = dot(normal, direction_);
        const Pack room = Pack::all(half_space.offset) - dot(normal, origin_);
        const Pack margin =
            Pack::all(slack) * (dot(sizes, abs(origin_)) + Pack::all(std::fabs(half_space.offset)));
        const Pack zero = Pack::all(0.0);
        const Mask level = ~(abs(slope) > Pack::all(0x1p-51) * dot(sizes, abs(direction_)));
        const Mask outside = level & (zero > room + margin);
        const Pack end = room / slope;
        const Pack reach = margin / abs(slope) + Pack::all(slack) * abs(end);
        const Mask leaving = ~level & (slope > zero);
        const Mask entering = ~level & ~(slope > zero);
        upper_ = select(leaving, min(upper_, end + reach), upper_);
        lower_ = select(entering, max(lower_, end - reach), lower_);
        lower_ = select(outside, Pack::all(1.0), lower_);
        upper_ = select(outside, zero - Pack::all(1.0), upper_);
    }

    Vector origin_, direction_;
    Pack inverse_length_;
    Pack lower_, upper_;
};

/// Rays of a row.
class RowClip {
    using Mask = Pack::Mask;
    static constexpr double slack = 0x1p-48;

  public:
    explicit RowClip(const ClipRow& row) : row_(row) {}

    void clip(std::size_t first) const {
        double numbers[Pack::lanes];
        for (std::size_t lane = 0; lane < Pack::lanes; ++lane)
            numbers[lane] = static_cast<double>(first + lane);
        const Pack i = Pack::load(numbers);
        PackClip clip(along(row_.first.origin, row_.origin_dx, i),
                      along(row_.first.direction, row_.direction_dx, i),
                      std::numeric_limits<double>::infinity());
        clip.intersect(row_.region);
        write(first, clip.lower(), clip.upper());
    }

  private:
    void write(std::size_t first, Pack from, Pack to) const {
        const Mask empty = from > to;
        const Pack one = Pack::all(1.0);
        const Pack minus_one = Pack::all(-1.0);
        if (row_.is_pencil) {
            from = minus_one / from;
            to = minus_one / to;
        }
        const Pack middle = Pack::all(row_.middle_w);
        const Pack inverse = Pack::all(1.0 / row_.radius_w);
        const Pack margin = Pack::all(slack * (std::fabs(row_.middle_w) + row_.radius_w) / row_.radius_w);
        select(empty, one, max((from - middle) * inverse - margin, minus_one)).store(row_.lower + first);
        select(empty, minus_one, min((to - middle) * inverse + margin, one)).store(row_.upper + first);
    }

    const ClipRow& row_;
};

} // namespace

template <base::VectorUnit unit>
void clip_row(const ClipRow& row) {
    const RowClip clip(row);
    for (std::size_t first = 0; first < row.count; first += Pack::lanes) clip.clip(first);
}

template <base::VectorUnit unit>
void clip_stars(const ClipStars& stars) {
    const auto load = [](const double* const* columns, std::size_t at) {
        return Vector{Pack::load(columns[0] + at), Pack::load(columns[1] + at), Pack::load(columns[2] + at)};
    };
    for (std::size_t ray = 0; ray < stars.rays; ++ray)
        for (std::size_t first = 0; first < stars.count; first += Pack::lanes) {
            const std::size_t at = ray * stars.count + first;
            PackClip clip(load(stars.origin, first), load(stars.direction, at), stars.reach);
            clip.intersect(stars.region);
            clip.lower().store(stars.lower + at);
            clip.upper().store(stars.upper + at);
        }
}

template void clip_row<base::this_unit>(const ClipRow&);
template void clip_stars<base::this_unit>(const ClipStars&);

} // namespace eliminant::scene
