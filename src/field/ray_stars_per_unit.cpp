#include "first_root_kernel.hpp"
#include "ray_stars.hpp"

#include "base/pack.hpp"

namespace eliminant::field {
namespace {

// A lane a point.
using Pack = base::Doubles;

/// A Taylor coefficient in doubles.
struct NarrowEntry {
    static constexpr std::size_t width = Pack::lanes; ///< in memory
    static constexpr double unit = 0x1p-53;
    Pack v;

    static NarrowEntry all(double high, double /*low*/) { return {Pack::all(high)}; }
    static NarrowEntry load(const double* p) { return {Pack::load(p)}; }
    void store(double* p) const { v.store(p); }
    Pack rounded() const { return v; }
    /// *this + t·other
    NarrowEntry plus(Pack t, NarrowEntry other) const { return {fma(t, other.v, v)}; }
};

/// The same in twice the precision.
struct WideEntry {
    static constexpr std::size_t width = 2 * Pack::lanes;
    static constexpr double unit = 0x1p-101; ///< of each step below, relative to |*this| + |t·other|
    Pack high, low;

    static WideEntry all(double high, double low) { return {Pack::all(high), Pack::all(low)}; }
    static WideEntry load(const double* p) { return {Pack::load(p), Pack::load(p + Pack::lanes)}; }
    void store(double* p) const {
        high.store(p);
        low.store(p + Pack::lanes);
    }
    Pack rounded() const { return high; }
    WideEntry plus(Pack t, WideEntry other) const {
        const Pack zero = Pack::all(0.0);
        const Pack product = t * other.high;
        const Pack product_error = fused(t, other.low, fused(t, other.high, zero - product));
        const Pack sum = high + product; // Knuth's two-sum
        const Pack part = sum - high;
        const Pack sum_error = (high - (sum - part)) + (product - part);
        const Pack rest = low + (product_error + sum_error);
        const Pack total = sum + rest;
        return {total, rest - (total - sum)};
    }
};

template <int fixed_degree>
class StarKernel {
    using Search = FirstRoot<Pack, fixed_degree>;
    using Mask = Pack::Mask;

  public:
    /// \param first of Pack::lanes points
    StarKernel(const StarPolynomial& f, const StarRays& rays, std::size_t first, double* workspace)
        : f_(f), rays_(rays), first_(first), entries_(workspace), wide_(workspace + f.size * Pack::lanes) {}

    void solve() {
        expand();
        for (std::size_t ray = 0; ray < rays_.rays; ++ray) solve_ray(ray * rays_.count + first_);
    }

  private:
    int degree() const { return fixed_degree > 0 ? fixed_degree : static_cast<int>(f_.degree); }

    /// Σ majorant[m]·r^m: bounds the sum of the absolute values of all terms where coordinates are up to r.
    Pack majorant(Pack r) const {
        Pack sum = Pack::all(0.0);
        for (int m = degree(); m >= 0; --m) sum = fma(sum, r, Pack::all(f_.majorant[m]));
        return sum;
    }

    /// The Taylor coefficients at the points, in doubles where these tell the sign of the value there with
    /// some room.
    void expand() {
        reach_ = Pack::all(0.0);
        for (int level = 0; level < 3; ++level) {
            origin_[level] = Pack::load(rays_.origin[f_.coordinates[level]] + first_);
            reach_ = max(reach_, abs(origin_[level]));
        }
        shift<NarrowEntry>(entries_);
        const Pack unsafe = Pack::all(64.0) * shift_rounding(NarrowEntry::unit) * majorant(reach_);
        unit_ = NarrowEntry::unit;
        if (any(~(abs(Pack::load(entries_)) > unsafe))) {
            shift<WideEntry>(wide_);
            for (std::size_t e = 0; e < f_.size; ++e)
                WideEntry::load(wide_ + e * WideEntry::width).rounded().store(entries_ + e * Pack::lanes);
            unit_ = WideEntry::unit;
        }
        measure();
    }

    /// A coefficient takes part in at most n multiplications and additions along each coordinate.
    Pack shift_rounding(double unit) const { return Pack::all((6.0 * degree() + 4.0) * unit); }

    template <class Entry>
    void shift(double* entries) const {
        const auto at = [&](std::size_t e) ELIMINANT_INLINE { return entries + e * Entry::width; };
        for (std::size_t e = 0; e < f_.size; ++e) Entry::all(f_.high[e], f_.low[e]).store(at(e));
        for (std::size_t l = 0; l < f_.line_count; ++l) {
            const StarPolynomial::Line& line = f_.lines[l];
            for (std::uint32_t done = 0; done + 1 < line.count; ++done) {
                Entry sum = Entry::load(at(line.first + line.count - 1));
                for (std::uint32_t k = line.count - 1; k > done; --k) {
                    sum = Entry::load(at(line.first + k - 1)).plus(origin_[2], sum);
                    sum.store(at(line.first + k - 1));
                }
            }
        }
        for (std::size_t s = 0; s < f_.step_count; ++s) {
            const StarPolynomial::Step& step = f_.steps[s];
            const Pack t = origin_[step.level];
            for (std::uint32_t k = 0; k < step.count; ++k)
                Entry::load(at(step.to + k)).plus(t, Entry::load(at(step.from + k))).store(at(step.to + k));
        }
    }

    /// The sums of the absolute values of the coefficients of each order.
    void measure() {
        for (int m = 0; m <= degree(); ++m) sizes_[m] = Pack::all(0.0);
        for (std::size_t l = 0; l < f_.filled_count; ++l) {
            const StarPolynomial::Line& line = f_.filled[l];
            for (std::uint32_t k = 0; k < line.count; ++k) {
                Pack& size = sizes_[line.i + line.j + k];
                size = size + abs(Pack::load(entries_ + (line.first + k) * Pack::lanes));
            }
        }
    }

    void solve_ray(std::size_t at) {
        const Pack lower = Pack::load(rays_.lower + at);
        const Pack upper = Pack::load(rays_.upper + at);
        const Mask asked = ~(lower > upper);
        if (!any(asked)) return write(at, {Pack::nowhere(), Pack::nowhere()});
        Pack direction[3];
        Pack reach = Pack::all(0.0);
        for (int level = 0; level < 3; ++level) {
            direction[level] = Pack::load(rays_.direction[f_.coordinates[level]] + at) * upper;
            reach = max(reach, abs(direction[level]));
        }
        const Mask usable =
            asked & (upper > Pack::all(0.0)) & (Pack::all(0x1p900) > majorant(reach_ + reach));
        Pack c[Search::capacity + 1];
        restrict_to(direction, c);
        auto answer = search(c, reach, usable, lower / upper);
        answer.undecided = answer.undecided | (asked & ~usable);
        write(at, answer);
    }

    /// Whether there is a root x ∈ [from, 1], part by part where one bound of the error is too coarse for all
    /// of it: next to the origin, which is next to the surface, values are small and errors may not be large.
    typename Search::Existence search(const Pack* c, Pack reach, Mask asked, Pack from) const {
        constexpr int most_parts = 12;
        const Pack one = Pack::all(1.0);
        typename Search::Existence answer{Pack::nowhere(), Pack::nowhere()};
        Mask open = asked;
        Pack to = one;
        for (int part = 0; part < most_parts && any(open); ++part) {
            Pack scaled[Search::capacity + 1];
            Pack power = one;
            for (int m = 0; m <= degree(); ++m) {
                scaled[m] = c[m] * power;
                power = power * to;
            }
            const Search here(degree(), f_.bernstein, error(reach * to));
            const auto found =
                here.exists(scaled, select(open, from / to, one), select(open, one, Pack::all(-1.0)));
            answer.found = answer.found | found.found;
            open = open & ~found.found;
            const Mask passed = open & ~found.undecided;
            open = open & ~(passed & ~(one > to));
            const Pack nearer = fma(to - from, Pack::all(0.125), from);
            from = select(passed, to, from);
            to = select(passed, one, nearer);
        }
        answer.undecided = open;
        return answer;
    }

    /// The coefficients of f(origin + x·direction) in x ∈ [0, 1].
    void restrict_to(const Pack* direction, Pack* c) const {
        Pack powers[3][Search::capacity + 1];
        for (int level = 0; level < 3; ++level) {
            powers[level][0] = Pack::all(1.0);
            for (int m = 0; m < degree(); ++m) powers[level][m + 1] = powers[level][m] * direction[level];
        }
        for (int m = 0; m <= degree(); ++m) c[m] = Pack::all(0.0);
        for (std::size_t l = 0; l < f_.filled_count; ++l) {
            const StarPolynomial::Line& line = f_.filled[l];
            const Pack factor = powers[0][line.i] * powers[1][line.j];
            const double* const entries = entries_ + line.first * Pack::lanes;
            Pack* const to = c + line.i + line.j;
            for (std::uint32_t k = 0; k < line.count; ++k)
                to[k] = fma(Pack::load(entries + k * Pack::lanes), factor * powers[2][k], to[k]);
        }
    }

    /// Of the coefficients of a ray whose steps have coordinates up to `reach`, and of the search.
    ///
    /// The expansion errs by its rounding of the absolute terms of f at the far end; forming the ray's
    /// polynomial from it by 4n + 6 roundings of each product, and a sum over the lines.
    Pack error(Pack reach) const {
        const int n = degree();
        Pack sum = Pack::all(0.0);
        for (int m = n; m >= 0; --m) sum = fma(sum, reach, sizes_[m]);
        const double roundings =
            static_cast<double>(f_.filled_count) + 4.0 * n + 6.0 + first_root_rounding(f_.degree);
        const Pack forming = Pack::all((roundings * 0x1p-53 + Search::overhang(n)) * (1.0 + 0x1p-20));
        return fma(forming, sum, fma(shift_rounding(unit_), majorant(reach_ + reach), Pack::all(0x1p-960)));
    }

    void write(std::size_t at, const typename Search::Existence& answer) const {
        for (std::size_t lane = 0; lane < Pack::lanes; ++lane)
            rays_.state[at + lane] = Pack::test(answer.found, lane)       ? RayState::root
                                     : Pack::test(answer.undecided, lane) ? RayState::undecided
                                                                          : RayState::no_root;
    }

    const StarPolynomial& f_;
    const StarRays& rays_;
    std::size_t first_;
    double* entries_; ///< Taylor coefficients at the points, a Pack each
    double* wide_;    ///< memory for the same as WideEntry
    Pack origin_[3];  ///< by levels, as direction
    Pack reach_;      ///< bounds the coordinates of the origins
    double unit_ = 0; ///< of the arithmetic of the expansion
    Pack sizes_[Search::capacity + 1];
};

// NOLINTBEGIN(readability-non-const-parameter): the kernel writes to its workspace
void solve_stars(const StarPolynomial& f, const StarRays& rays, std::size_t first, double* workspace) {
    with_fixed_degree(f.degree,
                      [&](auto n) { StarKernel<decltype(n)::value>(f, rays, first, workspace).solve(); });
}
// NOLINTEND(readability-non-const-parameter)

} // namespace

template <base::VectorUnit unit>
StarSolver star_solver_of() {
    return {solve_stars, Pack::lanes};
}

template StarSolver star_solver_of<base::this_unit>();

} // namespace eliminant::field
