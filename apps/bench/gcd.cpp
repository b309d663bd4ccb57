// Greatest common divisors against FLINT, one thread, one JSON object a line:
//
//     bench_gcd [--repeat N] [NAME …]        all problems whose name contains one of the NAMEs
//
// Times are medians over the repetitions. Every answer is compared with FLINT's, term by term.
#include "eliminant/algebra/gcd.hpp"
#include "eliminant/algebra/arithmetic.hpp"

#include <flint/fmpz_mpoly.h>
#include <flint/nmod_mpoly.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <iostream>
#include <random>
#include <string>
#include <string_view>
#include <vector>

namespace {

using eliminant::CoefficientField;
using eliminant::Integer;
using eliminant::MonomialOrder;
using eliminant::Polynomial;
using eliminant::PolynomialBuilder;
using eliminant::Ring;

struct Problem {
    std::string name;
    Polynomial f;
    Polynomial g;
};

double median_seconds(int repeat, const std::function<void()>& work) {
    using Clock = std::chrono::steady_clock;
    std::vector<double> times;
    for (int i = 0; i < repeat; ++i) {
        const auto start = Clock::now();
        work();
        times.push_back(std::chrono::duration<double>(Clock::now() - start).count());
    }
    std::ranges::sort(times);
    return times[times.size() / 2];
}

/// FLINT's two multivariate types behind one face; both sort by the ring's order, which is lex here.
struct IntegerPeer {
    fmpz_mpoly_ctx_t context;
    using Value = fmpz_mpoly_struct;
    explicit IntegerPeer(const Ring& ring) {
        fmpz_mpoly_ctx_init(context, static_cast<slong>(ring.variable_count()), ORD_LEX);
    }
    ~IntegerPeer() { fmpz_mpoly_ctx_clear(context); }
    IntegerPeer(const IntegerPeer&) = delete;
    IntegerPeer& operator=(const IntegerPeer&) = delete;
    void init(Value* f) { fmpz_mpoly_init(f, context); }
    void clear(Value* f) { fmpz_mpoly_clear(f, context); }
    void push(Value* f, const mpz_class& c, const ulong* e) {
        fmpz_t value;
        fmpz_init(value);
        fmpz_set_mpz(value, c.get_mpz_t());
        fmpz_mpoly_push_term_fmpz_ui(f, value, e, context);
        fmpz_clear(value);
    }
    bool gcd(Value* h, const Value* f, const Value* g) { return fmpz_mpoly_gcd(h, f, g, context) != 0; }
    bool equal(const Value* f, const Value* g) { return fmpz_mpoly_equal(f, g, context) != 0; }
};

struct ResiduePeer {
    nmod_mpoly_ctx_t context;
    using Value = nmod_mpoly_struct;
    explicit ResiduePeer(const Ring& ring) {
        nmod_mpoly_ctx_init(context, static_cast<slong>(ring.variable_count()), ORD_LEX,
                            ring.field().characteristic());
    }
    ~ResiduePeer() { nmod_mpoly_ctx_clear(context); }
    ResiduePeer(const ResiduePeer&) = delete;
    ResiduePeer& operator=(const ResiduePeer&) = delete;
    void init(Value* f) { nmod_mpoly_init(f, context); }
    void clear(Value* f) { nmod_mpoly_clear(f, context); }
    void push(Value* f, const mpz_class& c, const ulong* e) {
        nmod_mpoly_push_term_ui_ui(f, c.get_ui(), e, context);
    }
    bool gcd(Value* h, const Value* f, const Value* g) { return nmod_mpoly_gcd(h, f, g, context) != 0; }
    bool equal(const Value* f, const Value* g) { return nmod_mpoly_equal(f, g, context) != 0; }
};

struct Comparison {
    double peer_seconds;
    bool equal;
};

template <class Peer>
Comparison compare_with_peer(const Problem& problem, const Polynomial& answer, int repeat) {
    Peer peer(problem.f.ring());
    typename Peer::Value f;
    typename Peer::Value g;
    typename Peer::Value expected;
    typename Peer::Value h;
    const auto load = [&peer](typename Peer::Value* target, const Polynomial& source) {
        peer.init(target);
        for (std::size_t i = 0; i < source.size(); ++i) {
            const auto exponents = source.monomial(i).exponents();
            peer.push(target, source.coefficient(i).get_num(), exponents.data());
        }
    };
    load(&f, problem.f);
    load(&g, problem.g);
    load(&expected, answer);
    peer.init(&h);
    const double seconds = median_seconds(repeat, [&] {
        if (!peer.gcd(&h, &f, &g)) std::abort();
    });
    const Comparison result{seconds, peer.equal(&h, &expected)};
    for (auto* value : {&f, &g, &expected, &h}) peer.clear(value);
    return result;
}

class Generator {
  public:
    Generator(CoefficientField field, std::size_t variables) : ring_(ring(std::move(field), variables)) {}

    /// Every monomial up to a total degree.
    Polynomial dense(std::uint64_t degree, unsigned bits) {
        PolynomialBuilder builder(ring_);
        std::vector<std::uint64_t> exponents(ring_.variable_count(), 0);
        add_all(builder, exponents, 0, degree, bits);
        return builder.build().primitive_part();
    }
    Polynomial sparse(std::size_t terms, std::uint64_t degree, unsigned bits) {
        PolynomialBuilder builder(ring_);
        std::vector<std::uint64_t> exponents(ring_.variable_count(), 0);
        for (std::size_t i = 0; i < terms; ++i) {
            builder.add(coefficient(bits), exponents); // the first term is constant
            for (auto& e : exponents) e = random_() % (degree + 1);
        }
        return builder.build().primitive_part();
    }

  private:
    static Ring ring(CoefficientField field, std::size_t variables) {
        std::vector<std::string> names;
        for (std::size_t i = 0; i < variables; ++i)
            names.push_back(std::string("x").append(std::to_string(i)));
        return {std::move(field), std::move(names), MonomialOrder::lex()};
    }
    Integer coefficient(unsigned bits) {
        Integer value(1);
        for (unsigned i = 0; i < bits; i += 16) value = value * Integer(65536) + Integer(random_() % 65536);
        while (value.bit_length() > bits) value = Integer::floor_divide(value, Integer(2));
        return random_() % 2 == 0 ? value : -value;
    }
    void add_all(PolynomialBuilder& builder, std::vector<std::uint64_t>& exponents, std::size_t variable,
                 std::uint64_t degree, unsigned bits) {
        if (variable == exponents.size()) return builder.add(coefficient(bits), exponents);
        for (std::uint64_t e = 0; e <= degree; ++e) {
            exponents[variable] = e;
            add_all(builder, exponents, variable + 1, degree - e, bits);
        }
        exponents[variable] = 0;
    }

    Ring ring_;
    std::mt19937_64 random_{1};
};

std::vector<Problem> problems() {
    std::vector<Problem> list;
    for (const bool modular : {false, true}) {
        const auto field = modular ? CoefficientField::prime(2147483647) : CoefficientField::rationals();
        const std::string suffix = modular ? ".p" : ".zz";
        const auto add = [&](const std::string& name, const Polynomial& h, const Polynomial& a,
                             const Polynomial& b) {
            list.push_back({name + suffix, h * a, h * b});
        };
        const auto dense = [&](const std::string& name, std::size_t n, std::uint64_t degree_h,
                               std::uint64_t degree, unsigned bits) {
            Generator random(field, n);
            add(name, random.dense(degree_h, bits), random.dense(degree, bits), random.dense(degree, bits));
        };
        const auto sparse = [&](const std::string& name, std::size_t n, std::size_t terms_h,
                                std::size_t terms, std::uint64_t degree, unsigned bits) {
            Generator random(field, n);
            add(name, random.sparse(terms_h, degree, bits), random.sparse(terms, degree, bits),
                random.sparse(terms, degree, bits));
        };
        dense("univariate.dense", 1, 200, 200, 20);
        dense("univariate.high-degree", 1, 3000, 3000, 20);
        dense("bivariate.dense", 2, 20, 20, 20);
        dense("bivariate.high-degree", 2, 60, 60, 20);
        dense("dense3", 3, 8, 8, 10);
        dense("dense4", 4, 6, 6, 10);
        dense("dense4.small-gcd", 4, 2, 8, 10);
        dense("dense4.large-gcd", 4, 8, 2, 10);
        dense("dense3.coprime", 3, 0, 12, 10);
        dense("dense3.big-coefficients", 3, 5, 5, 1000);
        sparse("sparse8", 8, 30, 30, 10, 10);
        sparse("sparse8.more-terms", 8, 100, 60, 6, 10);
        sparse("sparse5.high-degree", 5, 40, 40, 100, 10);
        sparse("sparse8.coprime", 8, 1, 900, 10, 10);
        sparse("sparse8.big-coefficients", 8, 20, 20, 10, 500);
        sparse("small", 3, 3, 3, 3, 5);
        sparse("small.coprime", 3, 1, 8, 3, 5);
    }
    return list;
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
    bool all_equal = true;
    for (const Problem& problem : problems()) {
        const auto matches = [&](std::string_view part) {
            return problem.name.find(part) != std::string::npos;
        };
        if (!wanted.empty() && std::ranges::none_of(wanted, matches)) continue;
        eliminant::Run run;
        Polynomial answer(problem.f.ring());
        const double seconds = median_seconds(repeat, [&] { answer = gcd(problem.f, problem.g, run); });
        const Comparison peer = problem.f.ring().field().is_rationals()
                                    ? compare_with_peer<IntegerPeer>(problem, answer, repeat)
                                    : compare_with_peer<ResiduePeer>(problem, answer, repeat);
        char line[256];
        std::snprintf(
            line, sizeof line,
            R"({"problem":"%s","terms":[%zu,%zu,%zu],"seconds":%.4g,"flint_seconds":%.4g,"ratio":%.3g})",
            problem.name.c_str(), problem.f.size(), problem.g.size(), answer.size(), seconds,
            peer.peer_seconds, seconds / peer.peer_seconds);
        std::cout << line << std::endl;
        if (!peer.equal) std::cerr << problem.name << ": the answers differ\n";
        all_equal = all_equal && peer.equal;
    }
    return all_equal ? 0 : 1;
}
