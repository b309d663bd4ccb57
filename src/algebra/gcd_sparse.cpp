#include "gcd_sparse.hpp"

#include "geometric_images.hpp"
#include "newton_interpolation.hpp"
#include "supposed_terms.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::algebra {

using dense::Element;
using dense::Vector;

/// Univariate images of H at ω, ω², …: the gcds of those of f and g, with γ's value as leading coefficient.
template <class Field>
class SparseGcd<Field>::Images {
  public:
    Images(const SparseGcd& parent, const ExponentRows& f, const ExponentRows& g, const ExponentRows& gamma,
           const Vector& omega)
        : parent_(parent), f_(parent.field_, f, omega), g_(parent.field_, g, omega),
          gamma_(parent.field_, gamma, omega) {}

    /// `count` images for these coefficients, all of one degree; nothing if one is unlucky.
    std::optional<std::vector<Vector>> operator()(Vector f, Vector g, Vector gamma, std::size_t count) const {
        const Field& field = parent_.field_;
        std::vector<Vector> result;
        Vector lead;
        for (std::size_t j = 0; j < count; ++j) {
            parent_.run_.poll();
            Vector a;
            Vector b;
            f_.next(f, a);
            g_.next(g, b);
            gamma_.next(gamma, lead);
            if (a.back() == 0 || b.back() == 0 || lead[0] == 0) return std::nullopt;
            Vector h = dense::gcd(field, std::move(a), std::move(b), parent_.run_);
            if (h.size() > parent_.degrees_[0] + 1) return std::nullopt;
            if (!result.empty() && h.size() != result.front().size()) return std::nullopt;
            for (Element& c : h) c = field.multiply(c, lead[0]);
            result.push_back(std::move(h));
        }
        return result;
    }

  private:
    const SparseGcd& parent_;
    GeometricImages<Field> f_;
    GeometricImages<Field> g_;
    GeometricImages<Field> gamma_;
};

template <class Field>
SparseGcd<Field>::SparseGcd(const Field& field, const SparseImage& f, const SparseImage& g,
                            const SparseImage& gamma, std::vector<std::size_t> degrees, Random& random,
                            base::Run& run)
    : field_(field), f_(f), g_(g), gamma_(gamma), degrees_(std::move(degrees)), random_(random), run_(run) {}

/// Random nonzero coordinates.
template <class Field>
Vector SparseGcd<Field>::random_point() {
    Vector point(degrees_.size());
    for (Element& c : point) c = 1 + random_.below(field_size(field_) - 1);
    return point;
}

/// The coefficients of a layer with a value in the place of its last variable, by prefixes. Those that vanish
/// keep their place.
template <class Field>
Vector SparseGcd<Field>::at(const Layer& layer, Element value) const {
    const ExponentRows& rows = layer.image.exponents;
    const std::size_t last = rows.variables - 1;
    const PowerTable<Field> powers(field_, value, largest_exponent(rows, last));
    Vector result(layer.ends.size(), 0);
    std::size_t i = 0;
    for (std::size_t prefix = 0; prefix < result.size(); ++prefix) {
        Element sum = 0;
        for (; i < layer.ends[prefix]; ++i) {
            const Element power = powers(rows.entries[i * rows.variables + last]);
            sum = field_.add(sum, field_.multiply(layer.image.coefficients[i], power));
        }
        result[prefix] = sum;
    }
    return result;
}

template <class Field>
typename SparseGcd<Field>::Layers SparseGcd<Field>::layers_of(const SparseImage& f, const Vector& point) {
    Layers layers(f.exponents.variables);
    layers.back().image = f;
    for (std::size_t k = layers.size() - 1; k > 0; --k) {
        run_.poll();
        const ExponentRows& rows = layers[k].image.exponents;
        ExponentRows prefixes{k, {}, 0};
        for (std::size_t i = 0; i < rows.count; ++i) {
            const auto prefix = rows.row(i).first(k);
            if (i + 1 < rows.count && std::ranges::equal(prefix, rows.row(i + 1).first(k))) continue;
            prefixes.push_back(prefix);
            layers[k].ends.push_back(i + 1);
        }
        layers[k - 1].image = {std::move(prefixes), at(layers[k], point[k])};
    }
    return layers;
}

template <class Field>
std::optional<SparseImage> SparseGcd<Field>::operator()() {
    const Vector point = random_point();
    const Layers f = layers_of(f_, point);
    const Layers g = layers_of(g_, point);
    const Layers gamma = layers_of(gamma_, point);
    // One variable: the image at the point itself, ω being irrelevant.
    const Images images(*this, f[0].image.exponents, g[0].image.exponents, gamma[0].image.exponents, point);
    const auto first =
        images(f[0].image.coefficients, g[0].image.coefficients, gamma[0].image.coefficients, 1);
    if (!first) return std::nullopt;
    degrees_[0] = first->front().size() - 1; // as good a bound as the one given
    SparseImage h = led_by(gamma[0].image);
    for (std::size_t power = degrees_[0]; power-- > 0;) {
        const std::uint64_t exponent = power;
        if (first->front()[power] != 0) h.push_back(std::span(&exponent, 1), first->front()[power]);
    }
    for (std::size_t k = 1; k < point.size(); ++k) {
        if (!extend(k, point[k], h, f, g, gamma)) return std::nullopt;
    }
    return h;
}

/// γ·x₁^d, d the degree of h: the leading coefficient of H is known. Terms that vanish at the point of a
/// layer stay.
template <class Field>
SparseImage SparseGcd<Field>::led_by(const SparseImage& gamma) const {
    SparseImage result = gamma;
    for (std::size_t i = 0; i < gamma.exponents.count; ++i)
        result.exponents.entries[i * gamma.exponents.variables] = degrees_[0];
    return result;
}

/// A random point ω that tells the terms apart, with what follows from it; nothing if the field is too small
/// for that.
template <class Field>
std::optional<SupposedTerms<Field>> SparseGcd<Field>::separated(const ExponentRows& rows, Vector& omega) {
    // t terms of one group in a field of q elements take about e^(t²/2q) attempts: 64 are enough for t
    // < 2.8·√q.
    for (int attempt = 0; attempt < 64; ++attempt) {
        run_.poll();
        omega = random_point();
        std::optional<SupposedTerms<Field>> terms(std::in_place, field_, rows, omega);
        if (terms->ready()) return terms;
    }
    return std::nullopt;
}

/// Brings in variable k, whose value so far was `known_point`.
template <class Field>
bool SparseGcd<Field>::extend(std::size_t k, Element known_point, SparseImage& h, const Layers& f,
                              const Layers& g, const Layers& gamma) {
    const std::size_t known = gamma[k - 1].image.exponents.count; // terms of the leading coefficient
    constexpr std::size_t max_entries = std::size_t{1} << 26;     // 256 MB
    if (degrees_[k] >= max_entries / h.exponents.count) return false;
    Vector omega;
    const auto terms = separated(h.exponents, omega);
    if (!terms) return false;
    const Images images(*this, f[k - 1].image.exponents, g[k - 1].image.exponents,
                        gamma[k - 1].image.exponents, omega);
    NewtonInterpolation<Field> interpolation(field_, h.exponents.count - known, degrees_[k]);
    interpolation.add(known_point, std::span(h.coefficients).subspan(known));
    const std::uint32_t size = field_size(field_);
    const auto first = random_.below(size);
    std::size_t unlucky = 0;
    bool changed = true;
    for (std::uint32_t i = 0; changed && !interpolation.complete(); ++i) {
        if (i == size || unlucky > degrees_[k] + 8) return false;
        const auto point = static_cast<Element>((std::uint64_t{first} + i) % size);
        if (point == known_point) continue;
        const Vector values_gamma = at(gamma[k], point);
        // One image more than needed tests the terms, at the first new point of the variable.
        const std::size_t count = terms->images_needed() + (interpolation.points() == 1 ? 1 : 0);
        const auto values = images(at(f[k], point), at(g[k], point), values_gamma, count);
        const auto coefficients = values ? terms->solve(*values, values_gamma) : std::nullopt;
        if (!coefficients) {
            ++unlucky;
            continue;
        }
        changed = interpolation.add(point, std::span(*coefficients).subspan(known));
    }
    SparseImage result = led_by(gamma[k].image);
    std::vector<std::uint64_t> row;
    for (std::size_t i = known; i < h.exponents.count; ++i) {
        row.assign(h.exponents.row(i).begin(), h.exponents.row(i).end());
        row.push_back(0);
        const auto column = interpolation.column(i - known);
        for (std::size_t e = column.size(); e-- > 0;) {
            row.back() = e;
            if (column[e] != 0) result.push_back(row, column[e]);
        }
    }
    h = std::move(result);
    return true;
}

template <class Field>
std::optional<Vector> SparseGcd<Field>::on_support(const ExponentRows& rows) {
    Vector omega;
    const auto terms = separated(rows, omega);
    if (!terms) return std::nullopt;
    const Images images(*this, f_.exponents, g_.exponents, gamma_.exponents, omega);
    const auto values =
        images(f_.coefficients, g_.coefficients, gamma_.coefficients, terms->images_needed() + 1);
    return values ? terms->solve(*values, gamma_.coefficients) : std::nullopt;
}

template class SparseGcd<PrimeField>;
template class SparseGcd<GaloisField>;

} // namespace eliminant::algebra
