#include "field/positive_root.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eliminant::field {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

struct Sides {
    double gained = 0; ///< what is positive in φ
    double lost = 0;   ///< what is subtracted
    double slope = 0;  ///< φ'
};

Sides sides_at(const FallingPolynomial& phi, double rho) {
    double sum = 0;
    double derivative = 0;
    for (std::size_t i = phi.higher.size(); i-- > 0;) {
        derivative = derivative * rho + sum;
        sum = sum * rho + phi.higher[i];
    }
    const double square = rho * rho;
    Sides result{phi.value, (sum * rho) * square + phi.linear * rho, 0};
    (phi.quadratic < 0 ? result.gained : result.lost) += std::abs(phi.quadratic) * square;
    result.slope = -(derivative * rho + 3 * sum) * square - 2 * phi.quadratic * rho - phi.linear;
    return result;
}

/// Whether φ(rho) > 0 whatever rounding did: both sides are sums of positive products.
bool is_positive(const FallingPolynomial& phi, double rho) {
    const double slack = static_cast<double>(4 * phi.higher.size() + 32) * 0x1p-53;
    const Sides sides = sides_at(phi, rho);
    return sides.gained * (1 - slack) > sides.lost * (1 + slack);
}

bool is_constant(const FallingPolynomial& phi) {
    return phi.linear == 0 && phi.quadratic == 0 &&
           std::ranges::all_of(phi.higher, [](double a) { return a == 0; });
}

/// Some ρ with Σ higher[i] ρ^(3+i) ≥ value, or as far as numbers reach.
double reach_of_higher(const FallingPolynomial& phi) {
    double reach = largest;
    for (std::size_t i = 0; i < phi.higher.size(); ++i)
        if (phi.higher[i] > 0)
            reach = std::min(reach, std::pow(phi.value / phi.higher[i], 1.0 / static_cast<double>(3 + i)));
    return std::min(reach * (1 + 0x1p-40), largest);
}

/// Newton's iteration on [0, most], where φ falls, then down until the sign is certain.
double root_below(const FallingPolynomial& phi, double most) {
    double rho = most;
    // Far out, where the higher powers rule, an iteration would gain only a factor (k − 1)/k.
    if (const Sides sides = sides_at(phi, most); !(sides.lost <= 16 * sides.gained))
        rho = std::min(most, reach_of_higher(phi));
    for (int i = 0; i < 40; ++i) {
        const Sides sides = sides_at(phi, rho);
        const double step = (sides.gained - sides.lost) / sides.slope;
        double next = rho - step;
        if (!(next > 0)) next = rho / 2;
        next = std::min(next, most);
        const bool settled = std::abs(next - rho) <= 0x1p-38 * rho;
        rho = next;
        if (settled) break;
    }
    double retreat = 0x1p-46;
    for (; rho > 0 && retreat < 1; retreat *= 16) {
        rho *= 1 - retreat;
        if (is_positive(phi, rho)) return rho;
    }
    return 0;
}

/// φ for a parabola that opens upwards: it falls up to the vertex only.
double positive_until_rising(const FallingPolynomial& phi) {
    const double bend = -phi.quadratic;
    const double vertex = phi.linear / (2 * bend) * (1 - 0x1p-50);
    const double lowest = (phi.value - phi.linear * phi.linear / (4 * bend) * (1 + 0x1p-48)) * (1 - 0x1p-50);
    if (!(lowest > 0)) { // the parabola has a zero, or nearly, before its vertex
        const double inside = std::max(0.0, phi.linear * phi.linear - 4 * bend * phi.value);
        return root_below(phi, std::min(vertex, 2 * phi.value / (phi.linear + std::sqrt(inside))));
    }
    // It is at least `lowest` everywhere.
    const FallingPolynomial rest{lowest, 0, 0, phi.higher};
    const double beyond = is_constant(rest) ? infinity : root_below(rest, reach_of_higher(rest));
    if (beyond > vertex || vertex == 0) return beyond;
    return is_positive(phi, vertex) ? vertex : std::max(beyond, root_below(phi, vertex));
}

} // namespace

double positive_until(const FallingPolynomial& phi) {
    const bool is_finite = std::isfinite(phi.value) && std::isfinite(phi.linear) &&
                           std::isfinite(phi.quadratic) &&
                           std::ranges::all_of(phi.higher, [](double a) { return std::isfinite(a); });
    if (!is_finite || !(phi.value > 0)) return 0;
    if (phi.quadratic < 0) return positive_until_rising(phi);
    // φ is concave: Newton's iteration from above stays above.
    if (is_constant(phi)) return infinity;
    if (phi.linear == 0 && phi.quadratic == 0) return root_below(phi, reach_of_higher(phi));
    const double inside = phi.linear * phi.linear + 4 * phi.quadratic * phi.value;
    return root_below(phi, std::min(2 * phi.value / (phi.linear + std::sqrt(inside)), largest));
}

} // namespace eliminant::field
