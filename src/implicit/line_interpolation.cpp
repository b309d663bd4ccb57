#include "implicit/line_interpolation.hpp"

#include <utility>

namespace eliminant::implicit {

using algebra::PrimeField;

LineInterpolation::LineInterpolation(const PrimeField& field, std::size_t degree, Residues direction,
                                     Residues corner)
    : field_(field), degree_(degree), direction_(std::move(direction)), corner_(std::move(corner)),
      columns_(direction_.size() == 2 ? degree + 1 : 1), cells_((degree + 1) * (degree + 1) * columns_, 0),
      reciprocals_(degree + 1, 0) {
    for (std::size_t j = 0; j < columns_; ++j)
        for (std::size_t i = 0; i + j <= degree; ++i) lines_.push_back({i, j});
    for (std::size_t i = 1; i <= degree; ++i) reciprocals_[i] = field.inverse(field.reduce(i));
}

Residues LineInterpolation::base(std::size_t line) const {
    Residues point = corner_;
    point[0] = field_.add(point[0], field_.reduce(lines_[line].i));
    if (point.size() == 2) point[1] = field_.add(point[1], field_.reduce(lines_[line].j));
    return point;
}

void LineInterpolation::set(std::size_t line, std::span<const Residue> restriction) {
    for (std::size_t e = 0; e <= degree_; ++e) at(lines_[line].i, lines_[line].j, e) = restriction[e];
}

/// Values at first, first + 1, … become coefficients in Newton's basis ∏ (b − nodes): divided differences, of
/// which the r-th ones have the denominator r.
template <class Cell>
void LineInterpolation::differences(std::size_t count, const Cell& cell) const {
    for (std::size_t r = 1; r < count; ++r)
        for (std::size_t i = count - 1; i >= r; --i)
            cell(i) = field_.multiply(field_.subtract(cell(i), cell(i - 1)), reciprocals_[r]);
}

/// Coefficients in Newton's basis become those of powers.
template <class Cell>
void LineInterpolation::to_powers(std::size_t count, Residue first_node, const Cell& cell) const {
    for (std::size_t i = count - 1; i-- > 0;) {
        const Residue node = field_.add(first_node, field_.reduce(i));
        for (std::size_t k = i; k + 1 < count; ++k)
            cell(k) = field_.subtract(cell(k), field_.multiply(node, cell(k + 1)));
    }
}

/// f(x) becomes f(x + by).
template <class Cell>
void LineInterpolation::shift(std::size_t count, Residue by, const Cell& cell) const {
    for (std::size_t r = 0; r + 1 < count; ++r)
        for (std::size_t k = count - 1; k-- > r;)
            cell(k) = field_.add(cell(k), field_.multiply(by, cell(k + 1)));
}

/// h_l needs the base points with i + j ≤ l only.
void LineInterpolation::interpolate_coefficient(std::size_t l) {
    const std::size_t e = degree_ - l;
    const std::size_t columns = columns_ == 1 ? 1 : l + 1;
    const auto row = [&](std::size_t j) {
        return [=, this](std::size_t i) -> Residue& { return at(i, j, e); };
    };
    const auto column = [&](std::size_t i) {
        return [=, this](std::size_t j) -> Residue& { return at(i, j, e); };
    };
    for (std::size_t j = 0; j < columns; ++j) differences(l - j + 1, row(j));
    if (columns > 1) {
        for (std::size_t i = 0; i <= l; ++i) {
            differences(l - i + 1, column(i));
            to_powers(l - i + 1, corner_[1], column(i));
        }
    }
    for (std::size_t j = 0; j < columns; ++j) to_powers(l - j + 1, corner_[0], row(j));
}

/// In b₁ = x − αz, b₂ = y − βz, τ = z terms keep their degree, so with z = 1 these are shifts of the
/// homogeneous parts.
void LineInterpolation::undo_shear() {
    const Residue x_shift = field_.negate(direction_[0]);
    for (std::size_t j = 0; j < columns_; ++j)
        for (std::size_t sum = 0; sum + j <= degree_; ++sum)
            shift(sum + 1, x_shift, [&](std::size_t i) -> Residue& { return at(i, j, sum - i); });
    if (columns_ == 1) return;
    const Residue y_shift = field_.negate(direction_[1]);
    for (std::size_t i = 0; i <= degree_; ++i)
        for (std::size_t sum = 0; sum + i <= degree_; ++sum)
            shift(sum + 1, y_shift, [&](std::size_t j) -> Residue& { return at(i, j, sum - j); });
}

std::vector<LineInterpolation::Term> LineInterpolation::terms() {
    for (std::size_t l = 0; l <= degree_; ++l) {
        // What lies beyond the simplex of h_l is its values there, which are not needed.
        interpolate_coefficient(l);
        for (const auto& [i, j] : lines_)
            if (i + j > l) at(i, j, degree_ - l) = 0;
    }
    undo_shear();
    std::vector<Term> result;
    for (const auto& [i, j] : lines_) {
        for (std::size_t e = 0; i + j + e <= degree_; ++e) {
            const Residue coefficient = at(i, j, e);
            if (coefficient == 0) continue;
            if (columns_ == 1)
                result.push_back({{i, e}, coefficient});
            else
                result.push_back({{i, j, e}, coefficient});
        }
    }
    return result;
}

} // namespace eliminant::implicit
