#include "gcd_dense.hpp"

#include "newton_interpolation.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::algebra {

namespace {

bool is_zero(std::span<const dense::Element> column) {
    return std::ranges::all_of(column, [](dense::Element c) { return c == 0; });
}

dense::Vector trimmed(std::span<const dense::Element> column) {
    dense::Vector f(column.begin(), column.end());
    dense::trim(f);
    return f;
}

/// Index of the last column that is not zero; the box is not zero.
std::size_t leading_column(const DenseBox& f) {
    std::size_t i = f.columns() - 1;
    while (is_zero(f.column(i))) --i;
    return i;
}

} // namespace

template <class Field>
std::optional<DenseBox> DenseGcd<Field>::operator()(DenseBox f, DenseBox g) {
    const std::size_t level = f.extents.size();
    if (level == 1) return univariate(f, g);
    const dense::Vector content_f = content(f);
    const dense::Vector content_g = content(g);
    const dense::Vector common = dense::gcd(field_, content_f, content_g, run_);
    const std::size_t bound = bounds_[level - 1];
    if (common.size() > bound + 1) return std::nullopt;
    const DenseBox a = divided(std::move(f), content_f);
    const DenseBox b = divided(std::move(g), content_g);
    const dense::Vector gamma =
        dense::gcd(field_, trimmed(a.column(leading_column(a))), trimmed(b.column(leading_column(b))), run_);
    // The interpolant is γ/lc(h)·h. It divides γ·h, and its degree is at most that of a or b as well, for
    // γ/lc(h) divides the leading coefficients of the cofactors.
    const std::size_t degree = std::min(
        {bound - (common.size() - 1) + gamma.size() - 1, a.extents.back() - 1, b.extents.back() - 1});
    auto h = interpolated(a, b, gamma, degree);
    return h ? finished(*std::move(h), common) : std::nullopt;
}

template <class Field>
std::optional<DenseBox> DenseGcd<Field>::univariate(const DenseBox& f, const DenseBox& g) {
    dense::Vector h = dense::gcd(field_, trimmed(f.values), trimmed(g.values), run_);
    if (h.size() > bounds_[0] + 1) return std::nullopt;
    h.resize(bounds_[0] + 1, 0);
    return DenseBox{{h.size()}, std::move(h)};
}

template <class Field>
std::optional<DenseBox> DenseGcd<Field>::interpolated(const DenseBox& f, const DenseBox& g,
                                                      const dense::Vector& gamma, std::size_t bound) {
    const dense::Vector lead_f = trimmed(f.column(leading_column(f)));
    const dense::Vector lead_g = trimmed(g.column(leading_column(g)));
    std::optional<NewtonInterpolation<Field>> sum;
    std::size_t leading_of_sum = 0; // index of the leading entry of its images
    const std::uint32_t size = field_size(field_);
    const auto first = random_.below(size);
    std::size_t unlucky = 0;
    for (std::uint32_t i = 0; i < size && unlucky <= bound + 8; ++i) {
        run_.poll();
        const auto point = static_cast<dense::Element>((std::uint64_t{first} + i) % size);
        if (dense::evaluate<Field>(field_, lead_f, point) == 0 ||
            dense::evaluate<Field>(field_, lead_g, point) == 0)
            continue;
        const auto image = (*this)(at(f, point), at(g, point));
        if (!image) {
            ++unlucky;
            continue;
        }
        std::size_t leading = image->values.size() - 1;
        while (image->values[leading] == 0) --leading;
        if (sum && leading > leading_of_sum) { // this point is unlucky
            ++unlucky;
            continue;
        }
        if (!sum || leading < leading_of_sum) { // all points before were
            sum.emplace(field_, image->values.size(), bound);
            leading_of_sum = leading;
        }
        const bool changed = sum->add(point, image->values, dense::evaluate<Field>(field_, gamma, point));
        if (changed && !sum->complete()) continue;
        std::vector<std::size_t> extents = image->extents;
        extents.push_back(bound + 1);
        return DenseBox{std::move(extents), sum->columns()};
    }
    return std::nullopt;
}

/// The primitive part of h with respect to the last variable times the content, monic and in its place.
template <class Field>
std::optional<DenseBox> DenseGcd<Field>::finished(DenseBox h, const dense::Vector& content_of_gcd) {
    const dense::Vector content_of_h = content(h);
    const DenseBox primitive = divided(std::move(h), content_of_h);
    const std::size_t leading = leading_column(primitive);
    const dense::Element scale = field_.inverse(trimmed(primitive.column(leading)).back());
    const std::size_t extent = bounds_[primitive.extents.size() - 1] + 1;
    std::vector<std::size_t> extents = primitive.extents;
    extents.back() = extent;
    DenseBox result{std::move(extents), dense::Vector(primitive.columns() * extent, 0)};
    for (std::size_t i = 0; i <= leading; ++i) {
        dense::Vector product = dense::multiply(field_, trimmed(primitive.column(i)), content_of_gcd);
        if (product.size() > extent) return std::nullopt;
        for (std::size_t j = 0; j < product.size(); ++j)
            result.column(i)[j] = field_.multiply(product[j], scale);
    }
    return result;
}

template <class Field>
DenseBox DenseGcd<Field>::at(const DenseBox& f, dense::Element point) {
    DenseBox result{{f.extents.begin(), f.extents.end() - 1}, dense::Vector(f.columns())};
    const dense::Vector powers = dense::powers(field_, point, f.extents.back());
    for (std::size_t i = 0; i < f.columns(); ++i) result.values[i] = dense::dot(field_, f.column(i), powers);
    return result;
}

/// gcd of the columns, monic.
template <class Field>
dense::Vector DenseGcd<Field>::content(const DenseBox& f) {
    dense::Vector common;
    for (std::size_t i = f.columns(); i-- > 0 && common.size() != 1;) {
        if (!is_zero(f.column(i))) common = dense::gcd(field_, std::move(common), trimmed(f.column(i)), run_);
    }
    return common;
}

template <class Field>
DenseBox DenseGcd<Field>::divided(DenseBox f, const dense::Vector& divisor) {
    if (divisor.size() == 1) return f;
    for (std::size_t i = 0; i < f.columns(); ++i) {
        dense::Vector column = trimmed(f.column(i));
        const dense::Vector quotient = dense::divide(field_, column, divisor);
        std::ranges::fill(f.column(i), 0);
        std::ranges::copy(quotient, f.column(i).begin());
    }
    return f;
}

template class DenseGcd<PrimeField>;
template class DenseGcd<GaloisField>;

} // namespace eliminant::algebra
