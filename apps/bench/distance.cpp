/// \file
/// bench_distance [SURFACE…]: how close the guaranteed distance comes to the true one, and what batches cost.
///
/// Points are uniform by volume within 2 units of the surface, in a cube around its clip ball. The true
/// distance is enclosed by subdivision: cubes without zeros by the guaranteed bound of their centers are
/// dropped, those with a change of sign give upper bounds, and the nearest cube is always the next to be
/// divided. Times are of this thread's processor time.
#include "eliminant/field/distance.hpp"
#include "eliminant/algebra/parse.hpp"
#include "eliminant/field/range.hpp"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <queue>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using eliminant::distance;
using eliminant::distance_from_ball;
using eliminant::DistanceArrays;
using eliminant::DistanceField;
using eliminant::DistanceLevel;
using eliminant::distances;
using eliminant::PointArrays;

double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

// ---- The true distance
// ---------------------------------------------------------------------------------------

struct Cube {
    glm::dvec3 center;
    double half = 0;
    double nearest = 0; ///< no point of it is nearer

    friend bool operator<(const Cube& a, const Cube& b) { return a.nearest > b.nearest; }
};

struct Enclosure {
    double lower = 0;
    double upper = INFINITY;
};

double nearest_of(const glm::dvec3& point, const glm::dvec3& center, double half) {
    return glm::length(glm::max(glm::abs(point - center) - half, glm::dvec3(0)));
}

/// Of a point from the zeros in the cube of half side `reach` around it, to 1 % if the surface is crossed
/// there.
Enclosure enclose(const DistanceField& f, const glm::dvec3& point, double reach) {
    constexpr int most_cubes = 20'000;
    std::priority_queue<Cube> queue;
    queue.push({point, reach, 0});
    Enclosure result;
    const int sign = f.polynomial().sign(point);
    for (int i = 0; i < most_cubes && !queue.empty(); ++i) {
        const Cube cube = queue.top();
        result.lower = cube.nearest;
        if (result.upper <= 1.01 * result.lower) break;
        queue.pop();
        for (int octant = 0; octant < 8; ++octant) {
            const glm::dvec3 side((octant & 1) != 0 ? 1 : -1, (octant & 2) != 0 ? 1 : -1,
                                  (octant & 4) != 0 ? 1 : -1);
            Cube child{cube.center + 0.5 * cube.half * side, cube.half / 2, 0};
            child.nearest = nearest_of(point, child.center, child.half);
            if (child.nearest > result.upper) continue;
            if (distance_from_ball(f, child.center, child.half * std::sqrt(3.0)) > 0) continue;
            // The segment to a point of another sign crosses the surface.
            if (f.polynomial().sign(child.center) != sign)
                result.upper = std::min(result.upper, glm::length(child.center - point));
            queue.push(child);
        }
    }
    if (queue.empty()) result.lower = reach;
    return result;
}

struct Ratio {
    double least = 0;    ///< mean of bound / upper end of the true distance
    double greatest = 0; ///< mean of bound / lower end
    int count = 0;
};

Ratio mean_ratio(const DistanceField& f, double radius, int count) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> coordinate(-radius - 2, radius + 2);
    Ratio result;
    while (result.count < count) {
        const glm::dvec3 p(coordinate(random), coordinate(random), coordinate(random));
        const Enclosure truth = enclose(f, p, 2.05);
        if (!(truth.upper <= 2)) continue;
        const double bound = distance(f, p, DistanceLevel::guaranteed).value;
        result.least += bound / truth.upper;
        result.greatest += bound / std::max(truth.lower, bound);
        ++result.count;
    }
    result.least /= count;
    result.greatest /= count;
    return result;
}

// ---- Batches
// -------------------------------------------------------------------------------------------------

struct Times {
    double single = 0; ///< nanoseconds a point
    double batch = 0;
};

Times times(const DistanceField& f, double radius, DistanceLevel level, std::size_t count) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> coordinate(-radius, radius);
    std::array<std::vector<double>, 3> in;
    for (auto& column : in)
        for (std::size_t i = 0; i < count; ++i) column.push_back(coordinate(random));
    std::vector<double> value(count);
    std::vector<std::int8_t> sign(count);
    Times best{INFINITY, INFINITY};
    for (int repeat = 0; repeat < 5; ++repeat) {
        double start = cpu_seconds();
        for (std::size_t i = 0; i < count; ++i)
            value[i] = distance(f, {in[0][i], in[1][i], in[2][i]}, level).value;
        best.single = std::min(best.single, cpu_seconds() - start);
        start = cpu_seconds();
        distances(f, PointArrays<double>{in[0], in[1], in[2]}, level, DistanceArrays{value, sign});
        best.batch = std::min(best.batch, cpu_seconds() - start);
    }
    const double nanoseconds = 1e9 / static_cast<double>(count);
    return {best.single * nanoseconds, best.batch * nanoseconds};
}

/// The value of `"key": "…"` in a line of JSON whose strings contain no quotes.
std::string string_field(const std::string& line, const std::string& key) {
    const std::string begin = "\"" + key + "\": \"";
    const std::size_t from = line.find(begin);
    if (from == std::string::npos) throw std::runtime_error("surfaces.jsonl: no " + key);
    return line.substr(from + begin.size(), line.find('"', from + begin.size()) - from - begin.size());
}

} // namespace

int main(int argument_count, char** arguments) {
    const std::vector<std::string> wanted(arguments + std::min(argument_count, 1),
                                          arguments + argument_count);
    std::ifstream file(std::string(ELIMINANT_DATA_DIR) + "/surfaces/surfaces.jsonl");
    const eliminant::Ring ring(eliminant::CoefficientField::rationals(), {"x", "y", "z"});
    std::puts(
        "Mean ratio of the guaranteed to the true distance, between what its enclosure allows;\n"
        "nanoseconds a point, single and in batches.\n"
        "| surface    | points | ratio         | first  | batch  | second | batch  | guar.  | batch  |\n"
        "|------------|--------|---------------|--------|--------|--------|--------|--------|--------|");
    for (std::string line; std::getline(file, line);) {
        const std::string name = string_field(line, "name");
        if (!wanted.empty() && std::ranges::find(wanted, name) == wanted.end()) continue;
        const double radius = eliminant::parse_rational(string_field(line, "sphere_radius")).get_d();
        const auto f = eliminant::parse_polynomial(ring, {string_field(line, "poly"), name});
        const DistanceField field(f);
        const bool is_large = f.size() > 500;
        const Ratio ratio = is_large ? Ratio{NAN, NAN, 0} : mean_ratio(field, radius, 200);
        const std::size_t count = is_large ? 500 : 20'000;
        const Times first = times(field, radius, DistanceLevel::first_order, count);
        const Times second = times(field, radius, DistanceLevel::second_order, count);
        const Times guaranteed = times(field, radius, DistanceLevel::guaranteed, count);
        std::printf("| %-10s | %6d | %5.3f - %5.3f | %6.0f | %6.0f | %6.0f | %6.0f | %6.0f | %6.0f |\n",
                    name.c_str(), ratio.count, ratio.least, ratio.greatest, first.single, first.batch,
                    second.single, second.batch, guaranteed.single, guaranteed.batch);
        std::fflush(stdout);
    }
}
