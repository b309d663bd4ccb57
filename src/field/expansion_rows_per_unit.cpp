#include "field/expansion_rows.hpp"

#include "base/pack.hpp"

namespace eliminant::field {
namespace {

// A lane a point.
using Pack = base::Doubles;

class ExpansionKernel {
  public:
    ExpansionKernel(const ExpansionView& f, const double* const* points, double* workspace, double* rows)
        : f_(f), entries_(workspace), sums_(workspace + f.size * Pack::lanes), row_(rows) {
        for (int level = 0; level < 3; ++level) point_[level] = Pack::load(points[f.coordinates[level]]);
    }

    void run() {
        shift();
        for (int i = 0; i < 10; ++i) put(f_.low[i] == TaylorScheme::none ? Pack::all(0.0) : entry(f_.low[i]));
        const TaylorScheme::Component* component = f_.components;
        for (std::size_t k = 3; k <= f_.degree; ++k) {
            Pack sum = Pack::all(0.0);
            for (const auto* end = f_.components + f_.component_ends[k - 3]; component != end; ++component) {
                const Pack c = entry(component->entry);
                sum = fma(Pack::all(component->weight), c * c, sum);
            }
            put(sum);
        }
        put_errors();
    }

  private:
    Pack entry(std::size_t i) const { return Pack::load(entries_ + i * Pack::lanes); }
    void put(Pack value) {
        value.store(row_);
        row_ += Pack::lanes;
    }

    /// See shift_to().
    void shift() {
        for (std::size_t i = 0; i < f_.size; ++i) Pack::all(f_.entries[i]).store(entries_ + i * Pack::lanes);
        for (const auto* line = f_.lines; line != f_.lines_end; ++line) {
            double* c = entries_ + line->first * Pack::lanes;
            for (std::uint32_t done = 0; done + 1 < line->count; ++done) {
                Pack above = Pack::load(c + (line->count - 1) * Pack::lanes);
                for (std::uint32_t k = line->count - 1; k > done; --k) {
                    above = fma(point_[2], above, Pack::load(c + (k - 1) * Pack::lanes));
                    above.store(c + (k - 1) * Pack::lanes);
                }
            }
        }
        for (const auto* step = f_.steps; step != f_.steps_end; ++step) {
            double* to = entries_ + step->to * Pack::lanes;
            const double* from = entries_ + step->from * Pack::lanes;
            for (std::size_t k = 0; k < step->count * Pack::lanes; k += Pack::lanes)
                fma(point_[step->level], Pack::load(from + k), Pack::load(to + k)).store(to + k);
        }
    }

    /// See shifted_majorant().
    void put_errors() {
        const Pack r = max(max(abs(point_[0]), abs(point_[1])), abs(point_[2]));
        for (std::size_t k = 0; k <= f_.degree; ++k) Pack::all(f_.majorant[k]).store(sums_ + k * Pack::lanes);
        for (std::size_t done = 0; done < f_.degree; ++done) {
            Pack above = Pack::load(sums_ + f_.degree * Pack::lanes);
            for (std::size_t k = f_.degree; k > done; --k) {
                above = fma(r, above, Pack::load(sums_ + (k - 1) * Pack::lanes));
                above.store(sums_ + (k - 1) * Pack::lanes);
            }
        }
        const Pack factor = Pack::all(f_.error_factor);
        for (std::size_t k = 0; k <= f_.degree; ++k) put(Pack::load(sums_ + k * Pack::lanes) * factor);
    }

    const ExpansionView& f_;
    double* entries_;
    double* sums_;
    double* row_;
    Pack point_[3];
};

void expand(const ExpansionView& f, const double* const* points, double* workspace, double* rows) {
    ExpansionKernel(f, points, workspace, rows).run();
}

} // namespace

template <base::VectorUnit unit>
Expander expander_of() {
    return {expand, Pack::lanes};
}

template Expander expander_of<base::this_unit>();

} // namespace eliminant::field
