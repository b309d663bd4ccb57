#include "groebner/fglm.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace eliminant::groebner {

using algebra::Monomial;
using algebra::PrimeField;
using algebra::Ring;

namespace {

using Vector = QuotientAlgebra::Vector;

/// Vectors in echelon form, each with the combination of the vectors added before that it is.
class Echelon {
  public:
    Echelon(const PrimeField& field, std::size_t size)
        : field_(field), kernels_(residue_kernels()), size_(size) {}

    /// Adds a vector that is independent of those added before; of one that depends on them, returns the
    /// coefficients of the combination that it is.
    std::optional<Vector> add(const Vector& vector, base::Run& run) {
        const std::uint64_t p = field_.characteristic();
        std::vector<std::uint64_t> rest(vector.begin(), vector.end());
        std::vector<std::uint64_t> combination(rows_.size(), 0);
        for (const Row& row : rows_) {
            const Residue factor = field_.reduce(rest[row.pivot]);
            if (factor == 0) continue;
            kernels_.subtract_multiple(rest.data(), row.vector.data(), size_, factor, p * p);
            kernels_.subtract_multiple(combination.data(), row.combination.data(), row.combination.size(),
                                       factor, p * p);
        }
        run.poll();
        Row row{reduced(rest), reduced(combination), 0};
        const auto pivot = std::ranges::find_if(row.vector, [](Residue c) { return c != 0; });
        if (pivot == row.vector.end()) {
            for (Residue& c : row.combination) c = field_.negate(c);
            return std::move(row.combination);
        }
        row.pivot = static_cast<std::size_t>(pivot - row.vector.begin());
        row.combination.push_back(1);
        const Residue inverse = field_.inverse(*pivot);
        for (Residue& c : row.vector) c = field_.multiply(c, inverse);
        for (Residue& c : row.combination) c = field_.multiply(c, inverse);
        rows_.push_back(std::move(row));
        return std::nullopt;
    }

  private:
    using Residue = PrimeField::Element;
    struct Row {
        Vector vector;      ///< 1 at the pivot, 0 at the pivots of the rows before
        Vector combination; ///< of the vectors added up to this one
        std::size_t pivot;
    };

    Vector reduced(const std::vector<std::uint64_t>& sums) const {
        Vector result(sums.size());
        std::ranges::transform(sums, result.begin(), [&](std::uint64_t s) { return field_.reduce(s); });
        return result;
    }

    const PrimeField& field_;
    const ResidueKernels& kernels_;
    std::size_t size_;
    std::vector<Row> rows_;
};

/// A monomial that is a product of standard monomials of the target by single variables.
struct Candidate {
    std::size_t divisors; ///< how many of its quotients by single variables are standard
    std::size_t from;     ///< one of them
    std::size_t variable; ///< and the variable
};

std::size_t support_size(const Monomial& m) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < m.ring().variable_count(); ++i) count += m.exponent(i) != 0 ? 1 : 0;
    return count;
}

} // namespace

ConvertedBasis fglm(QuotientAlgebra& algebra, const Ring& target, std::span<const std::size_t> variables,
                    base::Run& run) {
    ConvertedBasis result;
    const Monomial one(target);
    std::vector<Monomial> single;
    for (std::size_t i = 0; i < target.variable_count(); ++i) {
        std::vector<std::uint64_t> exponents(target.variable_count(), 0);
        exponents[i] = 1;
        single.emplace_back(target, exponents);
    }
    Echelon echelon(algebra.field(), algebra.size());
    std::vector<Vector> normal_forms; // of the standard monomials
    std::map<Monomial, Candidate> candidates = {{one, {0, 0, 0}}};
    while (!candidates.empty()) {
        const auto [m, candidate] = std::move(*candidates.begin());
        candidates.erase(candidates.begin());
        // All of its divisors came before it; one that is not standard is a multiple of a leading monomial.
        if (candidate.divisors != support_size(m)) continue;
        Vector vector = normal_forms.empty() ? algebra.unit(0) // of the standard monomials, 1 is the least
                                             : algebra.times_variable(variables[candidate.variable],
                                                                      normal_forms[candidate.from]);
        run.report([&] { return base::Progress{"change of order", result.standard.size(), algebra.size()}; });
        if (std::optional<Vector> combination = echelon.add(vector, run)) {
            result.leads.push_back(m);
            result.tails.push_back(std::move(*combination));
            continue;
        }
        for (std::size_t i = 0; i < single.size(); ++i) {
            Candidate& next =
                candidates.try_emplace(m * single[i], Candidate{0, normal_forms.size(), i}).first->second;
            ++next.divisors;
        }
        result.standard.push_back(m);
        normal_forms.push_back(std::move(vector));
    }
    for (Vector& tail : result.tails) tail.resize(result.standard.size(), 0);
    return result;
}

} // namespace eliminant::groebner
