// Methods of implicitization side by side, and what was predicted of them: one JSON object a line.
//
//     bench_implicit [--repeat N] [--limit SECONDS] [--directory D] [NAME …]
//
// Shapes are random parametrizations of many kinds, made here, and the files NAME.par of data/implicit (or of
// D); those whose name contains one of the NAMEs. For each method there are the seconds it took on one
// thread, without proof, median of N, and those the cost model predicted (null where it excludes the method,
// negative for a lower bound). `loss` is the time of the method that was chosen, choice included, over the
// least time. A method that falls back on another one, or needs longer than the limit, has no time.
#include "eliminant/implicit/implicitize.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iostream>
#include <map>
#include <optional>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

using eliminant::Assurance;
using eliminant::implicitize;
using eliminant::ImplicitResult;
using eliminant::Method;
using eliminant::Parametrization;
using eliminant::parse_parametrization;
using eliminant::Run;
using eliminant::RunOptions;
using Json = nlohmann::ordered_json;

struct Settings {
    int repeat = 3;
    double limit = 5;
    std::filesystem::path directory = ELIMINANT_DATA_DIR "/implicit";
    std::vector<std::string> wanted;
};

/// Random polynomials as text.
class Source {
  public:
    explicit Source(unsigned seed) : random_(seed) {}

    std::string integer(int bits) {
        const long range = 1L << bits;
        const auto value = static_cast<long>(random_() % (2 * static_cast<unsigned long>(range))) - range;
        return std::string("(").append(std::to_string(value == 0 ? 1 : value)).append(")");
    }
    std::string curve(int degree, int bits) {
        std::string text;
        for (int i = 0; i <= degree; ++i)
            text.append(i == 0 ? "" : "+").append(integer(bits)).append("*t^").append(std::to_string(i));
        return std::string("(").append(text).append(")");
    }
    /// All terms of degrees at most m in s and n in t, and at most `total` together.
    std::string surface(int m, int n, int total, int bits) {
        std::string text;
        for (int i = 0; i <= m; ++i)
            for (int j = 0; j <= n && i + j <= total; ++j)
                text.append(text.empty() ? "" : "+")
                    .append(integer(bits))
                    .append("*s^")
                    .append(std::to_string(i))
                    .append("*t^")
                    .append(std::to_string(j));
        return std::string("(").append(text).append(")");
    }
    std::string patch(int m, int n, int bits) { return surface(m, n, m + n, bits); }
    std::string triangle(int n, int bits) { return surface(n, n, n, bits); }
    /// Few terms.
    std::string sparse(int m, int n, int terms) {
        std::string text;
        for (int i = 0; i < terms; ++i)
            text.append(i == 0 ? "" : "+")
                .append(integer(3))
                .append("*s^")
                .append(std::to_string(below(m + 1)))
                .append("*t^")
                .append(std::to_string(below(n + 1)));
        return std::string("(").append(text).append(")");
    }

  private:
    int below(int bound) { return static_cast<int>(random_() % static_cast<unsigned>(bound)); }
    std::mt19937 random_;
};

using Shapes = std::map<std::string, std::string>;

std::string joined(std::initializer_list<std::string_view> parts) {
    std::string text;
    for (const std::string_view part : parts) text.append(part);
    return text;
}

std::string named(std::string_view kind, int number) { return joined({kind, std::to_string(number)}); }

std::string curve_of(const std::string& x, const std::string& y) {
    return joined({"x = ", x, "\ny = ", y, "\n"});
}

std::string surface_of(const std::string& x, const std::string& y, const std::string& z) {
    return joined({"parameters s, t\nx = ", x, "\ny = ", y, "\nz = ", z, "\n"});
}

void add_curves(Shapes& shapes) {
    Source source(1);
    for (const int d : {4, 8, 16, 24, 40}) {
        for (const int bits : {3, 30}) {
            if (d == 40 && bits == 30) continue;
            const std::string tail = joined({std::to_string(d), "_", std::to_string(bits), "bit"});
            const auto form = [&] { return source.curve(d, bits); };
            const std::string w = form();
            shapes["curve" + tail] = curve_of(form(), form());
            shapes["rational_curve" + tail] = curve_of(joined({form(), "/", w}), joined({form(), "/", w}));
        }
    }
    for (const int d : {5, 20, 60}) {
        const std::string u = source.curve(d, 4);
        shapes[named("circle_of_degree", d)] =
            curve_of(joined({"(1-", u, "^2)/(1+", u, "^2)"}), joined({"2*", u, "/(1+", u, "^2)"}));
        shapes[named("graph_curve", d)] = curve_of("t", source.curve(d, 6));
    }
    shapes["sparse_curve"] = curve_of("t^37+t", "t^101+t^3");
    shapes["monomial_curve"] = curve_of("t^37", "t^101");
    shapes["lopsided_curve"] = curve_of(source.curve(3, 10), source.curve(40, 4));
}

template <class Form>
std::string rational_surface(const Form& form) {
    const std::string w = form();
    const auto quotient = [&] { return joined({form(), "/", w}); };
    return surface_of(quotient(), quotient(), quotient());
}

void add_surfaces(Shapes& shapes) {
    Source source(2);
    for (const auto& [m, n] : {std::pair{1, 1}, {1, 2}, {2, 2}, {2, 3}, {3, 3}, {1, 6}}) {
        for (const int bits : {3, 20}) {
            const std::string tail =
                joined({std::to_string(m), std::to_string(n), "_", std::to_string(bits), "bit"});
            const auto form = [&, rows = m, columns = n] { return source.patch(rows, columns, bits); };
            shapes["patch" + tail] = surface_of(form(), form(), form());
            if (m * n <= 6) shapes["rational_patch" + tail] = rational_surface(form);
        }
    }
    for (const int n : {2, 3, 4, 5}) {
        const auto form = [&] { return source.triangle(n, 4); };
        shapes[named("triangle", n)] = surface_of(form(), form(), form());
        if (n <= 4) shapes[named("rational_triangle", n)] = rational_surface(form);
    }
    for (const int n : {2, 4, 6}) {
        const std::string u = source.triangle(n, 3);
        const std::string v = source.triangle(n, 3);
        const std::string w = joined({"(1+", u, "^2+", v, "^2)"});
        shapes[named("sphere_of_degree", 2 * n)] =
            surface_of(joined({"2*", u, "/", w}), joined({"2*", v, "/", w}), joined({"(2-", w, ")/", w}));
        shapes[named("paraboloid_of_degree", n)] = surface_of(u, v, joined({u, "^2+3*", v, "^2+", u}));
    }
    for (const int n : {5, 20, 60}) shapes[named("graph", n)] = surface_of("s", "t", source.triangle(n, 5));
    for (const int n : {4, 7, 10}) {
        const auto form = [&] { return source.sparse(n, n, 3); };
        shapes[named("sparse_surface", n)] = surface_of(form(), form(), form());
    }
    shapes["monomial_surface"] = surface_of("s^30*t^7", "s^5*t^30", "s^17*t^13");
    shapes["small_monomial_surface"] = surface_of("s^3*t^2", "s*t^4", "s^2*t");
    shapes["symmetric_surface"] = surface_of("s^2+t^2", "s*t*(s^2-t^2)", "s^4+t^4-s^2*t^2");
}

void add_others(Shapes& shapes) {
    shapes["torus_with_constants"] =
        "constants R, r\nx = (R+r*cos(u))*cos(v)\ny = (R+r*cos(u))*sin(v)\nz = r*sin(u)\n";
    shapes["ellipse_with_constants"] = "constants a, b\nx = a*cos(u)+b\ny = b*sin(u)+a\n";
    shapes["cubic_with_constant"] = "constants r\nx = r*t^3+t\ny = t^2+r*t+1\n";
    shapes["quadrics_in_4_space"] =
        "parameters s, t, u\nx = s^2+t*u\ny = t^2+s*u+s\nz = u^2+s*t\nw = s*t+t*u+u\n";
    shapes["graph_in_4_space"] = "parameters s, t, u\nx = s\ny = t\nz = u\nw = s^5*t+u^6-s*t*u+3\n";
    shapes["sphere_in_4_space"] = "parameters s, t, u\nx = 2s/(1+s^2+t^2+u^2)\ny = 2t/(1+s^2+t^2+u^2)\n"
                                  "z = 2u/(1+s^2+t^2+u^2)\nw = (1-s^2-t^2-u^2)/(1+s^2+t^2+u^2)\n";
}

void add_files(Shapes& shapes, const std::filesystem::path& directory) {
    for (const auto& entry : std::filesystem::directory_iterator(directory)) {
        if (entry.path().extension() != ".par") continue;
        std::ostringstream content;
        content << std::ifstream(entry.path()).rdbuf();
        shapes[entry.path().stem().string()] = content.str();
    }
}

double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Measurement {
    double seconds;
    ImplicitResult result;
};

std::optional<Measurement> measure(const Parametrization& shape, Method method, const Settings& settings) {
    std::vector<double> times;
    std::optional<ImplicitResult> result;
    for (int i = 0; i < settings.repeat; ++i) {
        RunOptions options;
        options.time_limit_seconds = settings.limit;
        Run run(options);
        const double start = processor_seconds();
        try {
            result = implicitize(shape, {.method = method, .assurance = Assurance::probable}, run);
        } catch (const eliminant::Stopped&) {
            return std::nullopt;
        }
        times.push_back(processor_seconds() - start);
        if (times.back() > 1) break;
    }
    std::ranges::sort(times);
    return Measurement{times[times.size() / 2], std::move(*result)};
}

Json rounded(double seconds) { return std::round(seconds * 1e7) / 1e7; }

void report(const std::string& name, const std::string& text, const Settings& settings) {
    Run run;
    const Parametrization shape = parse_parametrization({text, name}, run);
    const auto chosen = measure(shape, Method::automatic, settings);
    if (chosen && chosen->result.codimension != 1) return;
    Json line;
    line["name"] = name;
    double least = chosen ? chosen->seconds : settings.limit;
    for (const Method method : {Method::resultant, Method::linear, Method::groebner}) {
        const auto found = measure(shape, method, settings);
        Json entry = {{"seconds", nullptr}, {"predicted", nullptr}};
        if (found && found->result.method == method) {
            entry["seconds"] = rounded(found->seconds);
            least = std::min(least, found->seconds);
        }
        if (chosen)
            for (const auto& cost : chosen->result.predicted)
                if (cost.method == method)
                    entry["predicted"] = rounded(cost.at_least ? -cost.seconds : cost.seconds);
        line[std::string(eliminant::implicit::to_string(method))] = entry;
    }
    if (chosen) {
        line["chosen"] = eliminant::implicit::to_string(chosen->result.method);
        line["seconds"] = rounded(chosen->seconds);
        line["degree"] = chosen->result.equations.front().total_degree();
        line["terms"] = chosen->result.equations.front().size();
        line["primes"] = chosen->result.statistics.primes_used;
        line["loss"] = std::round(100 * chosen->seconds / least) / 100;
    }
    std::cout << line.dump() << std::endl;
}

} // namespace

int main(int argc, char** argv) {
    Settings settings;
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const auto value = [&]() -> std::string { return i + 1 < argc ? argv[++i] : ""; };
        if (argument == "--repeat")
            settings.repeat = std::max(1, std::atoi(value().c_str()));
        else if (argument == "--limit")
            settings.limit = std::strtod(value().c_str(), nullptr);
        else if (argument == "--directory")
            settings.directory = value();
        else
            settings.wanted.push_back(argument);
    }
    Shapes shapes;
    add_curves(shapes);
    add_surfaces(shapes);
    add_others(shapes);
    add_files(shapes, settings.directory);
    for (const auto& [name, text] : shapes) {
        const auto matches = [&name = name](const std::string& wanted) {
            return name.find(wanted) != std::string::npos;
        };
        if (settings.wanted.empty() || std::ranges::any_of(settings.wanted, matches))
            report(name, text, settings);
    }
    return 0;
}
