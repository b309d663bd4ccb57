#include "eliminant/field/first_roots.hpp"

#include "field/dyadic.hpp"
#include "field/first_root.hpp"

#include "eliminant/base/error.hpp"
#include "eliminant/field/real_roots.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace eliminant::field {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Polynomials go through the kernel so many at a time: a block of degree 18 stays in the first-level cache.
constexpr std::size_t block = 64;
static_assert(block % FirstRootBatch::padding == 0);

void require(const PolynomialBatch& batch, std::size_t roots) {
    if (batch.coefficients.size() != (batch.degree + 1) * batch.count || batch.lower.size() != batch.count ||
        batch.upper.size() != batch.count || roots != batch.count)
        throw base::DomainError("first roots: the spans' lengths do not fit degree and count");
}

/// One polynomial, however long it takes.
double decide(const std::vector<double>& p, double lower, double upper, base::Run& run) {
    if (p.size() <= max_kernel_degree + 1) {
        const std::vector<DoubleDouble> wide(p.begin(), p.end());
        const FirstRootAnswer answer = first_root(wide, 0.0, lower, upper);
        const bool near_end = std::min(answer.root - lower, upper - answer.root) < 0x1p-40;
        if (answer.state == RayState::no_root) return infinity;
        if (answer.state == RayState::root && !near_end) return answer.root;
    }
    const long exponent = common_exponent(p);
    std::vector<mpz_class> exact;
    for (const double c : p) exact.push_back(scaled_integer(c, exponent));
    if (std::ranges::all_of(exact, [](const mpz_class& c) { return c == 0; })) return lower;
    const auto root = first_real_root(exact, lower, upper, run);
    return root ? root->value : infinity;
}

/// A block of polynomials, each scaled by a power of two so that one error bound serves all.
class Block {
  public:
    Block(const PolynomialBatch& batch, FirstRootSolver solver)
        : batch_(batch), solver_(solver), coefficients_((batch.degree + 1) * block) {}

    void solve(std::size_t first, std::span<double> roots, base::Run& run) {
        const std::size_t count = std::min(block, batch_.count - first);
        load(first, count);
        const std::size_t n = batch_.degree;
        const bool in_kernel = n >= 1 && n <= max_kernel_degree;
        if (in_kernel)
            solver_({.degree = n,
                     .count = block,
                     .coefficients = coefficients_.data(),
                     .bernstein = bernstein_matrix(n),
                     .error = first_root_rounding(n) * 0x1p-53 * (1.0 + 0x1p-30),
                     .lower = lower_.data(),
                     .upper = upper_.data(),
                     .root = root_.data(),
                     .state = state_.data()});
        for (std::size_t i = 0; i < count; ++i) {
            const double lower = batch_.lower[first + i];
            const double upper = batch_.upper[first + i];
            // The kernel's pieces overlap their ends a little: only exact arithmetic tells in from out there.
            const bool near_end = std::min(root_[i] - lower, upper - root_[i]) < 0x1p-40;
            const bool sure =
                in_kernel && (state_[i] == RayState::no_root || (state_[i] == RayState::root && !near_end));
            double& root = roots[first + i];
            if (!(lower <= upper))
                root = infinity;
            else if (sure)
                root = state_[i] == RayState::root ? root_[i] : infinity;
            else
                root = decide(polynomial(first + i), lower, upper, run);
        }
    }

  private:
    void load(std::size_t first, std::size_t count) {
        std::array<double, block> sums{};
        const std::size_t n = batch_.degree;
        for (std::size_t k = 0; k <= n; ++k) {
            const double* const from = &batch_.coefficients[k * batch_.count + first];
            for (std::size_t i = 0; i < count; ++i) sums[i] += std::fabs(from[i]);
        }
        std::array<double, block> scale{};
        lower_.fill(1.0);
        upper_.fill(-1.0);
        for (std::size_t i = 0; i < count; ++i) {
            if (!std::isfinite(sums[i]) || !(std::fabs(batch_.lower[first + i]) <= 1.0) ||
                !(std::fabs(batch_.upper[first + i]) <= 1.0))
                throw base::DomainError(
                    "first roots: finite coefficients and intervals within [-1, 1] are expected");
            const int exponent = sums[i] > 0.0 ? std::ilogb(sums[i]) + 1 : 0;
            // Beyond that the scaled coefficients would be rounded: left to decide().
            const bool in_range = std::abs(exponent) < 900;
            scale[i] = in_range ? std::ldexp(1.0, -exponent) : 0.0;
            lower_[i] = batch_.lower[first + i];
            upper_[i] = batch_.upper[first + i];
        }
        for (std::size_t k = 0; k <= n; ++k) {
            const double* const from = &batch_.coefficients[k * batch_.count + first];
            for (std::size_t i = 0; i < count; ++i) coefficients_[k * block + i] = from[i] * scale[i];
        }
    }

    std::vector<double> polynomial(std::size_t i) const {
        std::vector<double> p(batch_.degree + 1);
        for (std::size_t k = 0; k < p.size(); ++k) p[k] = batch_.coefficients[k * batch_.count + i];
        return p;
    }

    const PolynomialBatch& batch_;
    FirstRootSolver solver_;
    std::vector<double> coefficients_;
    std::array<double, block> lower_{};
    std::array<double, block> upper_{};
    std::array<double, block> root_{};
    std::array<RayState, block> state_{};
};

} // namespace

void first_roots(const PolynomialBatch& batch, std::span<double> roots, base::Run& run) {
    require(batch, roots.size());
    Block solver(batch, first_root_solver(base::best_vector_unit()));
    for (std::size_t first = 0; first < batch.count; first += block) {
        run.poll();
        solver.solve(first, roots, run);
    }
}

} // namespace eliminant::field
