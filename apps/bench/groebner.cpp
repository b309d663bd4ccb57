// Buchberger's algorithm against Singular's std, one thread, one JSON object a line:
//
//     bench_groebner [--repeat N] [--no-peer] [NAME …]      systems of data/groebner whose name contains a
//     NAME
//
// Each system is done over ℚ and over GF(1073741827) in degrevlex. Times are medians of the computation
// alone, on both sides without reading the input; peaks of memory are those of whole processes, a process a
// measurement.
#include "eliminant/algebra/system.hpp"
#include "eliminant/groebner/buchberger.hpp"

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace {

struct Measurement {
    double seconds = -1; ///< negative if there is none
    double mebibytes = 0;
};

std::string read_file(const std::filesystem::path& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values.empty() ? -1 : values[values.size() / 2];
}

/// Runs `work` in a child process and reads the numbers that it prints.
Measurement measure(const std::function<void(FILE*)>& work) {
    std::array<int, 2> channel{};
    if (pipe(channel.data()) != 0) return {};
    const pid_t child = fork();
    if (child == 0) {
        close(channel[0]);
        FILE* out = fdopen(channel[1], "w");
        work(out);
        std::fclose(out);
        std::_Exit(0);
    }
    close(channel[1]);
    FILE* in = fdopen(channel[0], "r");
    std::vector<double> times;
    for (double t = 0; std::fscanf(in, "%lf", &t) == 1;) times.push_back(t);
    std::fclose(in);
    rusage usage{};
    wait4(child, nullptr, 0, &usage);
    return {median(times), static_cast<double>(usage.ru_maxrss) / 1024};
}

Measurement measure_ours(const std::string& text, const std::string& name, std::uint64_t p, int repeat) {
    return measure([&](FILE* out) {
        eliminant::Run run;
        eliminant::SystemOverrides overrides;
        if (p != 0) overrides.field = eliminant::CoefficientField::prime(p);
        const auto system =
            eliminant::parse_system({text, name}, eliminant::SystemFormat::msolve, overrides, run);
        for (int i = 0; i < repeat; ++i) {
            const auto start = std::chrono::steady_clock::now();
            const auto basis = eliminant::buchberger(system.ring, system.polynomials, {}, run);
            const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
            std::fprintf(out, "%.6f\n", basis.complete ? time.count() : -1);
        }
    });
}

/// Singular's own timer in milliseconds.
Measurement measure_singular(const std::string& text, std::uint64_t p, int repeat) {
    std::istringstream lines(text);
    std::string variables;
    std::string characteristic;
    std::getline(lines, variables);
    std::getline(lines, characteristic);
    std::ostringstream rest;
    rest << lines.rdbuf();
    std::ostringstream script;
    script << "system(\"--ticks-per-sec\",1000000);ring r=" << p << ",(" << variables
           << "),dp;ideal I=" << rest.str() << ";option(redSB);int t;int k;ideal G;for(k=0;k<" << repeat
           << ";k++){t=rtimer;G=std(I);print(rtimer-t);}quit;\n";
    const std::string path =
        std::filesystem::temp_directory_path() / ("singular-" + std::to_string(getpid()) + ".sing");
    std::ofstream(path) << script.str();
    Measurement result = measure([&](FILE* out) {
        dup2(fileno(out), STDOUT_FILENO);
        execlp("Singular", "Singular", "-q", path.c_str(), nullptr);
        std::_Exit(127);
    });
    std::filesystem::remove(path);
    if (result.seconds >= 0) result.seconds /= 1e6;
    return result;
}

} // namespace

int main(int argc, char** argv) {
    int repeat = 5;
    bool peer = true;
    std::vector<std::string> wanted;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--repeat") == 0 && i + 1 < argc)
            repeat = std::max(1, std::atoi(argv[++i]));
        else if (std::strcmp(argv[i], "--no-peer") == 0)
            peer = false;
        else
            wanted.emplace_back(argv[i]);
    }
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(ELIMINANT_DATA_DIR "/groebner")) {
        const std::string name = entry.path().filename();
        const auto occurs = [&name](const std::string& part) { return name.find(part) != std::string::npos; };
        if (name.ends_with(".ms") && (wanted.empty() || std::ranges::any_of(wanted, occurs)))
            files.push_back(entry.path());
    }
    std::ranges::sort(files);
    double logarithms = 0; // of the ratios where the peer needs over 50 ms
    int counted = 0;
    for (const auto& file : files) {
        const std::string text = read_file(file);
        for (const std::uint64_t p : {std::uint64_t{1073741827}, std::uint64_t{0}}) {
            const Measurement ours = measure_ours(text, file.filename(), p, repeat);
            const Measurement theirs = peer ? measure_singular(text, p, repeat) : Measurement{};
            std::printf("{\"system\":\"%s\",\"field\":\"%s\",\"seconds\":%.4f,\"mebibytes\":%.1f",
                        file.stem().stem().c_str(), p == 0 ? "QQ" : "GF(1073741827)", ours.seconds,
                        ours.mebibytes);
            if (theirs.seconds >= 0)
                std::printf(",\"singular_seconds\":%.4f,\"singular_mebibytes\":%.1f,\"ratio\":%.2f",
                            theirs.seconds, theirs.mebibytes, ours.seconds / theirs.seconds);
            std::printf("}\n");
            std::fflush(stdout);
            if (theirs.seconds > 0.05) {
                logarithms += std::log(ours.seconds / theirs.seconds);
                ++counted;
            }
        }
    }
    if (counted != 0)
        std::printf("{\"geometric_mean_where_peer_over_50ms\":%.3f,\"systems\":%d}\n",
                    std::exp(logarithms / counted), counted);
}
