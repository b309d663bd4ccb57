// The guaranteed distance against true ones at millions of points; what source documents state wrongly.
#include "eliminant/field/distance.hpp"

#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/base/error.hpp"

#include "field/distance_batch.hpp"
#include "field/surfaces.hpp"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace eliminant {
namespace {

// Sanitizers and debug builds take twenty times as long.
#if defined(__SANITIZE_ADDRESS__) || !defined(NDEBUG)
constexpr std::size_t points_a_surface = 20'000;
#else
constexpr std::size_t points_a_surface = 400'000;
#endif

/// The zero of a function that falls, by bisection to the last bit.
template <class Function>
double falling_zero(const Function& f, double lower, double upper) {
    for (int i = 0; i < 100; ++i) {
        const double middle = lower + (upper - lower) / 2;
        (f(middle) > 0 ? lower : upper) = middle;
    }
    return lower;
}

/// To x²/a² + y²/b² + z²/c² = 1 for a > b > c (Eberly, Distance from a point to an ellipse, an ellipsoid, or
/// a hyperellipsoid, 2013): the foot is a_i² p_i/(t + a_i²) for the largest zero t.
double distance_to_ellipsoid(const glm::dvec3& point) {
    const glm::dvec3 squares(4, 1, 0.25);
    const glm::dvec3 p = glm::max(glm::abs(point), glm::dvec3(1e-9)); // where all coordinates count
    const auto excess = [&](double t) {
        double sum = -1;
        for (int i = 0; i < 3; ++i) sum += squares[i] * (p[i] / (t + squares[i])) * (p[i] / (t + squares[i]));
        return sum;
    };
    const double t = falling_zero(excess, -0.25 + 0.5 * p.z, 2 * glm::length(p) + 1);
    glm::dvec3 foot;
    for (int i = 0; i < 3; ++i) foot[i] = squares[i] * p[i] / (t + squares[i]);
    return glm::length(foot - p) + 3e-9;
}

/// To z = x² + y²: the foot (r, r²) has 2r³ + (1 − 2z)r = ρ, whose largest zero is the nearest one.
double distance_to_paraboloid(const glm::dvec3& p) {
    const double rho = std::hypot(p.x, p.y);
    const auto lacking = [&](double r) { return rho - (2 * r * r + 1 - 2 * p.z) * r; };
    const double turn = p.z > 0.5 ? std::sqrt((2 * p.z - 1) / 6) : 0.0; // from there on it falls
    const double r = falling_zero(lacking, turn, 10 + rho + std::abs(p.z));
    return std::hypot(r - rho, r * r - p.z);
}

struct Known {
    const char* text;
    double (*distance)(const glm::dvec3&);
};

const Known known[] = {
    {"x^2+y^2+z^2-1", [](const glm::dvec3& p) { return std::abs(glm::length(p) - 1); }},
    {"2x-y+2z-3", [](const glm::dvec3& p) { return std::abs(2 * p.x - p.y + 2 * p.z - 3) / 3; }},
    {"x^2+y^2-1/4", [](const glm::dvec3& p) { return std::abs(std::hypot(p.x, p.y) - 0.5); }},
    {"(x^2+y^2+z^2+21/25)^2-4*(x^2+y^2)",
     [](const glm::dvec3& p) { return std::abs(std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.4); }},
    {"x^2+y^2-z^2",
     [](const glm::dvec3& p) { return std::abs(std::hypot(p.x, p.y) - std::abs(p.z)) / std::sqrt(2.0); }},
    {"z-x^2-y^2", distance_to_paraboloid},
    {"x^2/4+y^2+4*z^2-1", distance_to_ellipsoid},
};

struct Columns {
    std::array<std::vector<double>, 3> in;
    std::vector<double> value;
    std::vector<std::int8_t> sign;

    explicit Columns(std::size_t count) : value(count), sign(count) {
        for (auto& column : in) column.resize(count);
    }
    PointArrays<double> points() const { return {in[0], in[1], in[2]}; }
    DistanceArrays result() { return {value, sign}; }
    glm::dvec3 point(std::size_t i) const { return {in[0][i], in[1][i], in[2][i]}; }
    void set(std::size_t i, const glm::dvec3& p) {
        for (std::size_t k = 0; k < 3; ++k) in[k][i] = p[static_cast<int>(k)];
    }
};

glm::dvec3 random_vector(std::mt19937_64& random, double size) {
    std::uniform_real_distribution<double> coordinate(-size, size);
    return {coordinate(random), coordinate(random), coordinate(random)};
}

TEST(TrueDistance, bound_is_below_it_at_millions_of_points) {
    std::mt19937_64 random(2024);
    constexpr std::size_t block = 4000;
    for (const Known& surface : known) {
        const DistanceField f(test::polynomial(surface.text));
        Columns columns(block);
        for (std::size_t done = 0; done < points_a_surface; done += block) {
            for (std::size_t i = 0; i < block; ++i) {
                // Everywhere, and within a millionth of axes and planes, where the medial axes are.
                glm::dvec3 p = random_vector(random, 2.5);
                if (i % 4 == 0) p[static_cast<int>(i / 4 % 3)] *= 1e-6;
                if (i % 8 == 0) p[static_cast<int>((i / 4 + 1) % 3)] *= 1e-6;
                columns.set(i, p);
            }
            distances(f, columns.points(), DistanceLevel::guaranteed, columns.result());
            for (std::size_t i = 0; i < block; ++i) {
                const glm::dvec3 p = columns.point(i);
                const double truth = surface.distance(p);
                ASSERT_LE(columns.value[i], truth * (1 + 1e-13) + 1e-15)
                    << surface.text << " at " << p.x << ' ' << p.y << ' ' << p.z;
                ASSERT_GE(columns.value[i], 0);
            }
        }
    }
}

TEST(TrueDistance, batches_agree_with_single_points_on_every_unit_and_for_every_length) {
    std::mt19937_64 random(11);
    for (const test::Surface& surface : test::surfaces()) {
        const DistanceField f(surface.polynomial);
        for (const DistanceLevel level : {DistanceLevel::first_order, DistanceLevel::second_order,
                                          DistanceLevel::second_order_frobenius, DistanceLevel::guaranteed})
            for (const base::VectorUnit unit : base::available_vector_units())
                for (const std::size_t count : {0UL, 1UL, 7UL, 8UL, 67UL}) {
                    if (count > 1 && surface.polynomial.size() > 1000) continue;
                    Columns columns(count);
                    for (std::size_t i = 0; i < count; ++i) {
                        glm::dvec3 p =
                            random_vector(random, std::ldexp(2.0, -static_cast<int>(random() % 60)));
                        if (i % 16 == 5) p.y = i % 32 == 5 ? INFINITY : std::nan("");
                        if (i % 16 == 6) p = glm::dvec3(0);
                        if (i % 16 == 7) p *= 1e200;
                        columns.set(i, p);
                    }
                    field::distances_with(unit, f, columns.points(), level, columns.result());
                    for (std::size_t i = 0; i < count; ++i) {
                        const Distance single = distance(f, columns.point(i), level);
                        EXPECT_EQ(columns.sign[i], single.sign) << surface.name;
                        if (std::isnan(single.value) || std::isinf(single.value)) {
                            EXPECT_EQ(std::isnan(columns.value[i]), std::isnan(single.value));
                            EXPECT_EQ(std::isinf(columns.value[i]), std::isinf(single.value));
                            continue;
                        }
                        const double tolerance = level == DistanceLevel::guaranteed ? 0x1p-10 : 0x1p-28;
                        EXPECT_NEAR(columns.value[i], single.value, tolerance * single.value)
                            << surface.name << ' ' << to_string(level) << ' ' << base::name(unit);
                    }
                }
    }
    const DistanceField sphere(test::surface("sphere"));
    Columns columns(4);
    DistanceArrays result = columns.result();
    result.sign = result.sign.first(3);
    EXPECT_THROW(distances(sphere, columns.points(), DistanceLevel::guaranteed, result), DomainError);
    EXPECT_THROW(distances(sphere, PointArrays<double>{columns.in[0], columns.in[1], {}},
                           DistanceLevel::guaranteed, columns.result()),
                 DomainError);
}

TEST(TrueDistance, of_polynomials_in_two_variables_and_of_constants_in_batches) {
    const DistanceField circle(test::polynomial("x^2+y^2-1"));
    Columns columns(9);
    for (std::size_t i = 0; i < 9; ++i) columns.set(i, {0.25 * static_cast<double>(i), 0, 77});
    distances(circle, PointArrays<double>{columns.in[0], columns.in[1], {}}, DistanceLevel::guaranteed,
              columns.result());
    for (std::size_t i = 0; i < 9; ++i) {
        const double truth = std::abs(0.25 * static_cast<double>(i) - 1);
        EXPECT_LE(columns.value[i], truth);
        EXPECT_GE(columns.value[i], 0.7 * truth);
        EXPECT_EQ(columns.sign[i], (i > 4) - (i < 4));
    }
    for (const char* constant : {"0", "-7"}) {
        distances(DistanceField(test::polynomial(constant)), columns.points(), DistanceLevel::guaranteed,
                  columns.result());
        for (std::size_t i = 0; i < 9; ++i) {
            EXPECT_EQ(columns.value[i], constant[0] == '0' ? 0 : INFINITY);
            EXPECT_EQ(columns.sign[i], constant[0] == '0' ? 0 : -1);
        }
    }
}

/// The patch of data/surfaces/bicubic18.controls.txt, exactly.
class BicubicPatch {
  public:
    BicubicPatch() {
        std::ifstream file(std::string(ELIMINANT_DATA_DIR) + "/surfaces/bicubic18.controls.txt");
        std::string line;
        while (std::getline(file, line)) {
            std::istringstream words(line.substr(0, line.find('(')));
            std::size_t i = 4;
            std::size_t j = 4;
            if (!(words >> i >> j) || i > 3 || j > 3) continue;
            std::string numbers = line.substr(line.find('('));
            for (char& c : numbers)
                if (c == '(' || c == ',' || c == ')') c = ' ';
            std::istringstream coordinates(numbers);
            for (int& c : controls_[i][j]) coordinates >> c;
            ++count_;
        }
    }
    std::size_t count() const { return count_; }
    /// Half the patch: the surface is f(2x, 2y, 2z) = 0.
    std::array<mpq_class, 3> operator()(const mpq_class& s, const mpq_class& t) const {
        std::array<mpq_class, 3> sum;
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < 4; ++j)
                for (std::size_t k = 0; k < 3; ++k)
                    sum[k] += weight(i, s) * weight(j, t) * controls_[i][j][k] / 2;
        return sum;
    }

  private:
    static mpq_class weight(std::size_t i, const mpq_class& t) {
        mpq_class result = i == 1 || i == 2 ? 3 : 1;
        for (std::size_t k = 0; k < 3; ++k) result *= k < i ? t : mpq_class(1 - t);
        return result;
    }
    std::array<std::array<std::array<int, 3>, 4>, 4> controls_{};
    std::size_t count_ = 0;
};

TEST(TrueDistance, degree_18_within_1e_8_of_the_surface_where_doubles_fail) {
    const BicubicPatch patch;
    ASSERT_EQ(patch.count(), 16U);
    const Polynomial& f = test::surface("bicubic18");
    const DistanceField field(f);
    std::mt19937_64 random(5);
    int undecided_by_doubles = 0;
    for (int i = 0; i < 16; ++i) {
        const mpq_class s(1 + static_cast<int>(random() % 97), 99);
        const mpq_class t(1 + static_cast<int>(random() % 97), 99);
        const std::array<mpq_class, 3> on_surface = patch(s, t);
        ASSERT_EQ(sgn(evaluate(f, on_surface)), 0);
        const double distance_of_foot =
            std::pow(10.0, -8 - i / 2); // from 1e-8 down to the spacing of doubles
        const glm::dvec3 offset = distance_of_foot * glm::normalize(random_vector(random, 1));
        glm::dvec3 p;
        mpq_class square = 0;
        for (int k = 0; k < 3; ++k) {
            const auto axis = static_cast<std::size_t>(k);
            p[k] = on_surface[axis].get_d() + offset[k];
            const mpq_class difference = mpq_class(p[k]) - on_surface[axis];
            square += difference * difference;
        }
        const Distance bound = distance(field, p, DistanceLevel::guaranteed);
        EXPECT_LE(mpq_class(bound.value) * mpq_class(bound.value), square);
        const std::array<mpq_class, 3> exact = {mpq_class(p.x), mpq_class(p.y), mpq_class(p.z)};
        EXPECT_EQ(bound.sign, sgn(evaluate(f, exact)));
        EXPECT_EQ(bound.value > 0, bound.sign != 0);
        const CompiledPolynomial& compiled = field.polynomial();
        if (std::abs(compiled.value(p)) <= compiled.close_error_bound(p).value) ++undecided_by_doubles;
    }
    EXPECT_GE(undecided_by_doubles, 4);
}

TEST(PrintedFormulas, eq_106_needs_the_absolute_value) {
    // Printed: (−‖∇f‖ + √(‖∇f‖² + 2‖H‖ f)) / ‖H‖ for the root of f = ‖∇f‖ρ + ½‖H‖ρ². With f < 0 it is no
    // distance: negative, or not a number.
    std::mt19937_64 random(6);
    const DistanceField sphere(test::polynomial("x^2+y^2+z^2-1"));
    int not_real = 0;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 p = random_vector(random, 0.57);
        const Jet jet = sphere.polynomial().jet(p);
        const double g = glm::length(jet.gradient);
        const double norm = jet.hessian.frobenius_norm();
        ASSERT_LT(jet.value, 0);
        const double printed = (-g + std::sqrt(g * g + 2 * norm * jet.value)) / norm;
        const double right = (-g + std::sqrt(g * g + 2 * norm * std::abs(jet.value))) / norm;
        EXPECT_FALSE(printed >= 0);
        if (std::isnan(printed)) ++not_real;
        const double found = distance(sphere, p, DistanceLevel::second_order_frobenius).value;
        EXPECT_NEAR(found, right, 1e-12);
        EXPECT_GT(found, 0);
    }
    EXPECT_GT(not_real, 100);
}

TEST(PrintedFormulas, a_lipschitz_constant_bounds_the_distance_from_below) {
    // |f(p)|/L ≤ distance; Corollary 1.2 as printed has ≥, which fails almost everywhere.
    std::mt19937_64 random(7);
    int printed_fails = 0;
    constexpr int count = 10'000;
    for (const std::size_t index : {0UL, 2UL, 3UL}) {
        const DistanceField f(test::polynomial(known[index].text));
        // L = max ‖∇f‖ on a ball that holds the points and their nearest zeros: of radius 3, by a bound for
        // the gradients of x²+y²+z²−1, x²+y²−1/4 and the torus.
        const double r = 3;
        const double lipschitz = index == 3 ? 4 * r * (r * r + 0.84) + 8 * r : 2 * r;
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 p = random_vector(random, 1.5);
            const double truth = known[index].distance(p);
            const double quotient = std::abs(f.polynomial().value(p)) / lipschitz;
            EXPECT_LE(quotient, truth + 1e-15);
            if (truth > quotient + 1e-12) ++printed_fails;
            // The proven bound is one of the right kind: moving by less never changes the sign.
            const Distance bound = distance(f, p, DistanceLevel::guaranteed);
            const glm::dvec3 step = glm::normalize(random_vector(random, 1)) * (bound.value * (1 - 1e-12));
            EXPECT_EQ(f.polynomial().sign(p + step), bound.sign);
        }
    }
    EXPECT_GT(printed_fails, 2 * count);
}

TEST(PrintedFormulas, the_quotient_by_the_gradient_is_no_bound) {
    // Proposition 1.2: |f|/‖∇f‖ exceeds the distance somewhere for all of these but the plane and the
    // cone, where it is at most (ρ + z)/√(2ρ² + 2z²) times it.
    std::mt19937_64 random(8);
    for (const Known& surface : known) {
        const std::string text = surface.text;
        if (text == "2x-y+2z-3" || text == "x^2+y^2-z^2") continue;
        const DistanceField f(test::polynomial(surface.text));
        bool exceeds = false;
        for (int i = 0; i < 5000 && !exceeds; ++i) {
            const glm::dvec3 p = random_vector(random, 1.2);
            exceeds = distance(f, p, DistanceLevel::first_order).value > surface.distance(p) * 1.01 + 1e-8;
        }
        EXPECT_TRUE(exceeds) << surface.text;
    }
}

TEST(PrintedFormulas, equation_113_is_among_the_surfaces) {
    // (x−2)²(x+2)² + (y−2)²(y+2)² + (z−2)²(z+2)² + 3(x²y² + x²z² + y²z²) + 6xyz − 10(x² + y² + z²) + 22.
    EXPECT_EQ(
        test::surface("thesis4"),
        test::polynomial("(x^2-4)^2+(y^2-4)^2+(z^2-4)^2+3*(x^2*y^2+x^2*z^2+y^2*z^2)+6*x*y*z-10*(x^2+y^2+"
                         "z^2)+22"));
}

} // namespace
} // namespace eliminant
