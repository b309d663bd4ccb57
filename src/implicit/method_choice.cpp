#include "implicit/method_choice.hpp"

#include "implicit/linear_method.hpp"
#include "implicit/resultant_method.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

namespace eliminant::implicit {

using algebra::Polynomial;

namespace {

/// Nanoseconds, measured on one core of an AMD EPYC with AVX-512 on the shapes of bench_implicit, most of
/// which they predict within a third. What counts are ratios: on a slower machine all of them are longer.
namespace nanoseconds {
constexpr double image = 5000;          // whatever the image modulo a prime
constexpr double map_term = 4;          // value of a term of the map
constexpr double monomial = 3;          // value of one at a point
constexpr double point = 500;           // whatever its coordinates
constexpr double root = 7000;           // of a polynomial, of which one in the field is to be found
constexpr double root_product = 1;      // in that search
constexpr double row_product = 0.11;    // in dense elimination
constexpr double row = 3;               // there, a pivot: four rows are taken at a time
constexpr double line = 2000;           // whatever its fibre
constexpr double bezout_product = 2;    // in elimination of Bézout's matrix
constexpr double node_product = 0.6;    // in interpolation of resultants
constexpr double algebra_element = 150; // product in a quotient algebra
constexpr double algebra_product = 0.8; // in that, a square of the dimension
constexpr double cell_product = 3;      // in interpolation of the equation
constexpr double elimination = 200000;  // whatever the ideal
constexpr double basis_product = 20;    // in reduction of polynomials
} // namespace nanoseconds

constexpr double bits_of_prime = 29;

double square(double x) { return x * x; }
double cube(double x) { return x * x * x; }

/// Σ over the coordinates of log₂ of the norm of numerator and denominator together.
double bits_of(const RationalMap& map) {
    const auto squares = [](const Polynomial& f) {
        mpz_class sum = 0;
        for (std::size_t i = 0; i < f.size(); ++i) {
            const mpz_class c = f.coefficient(i).get_num();
            sum += c * c;
        }
        return sum;
    };
    double bits = 0;
    for (std::size_t i = 0; i + map.constants.size() < map.components.size(); ++i) {
        const auto& [numerator, over_denominator] = map.components[i];
        mpz_class sum = squares(numerator);
        if (over_denominator) sum += squares(map.denominator);
        bits += 0.5 * static_cast<double>(mpz_sizeinbase(sum.get_mpz_t(), 2));
    }
    return bits;
}

/// Most coefficients are found over the denominator of those before, so fractions cost nothing.
double predicted_primes(double coefficient_bits) {
    constexpr double margin = 40;
    return 1 + std::floor((coefficient_bits + margin) / bits_of_prime);
}

double number_of_terms(const RationalMap& map) {
    std::size_t terms = map.denominator.size();
    for (const auto& component : map.components) terms += component.numerator.size();
    return static_cast<double>(terms);
}

double resultant_line(const ResultantSizes& sizes) {
    const auto m = static_cast<double>(sizes.eliminated);
    const auto nodes = static_cast<double>(sizes.nodes);
    const double steps = std::sqrt(static_cast<double>(sizes.degree));
    const double products = 2 * m + 2 * steps + 6; // height, its inverse, traces of its powers
    return nanoseconds::line + nanoseconds::bezout_product * nodes * (cube(m) / 3 + 2 * square(m)) +
           nanoseconds::node_product * 3 * square(nodes) +
           products * (nanoseconds::algebra_element +
                       nanoseconds::algebra_product * square(static_cast<double>(sizes.fibre_size)));
}

double resultant_image(const ResultantSizes& sizes) {
    const auto d = static_cast<double>(sizes.degree);
    const double cells = sizes.eliminated == 0 ? cube(d) : square(square(d));
    return nanoseconds::image + static_cast<double>(sizes.lines) * resultant_line(sizes) +
           nanoseconds::node_product * 2 * square(static_cast<double>(sizes.nodes)) +
           nanoseconds::cell_product * cells;
}

double linear_system(const RationalMap& map, const LinearSizes& sizes) {
    const auto terms = static_cast<double>(sizes.terms);
    const auto degree = static_cast<double>(sizes.root_degree);
    double point =
        nanoseconds::point + nanoseconds::map_term * number_of_terms(map) + nanoseconds::monomial * terms;
    if (degree > 1)
        point += nanoseconds::root + nanoseconds::root_product * 2 * bits_of_prime * square(degree);
    return terms * (point + nanoseconds::row * terms) + nanoseconds::row_product * cube(terms) / 3;
}

double linear_image(const RationalMap& map, const LinearSizes& sizes) {
    return nanoseconds::image + static_cast<double>(sizes.planes) * linear_system(map, sizes);
}

double seconds(double cost) { return 1e-9 * cost; }

std::string text_of(const MethodCost& cost) {
    std::array<char, 32> milliseconds{};
    std::snprintf(milliseconds.data(), milliseconds.size(), "%.3g ms", 1e3 * cost.seconds);
    return std::string(to_string(cost.method))
        .append(cost.at_least ? " over " : " ")
        .append(milliseconds.data());
}

class Choice {
  public:
    Choice(const HypersurfaceProblem& problem, const std::function<GradedMap()>& graded_map, base::Run& run)
        : problem_(problem), graded_map_(graded_map), run_(run), map_bits_(bits_of(problem.map)),
          linear_(linear_method(problem, run)) {}

    MethodChoice make() {
        if (!has_few_terms(terms_at_sight)) look_closer();
        std::ranges::stable_sort(result_.costs, {}, [](const MethodCost& cost) {
            return std::pair(cost.at_least, cost.seconds); // bounds say less
        });
        for (const MethodCost& cost : result_.costs)
            result_.reason.append(result_.reason.empty() ? "predicted: " : ", ").append(text_of(cost));
        sort_methods();
        result_.elimination = std::move(elimination_);
        return std::move(result_);
    }

  private:
    /// So small systems are solved before anything else could be looked at.
    static constexpr std::size_t terms_at_sight = 28;

    void add(Method method, double cost, bool at_least = false) {
        result_.costs.push_back({method, seconds(cost), at_least});
    }

    void degree_is(std::size_t degree) {
        primes_ = predicted_primes(static_cast<double>(degree) * map_bits_);
    }

    bool has_few_terms(std::size_t max_terms) {
        const auto sizes = linear_ ? linear_->small_sizes(max_terms) : std::nullopt;
        if (!sizes) return false;
        degree_is(sizes->degree);
        degree_ = sizes->degree;
        add(Method::linear, primes_ * linear_image(problem_.map, *sizes));
        return true;
    }

    void look_closer() {
        resultant_ = resultant_method(problem_, run_);
        const auto bounds = resultant_ ? resultant_->size_bounds() : std::nullopt;
        const double line = bounds ? resultant_line(*bounds) : without_resultants;
        // The little that is known before: two primes at least, and degrees.
        try_elimination(bounds ? 2 * resultant_image(*bounds) : without_resultants);
        if (elimination_ && elimination_cost() < learned_lines * line) {
            add(Method::groebner, elimination_cost());
            return;
        }
        if (has_few_terms(terms_worth(line))) {
            if (bounds) add(Method::resultant, primes_ * resultant_image(with_degree(*bounds, degree_)));
        } else if (const auto sizes = resultant_ ? resultant_->sizes() : std::nullopt) {
            degree_is(sizes->degree);
            add(Method::resultant, primes_ * resultant_image(*sizes));
            const auto linear = linear_ ? linear_->sizes(sizes->degree) : std::nullopt;
            // The first prime also tries lower degrees.
            if (linear) add(Method::linear, (primes_ + 1) * linear_image(problem_.map, *linear));
        }
        if (elimination_)
            add(Method::groebner, elimination_cost());
        else if (tried_ > 0 && !result_.costs.empty())
            add(Method::groebner, primes_ * tried_, true);
    }

    /// A system of so many terms costs a fraction of what a line of resultants does.
    static std::size_t terms_worth(double line) {
        constexpr double fraction = 0.25;
        constexpr double most = 220;
        const double terms = std::cbrt(fraction * line * 3 / nanoseconds::row_product);
        return static_cast<std::size_t>(std::min(terms, most));
    }
    static constexpr double without_resultants = 1e7; // nanoseconds: elimination is tried a little
    static constexpr double learned_lines = 4;        // that resultants take before anything is known

    /// Bounds from degrees, and the degree of the equation.
    static ResultantSizes with_degree(ResultantSizes sizes, std::size_t degree) {
        sizes.degree = std::min(sizes.degree, degree);
        sizes.lines = sizes.eliminated == 0 ? degree + 1 : (degree + 1) * (degree + 2) / 2;
        return sizes;
    }

    /// Tries elimination for a small part of what another method may take.
    void try_elimination(double others) {
        constexpr double worth_trying = 2e6;
        constexpr double most = 2e7;
        constexpr double fraction = 0.05;
        if (others < worth_trying) return;
        tried_ = std::min(most, fraction * others);
        elimination_ = elimination_effort(graded_map_(), tried_ / nanoseconds::basis_product, run_);
    }

    double elimination_cost() const {
        const double primes = 1 + std::floor(elimination_->bits / bits_of_prime);
        return primes * (nanoseconds::elimination + nanoseconds::basis_product * elimination_->products);
    }

    /// Those that are not expected to be slower than elimination; what could not be predicted is left to try.
    void sort_methods() {
        const auto take = [this](std::unique_ptr<HypersurfaceMethod> method) {
            if (method) result_.methods.push_back(std::move(method));
        };
        for (const MethodCost& cost : result_.costs) {
            if (cost.method == Method::groebner && !cost.at_least) return;
            if (cost.method == Method::resultant) take(std::move(resultant_));
            if (cost.method == Method::linear) take(std::move(linear_));
        }
        take(std::move(resultant_));
        take(std::move(linear_));
    }

    const HypersurfaceProblem& problem_;
    const std::function<GradedMap()>& graded_map_;
    base::Run& run_;
    double map_bits_;
    double primes_ = 1;
    std::size_t degree_ = 0; ///< where few terms were enough
    double tried_ = 0;       ///< nanoseconds, of elimination
    std::optional<EliminationEffort> elimination_;
    std::unique_ptr<LinearMethod> linear_;
    std::unique_ptr<ResultantMethod> resultant_;
    MethodChoice result_;
};

} // namespace

MethodChoice choose_method(const HypersurfaceProblem& problem, const std::function<GradedMap()>& graded_map,
                           base::Run& run) {
    return Choice(problem, graded_map, run).make();
}

MethodChoice method_asked_for(Method method, const HypersurfaceProblem& problem, base::Run& run) {
    MethodChoice choice;
    if (method == Method::linear) choice.methods.push_back(linear_method(problem, run));
    if (method == Method::resultant) choice.methods.push_back(resultant_method(problem, run));
    std::erase(choice.methods, nullptr);
    return choice;
}

} // namespace eliminant::implicit
