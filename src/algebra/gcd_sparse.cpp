#include "gcd_sparse.hpp"

#include "newton_interpolation.hpp"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace eliminant::algebra {

namespace {

using dense::Element;
using dense::Vector;

/// Powers of one element; small ones from a table.
template <class Field>
class PowerTable {
  public:
    PowerTable(const Field& field, Element base, std::uint64_t max_exponent)
        : field_(field), base_(base),
          table_(dense::powers(field, base,
                               static_cast<std::size_t>(std::min<std::uint64_t>(max_exponent, 4095)) + 1)) {}
    Element operator()(std::uint64_t exponent) const {
        return exponent < table_.size() ? table_[exponent] : field_.power(base_, exponent);
    }

  private:
    const Field& field_;
    Element base_;
    Vector table_;
};

std::uint64_t largest_exponent(const ExponentRows& rows, std::size_t variable) {
    std::uint64_t largest = 0;
    for (std::size_t i = 0; i < rows.count; ++i) largest = std::max(largest, rows.row(i)[variable]);
    return largest;
}

/// The value of each row's monomial, without its power of the first variable, where variable i has the value
/// point[i].
template <class Field>
Vector monomial_values(const Field& field, const ExponentRows& rows, const Vector& point) {
    Vector values(rows.count, 1);
    for (std::size_t v = 1; v < rows.variables; ++v) {
        const PowerTable<Field> powers(field, point[v], largest_exponent(rows, v));
        for (std::size_t i = 0; i < rows.count; ++i)
            values[i] = field.multiply(values[i], powers(rows.row(i)[v]));
    }
    return values;
}

/// A polynomial at the points ω, ω², ω³, … of all variables but the first, one univariate image after the
/// other: a multiplication and an addition a term.
template <class Field>
class GeometricImages {
  public:
    GeometricImages(const Field& field, const ExponentRows& rows, const Vector& ratios,
                    const Vector& coefficients)
        : field_(field), rows_(rows), ratios_(ratios), values_(coefficients),
          extent_(static_cast<std::size_t>(rows.row(0)[0]) + 1) {}

    void next(Vector& image) {
        image.assign(extent_, 0);
        for (std::size_t i = 0; i < values_.size(); ++i) {
            values_[i] = field_.multiply(values_[i], ratios_[i]);
            Element& sum = image[rows_.entries[i * rows_.variables]];
            sum = field_.add(sum, values_[i]);
        }
    }

  private:
    const Field& field_;
    const ExponentRows& rows_;
    const Vector& ratios_;
    Vector values_;
    std::size_t extent_; ///< rows are in lex, so the first has the largest power of the first variable
};

} // namespace

/// The supposed terms of H, grouped by the power of x₁, with what the Vandermonde systems at ω need. The
/// leading group is that of γ, whose coefficients are known.
template <class Field>
class SparseGcd<Field>::Support {
  public:
    /// Ready only if the monomials of each group have distinct values.
    Support(const Field& field, const ExponentRows& rows, const Vector& omega)
        : field_(field), nodes_(monomial_values(field, rows, omega)) {
        for (std::size_t first = 0; first < rows.count;) {
            std::size_t last = first;
            while (last < rows.count && rows.row(last)[0] == rows.row(first)[0]) ++last;
            groups_.push_back({rows.row(first)[0], first, last - first, {1}});
            first = last;
        }
        denominators_.assign(rows.count, 1);
        for (std::size_t i = 1; i < groups_.size() && ready_; ++i) prepare(groups_[i]);
    }

    bool ready() const { return ready_; }
    /// Images that determine the coefficients.
    std::size_t images_needed() const {
        std::size_t most = 0;
        for (std::size_t i = 1; i < groups_.size(); ++i) most = std::max(most, groups_[i].length);
        return most;
    }

    /// The coefficients from univariate images, images_needed() of them and one that tests the support;
    /// nothing if the test fails. Those of the leading group are γ's.
    std::optional<Vector> solve(const std::vector<Vector>& images, const Vector& gamma) const {
        if (images.front().size() != groups_.front().power + 1) return std::nullopt;
        Vector result(nodes_.size(), 0);
        std::ranges::copy(gamma, result.begin());
        std::size_t next_group = 0;
        Vector samples(images.size());
        for (std::size_t power = images.front().size(); power-- > 0;) {
            for (std::size_t j = 0; j < images.size(); ++j) samples[j] = images[j][power];
            if (next_group == groups_.size() || groups_[next_group].power != power) {
                if (std::ranges::any_of(samples, [](Element s) { return s != 0; })) return std::nullopt;
                continue;
            }
            const Group& group = groups_[next_group++];
            if (&group == &groups_.front()) continue;
            solve_group(group, samples, result);
            if (!agrees(group, samples.back(), images.size(), result)) return std::nullopt;
        }
        return result;
    }

  private:
    struct Group {
        std::uint64_t power; ///< of x₁
        std::size_t first;   ///< row
        std::size_t length;
        Vector master; ///< M = ∏ (z − node) over the group
    };

    /// M and, for each node m with Q = M/(z − m), 1/(m·Q(m)).
    void prepare(Group& group) {
        std::unordered_set<Element> seen;
        for (std::size_t i = group.first; i < group.first + group.length; ++i) {
            ready_ = ready_ && seen.insert(nodes_[i]).second;
            dense::multiply_by_root(field_, group.master, nodes_[i]);
        }
        if (!ready_) return;
        for (std::size_t i = group.first; i < group.first + group.length; ++i) {
            const Vector quotient = quotient_of(group, nodes_[i]);
            const Element value = dense::evaluate<Field>(field_, quotient, nodes_[i]);
            denominators_[i] = field_.inverse(field_.multiply(nodes_[i], value));
        }
    }

    Vector quotient_of(const Group& group, Element node) const {
        Vector quotient(group.length);
        Element carry = 0;
        for (std::size_t j = group.length; j-- > 0;) {
            carry = field_.add(group.master[j + 1], field_.multiply(node, carry));
            quotient[j] = carry;
        }
        return quotient;
    }

    /// Σ_l y_l·m_l^j = s_j for 1 ≤ j ≤ length: Σ_j q_j·s_{j+1} = Σ_l y_l·m_l·Q(m_l) has one term, that of the
    /// node that Q omits.
    void solve_group(const Group& group, const Vector& samples, Vector& result) const {
        for (std::size_t i = group.first; i < group.first + group.length; ++i) {
            const Vector quotient = quotient_of(group, nodes_[i]);
            result[i] = field_.multiply(dense::dot<Field>(field_, quotient, samples), denominators_[i]);
        }
    }

    /// Whether the group has that value at ω^j.
    bool agrees(const Group& group, Element sample, std::size_t j, const Vector& result) const {
        Element value = 0;
        for (std::size_t i = group.first; i < group.first + group.length; ++i)
            value = field_.add(value, field_.multiply(result[i], field_.power(nodes_[i], j)));
        return value == sample;
    }

    const Field& field_;
    Vector nodes_;
    Vector denominators_;
    std::vector<Group> groups_;
    bool ready_ = true;
};

/// Univariate images of H at ω, ω², …: the gcds of those of f and g, with γ's value as leading coefficient.
template <class Field>
class SparseGcd<Field>::Images {
  public:
    Images(const SparseGcd& parent, const ExponentRows& f, const ExponentRows& g, const ExponentRows& gamma,
           const Vector& omega)
        : parent_(parent), f_(f), g_(g), gamma_(gamma), ratios_f_(monomial_values(parent.field_, f, omega)),
          ratios_g_(monomial_values(parent.field_, g, omega)),
          ratios_gamma_(monomial_values(parent.field_, gamma, omega)) {}

    /// `count` images for these coefficients, all of one degree; nothing if one is unlucky.
    std::optional<std::vector<Vector>> operator()(const Vector& f, const Vector& g, const Vector& gamma,
                                                  std::size_t count) const {
        const Field& field = parent_.field_;
        GeometricImages<Field> images_f(field, f_, ratios_f_, f);
        GeometricImages<Field> images_g(field, g_, ratios_g_, g);
        GeometricImages<Field> images_gamma(field, gamma_, ratios_gamma_, gamma);
        std::vector<Vector> result;
        Vector lead;
        for (std::size_t j = 0; j < count; ++j) {
            parent_.run_.poll();
            Vector a;
            Vector b;
            images_f.next(a);
            images_g.next(b);
            images_gamma.next(lead);
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
    const ExponentRows& f_;
    const ExponentRows& g_;
    const ExponentRows& gamma_;
    Vector ratios_f_;
    Vector ratios_g_;
    Vector ratios_gamma_;
};

template <class Field>
SparseGcd<Field>::SparseGcd(const Field& field, const SparseImage& f, const SparseImage& g,
                            const SparseImage& gamma, std::vector<std::size_t> degrees,
                            std::mt19937_64& random, base::Run& run)
    : field_(field), f_(f), g_(g), gamma_(gamma), degrees_(std::move(degrees)), random_(random), run_(run) {}

/// Random nonzero coordinates.
template <class Field>
Vector SparseGcd<Field>::random_point() {
    Vector point(degrees_.size());
    for (Element& c : point) c = static_cast<Element>(1 + random_() % (field_size(field_) - 1));
    return point;
}

/// The coefficients of f with a value in the place of its last variable; `prefixes` are its rows without
/// that, each once. Coefficients that vanish keep their place.
template <class Field>
Vector SparseGcd<Field>::collapsed(const SparseImage& f, const ExponentRows& prefixes, Element value) {
    const std::size_t last = prefixes.variables;
    const PowerTable<Field> powers(field_, value, largest_exponent(f.exponents, last));
    Vector result(prefixes.count, 0);
    std::size_t prefix = 0;
    for (std::size_t i = 0; i < f.exponents.count; ++i) {
        if (!std::ranges::equal(f.exponents.row(i).first(last), prefixes.row(prefix))) ++prefix;
        result[prefix] =
            field_.add(result[prefix], field_.multiply(f.coefficients[i], powers(f.exponents.row(i)[last])));
    }
    return result;
}

template <class Field>
typename SparseGcd<Field>::Layers SparseGcd<Field>::layers_of(const SparseImage& f, const Vector& point) {
    Layers layers(f.exponents.variables);
    layers.back() = f;
    for (std::size_t k = layers.size() - 1; k > 0; --k) {
        run_.poll();
        const ExponentRows& rows = layers[k].exponents;
        ExponentRows prefixes{k, {}, 0};
        for (std::size_t i = 0; i < rows.count; ++i) {
            const auto prefix = rows.row(i).first(k);
            if (i == 0 || !std::ranges::equal(prefix, prefixes.row(prefixes.count - 1)))
                prefixes.push_back(prefix);
        }
        Vector coefficients = collapsed(layers[k], prefixes, point[k]);
        layers[k - 1] = {std::move(prefixes), std::move(coefficients)};
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
    const Images images(*this, f[0].exponents, g[0].exponents, gamma[0].exponents, point);
    const auto first = images(f[0].coefficients, g[0].coefficients, gamma[0].coefficients, 1);
    if (!first) return std::nullopt;
    degrees_[0] = first->front().size() - 1; // as good a bound as the one given
    SparseImage h = led_by(gamma[0]);
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

/// Brings in variable k, whose value so far was `known_point`.
template <class Field>
bool SparseGcd<Field>::extend(std::size_t k, Element known_point, SparseImage& h, const Layers& f,
                              const Layers& g, const Layers& gamma) {
    const Vector omega = random_point();
    const Support support(field_, h.exponents, omega);
    if (!support.ready()) return false;
    const Images images(*this, f[k - 1].exponents, g[k - 1].exponents, gamma[k - 1].exponents, omega);
    const std::size_t known = gamma[k - 1].exponents.count; // terms of the leading coefficient
    NewtonInterpolation<Field> interpolation(field_, h.exponents.count - known, degrees_[k]);
    interpolation.add(known_point, std::span(h.coefficients).subspan(known));
    const std::uint32_t size = field_size(field_);
    const auto first = static_cast<std::uint32_t>(random_() % size);
    std::size_t unlucky = 0;
    bool changed = true;
    for (std::uint32_t i = 0; changed && !interpolation.complete(); ++i) {
        if (i == size || unlucky > degrees_[k] + 8) return false;
        const auto point = static_cast<Element>((std::uint64_t{first} + i) % size);
        if (point == known_point) continue;
        const Vector values_gamma = collapsed(gamma[k], gamma[k - 1].exponents, point);
        const auto values =
            images(collapsed(f[k], f[k - 1].exponents, point), collapsed(g[k], g[k - 1].exponents, point),
                   values_gamma, support.images_needed() + 1);
        const auto coefficients = values ? support.solve(*values, values_gamma) : std::nullopt;
        if (!coefficients) {
            ++unlucky;
            continue;
        }
        changed = interpolation.add(point, std::span(*coefficients).subspan(known));
    }
    SparseImage result = led_by(gamma[k]);
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
    const Vector omega = random_point();
    const Support support(field_, rows, omega);
    if (!support.ready()) return std::nullopt;
    const Images images(*this, f_.exponents, g_.exponents, gamma_.exponents, omega);
    const auto values =
        images(f_.coefficients, g_.coefficients, gamma_.coefficients, support.images_needed() + 1);
    return values ? support.solve(*values, gamma_.coefficients) : std::nullopt;
}

template class SparseGcd<PrimeField>;
template class SparseGcd<GaloisField>;

} // namespace eliminant::algebra
