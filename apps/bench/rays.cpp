/// \file
/// bench_rays [SURFACE…]: first roots along rays, certified, against all roots by the companion-matrix solver
/// of Eigen's polynomial module, uncertified and in doubles; one JSON object a line.
///
/// Both sides get the same polynomials: the surface on each of the exact rays of data/surfaces/rays that meet
/// the clip ball, on the part within it brought to [−1, 1]. Times are of this thread's processor time, the
/// least of five. `wrong` counts the rays whose hit or miss, or depth by more than 1e-6, is not that of the
/// exact answers, for the polynomials and for the whole picture traced as one grid.
#include "eliminant/algebra/parse.hpp"
#include "eliminant/field/first_roots.hpp"
#include "eliminant/field/ray_restriction.hpp"
#include "eliminant/scene/algebraic_surface.hpp"

#include <glm/geometric.hpp>
#include <unsupported/Eigen/Polynomials>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using eliminant::algebraic_surface;
using eliminant::Ball;
using eliminant::ClipRegion;
using eliminant::CoefficientField;
using eliminant::first_roots;
using eliminant::Hit;
using eliminant::Interval;
using eliminant::parse_polynomial;
using eliminant::parse_rational;
using eliminant::Polynomial;
using eliminant::PolynomialBatch;
using eliminant::Ray;
using eliminant::RayGrid;
using eliminant::restrict_to_ray;
using eliminant::Ring;
using eliminant::Run;

double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

template <class Body>
double best_time(const Body& body) {
    double best = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 5; ++i) {
        const double start = cpu_seconds();
        body();
        best = std::min(best, cpu_seconds() - start);
    }
    return best;
}

struct Case {
    std::string name;
    Polynomial polynomial;
    double clip_radius;
    glm::dvec3 camera;
};

double number(const std::string& text) { return mpq_class(parse_rational({text, "surfaces.jsonl"})).get_d(); }

std::string string_field(const std::string& line, const std::string& key) {
    const std::string begin = "\"" + key + "\": \"";
    const std::size_t from = line.find(begin) + begin.size();
    return line.substr(from, line.find('"', from) - from);
}

std::vector<Case> cases() {
    std::ifstream file(std::string(ELIMINANT_DATA_DIR) + "/surfaces/surfaces.jsonl");
    const Ring xyz(CoefficientField::rationals(), {"x", "y", "z"});
    std::vector<Case> result;
    for (std::string line; std::getline(file, line);) {
        Case entry{string_field(line, "name"),
                   parse_polynomial(xyz, {string_field(line, "expanded"), "surfaces.jsonl"}),
                   number(string_field(line, "sphere_radius")), glm::dvec3(0.0)};
        std::istringstream origin(line.substr(line.find("\"origin\": [") + 11));
        for (int axis = 0; axis < 3; ++axis) {
            std::string quoted;
            std::getline(origin, quoted, ',');
            const std::size_t begin = quoted.find('"') + 1;
            entry.camera[axis] = number(quoted.substr(begin, quoted.find('"', begin) - begin));
        }
        result.push_back(entry);
    }
    if (result.empty()) throw std::runtime_error("data/surfaces/surfaces.jsonl is missing");
    return result;
}

RayGrid grid_of(const Case& entry) {
    constexpr double n = 128.0;
    constexpr double tangent = 0.27;
    const glm::dvec3 forward = glm::normalize(-entry.camera);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, glm::dvec3(0.0, 1.0, 0.0)));
    const glm::dvec3 up = glm::cross(right, forward);
    RayGrid rays;
    rays.width = rays.height = 128;
    rays.origin = entry.camera;
    rays.direction = forward + tangent * (1.0 - n) / n * right + tangent * (n - 1.0) / n * up;
    rays.direction_dx = 2.0 * tangent / n * right;
    rays.direction_dy = -2.0 * tangent / n * up;
    return rays;
}

/// One of the exact rays and the polynomial on it.
struct Sample {
    std::size_t pixel;
    double depth; ///< exact: infinity for a miss
    Ray ray;
    Interval interval;
    std::vector<double> polynomial; ///< on [−1, 1]
};

/// Σ c_i t^i on the interval as a polynomial on [−1, 1]: exactly, then rounded.
std::vector<double> on_unit_interval(const std::vector<mpz_class>& c, Interval interval) {
    const mpq_class middle = (mpq_class(interval.lower) + mpq_class(interval.upper)) / 2;
    const mpq_class radius = (mpq_class(interval.upper) - mpq_class(interval.lower)) / 2;
    std::vector<mpq_class> p(c.begin(), c.end());
    for (std::size_t i = 0; i + 1 < p.size(); ++i)
        for (std::size_t j = p.size() - 1; j-- > i;) p[j] += middle * p[j + 1];
    mpq_class power = 1;
    mpq_class largest = 0;
    for (mpq_class& q : p) {
        q *= power;
        power *= radius;
        if (abs(q) > largest) largest = abs(q);
    }
    std::vector<double> result;
    for (const mpq_class& q : p) result.push_back(mpq_class(q / largest).get_d());
    return result;
}

std::vector<Sample> samples(const Case& entry, const RayGrid& rays, const ClipRegion& clip) {
    std::ifstream file(std::string(ELIMINANT_DATA_DIR) + "/surfaces/rays/" + entry.name + ".txt");
    std::string word;
    std::getline(file, word);
    std::vector<Sample> result;
    Run run;
    for (std::size_t i = 0; file >> word; ++i) {
        if (word == "?") continue;
        const std::size_t row = 4 * (i / 32) + 2;
        const std::size_t column = 4 * (i % 32) + 2;
        Sample sample{row * 128 + column,
                      word == "-" ? std::numeric_limits<double>::infinity() : std::stod(word),
                      rays.ray(static_cast<double>(column), static_cast<double>(row)),
                      {},
                      {}};
        sample.interval = clip.interval(sample.ray);
        if (sample.interval.empty()) continue;
        sample.polynomial = on_unit_interval(
            restrict_to_ray(entry.polynomial, sample.ray.origin, sample.ray.direction, run), sample.interval);
        result.push_back(sample);
    }
    return result;
}

bool is_wrong(const Sample& sample, double t) {
    const double depth = t * glm::length(sample.ray.direction);
    if (std::isinf(depth) || std::isinf(sample.depth)) return depth != sample.depth;
    return std::abs(depth - sample.depth) > 1e-6 * sample.depth;
}

void measure(const Case& entry) {
    const RayGrid rays = grid_of(entry);
    ClipRegion clip;
    clip.add(Ball{glm::dvec3(0.0), entry.clip_radius});
    const std::vector<Sample> all = samples(entry, rays, clip);
    const std::size_t n = all.front().polynomial.size() - 1;

    PolynomialBatch batch{.degree = n, .count = all.size()};
    std::vector<double> coefficients((n + 1) * all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t k = 0; k <= n; ++k) coefficients[k * all.size() + i] = all[i].polynomial[k];
    const std::vector<double> lower(all.size(), -1.0);
    const std::vector<double> upper(all.size(), 1.0);
    batch.coefficients = coefficients;
    batch.lower = lower;
    batch.upper = upper;
    std::vector<double> roots(all.size());
    Run run;
    first_roots(batch, roots, run); // once for the tables
    const int repeat = 20;
    const double ours = best_time([&] {
                            for (int i = 0; i < repeat; ++i) first_roots(batch, roots, run);
                        }) /
                        repeat;

    std::vector<Eigen::VectorXd> vectors;
    for (const Sample& sample : all)
        vectors.emplace_back(Eigen::Map<const Eigen::VectorXd>(
            sample.polynomial.data(), static_cast<Eigen::Index>(sample.polynomial.size())));
    double checksum = 0.0; // so that nothing is optimised away
    const double theirs = best_time([&] {
        Eigen::PolynomialSolver<double, Eigen::Dynamic> solver;
        for (const Eigen::VectorXd& p : vectors) {
            solver.compute(p);
            checksum += solver.roots()[0].real();
        }
    });

    int wrong = 0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Interval& interval = all[i].interval;
        const double middle = 0.5 * (interval.lower + interval.upper);
        const double radius = 0.5 * (interval.upper - interval.lower);
        wrong += is_wrong(all[i], middle + radius * roots[i]) ? 1 : 0;
    }
    const auto surface = algebraic_surface(entry.polynomial, run);
    std::vector<Hit> hits(rays.width * rays.height);
    surface->tracer(rays, clip, run)->trace({0, 0, rays.width, rays.height}, hits, run);
    int wrong_in_grid = 0;
    for (const Sample& sample : all) wrong_in_grid += is_wrong(sample, hits[sample.pixel].t) ? 1 : 0;

    const double count = static_cast<double>(all.size());
    std::printf(R"({"surface":"%s","degree":%zu,"rays":%zu,"first_root_ns":%.1f,"eigen_all_roots_ns":%.1f,)"
                R"("ratio":%.1f,"wrong":%d,"wrong_in_grid":%d,"checksum":%.3g})"
                "\n",
                entry.name.c_str(), n, all.size(), 1e9 * ours / count, 1e9 * theirs / count, theirs / ours,
                wrong, wrong_in_grid, checksum);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> wanted(argv + 1, argv + argc);
    try {
        for (const Case& entry : cases())
            if (wanted.empty() || std::ranges::find(wanted, entry.name) != wanted.end()) measure(entry);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_rays: %s\n", error.what());
        return 1;
    }
    return 0;
}
