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

TEST(MacaulayMatrix, AgreesWithSchoolbookElimination) {
    eliminant::testing::Random random(3);
    base::Run run;
    for (const std::uint64_t p : {2U, 3U, 32003U, 2147483647U}) {
        const algebra::PrimeField field(p);
        for (int round = 0; round < 30; ++round) {
            const std::size_t columns = 1 + random() % 20;
            const std::size_t pivots = random() % (columns + 1);
            const std::size_t rows = random() % 12;
            const auto random_row = [&](std::size_t lead, bool monic) {
                std::vector<std::uint32_t> row(columns, 0);
                for (std::size_t c = lead; c < columns; ++c)
                    row[c] = random() % 3 == 0 ? static_cast<std::uint32_t>(random() % p) : 0;
                if (monic) row[lead] = 1;
                return row;
            };
            Dense dense_pivots;
            Dense dense_rows;
            std::vector<std::size_t> leads(columns);
            for (std::size_t c = 0; c < columns; ++c) leads[c] = c;
            std::ranges::shuffle(leads, random);
            for (std::size_t i = 0; i < pivots; ++i) dense_pivots.push_back(random_row(leads[i], true));
            for (std::size_t i = 0; i < rows; ++i) dense_rows.push_back(random_row(random() % columns, true));

            groebner::MacaulayMatrix matrix(field, columns);
            std::vector<std::vector<std::uint32_t>> storage;
            storage.reserve(pivots + rows);
            const auto add = [&](const std::vector<std::uint32_t>& row, bool pivot) {
                std::vector<std::uint32_t> at;
                auto& coefficients = storage.emplace_back();
                for (std::uint32_t c = 0; c < columns; ++c) {
                    if (row[c] == 0) continue;
                    at.push_back(c);
                    coefficients.push_back(row[c]);
                }
                std::ranges::copy(
                    at, (pivot ? matrix.add_pivot(coefficients) : matrix.add_row(coefficients)).begin());
            };
            for (const auto& row : dense_pivots) add(row, true);
            for (const auto& row : dense_rows) add(row, false);
            const auto found = matrix.echelon({}, run).rows;

            // Together with the pivots, the rows found span what all rows span, and they avoid the pivot
            // columns.
            Dense all = dense_pivots;
            all.insert(all.end(), dense_rows.begin(), dense_rows.end());
            Dense reduced = dense_pivots;
            for (const auto& row : found) {
                std::vector<std::uint32_t> dense(columns, 0);
                for (std::size_t i = 0; i < row.columns.size(); ++i) {
                    dense[row.columns[i]] = row.coefficients[i];
                    EXPECT_FALSE(std::find(leads.begin(), leads.begin() + static_cast<std::ptrdiff_t>(pivots),
                                           row.columns[i]) !=
                                 leads.begin() + static_cast<std::ptrdiff_t>(pivots));
                }
                EXPECT_EQ(row.coefficients.front(), 1U);
                reduced.push_back(dense);
            }
            EXPECT_EQ(schoolbook_echelon(field, reduced), schoolbook_echelon(field, all)) << "p = " << p;
            EXPECT_EQ(schoolbook_echelon(field, all).size(), pivots + found.size())
                << "rows found are independent";
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
            EXPECT_GT(basis.statistics.matrices, 0U);
            EXPECT_GT(basis.statistics.largest_matrix_columns, 0U);
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

TEST(F4, IsForPrimeFields) {
    base::Run run;
    EXPECT_THROW(f4(Ring(CoefficientField::rationals(), {"x"}), {}, {}, run), DomainError);
}

} // namespace
