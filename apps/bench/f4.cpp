// F4 over GF(p) and what lifting over ℚ pays for: one JSON object a line.
//
//     bench_f4 [--repeat N] [--threads N] [--probable] [--directory D] [--baseline PROGRAM] [NAME …]
//
// Systems are the files NAME.qq.ms of data/groebner (or of D) whose name contains one of the NAMEs, in
// degrevlex modulo 1073741827. `seconds` is the median time of a basis, `learn` that of a recorded one,
// `replay` that of one more prime, eight at a time. The baseline is an older executable of this program: it
// is run in turn with this one on each system, and `ratio` is our time over its time.
#include "groebner/f4_trace.hpp"

#include "eliminant/algebra/prime_field.hpp"
#include "eliminant/algebra/system.hpp"
#include "eliminant/groebner/f4.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

namespace {

constexpr std::uint64_t prime = 1073741827;

struct Settings {
    int repeat = 5;
    unsigned threads = 1;
    bool probable = false;
    std::filesystem::path directory = ELIMINANT_DATA_DIR "/groebner";
    std::string baseline;
    std::vector<std::string> wanted;
};

double median_seconds(int repeat, const std::function<void()>& work) {
    std::vector<double> times;
    for (int i = 0; i < repeat; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        times.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    std::ranges::nth_element(times, times.begin() + repeat / 2);
    return times[static_cast<std::size_t>(repeat / 2)];
}

eliminant::System read_system(const std::filesystem::path& file, bool modular, eliminant::Run& run) {
    std::ostringstream content;
    content << std::ifstream(file).rdbuf();
    const std::string text = content.str();
    eliminant::SystemOverrides overrides;
    if (modular) overrides.field = eliminant::CoefficientField::prime(prime);
    return eliminant::parse_system({text, file.string()}, eliminant::SystemFormat::msolve, overrides, run);
}

/// `seconds` that a baseline prints for one system.
std::optional<double> baseline_seconds(const Settings& settings, const std::string& name) {
    const std::string command = "'" + settings.baseline + "' --exactly --repeat " +
                                std::to_string(settings.repeat) + " --threads " +
                                std::to_string(settings.threads) + (settings.probable ? " --probable" : "") +
                                " --directory '" + settings.directory.string() + "' '" + name + "'";
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return std::nullopt;
    std::string output(4096, '\0');
    output.resize(std::fread(output.data(), 1, output.size(), pipe));
    pclose(pipe);
    const std::string key = "\"seconds\":";
    const std::size_t at = output.find(key);
    if (at == std::string::npos) return std::nullopt;
    return std::strtod(output.c_str() + at + key.size(), nullptr);
}

void measure(const Settings& settings, const std::filesystem::path& file, const std::string& name) {
    eliminant::RunOptions run_options;
    run_options.threads = settings.threads;
    eliminant::Run run(run_options);
    eliminant::BuchbergerOptions options;
    if (settings.probable) options.linear_algebra = eliminant::groebner::LinearAlgebra::probabilistic;

    const eliminant::System modular = read_system(file, true, run);
    eliminant::GroebnerBasis basis;
    const double seconds = median_seconds(
        settings.repeat, [&] { basis = eliminant::f4(modular.ring, modular.polynomials, options, run); });

    using eliminant::groebner::F4Trace;
    const eliminant::System rational = read_system(file, false, run);
    std::optional<F4Trace> trace;
    const double learn = median_seconds(settings.repeat, [&] {
        trace = F4Trace::learn(rational.ring, rational.polynomials, prime, {}, run);
    });
    std::vector<std::uint32_t> primes;
    for (std::uint64_t p = prime; primes.size() < eliminant::groebner::lane_count;) {
        p = eliminant::algebra::previous_prime(p);
        primes.push_back(static_cast<std::uint32_t>(p));
    }
    const double replay =
        trace ? median_seconds(settings.repeat, [&] { static_cast<void>(trace->replay(primes, run)); }) : -1;

    const auto& statistics = basis.statistics;
    const auto* const largest = statistics.largest_matrix();
    std::printf(
        "{\"name\":\"%s\",\"seconds\":%.6f,\"learn\":%.6f,\"replay\":%.6f,\"elements\":%zu,\"matrices\":%llu,"
        "\"largest_matrix\":[%llu,%llu],\"trace_bytes\":%zu",
        name.c_str(), seconds, learn, replay / static_cast<double>(primes.size()), basis.elements.size(),
        static_cast<unsigned long long>(statistics.matrices.size()),
        static_cast<unsigned long long>(largest ? largest->rows : 0),
        static_cast<unsigned long long>(largest ? largest->columns : 0),
        trace ? trace->size_in_bytes() : std::size_t{0});
    if (!settings.baseline.empty()) {
        const std::optional<double> before = baseline_seconds(settings, name);
        if (before && *before > 0)
            std::printf(",\"baseline\":%.6f,\"ratio\":%.3f", *before, seconds / *before);
    }
    std::printf("}\n");
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    Settings settings;
    bool exactly = false; // names are whole names
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        const auto value = [&]() -> std::string { return i + 1 < argc ? argv[++i] : ""; };
        if (argument == "--repeat")
            settings.repeat = std::max(1, std::atoi(value().c_str()));
        else if (argument == "--threads")
            settings.threads = static_cast<unsigned>(std::max(1, std::atoi(value().c_str())));
        else if (argument == "--probable")
            settings.probable = true;
        else if (argument == "--exactly")
            exactly = true;
        else if (argument == "--directory")
            settings.directory = value();
        else if (argument == "--baseline")
            settings.baseline = value();
        else
            settings.wanted.push_back(argument);
    }
    const std::string ending = ".qq.ms";
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(settings.directory)) {
        if (entry.path().string().ends_with(ending)) files.push_back(entry.path());
    }
    std::ranges::sort(files);
    for (const std::filesystem::path& file : files) {
        std::string name = file.filename().string();
        name.resize(name.size() - ending.size());
        const auto matches = [&](const std::string& wanted) {
            return exactly ? name == wanted : name.find(wanted) != std::string::npos;
        };
        if (settings.wanted.empty() || std::ranges::any_of(settings.wanted, matches))
            measure(settings, file, name);
    }
    return 0;
}
