#include "point_transform.hpp"

#include <algorithm>

namespace eliminant::algebra {

namespace {

/// Columns that are treated together, so that those of 40 rows stay in a cache of 32 KiB.
constexpr std::size_t strip = 192;

/// The part of the rows of a layout that lies in a strip of columns.
class StripRows {
  public:
    StripRows(const AxisLayout& layout, std::uint32_t* values, std::size_t column)
        : layout_(layout), values_(values), column_(column) {
        while (count_ < layout.rows() && layout.row_size(count_) > column) ++count_;
    }
    /// Rows that reach the strip.
    std::size_t count() const { return count_; }
    std::uint32_t* row(std::size_t k) const { return values_ + layout_.row_begin(k) + column_; }
    std::size_t size(std::size_t k) const { return std::min(layout_.row_size(k) - column_, strip); }

  private:
    const AxisLayout& layout_;
    std::uint32_t* values_;
    std::size_t column_;
    std::size_t count_ = 0;
};

template <class Treat>
void for_each_strip(const AxisLayout& layout, std::vector<std::uint32_t>& values, const base::Run& run,
                    const Treat& treat) {
    for (std::size_t column = 0; column < layout.row_size(0); column += strip) {
        run.poll();
        treat(StripRows(layout, values.data(), column));
    }
}

/// k! and 1/k! modulo p for k below a count that is at most p.
struct Factorials {
    std::vector<ResidueFactor> values;
    std::vector<ResidueFactor> inverses;

    Factorials(const PrimeField& field, std::size_t count) : values(count), inverses(count) {
        const std::uint32_t p = field.characteristic();
        std::uint32_t factorial = 1;
        for (std::size_t k = 0; k < count; ++k) {
            if (k != 0) factorial = field.multiply(factorial, field.reduce(k));
            values[k] = ResidueFactor(factorial, p);
        }
        std::uint32_t inverse = field.inverse(factorial);
        for (std::size_t k = count; k-- > 0;) {
            inverses[k] = ResidueFactor(inverse, p);
            inverse = field.multiply(inverse, field.reduce(k));
        }
    }
};

} // namespace

PointTransform::PointTransform(const ExponentSet& set) : set_(&set), rows_(&residue_rows()) {
    for (std::size_t axis = 0; axis < set.axes(); ++axis) layouts_.emplace_back(set, axis);
}

void PointTransform::move(Values& values, std::size_t from, std::size_t to) const {
    Values moved(values.size());
    const auto source = layouts_[from].positions();
    const auto target = layouts_[to].positions();
    for (std::size_t i = 0; i < moved.size(); ++i) moved[target[i]] = values[source[i]];
    values = std::move(moved);
}

template <class AlongAxis>
void PointTransform::forwards(Values& values, const AlongAxis& along_axis) const {
    for (std::size_t axis = 0; axis < layouts_.size(); ++axis) {
        if (axis != 0) move(values, axis - 1, axis);
        along_axis(layouts_[axis]);
    }
}

template <class AlongAxis>
void PointTransform::backwards(Values& values, const AlongAxis& along_axis) const {
    for (std::size_t axis = layouts_.size(); axis-- > 0;) {
        if (axis + 1 != layouts_.size()) move(values, axis + 1, axis);
        along_axis(layouts_[axis]);
    }
}

void PointTransform::monomials_to_newton(Values& values, const PrimeField& field,
                                         const base::Run& run) const {
    // Division by x − j leaves the coefficient of x(x − 1)…(x − j + 1) and the quotient for the next one.
    const std::uint32_t p = field.characteristic();
    forwards(values, [&](const AxisLayout& layout) {
        for_each_strip(layout, values, run, [&](const StripRows& rows) {
            for (std::size_t j = 1; j + 1 < rows.count(); ++j) {
                const ResidueFactor factor(field.reduce(j), p);
                for (std::size_t k = rows.count() - 1; k-- > j;)
                    rows_->add_multiple(rows.row(k), rows.row(k + 1), rows.size(k + 1), factor, p);
            }
        });
    });
}

void PointTransform::newton_to_monomials(Values& values, const PrimeField& field,
                                         const base::Run& run) const {
    const std::uint32_t p = field.characteristic();
    backwards(values, [&](const AxisLayout& layout) {
        for_each_strip(layout, values, run, [&](const StripRows& rows) {
            for (std::size_t j = rows.count(); j-- > 1;) {
                const ResidueFactor factor(field.negate(field.reduce(j)), p);
                for (std::size_t k = j; k + 1 < rows.count(); ++k)
                    rows_->add_multiple(rows.row(k), rows.row(k + 1), rows.size(k + 1), factor, p);
            }
        });
    });
}

void PointTransform::newton_to_values(Values& values, const PrimeField& field, const base::Run& run) const {
    // k! times the coefficients are the differences of the values at 0, 1, 2, …
    const std::uint32_t p = field.characteristic();
    backwards(values, [&](const AxisLayout& layout) {
        const Factorials factorials(field, layout.rows());
        for_each_strip(layout, values, run, [&](const StripRows& rows) {
            for (std::size_t k = 2; k < rows.count(); ++k)
                rows_->scale(rows.row(k), rows.size(k), factorials.values[k], p);
            for (std::size_t order = rows.count(); order-- > 1;) {
                for (std::size_t k = order; k < rows.count(); ++k)
                    rows_->add(rows.row(k), rows.row(k - 1), rows.size(k), p);
            }
        });
    });
}

void PointTransform::values_to_newton(Values& values, const PrimeField& field, const base::Run& run) const {
    const std::uint32_t p = field.characteristic();
    forwards(values, [&](const AxisLayout& layout) {
        const Factorials factorials(field, layout.rows());
        for_each_strip(layout, values, run, [&](const StripRows& rows) {
            for (std::size_t order = 1; order < rows.count(); ++order) {
                for (std::size_t k = rows.count(); k-- > order;)
                    rows_->subtract(rows.row(k), rows.row(k - 1), rows.size(k), p);
            }
            for (std::size_t k = 2; k < rows.count(); ++k)
                rows_->scale(rows.row(k), rows.size(k), factorials.inverses[k], p);
        });
    });
}

} // namespace eliminant::algebra
