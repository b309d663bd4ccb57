#include "gcd_methods.hpp"

#include "gcd_dense.hpp"
#include "gcd_sparse.hpp"

#include "eliminant/algebra/coefficients.hpp"
#include "eliminant/algebra/gcd.hpp"

#include <algorithm>

namespace eliminant::algebra {

namespace {

template <class Field>
std::uint32_t image_of(const Field& field, const TermRows& rows, std::size_t i) {
    return rows.integers.empty() ? image_in(field, rows.residues[i]) : image_in(field, rows.integers[i]);
}

template <class Field>
SparseImage sparse_image(const Field& field, const TermRows& rows) {
    SparseImage image{rows.exponents, dense::Vector(rows.exponents.count)};
    for (std::size_t i = 0; i < rows.exponents.count; ++i) image.coefficients[i] = image_of(field, rows, i);
    return image;
}

class DenseMethod final : public ImageMethod {
  public:
    DenseMethod(GcdProblem problem, Random& random, base::Run& run)
        : problem_(std::move(problem)), random_(random), run_(run),
          f_(term_rows(problem_.f, problem_.variables, run)),
          g_(term_rows(problem_.g, problem_.variables, run)) {
        if (!f_.integers.empty()) gamma_ = gcd(f_.integers.front(), g_.integers.front());
    }

    std::optional<ModularImage> image(const PrimeField& field) override { return image_over(field); }
    std::optional<ModularImage> image(const GaloisField& field) override { return image_over(field); }
    void reset() override {}

    std::strong_ordering compare(const ModularImage& a, const ModularImage& b) const override {
        return a.places.back() <=> b.places.back();
    }
    std::span<const std::size_t> variables() const override { return problem_.variables; }
    void exponents_of(std::size_t place, std::span<std::uint64_t> row) const override {
        for (std::size_t k = row.size(); k-- > 0;) {
            row[k] = place % (problem_.bounds[k] + 1);
            place /= problem_.bounds[k] + 1;
        }
    }
    Polynomial gcd_from(const Polynomial& multiple, base::Run& /*run*/) const override {
        return multiple.primitive_part();
    }

  private:
    template <class Field>
    std::optional<ModularImage> image_over(const Field& field) {
        if (image_of(field, f_, 0) == 0 || image_of(field, g_, 0) == 0) return std::nullopt;
        DenseGcd<Field> gcd_of(field, problem_.bounds, random_, run_);
        const auto h = gcd_of(box(field, problem_.f, f_), box(field, problem_.g, g_));
        if (!h) return std::nullopt;
        const std::uint32_t scale = scale_in(field);
        ModularImage result;
        for (std::size_t i = 0; i < h->values.size(); ++i) {
            if (h->values[i] == 0) continue;
            result.places.push_back(i);
            result.residues.push_back(field.multiply(h->values[i], scale));
        }
        return result;
    }
    std::uint32_t scale_in(const PrimeField& field) const { return field.from_integer(gamma_); }
    std::uint32_t scale_in(const GaloisField& /*field*/) const { return 1; }

    template <class Field>
    DenseBox box(const Field& field, const Polynomial& f, const TermRows& rows) const {
        DenseBox result;
        std::size_t volume = 1;
        for (const std::size_t v : problem_.variables) {
            result.extents.push_back(static_cast<std::size_t>(f.degree(v)) + 1);
            volume *= result.extents.back();
        }
        result.values.assign(volume, 0);
        for (std::size_t i = 0; i < rows.exponents.count; ++i) {
            std::size_t place = 0;
            for (std::size_t k = 0; k < result.extents.size(); ++k)
                place = place * result.extents[k] + static_cast<std::size_t>(rows.exponents.row(i)[k]);
            result.values[place] = image_of(field, rows, i);
        }
        return result;
    }

    GcdProblem problem_;
    Random& random_;
    base::Run& run_;
    TermRows f_;
    TermRows g_;
    Integer gamma_ = Integer(1); ///< gcd of the leading coefficients: images are scaled to it
};

/// f and g are primitive with respect to the main variable.
class SparseMethod final : public ImageMethod {
  public:
    SparseMethod(GcdProblem problem, Random& random, base::Run& run)
        : problem_(std::move(problem)), random_(random), run_(run),
          f_(term_rows(problem_.f, problem_.variables, run)),
          g_(term_rows(problem_.g, problem_.variables, run)) {
        const std::size_t main = problem_.variables.front();
        const Polynomial lead_f = leading_coefficient(problem_.f, main);
        const Polynomial lead_g = leading_coefficient(problem_.g, main);
        Polynomial gamma = gcd(lead_f, lead_g, run);
        if (gamma.ring().field().is_rationals()) {
            const Integer common =
                gcd(Integer(lead_f.content().get_num()), Integer(lead_g.content().get_num()));
            gamma = gamma.scaled(common.to_mpz());
        }
        gamma_ = term_rows(gamma, problem_.variables, run);
        degrees_.push_back(problem_.bounds.front());
        for (std::size_t k = 1; k < problem_.variables.size(); ++k) {
            const std::size_t v = problem_.variables[k];
            // γ/lc(h) divides the leading coefficients of the cofactors, so H is no higher than f and g.
            degrees_.push_back(std::min({problem_.bounds[k] + static_cast<std::size_t>(gamma.degree(v)),
                                         static_cast<std::size_t>(problem_.f.degree(v)),
                                         static_cast<std::size_t>(problem_.g.degree(v))}));
        }
    }

    std::optional<ModularImage> image(const PrimeField& field) override { return image_over(field); }
    std::optional<ModularImage> image(const GaloisField& field) override { return image_over(field); }
    void reset() override { support_.reset(); }

    /// Images with another degree fail.
    std::strong_ordering compare(const ModularImage& /*a*/, const ModularImage& /*b*/) const override {
        return std::strong_ordering::equal;
    }
    std::span<const std::size_t> variables() const override { return problem_.variables; }
    void exponents_of(std::size_t place, std::span<std::uint64_t> row) const override {
        std::ranges::copy(support_->row(place), row.begin());
    }
    Polynomial gcd_from(const Polynomial& multiple, base::Run& run) const override {
        return primitive_part(multiple, std::span(problem_.variables).first(1), run);
    }

  private:
    template <class Field>
    std::optional<ModularImage> image_over(const Field& field) {
        const SparseImage f = sparse_image(field, f_);
        const SparseImage g = sparse_image(field, g_);
        const SparseImage gamma = sparse_image(field, gamma_);
        SparseGcd<Field> interpolate(field, f, g, gamma, degrees_, random_, run_);
        ModularImage result;
        if (support_) {
            auto coefficients = interpolate.on_support(*support_);
            if (!coefficients) return std::nullopt;
            result.residues = *std::move(coefficients);
        } else {
            auto h = interpolate();
            if (!h) return std::nullopt;
            support_ = std::move(h->exponents);
            result.residues = std::move(h->coefficients);
        }
        for (std::size_t i = 0; i < support_->count; ++i) result.places.push_back(i);
        return result;
    }

    GcdProblem problem_;
    Random& random_;
    base::Run& run_;
    TermRows f_;
    TermRows g_;
    TermRows gamma_;
    std::vector<std::size_t> degrees_;    ///< bounds for H
    std::optional<ExponentRows> support_; ///< of H, from the first image
};

} // namespace

std::unique_ptr<ImageMethod> dense_method(GcdProblem problem, Random& random, base::Run& run) {
    return std::make_unique<DenseMethod>(std::move(problem), random, run);
}

std::unique_ptr<ImageMethod> sparse_method(GcdProblem problem, Random& random, base::Run& run) {
    return std::make_unique<SparseMethod>(std::move(problem), random, run);
}

} // namespace eliminant::algebra
