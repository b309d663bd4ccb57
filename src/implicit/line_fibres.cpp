#include "implicit/line_fibres.hpp"

#include "algebra/random.hpp"
#include "algebra/univariate_mod_p.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace eliminant::implicit {

namespace dense = algebra::dense;
using algebra::PrimeField;

namespace {

/// f − factor·g, of any lengths.
Residues minus_multiple(const PrimeField& field, const Residues& f, Residue factor, const Residues& g) {
    Residues result = f;
    result.resize(std::max(f.size(), g.size()), 0);
    dense::add_multiple<PrimeField>(field, result, g, field.negate(factor));
    return result;
}

/// The fibre with these roots, and the height numerator/denominator.
std::optional<LineFibre> fibre(QuotientAlgebra algebra, const Residues& numerator,
                               const Residues& denominator) {
    const auto inverse = algebra.inverse(denominator);
    if (!inverse) return std::nullopt;
    Residues height = algebra.multiply(numerator, *inverse);
    return LineFibre{std::move(algebra), std::move(height)};
}

class CurveFibres : public LineFibres {
  public:
    CurveFibres(const PrimeField& field, std::span<const FormRows> forms, Residue slope, const base::Run& run)
        : field_(field), run_(run), denominator_(forms[0][0]), height_(forms[2][0]),
          sheared_(minus_multiple(field, forms[1][0], slope, forms[2][0])) {}

    std::optional<LineFibre> over(std::span<const Residue> base) const override {
        Residues equation = minus_multiple(field_, sheared_, base[0], denominator_);
        dense::trim(equation);
        if (equation.size() < 2) return std::nullopt;
        dense::make_monic(field_, equation);
        QuotientAlgebra algebra(field_, std::move(equation), run_);
        const Residues numerator = algebra.element(height_);
        const Residues denominator = algebra.element(denominator_);
        return fibre(std::move(algebra), numerator, denominator);
    }

  private:
    const PrimeField& field_;
    const base::Run& run_;
    Residues denominator_;
    Residues height_;
    Residues sheared_;
};

/// Polynomials in t by their values at a set of nodes.
class Nodes {
  public:
    Nodes(const PrimeField& field, Residue first, std::size_t count, const base::Run& run)
        : field_(field), inverse_(count) {
        for (std::size_t i = 0; i < count; ++i) nodes_.push_back(field.add(first, static_cast<Residue>(i)));
        invert_vandermonde(run);
    }

    std::size_t count() const { return nodes_.size(); }

    Residues values(const Residues& f) const {
        Residues result;
        for (const Residue node : nodes_) result.push_back(dense::evaluate<PrimeField>(field_, f, node));
        return result;
    }
    Residues polynomial(const Residues& values) const {
        Residues result;
        for (const Residues& row : inverse_) result.push_back(dot_product(field_, row, values));
        dense::trim(result);
        return result;
    }

  private:
    /// Column j is the polynomial that is 1 at node j and 0 at the others: ∏ (t − nodes) without a factor.
    void invert_vandermonde(const base::Run& run) {
        Residues master = {1};
        for (const Residue node : nodes_) dense::multiply_by_root(field_, master, node);
        for (const Residue node : nodes_) {
            run.poll();
            Residues quotient(master.begin() + 1, master.end());
            for (std::size_t i = quotient.size() - 1; i-- > 0;)
                quotient[i] = field_.add(quotient[i], field_.multiply(node, quotient[i + 1]));
            const Residue scale = field_.inverse(dense::evaluate<PrimeField>(field_, quotient, node));
            for (std::size_t i = 0; i < quotient.size(); ++i)
                inverse_[i].push_back(field_.multiply(scale, quotient[i]));
        }
    }

    const PrimeField& field_;
    Residues nodes_;
    std::vector<Residues> inverse_; ///< rows of the inverse Vandermonde matrix
};

/// The inverses of nonzero residues with one inversion (Montgomery's trick); empty if one is zero.
Residues inverses(const PrimeField& field, const Residues& values) {
    Residues products(values.size());
    Residue product = 1;
    for (std::size_t i = 0; i < values.size(); ++i) {
        products[i] = product;
        product = field.multiply(product, values[i]);
    }
    if (product == 0) return {};
    Residue inverse = field.inverse(product);
    for (std::size_t i = values.size(); i-- > 0;) {
        products[i] = field.multiply(products[i], inverse);
        inverse = field.multiply(inverse, values[i]);
    }
    return products;
}

/// The resultant of two polynomials A, B in s, of formal degree m, whose coefficients are polynomials in t,
/// and their first subresultant c₀·s − c₁: where the resultant vanishes and c₀ does not, s = c₁/c₀ is the
/// only common root.
struct Elimination {
    Residues resultant;
    Residues c0;
    Residues c1;
};

/// Gaussian elimination of Bézout's matrix at all nodes at the same time: every number is an array, one entry
/// a node. The matrix (b_ij), for which (A(x)B(y) − A(y)B(x))/(x − y) = Σ b_ij xⁱyʲ, has at a common root s
/// the kernel vector (1, s, …, s^(m−1)). With columns from s^(m−1) down to 1, and without exchanges of rows,
/// the last rows of the triangular form are (…, u, v) and (…, 0, w), where ∏ of the pivots is the resultant,
/// and u·s + v = 0 at a common root.
class BezoutElimination {
  public:
    BezoutElimination(const PrimeField& field, const Nodes& nodes, std::span<const Residues> a,
                      std::span<const Residues> b, const base::Run& run)
        : field_(field), run_(run), nodes_(nodes), size_(a.size() - 1), entries_(size_ * size_) {
        fill(a, b);
    }

    /// nullopt if a pivot happened to be zero at a node.
    std::optional<Elimination> eliminate() {
        Residues leading(nodes_.count(), 1); // ∏ of the pivots but the last two
        for (std::size_t k = 0; k + 1 < size_; ++k) {
            if (!eliminate_column(k)) return std::nullopt;
            if (k + 2 < size_) multiply_by(leading, entry(k, k));
        }
        Residues c1 = leading;
        multiply_by(c1, entry(size_ - 2, size_ - 1));
        for (Residue& value : c1) value = field_.negate(value);
        Residues c0 = leading;
        multiply_by(c0, entry(size_ - 2, size_ - 2));
        Residues resultant = c0;
        multiply_by(resultant, entry(size_ - 1, size_ - 1));
        return Elimination{nodes_.polynomial(resultant), nodes_.polynomial(c0), nodes_.polynomial(c1)};
    }

  private:
    Residues& entry(std::size_t row, std::size_t column) { return entries_[row * size_ + column]; }

    /// b_ij = A_{i+1}B_j − A_jB_{i+1} + b_{i+1,j−1}, in reversed rows and columns.
    void fill(std::span<const Residues> a, std::span<const Residues> b) {
        for (std::size_t j = 0; j < size_; ++j) {
            for (std::size_t i = 0; i < size_; ++i) {
                Residues& target = entry(size_ - 1 - i, size_ - 1 - j);
                target.resize(nodes_.count());
                const bool has_next = j > 0 && i + 1 < size_;
                const Residues* next = has_next ? &entry(size_ - 2 - i, size_ - j) : nullptr;
                for (std::size_t node = 0; node < target.size(); ++node) {
                    const std::uint64_t plus = std::uint64_t{a[i + 1][node]} * b[j][node];
                    const std::uint64_t minus = std::uint64_t{a[j][node]} * field_.negate(b[i + 1][node]);
                    target[node] = field_.reduce(plus + minus + (next ? (*next)[node] : 0));
                }
            }
        }
    }

    bool eliminate_column(std::size_t k) {
        const Residues inverse = inverses(field_, entry(k, k));
        if (inverse.empty()) return false;
        for (std::size_t i = k + 1; i < size_; ++i) {
            run_.poll();
            Residues factor = entry(i, k);
            for (std::size_t node = 0; node < factor.size(); ++node)
                factor[node] = field_.negate(field_.multiply(factor[node], inverse[node]));
            for (std::size_t j = k + 1; j < size_; ++j) {
                Residues& target = entry(i, j);
                const Residues& pivot = entry(k, j);
                for (std::size_t node = 0; node < target.size(); ++node)
                    target[node] = field_.reduce(target[node] + std::uint64_t{factor[node]} * pivot[node]);
            }
        }
        return true;
    }

    void multiply_by(Residues& values, const Residues& factors) const {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = field_.multiply(values[i], factors[i]);
    }

    const PrimeField& field_;
    const base::Run& run_;
    const Nodes& nodes_;
    std::size_t size_;
    std::vector<Residues> entries_;
};

class SurfaceFibres : public LineFibres {
  public:
    SurfaceFibres(const PrimeField& field, std::span<const FormRows> forms,
                  std::span<const Residue> direction, SurfaceNodes nodes, Residue first_node,
                  const base::Run& run)
        : field_(field), run_(run), nodes_(field, first_node, nodes.count, run), denominator_(forms[0]),
          height_(forms[3]) {
        for (std::size_t i = 0; i < denominator_.size(); ++i) {
            denominator_values_.push_back(nodes_.values(denominator_[i]));
            for (std::size_t k = 0; k < 2; ++k)
                sheared_values_[k].push_back(
                    nodes_.values(minus_multiple(field, forms[k + 1][i], direction[k], height_[i])));
        }
        for (Residues& row : denominator_) dense::trim(row);
        while (!denominator_.empty() && denominator_.back().empty()) denominator_.pop_back();
    }

    /// The resultant over a base point, with its fixed roots.
    std::optional<Elimination> eliminate(std::span<const Residue> base) const {
        std::array<std::vector<Residues>, 2> equations;
        for (std::size_t k = 0; k < 2; ++k) {
            const Residue factor = field_.negate(base[k]);
            equations[k] = sheared_values_[k];
            for (std::size_t i = 0; i < equations[k].size(); ++i)
                dense::add_multiple<PrimeField>(field_, equations[k][i], denominator_values_[i], factor);
        }
        if (equations[0].size() == 2) return eliminate_linear(equations[0], equations[1]);
        return BezoutElimination(field_, nodes_, equations[0], equations[1], run_).eliminate();
    }

    /// Finds the fixed roots, as those which two lines have in common.
    bool find_fixed_roots(algebra::Random& random, base::Run& run) {
        for (int i = 0; i < 2; ++i) {
            const Residues base = {random.below(field_.characteristic()),
                                   random.below(field_.characteristic())};
            const auto elimination = eliminate(base);
            if (!elimination || elimination->resultant.empty()) return false;
            fixed_ = dense::gcd(field_, fixed_, elimination->resultant, run);
        }
        return true;
    }

    std::optional<LineFibre> over(std::span<const Residue> base) const override {
        auto elimination = eliminate(base);
        if (!elimination || elimination->resultant.empty()) return std::nullopt;
        Residues roots = dense::divide(field_, elimination->resultant, fixed_);
        if (!elimination->resultant.empty() || roots.size() < 2) return std::nullopt;
        dense::make_monic(field_, roots);
        QuotientAlgebra algebra(field_, std::move(roots), run_);
        const auto inverse = algebra.inverse(algebra.element(elimination->c0));
        if (!inverse) return std::nullopt;
        const Residues s = algebra.multiply(*inverse, algebra.element(elimination->c1));
        const Residues numerator = algebra.value(height_, s);
        const Residues denominator = algebra.value(denominator_, s);
        return fibre(std::move(algebra), numerator, denominator);
    }

  private:
    /// A₁s + A₀ is its own first subresultant.
    Elimination eliminate_linear(std::span<const Residues> a, std::span<const Residues> b) const {
        Residues resultant(nodes_.count());
        Residues c1(nodes_.count());
        for (std::size_t node = 0; node < resultant.size(); ++node) {
            c1[node] = field_.negate(a[0][node]);
            resultant[node] =
                field_.reduce(std::uint64_t{a[1][node]} * b[0][node] + std::uint64_t{c1[node]} * b[1][node]);
        }
        return {nodes_.polynomial(resultant), nodes_.polynomial(a[1]), nodes_.polynomial(c1)};
    }

    const PrimeField& field_;
    const base::Run& run_;
    Nodes nodes_;
    FormRows denominator_;
    FormRows height_;
    std::vector<Residues> denominator_values_;
    std::array<std::vector<Residues>, 2> sheared_values_;
    Residues fixed_; ///< the polynomial of the fixed roots, monic
};

std::size_t degree_in_t(std::span<const FormRows> forms) {
    std::size_t length = 1;
    for (const FormRows& form : forms)
        for (const Residues& row : form) length = std::max(length, row.size());
    return length - 1;
}

} // namespace

std::unique_ptr<LineFibres> curve_fibres(const PrimeField& field, std::span<const FormRows> forms,
                                         std::span<const Residue> direction, const base::Run& run) {
    return std::make_unique<CurveFibres>(field, forms, direction[0], run);
}

std::unique_ptr<LineFibres> surface_fibres(const PrimeField& field, std::span<const FormRows> forms,
                                           std::span<const Residue> direction, SurfaceNodes nodes,
                                           std::uint64_t seed, base::Run& run) {
    algebra::Random random(seed);
    const Residue first = random.below(field.characteristic());
    auto fibres = std::make_unique<SurfaceFibres>(field, forms, direction, nodes, first, run);
    if (!fibres->find_fixed_roots(random, run)) return nullptr;
    return fibres;
}

SurfaceNodes sufficient_nodes(std::span<const FormRows> forms) {
    // Each of the m rows of Bézout's matrix has entries of degree 2n; cofactors have fewer rows.
    return {2 * (forms[0].size() - 1) * degree_in_t(forms) + 1};
}

std::optional<SurfaceNodes> needed_nodes(const PrimeField& field, std::span<const FormRows> forms,
                                         std::uint64_t seed, base::Run& run) {
    run.poll();
    algebra::Random random(seed);
    const auto choose = [&] { return random.below(field.characteristic()); };
    const Residues direction = {choose(), choose()};
    const Residues base = {choose(), choose()};
    const SurfaceFibres fibres(field, forms, direction, sufficient_nodes(forms), choose(), run);
    const auto elimination = fibres.eliminate(base);
    if (!elimination) return std::nullopt;
    return SurfaceNodes{std::max(
        {elimination->resultant.size(), elimination->c0.size(), elimination->c1.size(), std::size_t{1}})};
}

} // namespace eliminant::implicit
