#include "algebra/rational_lifting.hpp"
#include "algebra/rational_reconstruction.hpp"
#include "algebra/remainder_table.hpp"

#include "eliminant/algebra/prime_field.hpp"

#include <gtest/gtest.h>

#include <random>

namespace eliminant::algebra {
namespace {

std::vector<std::uint32_t> primes_below(std::uint64_t bound, std::size_t count) {
    std::vector<std::uint32_t> primes;
    while (primes.size() < count) {
        bound = previous_prime(bound);
        primes.push_back(static_cast<std::uint32_t>(bound));
    }
    return primes;
}

mpz_class product(const std::vector<std::uint32_t>& primes) {
    mpz_class result = 1;
    for (const std::uint32_t p : primes) result *= p;
    return result;
}

class Numbers {
  public:
    explicit Numbers(unsigned long seed) {
        gmp_randinit_default(state_);
        gmp_randseed_ui(state_, seed);
    }
    ~Numbers() { gmp_randclear(state_); }
    Numbers(const Numbers&) = delete;
    Numbers& operator=(const Numbers&) = delete;

    /// Of at most `bits` bits, often with long runs of equal ones, either sign.
    mpz_class integer(unsigned bits) {
        mpz_class x;
        if (bits == 0) return x;
        if (coin())
            mpz_rrandomb(x.get_mpz_t(), state_, bits);
        else
            mpz_urandomb(x.get_mpz_t(), state_, bits);
        return coin() ? mpz_class(-x) : x;
    }
    bool coin() { return gmp_urandomb_ui(state_, 1) == 1; }

  private:
    gmp_randstate_t state_;
};

std::uint32_t residue(const mpz_class& n, const mpz_class& d, std::uint32_t p) {
    const PrimeField field(p);
    return field.from_fraction(Integer(n), Integer(d));
}

/// What reconstruct_fraction() says, by the definition: every convergent.
std::optional<Fraction> slow_fraction(const mpz_class& a, const mpz_class& M, unsigned margin) {
    mpz_class r0 = M;
    mpz_class r1 = a;
    mpz_class t0 = 0;
    mpz_class t1 = 1;
    while (r1 != 0) {
        const mpz_class q = r0 / r1;
        if (mpz_sizeinbase(q.get_mpz_t(), 2) > margin) {
            if (gcd(r1, t1) != 1) return std::nullopt;
            return Fraction{t1 < 0 ? mpz_class(-r1) : r1, abs(t1)};
        }
        r0 -= q * r1;
        std::swap(r0, r1);
        t0 -= q * t1;
        std::swap(t0, t1);
    }
    if (a == 0) return Fraction{0, 1};
    return std::nullopt;
}

TEST(RationalReconstruction, FindsFractionsOfEveryShape) {
    Numbers numbers(7);
    base::Run run;
    const auto primes = primes_below(1U << 31, 40);
    for (unsigned count = 2; count <= 40; count += 2) {
        const mpz_class M = product({primes.begin(), primes.begin() + count});
        const unsigned bits = static_cast<unsigned>(mpz_sizeinbase(M.get_mpz_t(), 2)) - 25;
        for (unsigned part = 0; part <= 10; ++part) {
            mpz_class n = numbers.integer(bits * part / 10);
            mpz_class d = abs(numbers.integer(bits - bits * part / 10)) + 1;
            const mpz_class common = gcd(n, d);
            n /= common;
            d /= common;
            mpz_class a;
            if (mpz_invert(a.get_mpz_t(), d.get_mpz_t(), M.get_mpz_t()) == 0) continue;
            a *= n;
            mpz_fdiv_r(a.get_mpz_t(), a.get_mpz_t(), M.get_mpz_t());
            const auto found = reconstruct_fraction(a, M, 21, run);
            ASSERT_TRUE(found) << n << "/" << d << " mod " << M;
            EXPECT_EQ(found->numerator, n);
            EXPECT_EQ(found->denominator, d);
        }
    }
}

TEST(RationalReconstruction, AgreesWithPlainEuclidOnArbitraryResidues) {
    Numbers numbers(8);
    base::Run run;
    const auto primes = primes_below(1U << 31, 30);
    for (int trial = 0; trial < 2000; ++trial) {
        const std::size_t count = 1 + static_cast<std::size_t>(trial) % 30;
        const mpz_class M = product({primes.begin(), primes.begin() + static_cast<std::ptrdiff_t>(count)});
        mpz_class a = numbers.integer(static_cast<unsigned>(31 * count));
        mpz_fdiv_r(a.get_mpz_t(), a.get_mpz_t(), M.get_mpz_t());
        const auto slow = slow_fraction(a, M, 20);
        const auto fast = reconstruct_fraction(a, M, 20, run);
        ASSERT_EQ(fast.has_value(), slow.has_value()) << a << " mod " << M;
        if (!fast) continue;
        EXPECT_EQ(fast->numerator, slow->numerator) << a << " mod " << M;
        EXPECT_EQ(fast->denominator, slow->denominator) << a << " mod " << M;
    }
}

TEST(RemainderTable, CombinesResiduesTimesAFactor) {
    Numbers numbers(9);
    for (const std::uint64_t bound : {std::uint64_t{1} << 31, std::uint64_t{1000}}) {
        for (std::size_t count = 1; count <= 25; ++count) {
            const auto primes = primes_below(bound, count);
            const RemainderTable table(primes);
            ASSERT_EQ(table.modulus(), product(primes));
            const unsigned bits = static_cast<unsigned>(table.modulus_bits());
            for (int trial = 0; trial < 20; ++trial) {
                const mpz_class x = numbers.integer(static_cast<unsigned>(31 * count));
                const mpz_class factor = numbers.integer(bits / 2);
                std::vector<std::uint32_t> residues;
                for (const std::uint32_t p : primes) residues.push_back(residue(x, 1, p));
                std::vector<mp_limb_t> scratch;
                mpz_class result;
                table.combine(residues, table.prepare(Integer(factor)), scratch, result);
                EXPECT_EQ((result - x * factor) % table.modulus(), 0) << x << " times " << factor;
                EXPECT_LE(abs(result) * 2, table.modulus() + table.modulus() / 1000000000);
            }
        }
    }
}

struct Case {
    std::vector<mpz_class> denominators;
    std::vector<std::vector<mpz_class>> numerators;

    std::vector<std::size_t> sizes() const {
        std::vector<std::size_t> result;
        for (const auto& vector : numerators) result.push_back(vector.size());
        return result;
    }
    std::vector<std::uint32_t> residues(std::uint32_t p) const {
        std::vector<std::uint32_t> result;
        for (std::size_t g = 0; g < numerators.size(); ++g) {
            for (const mpz_class& n : numerators[g]) result.push_back(residue(n, denominators[g], p));
        }
        return result;
    }
    void expect_found(const RationalLifting& lifting) const {
        ASSERT_EQ(lifting.vectors().size(), numerators.size());
        for (std::size_t g = 0; g < numerators.size(); ++g) {
            const auto& found = lifting.vectors()[g];
            EXPECT_EQ(found.denominator.to_mpz(), denominators[g]);
            ASSERT_EQ(found.numerators.size(), numerators[g].size());
            for (std::size_t i = 0; i < numerators[g].size(); ++i)
                EXPECT_EQ(found.numerators[i].to_mpz(), numerators[g][i]);
        }
    }
    /// Primes p with p | denominator have no residues.
    bool is_defined(std::uint32_t p) const {
        return std::ranges::none_of(denominators, [&](const mpz_class& d) { return d % p == 0; });
    }

  private:
    static std::uint32_t residue(const mpz_class& n, const mpz_class& d, std::uint32_t p) {
        return algebra::residue(n, d, p);
    }
};

/// Vectors of different lengths; some denominators occur only in late entries.
Case random_case(unsigned long seed) {
    Numbers numbers(seed);
    Case result;
    for (std::size_t g = 0; g < 12; ++g) {
        const auto bits = static_cast<unsigned>(40 * (seed % 7) * (g % 4) + 5);
        mpz_class denominator = 1;
        std::vector<mpq_class> entries;
        for (std::size_t i = 0; i < g * g; ++i) {
            const mpz_class own = i % 17 == 3 ? mpz_class(abs(numbers.integer(30)) + 1) : mpz_class(1);
            mpq_class entry(numbers.integer(bits), (abs(numbers.integer(bits / 3)) + 1) * own);
            if (i % 5 != 0) entry = mpq_class(entry.get_num(), denominator);
            entry.canonicalize();
            denominator = lcm(denominator, entry.get_den());
            entries.push_back(entry);
        }
        result.denominators.push_back(denominator);
        std::vector<mpz_class> numerators;
        for (const mpq_class& entry : entries)
            numerators.emplace_back(entry.get_num() * (denominator / entry.get_den()));
        result.numerators.push_back(std::move(numerators));
    }
    return result;
}

TEST(RationalLifting, FindsRandomVectorsOnAnyNumberOfThreads) {
    for (unsigned long seed = 1; seed <= 7; ++seed) {
        SCOPED_TRACE(seed);
        const Case vectors = random_case(seed);
        std::vector<std::size_t> needed;
        for (const unsigned threads : {1U, 3U}) {
            base::Run run(base::RunOptions{.threads = threads});
            RationalLifting lifting(vectors.sizes());
            std::uint64_t p = std::uint64_t{1} << 31;
            do {
                do p = previous_prime(p);
                while (!vectors.is_defined(static_cast<std::uint32_t>(p)));
                const auto prime = static_cast<std::uint32_t>(p);
                lifting.add(prime, vectors.residues(prime));
                ASSERT_LT(lifting.prime_count(), 5000U);
            } while (!lifting.lift(run));
            needed.push_back(lifting.prime_count());
            vectors.expect_found(lifting);
            for (std::size_t i = 0; i < lifting.prime_count(); ++i)
                EXPECT_TRUE(lifting.agrees_with_added(i, run));
        }
        EXPECT_EQ(needed[0], needed[1]);
    }
}

TEST(RationalLifting, NeedsNoMorePrimesThanTheLongestFraction) {
    // 1/d with d of 310 bits: Wang's bound would ask for 620 bits of modulus.
    Case vectors{{mpz_class("1" + std::string(310, '0'), 2) + 1}, {{1}}};
    base::Run run;
    RationalLifting lifting(vectors.sizes());
    for (const std::uint32_t p : primes_below(1U << 31, 12)) lifting.add(p, vectors.residues(p));
    EXPECT_TRUE(lifting.lift(run));
    vectors.expect_found(lifting);
}

TEST(RationalLifting, DropsVectorsThatAnotherPrimeContradicts) {
    Case vectors{{3, 7}, {{3, 5, -1}, {7, 22, 1}}};
    Case others{{3, 7}, {{3, 5, -1}, {7, 23, 1}}};
    base::Run run;
    RationalLifting lifting(vectors.sizes());
    const auto primes = primes_below(1U << 31, 20);
    for (std::size_t i = 0; i < 4; ++i) lifting.add(primes[i], vectors.residues(primes[i]));
    ASSERT_TRUE(lifting.lift(run));
    vectors.expect_found(lifting);
    EXPECT_TRUE(lifting.agrees(primes[4], vectors.residues(primes[4]), run));
    EXPECT_FALSE(lifting.agrees(primes[5], others.residues(primes[5]), run));
    EXPECT_TRUE(lifting.lift(run)); // the primes that were added say the same as before
    vectors.expect_found(lifting);
}

TEST(RationalLifting, IsNotMisledForLongByAProductOfItsPrimes) {
    const auto primes = primes_below(1U << 31, 30);
    // 1 modulo each of the first 20 primes.
    Case vectors{{1}, {{product({primes.begin(), primes.begin() + 20}) + 1}}};
    base::Run run;
    RationalLifting lifting(vectors.sizes());
    for (std::size_t i = 0; i < 29; ++i) lifting.add(primes[i], vectors.residues(primes[i]));
    if (lifting.lift(run) && lifting.agrees(primes[29], vectors.residues(primes[29]), run)) return;
    ASSERT_TRUE(lifting.lift(run));
    vectors.expect_found(lifting);
}

TEST(RationalLifting, StopsWhenAskedTo) {
    const Case vectors = random_case(3);
    base::Run run;
    RationalLifting lifting(vectors.sizes());
    for (const std::uint32_t p : primes_below(1U << 31, 400)) lifting.add(p, vectors.residues(p));
    run.request_stop();
    EXPECT_THROW(lifting.lift(run), Stopped);
    base::Run other;
    EXPECT_TRUE(lifting.lift(other));
    EXPECT_THROW(lifting.agrees_with_added(0, run), Stopped);
}

TEST(RationalLifting, NothingToFindIsFound) {
    base::Run run;
    RationalLifting nothing(std::vector<std::size_t>{});
    EXPECT_TRUE(nothing.lift(run));
    RationalLifting empty({0, 0});
    EXPECT_TRUE(empty.lift(run));
    EXPECT_EQ(empty.vectors().size(), 2U);
}

} // namespace
} // namespace eliminant::algebra
