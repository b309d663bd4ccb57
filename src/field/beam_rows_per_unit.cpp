#include "beam_rows.hpp"
#include "first_root_kernel.hpp"

#include "base/pack.hpp"

namespace eliminant::field {
namespace {

using Pack = base::Doubles;

template <int fixed_degree>
class RowKernel {
    using Search = FirstRoot<Pack, fixed_degree>;
    using Answer = typename Search::Answer;

  public:
    explicit RowKernel(const BeamRow& row)
        : row_(row), search_(static_cast<int>(row.degree), row.bernstein, row.error) {}

    void solve() const {
        for (std::size_t first = 0; first < row_.count; first += Pack::lanes) solve_pack(first);
    }

  private:
    void solve_pack(std::size_t first) const {
        const Pack lower = Pack::load(row_.lower + first);
        const Pack upper = Pack::load(row_.upper + first);
        if (!any(~(lower > upper))) {
            for (std::size_t lane = first; lane < first + Pack::lanes; ++lane) {
                row_.state[lane] = RayState::no_root;
                row_.side[lane] = 0;
                row_.steps[lane] = 0;
            }
            return;
        }
        const Pack u = Pack::load(row_.u + first);
        Pack c[Search::capacity + 1];
        restrict_to(u, row_.coefficients, c);
        const Answer answer = search_.find(c, lower, upper);
        if (any(answer.found)) write_derivatives(first, u, c, answer.root);
        write(first, answer);
    }

    /// The polynomial in w at u: Horner's scheme for each coefficient.
    ELIMINANT_INLINE void restrict_to(Pack u, const double* table, Pack* c) const {
        const int n = search_.degree();
        Search::repeat(n + 1, [&](int k) ELIMINANT_INLINE {
            const double* const in_u = table + static_cast<std::ptrdiff_t>(k) * (n + 1);
            Pack sum = Pack::all(in_u[n - k]);
            Search::repeat(
                n - k, [&](int i) ELIMINANT_INLINE { sum = fma(sum, u, Pack::all(in_u[n - k - 1 - i])); });
            c[k] = sum;
        });
    }

    void write_derivatives(std::size_t first, Pack u, const Pack* c, Pack w) const {
        Pack value = w;
        Pack slope = w;
        search_.value_and_slope(c, w, value, slope);
        slope.store(row_.dw + first);
        Pack d[Search::capacity + 1] = {};
        restrict_to(u, row_.v_derivative, d);
        search_.value_and_slope(d, w, value, slope);
        value.store(row_.dv + first);
        const int n = search_.degree();
        Search::repeat(n + 1, [&](int k) ELIMINANT_INLINE {
            const double* const in_u = row_.coefficients + static_cast<std::ptrdiff_t>(k) * (n + 1);
            Pack sum = Pack::all(0.0);
            Search::repeat(n - k, [&](int i) ELIMINANT_INLINE {
                sum = fma(sum, u, Pack::all((n - k - i) * in_u[n - k - i]));
            });
            d[k] = sum;
        });
        search_.value_and_slope(d, w, value, slope);
        value.store(row_.du + first);
    }

    void write(std::size_t first, const Answer& answer) const {
        answer.root.store(row_.root + first);
        for (std::size_t lane = 0; lane < Pack::lanes; ++lane) {
            const std::size_t i = first + lane;
            row_.state[i] = Pack::test(answer.undecided, lane) ? RayState::undecided
                            : Pack::test(answer.found, lane)   ? RayState::root
                                                               : RayState::no_root;
            row_.steps[i] = static_cast<std::uint8_t>(answer.steps < 255 ? answer.steps : 255);
            row_.side[i] = !Pack::test(answer.known, lane) ? std::int8_t{0}
                           : answer.start.lane(lane) < 0.0 ? std::int8_t{-1}
                                                           : std::int8_t{1};
        }
    }

    const BeamRow& row_;
    Search search_;
};

template <int fixed_degree>
void solve_batch(const FirstRootBatch& batch) {
    using Search = FirstRoot<Pack, fixed_degree>;
    const Search search(static_cast<int>(batch.degree), batch.bernstein, batch.error);
    const int n = search.degree();
    for (std::size_t first = 0; first < batch.count; first += Pack::lanes) {
        Pack c[Search::capacity + 1] = {};
        Search::repeat(n + 1, [&](int k) ELIMINANT_INLINE {
            c[k] = Pack::load(batch.coefficients + static_cast<std::size_t>(k) * batch.count + first);
        });
        const auto answer = search.find(c, Pack::load(batch.lower + first), Pack::load(batch.upper + first));
        answer.root.store(batch.root + first);
        for (std::size_t lane = 0; lane < Pack::lanes; ++lane)
            batch.state[first + lane] = Pack::test(answer.undecided, lane) ? RayState::undecided
                                        : Pack::test(answer.found, lane)   ? RayState::root
                                                                           : RayState::no_root;
    }
}

} // namespace

template <base::VectorUnit unit>
void solve_beam_row(const BeamRow& row) {
    with_fixed_degree(row.degree, [&](auto n) { RowKernel<decltype(n)::value>(row).solve(); });
}

template <base::VectorUnit unit>
void first_roots(const FirstRootBatch& batch) {
    with_fixed_degree(batch.degree, [&](auto n) { solve_batch<decltype(n)::value>(batch); });
}

template void solve_beam_row<base::this_unit>(const BeamRow&);
template void first_roots<base::this_unit>(const FirstRootBatch&);

} // namespace eliminant::field
