/// \file
/// bench_field [SURFACE…]: value, gradient and Hessian in batches, against a C++ function of each surface
/// that is written, compiled by `c++ -O3 -march=native` and loaded here; and what the levels of distance
/// cost.
///
/// The function is the polynomial and its nine derivatives in expanded form, as a computer-algebra system
/// writes them: powers and monomials are common subexpressions, computed once. It is called for one point at
/// a time. Both sides work on blocks of points that stay in the first-level cache. Times are of this thread's
/// processor time.
#include "eliminant/algebra/calculus.hpp"
#include "eliminant/algebra/parse.hpp"
#include "eliminant/field/distance.hpp"

#include <dlfcn.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using eliminant::CoefficientField;
using eliminant::CompiledPolynomial;
using eliminant::derivative;
using eliminant::distance;
using eliminant::DistanceField;
using eliminant::DistanceLevel;
using eliminant::JetArrays;
using eliminant::parse_polynomial;
using eliminant::parse_rational;
using eliminant::PointArrays;
using eliminant::Polynomial;
using eliminant::Ring;

constexpr std::size_t block = 256;
constexpr std::size_t blocks = 4'000;   ///< 1,024,000 points
constexpr std::size_t pool = 8 * block; ///< random points that are gone through again and again

double cpu_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The least time of three.
template <class Body>
double best_time(const Body& body) {
    double best = INFINITY;
    for (int i = 0; i < 3; ++i) {
        const double start = cpu_seconds();
        body();
        best = std::min(best, cpu_seconds() - start);
    }
    return best;
}

// ---- The other side
// ------------------------------------------------------------------------------------------

using Monomial3 = std::array<std::uint64_t, 3>;

/// The text of the function.
class Writer {
  public:
    std::string function(const std::vector<Polynomial>& outputs) {
        std::string sums;
        for (std::size_t i = 0; i < outputs.size(); ++i) {
            sums += "    out[" + std::to_string(i) + "] = 0";
            const Polynomial& f = outputs[i];
            for (std::size_t t = 0; t < f.size(); ++t) {
                const std::string name = monomial({f.exponent(t, 0), f.exponent(t, 1), f.exponent(t, 2)});
                char number[40];
                std::snprintf(number, sizeof number, "%.17g", f.coefficient(t).get_d());
                sums += std::string(" + ") + number + (name.empty() ? "" : "*" + name);
            }
            sums += ";\n";
        }
        return "extern \"C\" void jet(double x, double y, double z, double* out) {\n" + definitions_ + sums +
               "}\n";
    }

  private:
    /// The name of a power or monomial, which is defined before unless it is a variable; nothing for 1.
    std::string monomial(const Monomial3& e) {
        static const std::array<std::string, 3> variables = {"x", "y", "z"};
        if (e == Monomial3{}) return "";
        std::size_t last = 2;
        while (e[last] == 0) --last;
        Monomial3 rest = e;
        rest[last] = 0;
        if (rest == Monomial3{} && e[last] == 1) return variables[last];
        const auto found = names_.find(e);
        if (found != names_.end()) return found->second;
        std::string product;
        if (rest == Monomial3{}) { // a power: from its halves
            Monomial3 half{};
            half[last] = e[last] / 2;
            Monomial3 other{};
            other[last] = e[last] - e[last] / 2;
            product = monomial(half) + "*" + monomial(other);
        } else {
            Monomial3 power{};
            power[last] = e[last];
            product = monomial(rest) + "*" + monomial(power);
        }
        std::string name = std::string("m").append(std::to_string(names_.size()));
        names_[e] = name;
        definitions_ += "    const double " + name + " = " + product + ";\n";
        return name;
    }

    std::map<Monomial3, std::string> names_;
    std::string definitions_;
};

using JetFunction = void (*)(double, double, double, double*);

JetFunction compiled_function(const std::string& name, const Polynomial& f) {
    std::vector<Polynomial> outputs = {f};
    for (std::size_t i = 0; i < 3; ++i) outputs.push_back(derivative(f, i));
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = i; j < 3; ++j) outputs.push_back(derivative(outputs[1 + i], j));
    const std::filesystem::path folder = std::filesystem::temp_directory_path() / "eliminant-bench-field";
    std::filesystem::create_directories(folder);
    const std::string stem = (folder / name).string();
    std::ofstream(stem + ".cpp") << Writer().function(outputs);
    const std::string command = "c++ -O3 -march=native -shared -fPIC -o '" + stem + ".so' '" + stem + ".cpp'";
    if (std::system(command.c_str()) != 0) throw std::runtime_error("failed: " + command);
    void* library = dlopen((stem + ".so").c_str(), RTLD_NOW);
    if (library == nullptr) throw std::runtime_error(dlerror());
    return reinterpret_cast<JetFunction>(dlsym(library, "jet"));
}

// ---- The measurements
// ----------------------------------------------------------------------------------------

struct Points {
    std::vector<double> x, y, z;
    explicit Points(double radius) : x(pool), y(pool), z(pool) {
        std::mt19937_64 random(1);
        std::uniform_real_distribution<double> coordinate(-radius, radius);
        for (auto* column : {&x, &y, &z})
            for (double& value : *column) value = coordinate(random);
    }
};

template <class Real>
double batch_seconds(const CompiledPolynomial& f, const Points& points) {
    std::array<std::vector<Real>, 3> in;
    std::array<std::vector<Real>, 10> out;
    for (auto& column : out) column.resize(block);
    const std::vector<double>* columns[] = {&points.x, &points.y, &points.z};
    for (std::size_t i = 0; i < 3; ++i)
        for (const double value : *columns[i]) in[i].push_back(static_cast<Real>(value));
    return best_time([&] {
        for (std::size_t b = 0; b < blocks; ++b) {
            const auto part = [&](std::size_t i) {
                return std::span<const Real>(in[i]).subspan(b * block % pool, block);
            };
            const auto slot = [&](std::size_t i) { return std::span<Real>(out[i]); };
            f.evaluate(PointArrays<Real>{part(0), part(1), part(2)},
                       JetArrays<Real>{slot(0),
                                       {slot(1), slot(2), slot(3)},
                                       {slot(4), slot(5), slot(6), slot(7), slot(8), slot(9)}});
        }
    });
}

double function_seconds(JetFunction jet, const Points& points) {
    std::vector<double> out(10 * block);
    return best_time([&] {
        for (std::size_t b = 0; b < blocks; ++b)
            for (std::size_t i = 0; i < block; ++i) {
                const std::size_t p = b * block % pool + i;
                jet(points.x[p], points.y[p], points.z[p], out.data() + 10 * i);
            }
    });
}

double distance_nanoseconds(const DistanceField& field, const Points& points, DistanceLevel level,
                            std::size_t count) {
    volatile double sink = 0;
    return best_time([&] {
               for (std::size_t i = 0; i < count; ++i)
                   sink = sink +
                          distance(field, {points.x[i % pool], points.y[i % pool], points.z[i % pool]}, level)
                              .value;
           }) /
           static_cast<double>(count) * 1e9;
}

void measure(const std::string& name, const Polynomial& f, double radius) {
    const Points points(radius);
    const CompiledPolynomial compiled(f);
    const double per_point = 1e9 / static_cast<double>(blocks * block);
    const double function = function_seconds(compiled_function(name, f), points) * per_point;
    const double doubles = batch_seconds<double>(compiled, points) * per_point;
    const double floats = batch_seconds<float>(compiled, points) * per_point;
    const DistanceField field(compiled);
    const std::size_t count = f.size() > 500 ? 2'000 : 100'000;
    const double first = distance_nanoseconds(field, points, DistanceLevel::first_order, count);
    const double second = distance_nanoseconds(field, points, DistanceLevel::second_order, count);
    const double guaranteed = distance_nanoseconds(field, points, DistanceLevel::guaranteed, count);
    std::printf("| %-10s | %2d | %9.1f | %8.2f | %8.2f | %6.1f | %8.0f | %8.0f | %8.0f | %5.2f |\n",
                name.c_str(), compiled.degree(), function, doubles, floats, function / doubles, first, second,
                guaranteed, guaranteed / second);
    std::fflush(stdout);
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
    const Ring ring(CoefficientField::rationals(), {"x", "y", "z"});
    std::puts("Nanoseconds a point.\n"
              "| surface    |  d |  function | batch    | floats   | ratio  | first    | second   | guarant. "
              "| g/s   |\n"
              "|------------|----|-----------|----------|----------|--------|----------|----------|----------"
              "|-------|");
    for (std::string line; std::getline(file, line);) {
        const std::string name = string_field(line, "name");
        if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), name) == wanted.end()) continue;
        const double radius = parse_rational(string_field(line, "sphere_radius")).get_d();
        measure(name, parse_polynomial(ring, {string_field(line, "poly"), name}), radius);
    }
}
