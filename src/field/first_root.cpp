#include "first_root.hpp"

#include "first_root_kernel.hpp"

#include "base/pack_portable.hpp"

#include <array>
#include <cmath>
#include <mutex>
#include <vector>

namespace eliminant::field {
namespace {

/// One number of 106 bits as a Pack.
struct WidePack {
    using Mask = base::Doubles::Mask;
    DoubleDouble v;

    static WidePack all(double x) { return {{x, 0.0}}; }
    static Mask nowhere() { return {false}; }
    static Mask opposite(WidePack a, WidePack b) {
        return {std::signbit(a.v.high) != std::signbit(b.v.high)};
    }
    friend WidePack operator+(WidePack a, WidePack b) { return {a.v + b.v}; }
    friend WidePack operator-(WidePack a, WidePack b) { return {a.v + DoubleDouble{-b.v.high, -b.v.low}}; }
    friend WidePack operator*(WidePack a, WidePack b) { return {a.v * b.v}; }
    /// To 53 bits: quotients only propose where to look.
    friend WidePack operator/(WidePack a, WidePack b) { return all(a.v.high / b.v.high); }
    friend Mask operator>(WidePack a, WidePack b) { return {(a - b).v.high > 0.0}; }
    friend Mask operator==(WidePack a, WidePack b) { return {a.v.high == b.v.high && a.v.low == b.v.low}; }
    friend WidePack fma(WidePack a, WidePack b, WidePack c) { return {a.v * b.v + c.v}; }
    friend WidePack min(WidePack a, WidePack b) { return (b > a).bit ? a : b; }
    friend WidePack abs(WidePack a) { return std::signbit(a.v.high) ? WidePack{{-a.v.high, -a.v.low}} : a; }
    friend WidePack select(Mask mask, WidePack a, WidePack b) { return mask.bit ? a : b; }
};

struct WideLimits {
    static constexpr int most_pieces = 200;
    static constexpr double shortest_piece = 0x1p-46; // then the interval's ends are known no better
};

double to_double(double x) { return x; }
double to_double(DoubleDouble x) { return x.high; }

double high_part(base::Doubles x) { return x.v; }
double high_part(WidePack x) { return x.v.high; }

template <class Pack, class Limits, class Number>
FirstRootAnswer search(std::span<const Number> coefficients, double error, double unit, double lower,
                       double upper) {
    const std::size_t n = coefficients.size() - 1;
    double magnitude = 0.0;
    std::array<Pack, max_kernel_degree + 1> c{};
    for (std::size_t i = 0; i <= n; ++i) {
        c[i] = Pack{coefficients[i]};
        magnitude += std::fabs(to_double(coefficients[i]));
    }
    error += first_root_rounding(n) * unit * magnitude * (1.0 + 0x1p-30);
    const FirstRoot<Pack, 0, Limits> find(static_cast<int>(n), bernstein_matrix(n), error);
    const auto answer = find.find(c.data(), Pack::all(lower), Pack::all(upper));
    const double start = high_part(answer.start);
    return {answer.undecided.bit ? RayState::undecided
            : answer.found.bit   ? RayState::root
                                 : RayState::no_root,
            high_part(answer.root),
            !answer.known.bit ? 0
            : start < 0.0     ? -1
                              : 1,
            answer.steps};
}

using BernsteinMatrix = std::vector<double>;

/// x^i = (s − (1 − s))^i (s + (1 − s))^(n − i) for s = (x + 1)/2; all integers here are below 2^53.
BernsteinMatrix make_bernstein_matrix(std::size_t n) {
    std::array<std::array<double, max_kernel_degree + 1>, max_kernel_degree + 1> binomial{};
    for (std::size_t i = 0; i <= n; ++i) {
        binomial[i][0] = 1.0;
        for (std::size_t j = 1; j <= i; ++j)
            binomial[i][j] = binomial[i - 1][j - 1] + (j < i ? binomial[i - 1][j] : 0.0);
    }
    BernsteinMatrix matrix((n + 1) * (n + 1));
    for (std::size_t i = 0; i <= n; ++i)
        for (std::size_t j = 0; j <= n; ++j) {
            double sum = 0.0;
            for (std::size_t l = 0; l <= i && l <= j; ++l)
                if (j - l <= n - i)
                    sum += ((i - l) % 2 == 0 ? 1.0 : -1.0) * binomial[i][l] * binomial[n - i][j - l];
            matrix[i * (n + 1) + j] = sum;
        }
    return matrix;
}

} // namespace

FirstRootAnswer first_root(std::span<const double> coefficients, double error, double lower, double upper) {
    return search<base::Doubles, DoubleLimits>(coefficients, error, 0x1p-53, lower, upper);
}

FirstRootAnswer first_root(std::span<const DoubleDouble> coefficients, double error, double lower,
                           double upper) {
    return search<WidePack, WideLimits>(coefficients, error, DoubleDouble::unit, lower, upper);
}

const double* bernstein_matrix(std::size_t degree) {
    // Made when asked for: all of them together would take a millisecond.
    static std::array<BernsteinMatrix, max_kernel_degree + 1> matrices;
    static std::array<std::once_flag, max_kernel_degree + 1> made;
    std::call_once(made.at(degree), [degree] { matrices[degree] = make_bernstein_matrix(degree); });
    return matrices[degree].data();
}

} // namespace eliminant::field
