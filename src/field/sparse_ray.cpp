#include "field/sparse_ray.hpp"

#include "field/bounds.hpp"
#include "field/dyadic.hpp"

#include <algorithm>
#include <cmath>

namespace eliminant::field {

/// t ↦ f(origin + t·direction).
class SparseRay::Restriction {
  public:
    Restriction(const SparseRay& f, const glm::dvec3& origin, const glm::dvec3& direction)
        : f_(f), origin_(origin), direction_(direction) {
        for (std::size_t axis = 0; axis < 3; ++axis) powers_[axis].resize(f.exponents_[axis].size());
    }

    /// Whether every number that occurs between these ends stays in the range of doubles.
    bool is_in_range(double lower, double upper) const {
        double reach = 1.0;
        double speed = 1.0;
        for (int axis = 0; axis < 3; ++axis) {
            for (const double t : {lower, upper})
                reach =
                    std::max(reach, std::abs(origin_[axis] + t * direction_[axis]) +
                                        0x1p-40 * (std::abs(origin_[axis]) + std::abs(t * direction_[axis])));
            speed = std::max(speed, std::abs(direction_[axis]));
        }
        const auto n = static_cast<double>(f_.degree_);
        return n * std::log2(reach) + std::log2(f_.coefficient_sum_ * (3.0 * n + 1.0) * speed) < 900.0;
    }

    Bounds value(double t) {
        raise({t, t});
        return value();
    }
    struct Jet {
        Bounds value;
        Bounds derivative;
    };
    /// On the whole interval; the value also by the mean value theorem.
    Jet jet(Bounds t) {
        const double middle = t.middle();
        const Bounds at_middle = value(middle);
        raise(t);
        const Bounds slope = derivative();
        return {intersection(value(), at_middle + slope * (t - Bounds{middle, middle})), slope};
    }

  private:
    void raise(Bounds t) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<std::size_t>(axis);
            const Bounds o{origin_[axis], origin_[axis]};
            const Bounds d{direction_[axis], direction_[axis]};
            const Bounds x = o + d * t;
            for (std::size_t i = 0; i < powers_[a].size(); ++i) powers_[a][i] = power(x, f_.exponents_[a][i]);
        }
    }
    static Bounds coefficient(const Term& term) { return outward(term.coefficient, term.coefficient); }

    Bounds value() const {
        Bounds sum;
        for (const Term& term : f_.terms_)
            sum = sum + coefficient(term) * powers_[0][term.power[0]] * powers_[1][term.power[1]] *
                            powers_[2][term.power[2]];
        return sum;
    }
    Bounds derivative() const {
        Bounds sum;
        for (const Term& term : f_.terms_) {
            Bounds slope;
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const std::size_t place = term.power[axis];
                const auto exponent = static_cast<double>(f_.exponents_[axis][place]);
                if (exponent == 0.0) continue;
                const double speed = direction_[static_cast<int>(axis)];
                const std::size_t second = (axis + 1) % 3;
                const std::size_t third = (axis + 2) % 3;
                slope = slope + Bounds{exponent, exponent} * Bounds{speed, speed} * powers_[axis][place - 1] *
                                    powers_[second][term.power[second]] * powers_[third][term.power[third]];
            }
            sum = sum + coefficient(term) * slope;
        }
        return sum;
    }

    const SparseRay& f_;
    glm::dvec3 origin_;
    glm::dvec3 direction_;
    std::array<std::vector<Bounds>, 3> powers_; ///< of the point or interval raised last
};

namespace {

/// The root of a monotone function with different signs at the ends, the first of which is `side`.
///
/// By bisection where Newton's step does not gain more: next to a high power the slopes in a bracket are of
/// all orders of magnitude.
template <class Restriction>
Bounds refined(Restriction& f, Bounds bracket, int side, int& steps) {
    for (;;) {
        ++steps;
        const double middle = bracket.middle();
        const Bounds value = f.value(middle);
        const Bounds slope = f.jet(bracket).derivative;
        Bounds next = bracket;
        if (slope.lower > 0x1p-100 || slope.upper < -0x1p-100) // else a quotient may overflow
            next = intersection(bracket, Bounds{middle, middle} - value / slope);
        if (!(next.width() < 0.5 * bracket.width()) || !(next.lower <= next.upper)) {
            const int sign = value.sign();
            if (sign == 0 || !(bracket.lower < middle && middle < bracket.upper)) return bracket;
            next = sign == side ? Bounds{middle, bracket.upper} : Bounds{bracket.lower, middle};
        }
        bracket = next;
    }
}

} // namespace

bool SparseRay::is_for(const algebra::Polynomial& f) {
    constexpr double term_cost = 50.0;
    constexpr std::int64_t least_degree = 13;
    constexpr std::int64_t most_degree = 1000;
    if (f.total_degree() < least_degree || f.total_degree() > most_degree) return false;
    const auto n = static_cast<double>(f.total_degree());
    return term_cost * static_cast<double>(f.size()) < (n + 1.0) * (n + 2.0) * (n + 3.0) / 6.0;
}

SparseRay::SparseRay(const algebra::Polynomial& f) : degree_(static_cast<std::size_t>(f.total_degree())) {
    const std::size_t variables = f.ring().variable_count();
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<std::size_t>& exponents = exponents_[axis];
        exponents.push_back(0);
        for (std::size_t i = 0; axis < variables && i < f.size(); ++i)
            if (const auto e = static_cast<std::size_t>(f.exponent(i, axis)); e > 0)
                exponents.insert(exponents.end(), {e - 1, e});
        std::ranges::sort(exponents);
        exponents.erase(std::unique(exponents.begin(), exponents.end()), exponents.end());
    }
    std::size_t bits = 0;
    for (const algebra::Integer& c : f.integer_terms().coefficients) bits = std::max(bits, c.bit_length());
    for (std::size_t i = 0; i < f.size(); ++i) {
        Term term{};
        const mpz_class exact = f.integer_terms().coefficients[i].to_mpz();
        term.coefficient = to_double_double(exact, static_cast<long>(bits)).high;
        for (std::size_t axis = 0; axis < variables; ++axis) {
            const auto e = static_cast<std::size_t>(f.exponent(i, axis));
            term.power[axis] = static_cast<std::size_t>(std::ranges::lower_bound(exponents_[axis], e) -
                                                        exponents_[axis].begin());
        }
        coefficient_sum_ += std::abs(term.coefficient);
        terms_.push_back(term);
    }
}

std::optional<RayRoot> SparseRay::first(const glm::dvec3& origin, const glm::dvec3& direction, double lower,
                                        double upper, const base::Run& run) const {
    constexpr int most_steps = 500;
    if (!(lower < upper) || !std::isfinite(upper)) return std::nullopt;
    Restriction f(*this, origin, direction);
    if (!f.is_in_range(lower, upper)) return std::nullopt;
    RayRoot root;
    root.side = f.value(lower).sign();
    if (root.side == 0) return std::nullopt;
    const double length = upper - lower;
    // What is not searched yet, the next part last. The sign at the start of the next part is root.side.
    std::vector<Bounds> pending{{lower, upper}};
    while (!pending.empty()) {
        run.poll();
        const Bounds t = pending.back();
        pending.pop_back();
        if (++root.steps > most_steps || t.width() < 0x1p-40 * length) return std::nullopt;
        const auto jet = f.jet(t);
        if (jet.value.excludes_zero()) continue;
        if (!jet.derivative.excludes_zero()) {
            const double middle = t.middle();
            pending.push_back({middle, t.upper});
            pending.push_back({t.lower, middle});
            continue;
        }
        const int sign_after = f.value(t.upper).sign();
        if (sign_after == 0) return std::nullopt;
        if (sign_after == root.side) continue;
        const Bounds bracket = refined(f, t, root.side, root.steps);
        if (!(bracket.width() < 0x1p-30 * length)) return std::nullopt;
        root.kind = RayRoot::Kind::crossing;
        root.multiplicity = 1;
        root.t = bracket.middle();
        return root;
    }
    return root;
}

} // namespace eliminant::field
