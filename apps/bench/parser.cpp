// A polynomial of a million terms as text, read and written, against FLINT and Singular; one JSON object a
// line:
//
//     bench_parser [TERMS [REPETITIONS]]
//
// Terms are in degrevlex order, as every system writes them, or shuffled, and between parentheses, where the
// grammar reads every term itself. Seconds are medians of the repetitions. Singular is measured by its own
// timer, from before the statement that holds the polynomial is read until it has its value.
#include "eliminant/algebra/parse.hpp"
#include "eliminant/algebra/print.hpp"

#include <flint/fmpz_mpoly.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using eliminant::CoefficientField;
using eliminant::Integer;
using eliminant::parse_polynomial;
using eliminant::Polynomial;
using eliminant::PolynomialBuilder;
using eliminant::Ring;

namespace {

const std::vector<std::string> names = {"x", "y", "z"};

template <class Work>
double median_seconds(int repetitions, Work&& work) {
    std::vector<double> seconds;
    for (int i = 0; i < repetitions; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        seconds.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
    std::ranges::nth_element(seconds, seconds.begin() + repetitions / 2);
    return seconds[static_cast<std::size_t>(repetitions / 2)];
}

/// About `terms` terms, so that the text is some 10 bytes a term.
Polynomial random_polynomial(const Ring& ring, std::size_t terms) {
    std::mt19937_64 random(1);
    PolynomialBuilder builder(ring);
    std::vector<std::uint64_t> exponents(names.size());
    for (std::size_t i = 0; i < terms; ++i) {
        for (auto& e : exponents) e = random() % 180;
        builder.add(Integer(static_cast<std::int64_t>(random() % 199) - 99), exponents);
    }
    return builder.build();
}

std::string shuffled(const Polynomial& f) {
    std::vector<std::size_t> permutation(f.size());
    for (std::size_t i = 0; i < f.size(); ++i) permutation[i] = i;
    std::ranges::shuffle(permutation, std::mt19937_64(2));
    std::ostringstream text;
    for (const std::size_t i : permutation)
        text << (f.coefficient(i) < 0 ? "" : "+") << f.coefficient(i) << '*' << f.monomial(i).to_string();
    return text.str().substr(text.str().front() == '+' ? 1 : 0);
}

double flint_seconds(const std::string& text, int repetitions) {
    fmpz_mpoly_ctx_t context;
    fmpz_mpoly_ctx_init(context, static_cast<slong>(names.size()), ORD_DEGREVLEX);
    const char* variables[] = {"x", "y", "z"};
    const double seconds = median_seconds(repetitions, [&] {
        fmpz_mpoly_t f;
        fmpz_mpoly_init(f, context);
        if (fmpz_mpoly_set_str_pretty(f, text.c_str(), variables, context) != 0) std::abort();
        fmpz_mpoly_clear(f, context);
    });
    fmpz_mpoly_ctx_clear(context);
    return seconds;
}

/// Nothing where Singular is not installed.
std::string singular_seconds(const std::string& text) {
    const std::string file = "/tmp/eliminant_bench_parser.sing";
    std::ofstream(file)
        << "ring r = 0,(x,y,z),dp; system(\"--ticks-per-sec\",1000);\nint t = rtimer;\npoly f = " << text
        << ";\nprint(rtimer - t); quit;\n";
    FILE* const pipe = popen(("Singular -q " + file + " 2>/dev/null").c_str(), "r");
    if (pipe == nullptr) return "null";
    char line[64] = "";
    const bool answered = std::fgets(line, sizeof line, pipe) != nullptr;
    pclose(pipe);
    std::remove(file.c_str());
    return answered ? std::to_string(std::atof(line) / 1000) : "null";
}

void report(const char* shape, const Polynomial& f, const std::string& text, int repetitions) {
    const double ours = median_seconds(repetitions, [&] {
        if (parse_polynomial(f.ring(), text) != f) std::abort();
    });
    const double equality = median_seconds(repetitions, [&] {
        if (f != Polynomial(f)) std::abort();
    });
    std::cout << "{\"input\":\"" << shape << "\",\"terms\":" << f.size() << ",\"bytes\":" << text.size()
              << ",\"eliminant_seconds\":" << ours - equality
              << ",\"flint_seconds\":" << flint_seconds(text, repetitions)
              << ",\"singular_seconds\":" << singular_seconds(text) << "}" << std::endl;
}

} // namespace

int main(int argc, char** argv) {
    const std::size_t terms = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
    const int repetitions = argc > 2 ? std::atoi(argv[2]) : 3;
    const Ring ring(CoefficientField::rationals(), names);
    const Polynomial f = random_polynomial(ring, terms);
    const std::string text = to_string(f);
    const double printing = median_seconds(repetitions, [&] {
        if (to_string(f).size() != text.size()) std::abort();
    });
    std::cout << "{\"output\":\"sorted\",\"terms\":" << f.size() << ",\"bytes\":" << text.size()
              << ",\"eliminant_seconds\":" << printing << "}" << std::endl;
    report("sorted", f, text, repetitions);
    report("shuffled", f, shuffled(f), repetitions);
    report("parenthesised", f, std::string("(").append(text).append(")"), repetitions);
}
