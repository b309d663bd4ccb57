#include "implicit/verify_values.hpp"

#include <algorithm>
#include <numeric>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::PrimeField;

namespace {

/// What is fixed comes last; the rest by ascending degree, so that few nodes have many children.
std::vector<std::size_t> sequence_of_variables(const Polynomial& f, const std::vector<bool>& fixed) {
    std::vector<std::size_t> variables(f.ring().variable_count());
    std::iota(variables.begin(), variables.end(), std::size_t{0});
    std::ranges::stable_sort(variables, {}, [&](std::size_t i) { return f.degree(i); });
    std::stable_partition(variables.begin(), variables.end(),
                          [&](std::size_t i) { return fixed.empty() || !fixed[i]; });
    return variables;
}

/// The exponents of all terms, row by row, the variables in the given sequence.
class Rows {
  public:
    Rows(const Polynomial& f, const std::vector<std::size_t>& variables) : width_(variables.size()) {
        exponents_.reserve(f.size() * width_);
        for (std::size_t term = 0; term < f.size(); ++term)
            for (const std::size_t i : variables)
                exponents_.push_back(static_cast<std::uint32_t>(f.exponent(term, i)));
    }
    std::span<const std::uint32_t> operator[](std::size_t term) const {
        return std::span(exponents_).subspan(term * width_, width_);
    }

  private:
    std::size_t width_;
    std::vector<std::uint32_t> exponents_;
};

} // namespace

ExponentTree::ExponentTree(const Polynomial& f, const std::vector<bool>& fixed)
    : order_(sequence_of_variables(f, fixed)),
      cut_(order_.size() - static_cast<std::size_t>(std::ranges::count(fixed, true))), terms_(f.size()),
      exponents_(order_.size() + 1), first_child_(order_.size()), degrees_(order_.size(), 0) {
    const Rows rows(f, order_);
    std::iota(terms_.begin(), terms_.end(), std::size_t{0});
    std::ranges::sort(terms_, [&](std::size_t a, std::size_t b) {
        return std::ranges::lexicographical_compare(rows[b], rows[a]);
    });
    exponents_[0] = {0};
    for (std::size_t i = 0; i < terms_.size(); ++i) {
        // A term opens new nodes from the level on where it differs from the one before.
        const std::span<const std::uint32_t> row = rows[terms_[i]];
        std::size_t level = 0;
        if (i > 0)
            while (row[level] == rows[terms_[i - 1]][level]) ++level;
        for (; level < depth(); ++level) {
            degrees_[level] = std::max(degrees_[level], row[level]);
            exponents_[level + 1].push_back(row[level]);
            first_child_[level].resize(node_count(level),
                                       static_cast<std::uint32_t>(node_count(level + 1) - 1));
        }
    }
    for (std::size_t level = 0; level < depth(); ++level)
        first_child_[level].resize(node_count(level) + 1, static_cast<std::uint32_t>(node_count(level + 1)));
}

std::vector<PrimeField::Element> ExponentTree::leaves(const Polynomial& f, const PrimeField& field) const {
    std::vector<PrimeField::Element> leaves(terms_.size());
    const PrimeField::Element scale = field.from_fraction(1, f.denominator());
    for (std::size_t i = 0; i < leaves.size(); ++i)
        leaves[i] = field.multiply(scale, field.from_integer(f.integer_terms().coefficients[terms_[i]]));
    return leaves;
}

ValuesModulo::ValuesModulo(const ExponentTree& tree, const Polynomial& f, const PrimeField& field)
    : tree_(&tree), modulus_(field.characteristic()), leaves_(tree.leaves(f, field)) {}

/// From values of the nodes at a level to those of the level above it; leaves have theirs in all lanes.
void ValuesModulo::climb_from(std::size_t level, const std::vector<Lanes>& values, std::vector<Lanes>& sums,
                              std::span<const Lanes> points) {
    const std::size_t above = level - 1;
    const std::size_t power_count = tree_->degree(above) + std::size_t{1};
    powers_.resize(power_count * lanes);
    loops_.powers(powers_.data(), points[tree_->variable(above)].data(), power_count, modulus_);
    sums.resize(tree_->node_count(above));
    const TreeEdges edges = tree_->edges(above);
    if (level == tree_->depth())
        loops_.sums_of_leaves(sums.front().data(), edges, powers_.data(), leaves_.data(), modulus_);
    else
        loops_.sums(sums.front().data(), edges, powers_.data(), values.front().data(), modulus_);
}

void ValuesModulo::fix(std::span<const Lanes> points) {
    if (leaves_.empty()) return;
    for (std::size_t level = tree_->depth(); level > tree_->cut(); --level) {
        climb_from(level, fixed_values_, sums_, points);
        std::swap(fixed_values_, sums_);
    }
}

ValuesModulo::Lanes ValuesModulo::operator()(std::span<const Lanes> points) {
    Lanes constant{};
    if (leaves_.empty()) return constant;
    if (tree_->cut() == 0) {
        constant.fill(leaves_.front());
        return tree_->depth() == 0 ? constant : fixed_values_.front();
    }
    climb_from(tree_->cut(), fixed_values_, values_, points);
    for (std::size_t level = tree_->cut() - 1; level > 0; --level) {
        climb_from(level, values_, sums_, points);
        std::swap(values_, sums_);
    }
    return values_.front();
}

} // namespace eliminant::implicit
