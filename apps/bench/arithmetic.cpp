// Polynomial arithmetic against FLINT, one thread, one JSON object a line:
//
//     bench_arithmetic [--repeat N] [NAME …]        all problems whose name contains one of the NAMEs
//
// Every measurement runs in a process of its own, so a peak of memory belongs to one problem and one library.
// Times are medians over the repetitions within that process; peaks leave out what the set-up of the operands
// needed.
#include "eliminant/algebra/arithmetic.hpp"

#include <flint/fmpz_mpoly.h>
#include <flint/nmod_mpoly.h>

#include <malloc.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <functional>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace {

constexpr std::uint64_t prime = 1073741827; // 2^30 + 3

struct Term {
    long coefficient;
    std::vector<std::uint64_t> exponents;
};

/// A polynomial both libraries can be given: base^power + plus.
struct Factor {
    std::vector<Term> base;
    std::uint64_t power = 1;
    long plus = 0;
};

enum class Operation { multiply, divide, power };

struct Problem {
    std::string name;
    std::size_t variables;
    bool lex;
    bool modular;
    Operation operation;
    Factor a;
    Factor b; ///< for a power: b.power is the exponent
};

struct Measurement {
    double seconds = 0;
    double peak_mebibytes = 0;
    std::size_t terms = 0;
};

/// A line of /proc/self/status: VmHWM is the peak of the resident memory, VmRSS its present size.
double mebibytes(std::string_view line_name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with(line_name)) return std::strtod(line.c_str() + line_name.size(), nullptr) / 1024;
    }
    return 0;
}

void forget_peak() {
    malloc_trim(0);
    std::ofstream("/proc/self/clear_refs") << 5;
}

double cpu_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// The median time of `work`, which returns the number of terms of its result.
Measurement measure(int repeat, const std::function<std::size_t()>& work) {
    forget_peak();
    Measurement result;
    std::vector<double> times;
    for (int i = 0; i < repeat; ++i) {
        const double start = cpu_seconds();
        result.terms = work();
        times.push_back(cpu_seconds() - start);
    }
    std::ranges::sort(times);
    result.seconds = times[times.size() / 2];
    result.peak_mebibytes = mebibytes("VmHWM:");
    return result;
}

std::vector<std::string> variable_names(std::size_t count) {
    std::vector<std::string> names;
    for (std::size_t i = 0; i < count; ++i) names.push_back(std::string("x").append(std::to_string(i)));
    return names;
}

Measurement run_eliminant(const Problem& problem, int repeat) {
    using eliminant::CoefficientField;
    using eliminant::divide_exactly;
    using eliminant::Integer;
    using eliminant::MonomialOrder;
    using eliminant::multiply;
    using eliminant::Polynomial;
    using eliminant::PolynomialBuilder;
    using eliminant::pow;
    using eliminant::Ring;
    const Ring ring(problem.modular ? CoefficientField::prime(prime) : CoefficientField::rationals(),
                    variable_names(problem.variables),
                    problem.lex ? MonomialOrder::lex() : MonomialOrder::degrevlex());
    const auto build = [&ring](const Factor& factor) {
        PolynomialBuilder builder(ring);
        for (const Term& term : factor.base) builder.add(Integer(term.coefficient), term.exponents);
        Polynomial f = builder.build();
        if (factor.power != 1) f = pow(f, factor.power);
        return f + Polynomial::constant(ring, factor.plus);
    };
    const Polynomial a = build(problem.a);
    eliminant::Run run;
    if (problem.operation == Operation::power)
        return measure(repeat, [&] { return pow(a, problem.b.power, run).size(); });
    const Polynomial b = build(problem.b);
    if (problem.operation == Operation::multiply)
        return measure(repeat, [&] { return multiply(a, b, run).size(); });
    const Polynomial product = multiply(a, b, run);
    return measure(repeat, [&] { return divide_exactly(product, b, run).size(); });
}

/// FLINT's two multivariate types behind one face.
struct IntegerPeer {
    using Value = fmpz_mpoly_struct;
    fmpz_mpoly_ctx_t context;
    IntegerPeer(std::size_t n, ordering_t order) {
        fmpz_mpoly_ctx_init(context, static_cast<slong>(n), order);
    }
    ~IntegerPeer() { fmpz_mpoly_ctx_clear(context); }
    IntegerPeer(const IntegerPeer&) = delete;
    IntegerPeer& operator=(const IntegerPeer&) = delete;
    void init(Value* f) { fmpz_mpoly_init(f, context); }
    void clear(Value* f) { fmpz_mpoly_clear(f, context); }
    void push(Value* f, long c, const ulong* e) { fmpz_mpoly_push_term_si_ui(f, c, e, context); }
    void sort(Value* f) { fmpz_mpoly_sort_terms(f, context), fmpz_mpoly_combine_like_terms(f, context); }
    void pow(Value* f, const Value* g, ulong k) { fmpz_mpoly_pow_ui(f, g, k, context); }
    void add(Value* f, const Value* g, long c) { fmpz_mpoly_add_si(f, g, c, context); }
    void multiply(Value* f, const Value* g, const Value* h) { fmpz_mpoly_mul(f, g, h, context); }
    bool divide(Value* f, const Value* g, const Value* h) {
        return fmpz_mpoly_divides(f, g, h, context) != 0;
    }
    static std::size_t size(const Value* f) { return static_cast<std::size_t>(f->length); }
};

struct ResiduePeer {
    using Value = nmod_mpoly_struct;
    nmod_mpoly_ctx_t context;
    ResiduePeer(std::size_t n, ordering_t order) {
        nmod_mpoly_ctx_init(context, static_cast<slong>(n), order, prime);
    }
    ~ResiduePeer() { nmod_mpoly_ctx_clear(context); }
    ResiduePeer(const ResiduePeer&) = delete;
    ResiduePeer& operator=(const ResiduePeer&) = delete;
    void init(Value* f) { nmod_mpoly_init(f, context); }
    void clear(Value* f) { nmod_mpoly_clear(f, context); }
    void push(Value* f, long c, const ulong* e) {
        const long residue = c % static_cast<long>(prime);
        nmod_mpoly_push_term_ui_ui(
            f, static_cast<ulong>(residue < 0 ? residue + static_cast<long>(prime) : residue), e, context);
    }
    void sort(Value* f) { nmod_mpoly_sort_terms(f, context), nmod_mpoly_combine_like_terms(f, context); }
    void pow(Value* f, const Value* g, ulong k) { nmod_mpoly_pow_ui(f, g, k, context); }
    void add(Value* f, const Value* g, long c) { nmod_mpoly_add_ui(f, g, static_cast<ulong>(c), context); }
    void multiply(Value* f, const Value* g, const Value* h) { nmod_mpoly_mul(f, g, h, context); }
    bool divide(Value* f, const Value* g, const Value* h) {
        return nmod_mpoly_divides(f, g, h, context) != 0;
    }
    static std::size_t size(const Value* f) { return static_cast<std::size_t>(f->length); }
};

template <class Peer>
Measurement run_peer(const Problem& problem, int repeat) {
    Peer peer(problem.variables, problem.lex ? ORD_LEX : ORD_DEGREVLEX);
    using Value = typename Peer::Value;
    const auto build = [&peer](Value* f, const Factor& factor) {
        peer.init(f);
        for (const Term& term : factor.base) {
            const std::vector<ulong> exponents(term.exponents.begin(), term.exponents.end());
            peer.push(f, term.coefficient, exponents.data());
        }
        peer.sort(f);
        if (factor.power != 1) peer.pow(f, f, factor.power);
        peer.add(f, f, factor.plus);
    };
    Value a;
    Value b;
    build(&a, problem.a);
    const auto timed = [&](auto&& work) {
        return measure(repeat, [&] {
            Value result;
            peer.init(&result);
            work(&result);
            const std::size_t terms = Peer::size(&result);
            peer.clear(&result);
            return terms;
        });
    };
    if (problem.operation == Operation::power)
        return timed([&](Value* result) { peer.pow(result, &a, problem.b.power); });
    build(&b, problem.b);
    if (problem.operation == Operation::multiply)
        return timed([&](Value* result) { peer.multiply(result, &a, &b); });
    Value product;
    peer.init(&product);
    peer.multiply(&product, &a, &b);
    return timed([&](Value* result) {
        if (!peer.divide(result, &product, &b)) std::abort();
    });
}

Measurement in_child(const std::function<Measurement()>& work) {
    int ends[2];
    if (pipe(ends) != 0) std::abort();
    const pid_t child = fork();
    if (child == 0) {
        const double before = mebibytes("VmRSS:"); // the program itself and the list of problems
        Measurement result = work();
        result.peak_mebibytes = std::max(0.0, result.peak_mebibytes - before);
        const auto written = write(ends[1], &result, sizeof result);
        _exit(written == sizeof result ? 0 : 1);
    }
    close(ends[1]);
    Measurement result;
    const bool complete = read(ends[0], &result, sizeof result) == sizeof result;
    close(ends[0]);
    waitpid(child, nullptr, 0);
    if (!complete) throw std::runtime_error("the measuring process failed");
    return result;
}

std::vector<Term> random_terms(std::size_t variables, std::size_t terms, std::uint64_t degree, long size) {
    std::mt19937_64 random(variables * terms + degree);
    std::vector<Term> result(terms);
    for (Term& term : result) {
        term.coefficient = 1 + static_cast<long>(random() % static_cast<std::uint64_t>(size));
        for (std::size_t i = 0; i < variables; ++i) term.exponents.push_back(random() % (degree + 1));
    }
    return result;
}

std::vector<Problem> problems() {
    const Factor fateman{
        {{1, {0, 0, 0, 0}}, {1, {1, 0, 0, 0}}, {1, {0, 1, 0, 0}}, {1, {0, 0, 1, 0}}, {1, {0, 0, 0, 1}}}, 20};
    Factor fateman_plus = fateman;
    fateman_plus.plus = 1;
    const Factor sparse_a{{{1, {0, 0, 0, 0, 0}},
                           {1, {1, 0, 0, 0, 0}},
                           {1, {0, 1, 0, 0, 0}},
                           {2, {0, 0, 2, 0, 0}},
                           {3, {0, 0, 0, 3, 0}},
                           {5, {0, 0, 0, 0, 5}}},
                          12};
    const Factor sparse_b{{{1, {0, 0, 0, 0, 0}},
                           {1, {0, 0, 0, 0, 1}},
                           {1, {0, 0, 0, 1, 0}},
                           {2, {0, 0, 2, 0, 0}},
                           {3, {0, 3, 0, 0, 0}},
                           {5, {5, 0, 0, 0, 0}}},
                          12};
    std::vector<Problem> list;
    const auto add = [&list](const std::string& name, std::size_t variables, Operation operation,
                             const Factor& a, const Factor& b) {
        for (const bool lex : {true, false}) {
            for (const bool modular : {false, true})
                list.push_back({name + (modular ? ".p" : ".zz") + (lex ? ".lex" : ".degrevlex"), variables,
                                lex, modular, operation, a, b});
        }
    };
    add("fateman.multiply", 4, Operation::multiply, fateman, fateman_plus);
    add("fateman.divide", 4, Operation::divide, fateman, fateman_plus);
    add("sparse12.multiply", 5, Operation::multiply, sparse_a, sparse_b);
    add("sparse12.divide", 5, Operation::divide, sparse_a, sparse_b);
    const Factor random_a{random_terms(6, 2000, 1000, 1000)};
    const Factor random_b{random_terms(6, 2001, 1000, 1000)};
    add("scattered.multiply", 6, Operation::multiply, random_a, random_b);
    add("scattered.divide", 6, Operation::divide, random_a, random_b);
    const Factor dense_a{random_terms(1, 30000, 10000, 1L << 30)};
    const Factor dense_b{random_terms(1, 30001, 10000, 1L << 30)};
    add("univariate.multiply", 1, Operation::multiply, dense_a, dense_b);
    add("univariate.divide", 1, Operation::divide, dense_a, dense_b);
    const Factor small_a{random_terms(3, 12, 4, 100)};
    const Factor small_b{random_terms(3, 13, 4, 100)};
    add("small.multiply", 3, Operation::multiply, small_a, small_b);
    add("small.divide", 3, Operation::divide, small_a, small_b);
    add("binomial.power", 1, Operation::power, {{{1, {0}}, {1, {1}}}}, {{}, 10000});
    add("fateman.power", 4, Operation::power, {fateman.base}, {{}, 20});
    add("sparse12.power", 5, Operation::power, {sparse_a.base}, {{}, 20});
    return list;
}

std::string json(const Measurement& m) {
    char text[160];
    std::snprintf(text, sizeof text, R"({"seconds":%.6g,"peak_mebibytes":%.1f,"terms":%zu})", m.seconds,
                  m.peak_mebibytes, m.terms);
    return text;
}

} // namespace

int main(int argc, char** argv) {
    int repeat = 5;
    std::vector<std::string_view> wanted;
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--repeat") == 0 && i + 1 < argc)
            repeat = std::max(1, std::atoi(argv[++i]));
        else
            wanted.emplace_back(argv[i]);
    }
    flint_set_num_threads(1);
    for (const Problem& problem : problems()) {
        const auto matches = [&](std::string_view part) {
            return problem.name.find(part) != std::string::npos;
        };
        if (!wanted.empty() && std::ranges::none_of(wanted, matches)) continue;
        const Measurement ours = in_child([&] { return run_eliminant(problem, repeat); });
        const Measurement peer = in_child([&] {
            return problem.modular ? run_peer<ResiduePeer>(problem, repeat)
                                   : run_peer<IntegerPeer>(problem, repeat);
        });
        char ratio[32] = "null"; // of memory, where there is enough to compare
        if (peer.peak_mebibytes > 1)
            std::snprintf(ratio, sizeof ratio, "%.3g", ours.peak_mebibytes / peer.peak_mebibytes);
        char ratios[96];
        std::snprintf(ratios, sizeof ratios, R"("time_ratio":%.3g,"memory_ratio":%s)",
                      ours.seconds / peer.seconds, ratio);
        std::cout << R"({"problem":")" << problem.name << R"(","eliminant":)" << json(ours) << R"(,"flint":)"
                  << json(peer) << "," << ratios << "}" << std::endl;
        if (ours.terms != peer.terms) {
            std::cerr << "the numbers of terms differ\n";
            return 1;
        }
    }
    return 0;
}
