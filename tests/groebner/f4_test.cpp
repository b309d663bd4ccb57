#include "eliminant/groebner/f4.hpp"

#include "eliminant/algebra/parse.hpp"
#include "groebner/classical_systems.hpp"
#include "groebner/macaulay_matrix.hpp"
#include "support/random_ideals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

using namespace eliminant;
using eliminant::testing::classical_system;

namespace {

using Dense = std::vector<std::vector<std::uint32_t>>;

/// Reduced row echelon form by the schoolbook method; zero rows are dropped.
Dense schoolbook_echelon(const algebra::PrimeField& field, Dense rows) {
    std::size_t rank = 0;
    const std::size_t columns = rows.empty() ? 0 : rows.front().size();
    for (std::size_t c = 0; c < columns && rank < rows.size(); ++c) {
        std::size_t pivot = rank;
        while (pivot < rows.size() && rows[pivot][c] == 0) ++pivot;
        if (pivot == rows.size()) continue;
        std::swap(rows[pivot], rows[rank]);
        const std::uint32_t inverse = field.inverse(rows[rank][c]);
        for (auto& x : rows[rank]) x = field.multiply(x, inverse);
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::uint32_t factor = rows[i][c];
            if (i == rank || factor == 0) continue;
            for (std::size_t k = 0; k < columns; ++k)
                rows[i][k] = field.subtract(rows[i][k], field.multiply(factor, rows[rank][k]));
        }
        ++rank;
    }
    rows.resize(rank);
    return rows;
}

/// Pivots, rows, and the matrix of both.
struct RandomMatrix {
    algebra::PrimeField field;
    std::size_t columns;
    std::vector<bool> is_pivot; ///< per column
    Dense pivots;
    Dense rows;
    std::vector<std::vector<std::uint32_t>> storage; ///< columns and coefficients of its rows
    groebner::MacaulayMatrix matrix;

    RandomMatrix(std::uint64_t p, std::size_t column_count, std::size_t pivot_count, std::size_t row_count,
                 std::size_t rank, std::uint64_t sparsity, eliminant::testing::Random& random)
        : field(p), columns(column_count), is_pivot(column_count, false), matrix(field, column_count) {
        std::vector<std::size_t> leads(columns);
        for (std::size_t c = 0; c < columns; ++c) leads[c] = c;
        std::ranges::shuffle(leads, random);
        storage.reserve(2 * (pivot_count + row_count));
        const auto random_row = [&](std::size_t lead) {
            std::vector<std::uint32_t> row(columns, 0);
            for (std::size_t c = lead; c < columns; ++c)
                row[c] = random() % sparsity == 0 ? static_cast<std::uint32_t>(random() % p) : 0;
            row[lead] = 1;
            return row;
        };
        for (std::size_t i = 0; i < pivot_count; ++i) {
            is_pivot[leads[i]] = true;
            pivots.push_back(random_row(leads[i]));
            add(pivots.back(), true);
        }
        for (std::size_t i = 0; i < row_count; ++i) {
            std::vector<std::uint32_t> row = random_row(random() % columns);
            if (i >= rank) { // the sum of two earlier rows
                const auto& a = rows[random() % i];
                const auto& b = rows[random() % i];
                for (std::size_t c = 0; c < columns; ++c) row[c] = field.add(a[c], b[c]);
                if (std::ranges::all_of(row, [](auto x) { return x == 0; })) row = a;
            }
            rows.push_back(std::move(row));
            add(rows.back(), false);
        }
    }
    RandomMatrix(const RandomMatrix&) = delete;
    RandomMatrix& operator=(const RandomMatrix&) = delete;

    void add(const std::vector<std::uint32_t>& row, bool pivot) {
        std::vector<std::uint32_t>& at = storage.emplace_back();
        std::vector<std::uint32_t>& coefficients = storage.emplace_back();
        for (std::uint32_t c = 0; c < columns; ++c) {
            if (row[c] == 0) continue;
            at.push_back(c);
            coefficients.push_back(row[c]);
        }
        const groebner::SparseRow<std::uint32_t> sparse{at.data(), coefficients.data(), at.size()};
        if (pivot)
            matrix.add_pivot(sparse);
        else
            matrix.add_row(sparse);
    }
};

/// The reduced echelon form is right: with the pivots, the rows found span what all rows span, they avoid
/// the pivot columns, and they are reduced by one another.
void check_echelon(const RandomMatrix& random_matrix, const groebner::MacaulayMatrix::Echelon& echelon) {
    Dense all = random_matrix.pivots;
    all.insert(all.end(), random_matrix.rows.begin(), random_matrix.rows.end());
    Dense reduced = random_matrix.pivots;
    Dense found;
    for (const auto& row : echelon.rows) {
        std::vector<std::uint32_t> dense(random_matrix.columns, 0);
        for (std::size_t i = 0; i < row.columns.size(); ++i) {
            dense[row.columns[i]] = row.coefficients[i];
            EXPECT_FALSE(random_matrix.is_pivot[row.columns[i]]);
        }
        reduced.push_back(dense);
        found.push_back(dense);
    }
    EXPECT_EQ(schoolbook_echelon(random_matrix.field, found), found);
    EXPECT_EQ(schoolbook_echelon(random_matrix.field, reduced), schoolbook_echelon(random_matrix.field, all));
    EXPECT_EQ(reduced.size(), schoolbook_echelon(random_matrix.field, all).size());
}

bool same_rows(const groebner::MacaulayMatrix::Echelon& a, const groebner::MacaulayMatrix::Echelon& b) {
    return std::ranges::equal(a.rows, b.rows, [](const auto& x, const auto& y) {
        return x.columns == y.columns && x.coefficients == y.coefficients;
    });
}

TEST(MacaulayMatrix, AgreesWithSchoolbookEliminationWithAllKernels) {
    constexpr int seed = 3;
    eliminant::testing::Random random(seed);
    base::Run run;
    for (const std::uint64_t p : {2U, 3U, 7U, 32003U, 65521U, 1073741827U, 2147483647U}) {
        for (int round = 0; round < 20; ++round) {
            SCOPED_TRACE("seed " + std::to_string(seed) + ", p = " + std::to_string(p) + ", round " +
                         std::to_string(round));
            const std::size_t columns = 1 + random() % 40;
            const std::size_t rows = random() % 30;
            const RandomMatrix matrix(p, columns, random() % (columns + 1), rows, rows, 1 + random() % 4,
                                      random);
            for (const base::VectorUnit unit : base::available_vector_units()) {
                SCOPED_TRACE(base::name(unit));
                groebner::MacaulayMatrix::EchelonOptions options;
                options.unit = unit;
                check_echelon(matrix, matrix.matrix.echelon(options, run));
            }
        }
    }
}

TEST(MacaulayMatrix, ThreadsAndRandomCombinationsGiveTheSame) {
    constexpr int seed = 4;
    eliminant::testing::Random random(seed);
    base::Run run;
    RunOptions three;
    three.threads = 3;
    base::Run three_threads(three);
    for (const std::uint64_t p : {65537U, 2147483647U}) {
        ASSERT_TRUE(groebner::MacaulayMatrix::can_combine(algebra::PrimeField(p)));
        // Many rows of low rank, and many of full rank.
        for (const std::size_t rank : {5U, 60U, 700U}) {
            SCOPED_TRACE("p = " + std::to_string(p) + ", rank " + std::to_string(rank));
            const RandomMatrix matrix(p, 90, 20, 700, rank, 8, random);
            const auto expected = matrix.matrix.echelon({}, run);
            check_echelon(matrix, expected);
            EXPECT_EQ(expected.failure_bound, 0);
            EXPECT_TRUE(same_rows(expected, matrix.matrix.echelon({}, three_threads)));
            groebner::MacaulayMatrix::EchelonOptions options;
            options.combine = true;
            for (options.seed = 0; options.seed < 3; ++options.seed) {
                for (base::Run* r : {&run, &three_threads}) {
                    const auto combined = matrix.matrix.echelon(options, *r);
                    EXPECT_TRUE(same_rows(expected, combined));
                    EXPECT_GT(combined.failure_bound, 0);
                    EXPECT_LT(combined.failure_bound, 1e-9);
                }
            }
            groebner::MacaulayMatrix::EchelonOptions known;
            known.rank = expected.rows.size();
            for (base::Run* r : {&run, &three_threads}) {
                const auto found = matrix.matrix.echelon(known, *r);
                EXPECT_TRUE(same_rows(expected, found));
                EXPECT_EQ(found.failure_bound, 0);
            }
        }
    }
    EXPECT_FALSE(groebner::MacaulayMatrix::can_combine(algebra::PrimeField(65521)));
}

TEST(MacaulayMatrix, TranscriptIsEnoughToFindTheSame) {
    constexpr int seed = 5;
    eliminant::testing::Random random(seed);
    base::Run run;
    for (int round = 0; round < 20; ++round) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", round " + std::to_string(round));
        RandomMatrix whole(2147483647, 60, 30, 40, 12, 5, random);
        groebner::MacaulayMatrix::Transcript transcript;
        groebner::MacaulayMatrix::EchelonOptions options;
        options.transcript = &transcript;
        const auto expected = whole.matrix.echelon(options, run);
        EXPECT_EQ(transcript.rows.size(), expected.rows.size());
        EXPECT_EQ(transcript.leads.size(), expected.rows.size());
        whole.matrix = groebner::MacaulayMatrix(whole.field, whole.columns);
        whole.storage.clear();
        for (const auto& pivot : whole.pivots) {
            const auto lead = std::ranges::find(pivot, 1U) - pivot.begin();
            if (transcript.pivots[static_cast<std::size_t>(lead)]) whole.add(pivot, true);
        }
        for (const std::size_t r : transcript.rows) whole.add(whole.rows[r], false);
        EXPECT_TRUE(same_rows(expected, whole.matrix.echelon({}, run)));
    }
}

TEST(MacaulayMatrix, EliminationCanBeStopped) {
    eliminant::testing::Random random(6);
    // Dense: its elimination takes far longer than the test does.
    const RandomMatrix matrix(2147483647, 4000, 2000, 1500, 1500, 2, random);
    for (const bool combine : {false, true}) {
        for (const unsigned threads : {1U, 2U}) {
            RunOptions run_options;
            run_options.threads = threads;
            base::Run run(run_options);
            std::thread stopper([&run] {
                std::this_thread::sleep_for(std::chrono::milliseconds(30));
                run.request_stop();
            });
            groebner::MacaulayMatrix::EchelonOptions options;
            options.combine = combine;
            EXPECT_THROW(static_cast<void>(matrix.matrix.echelon(options, run)), Stopped);
            stopper.join();
        }
    }
}

TEST(F4, AgreesWithBuchbergerOnRandomIdeals) {
    eliminant::testing::Random random(21);
    base::Run run;
    for (const Ring& ring : eliminant::testing::sample_rings()) {
        if (ring.field().is_rationals()) continue;
        for (int round = 0; round < 12; ++round) {
            std::vector<Polynomial> generators;
            for (std::uint64_t i = 0; i < 1 + random() % 4; ++i)
                generators.push_back(
                    eliminant::testing::random_small(ring, random, 1 + random() % 5, 1 + random() % 3));
            const auto expected = buchberger(ring, generators, {}, run).elements;
            for (const auto selection : {groebner::Selection::sugar, groebner::Selection::normal}) {
                BuchbergerOptions options;
                options.selection = selection;
                const GroebnerBasis basis = f4(ring, generators, options, run);
                EXPECT_TRUE(basis.complete);
                EXPECT_EQ(basis.elements, expected) << ring.to_string() << ", round " << round;
            }
        }
    }
}

/// Number of elements and largest degree of the reduced degrevlex basis, as all systems report them.
struct ClassicalSystem {
    std::string name;
    std::size_t elements;
    std::int64_t max_degree;
    bool quick_over_rationals;
};

const std::vector<ClassicalSystem> classical_systems = {
    {"katsura6", 41, 7, true}, {"katsura7", 74, 8, false}, {"katsura8", 143, 9, false},
    {"cyclic5", 20, 8, true},  {"cyclic6", 45, 9, true},   {"eco8", 59, 5, true},
    {"eco9", 106, 6, true},    {"noon5", 72, 9, true},     {"noon6", 187, 11, true},
    {"noon7", 495, 13, false}, {"chandra6", 32, 6, true},  {"chandra7", 64, 7, true},
    {"chandra8", 128, 8, true}};

TEST(F4, AgreesWithBuchbergerOnClassicalSystems) {
    base::Run run;
    for (const ClassicalSystem& known : classical_systems) {
        for (const std::uint64_t p : {32003U, 1073741827U}) {
            const System system = classical_system(known.name, CoefficientField::prime(p), run);
            BuchbergerOptions options;
            options.selection = groebner::Selection::normal;
            const GroebnerBasis basis = f4(system.ring, system.polynomials, options, run);
            EXPECT_EQ(basis.elements, buchberger(system.ring, system.polynomials, {}, run).elements)
                << known.name;
            EXPECT_EQ(basis.elements.size(), known.elements) << known.name;
            std::int64_t degree = 0;
            for (const Polynomial& f : basis.elements) degree = std::max(degree, f.total_degree());
            EXPECT_EQ(degree, known.max_degree) << known.name;
            ASSERT_NE(basis.statistics.largest_matrix(), nullptr);
            EXPECT_GT(basis.statistics.largest_matrix()->columns, 0U);
        }
    }
}

TEST(Buchberger, BasesOverTheRationalsHaveTheRightImages) {
    base::Run run;
    for (const ClassicalSystem& known : classical_systems) {
        if (!known.quick_over_rationals) continue;
        const System rational = classical_system(known.name, CoefficientField::rationals(), run);
        const System modular = classical_system(known.name, CoefficientField::prime(1073741827), run);
        const GroebnerBasis basis = buchberger(rational.ring, rational.polynomials, {}, run);
        EXPECT_EQ(basis.proof, groebner::Proof::full);
        std::vector<Polynomial> images;
        for (const Polynomial& f : basis.elements) images.push_back(f.in_ring(modular.ring).monic());
        EXPECT_EQ(images, f4(modular.ring, modular.polynomials, {}, run).elements) << known.name;
    }
}

TEST(F4, ThreadsAndProbabilisticLinearAlgebraGiveTheSame) {
    base::Run run;
    RunOptions two;
    two.threads = 2;
    base::Run two_threads(two);
    BuchbergerOptions exact;
    exact.selection = groebner::Selection::normal;
    BuchbergerOptions probabilistic = exact;
    probabilistic.linear_algebra = groebner::LinearAlgebra::probabilistic;
    for (const char* name : {"katsura7", "eco9", "cyclic6", "chandra8"}) {
        const System system = classical_system(name, CoefficientField::prime(1073741827), run);
        const GroebnerBasis expected = f4(system.ring, system.polynomials, exact, run);
        EXPECT_EQ(expected.proof, groebner::Proof::full);
        EXPECT_EQ(expected.failure_bound, 0);
        EXPECT_EQ(f4(system.ring, system.polynomials, exact, two_threads).elements, expected.elements);
        for (base::Run* r : {&run, &two_threads}) {
            const GroebnerBasis found = f4(system.ring, system.polynomials, probabilistic, *r);
            EXPECT_EQ(found.elements, expected.elements) << name;
            EXPECT_EQ(found.proof, groebner::Proof::bounded) << name;
            EXPECT_GT(found.failure_bound, 0);
            EXPECT_LT(found.failure_bound, 1e-10);
        }
    }
    // Small fields are done exactly, and say so.
    const System small = classical_system("eco9", CoefficientField::prime(101), run);
    EXPECT_EQ(f4(small.ring, small.polynomials, probabilistic, run).proof, groebner::Proof::full);
}

TEST(F4, KeepsDegreesSmallInOrdersThatAreNotGraded) {
    base::Run run;
    struct Case {
        const char* name;
        MonomialOrder order;
        std::size_t elements;
    };
    const std::vector<Case> cases = {{"cyclic5", MonomialOrder::lex(), 11},
                                     {"cyclic5", MonomialOrder::elimination({0, 1}), 20},
                                     {"katsura6", MonomialOrder::elimination({0, 1, 2, 3, 4, 5}), 7}};
    for (const Case& c : cases) {
        const System system = classical_system(c.name, CoefficientField::prime(1073741827), run);
        const Ring ring = system.ring.with_order(c.order);
        std::vector<Polynomial> generators;
        for (const Polynomial& f : system.polynomials) generators.push_back(f.in_ring(ring));
        const std::vector<Polynomial> basis = f4(ring, generators, {}, run).elements;
        EXPECT_EQ(basis.size(), c.elements) << ring.to_string();
        EXPECT_TRUE(is_reduced_groebner(basis, run)) << ring.to_string();
        for (const Polynomial& f : generators)
            EXPECT_TRUE(normal_form(f, basis, run).is_zero()) << ring.to_string();
        // And not too large: modulo the degrevlex basis all of it vanishes.
        const std::vector<Polynomial> graded = f4(system.ring, system.polynomials, {}, run).elements;
        for (const Polynomial& f : basis)
            EXPECT_TRUE(normal_form(f.in_ring(system.ring), graded, run).is_zero()) << ring.to_string();
    }
}

TEST(F4, WidensItsMonomialsWhenTheyOutgrowThem) {
    base::Run run;
    const Ring ring(CoefficientField::prime(32003), {"x", "y"}, MonomialOrder::lex());
    const std::vector<Polynomial> generators = {algebra::parse_polynomial(ring, "x^100-y^101"),
                                                algebra::parse_polynomial(ring, "x^60*y-1")};
    EXPECT_EQ(f4(ring, generators, {}, run).elements, buchberger(ring, generators, {}, run).elements);
}

TEST(F4, StopsAndBoundsLikeBuchberger) {
    base::Run run;
    const Ring ring(CoefficientField::prime(32003), {"s", "t", "x", "y", "z", "w"},
                    MonomialOrder::elimination({0, 1}));
    std::vector<Polynomial> generators;
    for (const char* text : {"x-s^3", "y-s^2*t", "z-s*t^2", "w-t^3"})
        generators.push_back(algebra::parse_polynomial(ring, text));
    BuchbergerOptions options;
    options.grading = {1, 1, 3, 3, 3, 3};
    options.selection = groebner::Selection::normal;
    options.stop_at = [](const Polynomial& f) { return f.degree(0) <= 0 && f.degree(1) <= 0; };
    const GroebnerBasis stopped = f4(ring, generators, options, run);
    EXPECT_FALSE(stopped.complete);
    EXPECT_EQ(stopped.elements.back().total_degree(), 2);
    options.stop_at = {};
    options.degree_bound = 5;
    EXPECT_FALSE(f4(ring, generators, options, run).complete);
}

TEST(F4, CanBeStoppedFromAnotherThread) {
    base::Run run;
    const Ring ring(CoefficientField::prime(2147483647), {"a", "b", "c", "d", "e", "f", "g", "h"});
    std::vector<Polynomial> generators;
    eliminant::testing::Random random(5);
    for (int i = 0; i < 9; ++i) generators.push_back(eliminant::testing::random_small(ring, random, 60, 4));
    std::thread stopper([&run] {
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
        run.request_stop();
    });
    EXPECT_THROW(f4(ring, generators, {}, run), Stopped);
    stopper.join();
}

TEST(F4, CannotBeStoppedEarlyOverTheRationals) {
    base::Run run;
    BuchbergerOptions options;
    options.degree_bound = 3;
    EXPECT_THROW(f4(Ring(CoefficientField::rationals(), {"x"}), {}, options, run), DomainError);
}

} // namespace
