#include "implicit/resultant_method.hpp"

#include "algebra/random.hpp"
#include "algebra/univariate_mod_p.hpp"
#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/algebra/gcd.hpp"
#include "implicit/line_fibres.hpp"
#include "implicit/line_interpolation.hpp"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

namespace eliminant::implicit {

namespace dense = algebra::dense;
using algebra::Integer;
using algebra::Polynomial;
using algebra::PrimeField;

namespace {

/// Beyond these the terms alone fill gigabytes.
constexpr std::int64_t max_fibre_size = 4000;
constexpr std::size_t max_surface_degree = 400;

/// A parameter that occurs only in powers of t^unit.
struct UsedParameter {
    std::size_t variable;
    std::uint64_t unit;
    std::int64_t degree; ///< in t^unit
};

/// f₀, …, fₙ over ℤ without common factor.
std::vector<Polynomial> forms_of(const RationalMap& map, base::Run& run) {
    std::vector<Polynomial> forms = {map.denominator};
    for (const auto& [numerator, over_denominator] : map.components)
        forms.push_back(over_denominator ? numerator : multiply(numerator, map.denominator, run));
    const Polynomial common = gcd(forms, run);
    if (!common.is_constant())
        for (Polynomial& form : forms) form = divide_exactly(form, common, run);
    return forms;
}

/// Each tᵏ that occurs being a power of t^unit, t^unit takes the place of t: the image is the same.
std::vector<UsedParameter> used_parameters(const std::vector<Polynomial>& forms) {
    std::vector<UsedParameter> result;
    for (std::size_t variable = 0; variable < forms.front().ring().variable_count(); ++variable) {
        UsedParameter parameter{variable, 0, 0};
        for (const Polynomial& form : forms) {
            parameter.degree = std::max(parameter.degree, form.degree(variable));
            for (std::size_t i = 0; i < form.size(); ++i)
                parameter.unit = std::gcd(parameter.unit, form.exponent(i, variable));
        }
        if (parameter.degree == 0) continue;
        parameter.degree /= static_cast<std::int64_t>(parameter.unit);
        result.push_back(parameter);
    }
    return result;
}

/// The form modulo p, in s = eliminated (if any) and t = hidden.
FormRows rows_of(const Polynomial& form, const PrimeField& field, const UsedParameter* eliminated,
                 const UsedParameter& hidden) {
    const auto length = [](const UsedParameter& parameter) {
        return static_cast<std::size_t>(parameter.degree) + 1;
    };
    FormRows rows(eliminated == nullptr ? 1 : length(*eliminated), Residues(length(hidden), 0));
    for (std::size_t i = 0; i < form.size(); ++i) {
        const std::uint64_t row =
            eliminated == nullptr ? 0 : form.exponent(i, eliminated->variable) / eliminated->unit;
        rows[row][form.exponent(i, hidden.variable) / hidden.unit] =
            field.from_fraction(form.integer_terms().coefficients[i], form.denominator());
    }
    return rows;
}

/// Replaces s by s + shift.
void shift_s(FormRows& rows, const PrimeField& field, Residue shift) {
    for (std::size_t i = 0; i + 1 < rows.size(); ++i)
        for (std::size_t k = rows.size() - 1; k-- > i;)
            dense::add_multiple<PrimeField>(field, rows[k], rows[k + 1], shift);
}

/// Replaces t by t + slope·s, in as many more rows as t has powers.
void shear(FormRows& rows, const PrimeField& field, Residue slope) {
    const std::size_t columns = rows.front().size();
    rows.resize(rows.size() + columns - 1, Residues(columns, 0));
    for (std::size_t j = 0; j + 1 < columns; ++j)
        for (std::size_t k = columns - 1; k-- > j;)
            for (std::size_t i = rows.size(); i-- > 1;)
                rows[i][k] = field.add(rows[i][k], field.multiply(slope, rows[i - 1][k + 1]));
}

/// A birational change of the parameters of a surface that comes first and does not change the image, for
/// maps that are in special position to the method.
enum class Position {
    as_given,
    /// A projective transformation of s: where forms of highest degree in s are alike, leading minors of
    /// Bézout's matrix are zero, but not after it.
    infinity_moved,
    /// (s, t + slope·s), and then the same: points of a fibre with equal t get different ones. The degree in
    /// s becomes the sum of both, so this is tried last.
    sheared,
};

class LineResultants : public ResultantMethod {
  public:
    LineResultants(const HypersurfaceProblem& problem, base::Run& run)
        : ring_(problem.ring), run_(run), forms_(forms_of(problem.map, run)),
          parameters_(used_parameters(forms_)) {
        // The parameter of lower degree is eliminated: the order of Bézout's matrix is its degree.
        std::ranges::stable_sort(parameters_, {}, &UsedParameter::degree);
    }

    Method name() const override { return Method::resultant; }

    std::optional<ResultantSizes> size_bounds() const override {
        if (parameters_.size() + 2 != forms_.size() || is_too_large()) return std::nullopt;
        const auto hidden = static_cast<std::size_t>(parameters_.back().degree);
        if (!is_surface()) return ResultantSizes{0, 0, hidden, hidden, hidden + 1};
        const auto eliminated = static_cast<std::size_t>(parameters_.front().degree);
        const std::size_t size = 2 * eliminated * hidden;
        return ResultantSizes{eliminated, size + 1, size, size, (size + 1) * (size + 2) / 2};
    }

    std::optional<ResultantSizes> sizes() override {
        if (!has_learned_) learn();
        if (!shape_) return std::nullopt;
        return ResultantSizes{is_surface() ? static_cast<std::size_t>(parameters_.front().degree) : 0,
                              shape_->nodes.count, shape_->fibre_size, shape_->degree, shape_->lines};
    }

    std::optional<HypersurfaceEquation> equation() override {
        if (!sizes()) return std::nullopt;
        auto result = equation_from_images(
            ring_, short_prime_bound, [this](const PrimeField& field) { return image(field); }, run_);
        if (result) result->how = description();
        return result;
    }

  private:
    /// What is the same for all lines and primes, but bad ones.
    struct Shape {
        SurfaceNodes nodes;     ///< for surfaces
        std::size_t fibre_size; ///< points that are taken to a line
        std::size_t degree;     ///< of the equation: how many points of the image that makes
        std::size_t lines;
    };

    static constexpr int attempts = 3; ///< against bad luck in random choices

    /// Finds the shape of the fibres, if the method is made for the map.
    void learn() {
        has_learned_ = true;
        if (parameters_.size() + 2 != forms_.size()) return;
        const PrimeField field(algebra::previous_prime(short_prime_bound));
        algebra::Random random(run_.seed());
        for (int i = 0; i < attempts; ++i) {
            for (const Position position :
                 {Position::as_given, Position::infinity_moved, Position::sheared}) {
                position_ = position;
                if (is_too_large() || (!is_surface() && position != Position::as_given)) continue;
                for (std::size_t choice = 0; choice < parameters_.size(); ++choice) {
                    if (learn_from_line(field, random)) return;
                    // Points of a fibre may have one parameter in common and not the other.
                    std::swap(parameters_.front(), parameters_.back());
                }
            }
        }
    }

    /// After learn(). May be called for several primes at the same time.
    std::optional<Polynomial> image(const PrimeField& field) const {
        algebra::Random random(run_.seed() + field.characteristic());
        for (int i = 0; i < attempts; ++i)
            if (auto equation = attempt(field, random)) return equation;
        return std::nullopt;
    }

    std::string description() const {
        return "resultants on " + std::to_string(shape_->lines) + " lines with fibres of " +
               std::to_string(shape_->fibre_size) + " points";
    }

    /// Whether fibres have more points than there is time for.
    bool is_too_large() const {
        std::int64_t eliminated = is_surface() ? parameters_.front().degree : 1;
        const std::int64_t hidden = parameters_.back().degree;
        if (eliminated > max_fibre_size || hidden > max_fibre_size) return true;
        if (position_ == Position::sheared) eliminated += hidden;
        return eliminated * hidden * (is_surface() ? 2 : 1) > max_fibre_size;
    }

    bool is_surface() const { return parameters_.size() == 2; }

    std::vector<FormRows> forms_modulo(const PrimeField& field, algebra::Random& random) const {
        const auto choose = [&] { return random.below(field.characteristic()); };
        const Residue slope = choose();
        const Residue before = choose();
        const Residue after = choose();
        std::vector<FormRows> forms;
        for (const Polynomial& form : forms_) {
            forms.push_back(
                rows_of(form, field, is_surface() ? &parameters_[0] : nullptr, parameters_.back()));
            if (position_ == Position::as_given) continue;
            if (position_ == Position::sheared) shear(forms.back(), field, slope);
            shift_s(forms.back(), field, before);
            std::ranges::reverse(forms.back()); // s becomes 1/s
            shift_s(forms.back(), field, after);
        }
        return forms;
    }

    Residues random_vector(const PrimeField& field, algebra::Random& random) const {
        Residues result;
        for (std::size_t i = 0; i < parameters_.size(); ++i)
            result.push_back(random.below(field.characteristic()));
        return result;
    }

    std::unique_ptr<LineFibres> fibres(const PrimeField& field, std::span<const FormRows> forms,
                                       std::span<const Residue> direction, SurfaceNodes nodes,
                                       algebra::Random& random) const {
        if (is_surface()) return surface_fibres(field, forms, direction, nodes, random(), run_);
        return curve_fibres(field, forms, direction, run_);
    }

    bool learn_from_line(const PrimeField& field, algebra::Random& random) {
        const std::vector<FormRows> forms = forms_modulo(field, random);
        SurfaceNodes nodes{0};
        if (is_surface()) {
            const auto needed = needed_nodes(field, forms, random(), run_);
            if (!needed) return false;
            nodes = *needed;
        }
        const Residues direction = random_vector(field, random);
        const auto maps = fibres(field, forms, direction, nodes, random);
        if (!maps) return false;
        const auto fibre = maps->over(random_vector(field, random));
        if (!fibre || !is_squarefree(field, fibre->algebra.modulus())) return false;

        const std::size_t size = fibre->algebra.dimension();
        const Residues heights = from_power_sums(field, fibre->algebra.traces_of_powers(fibre->height, size));
        const std::size_t degree = size - repeated_roots(field, heights);
        if (size % degree != 0) return false;
        if (is_surface() && degree > max_surface_degree) return false;
        const Residues zeros(parameters_.size(), 0);
        shape_ = Shape{nodes, size, degree, LineInterpolation(field, degree, zeros, zeros).line_count()};
        return true;
    }

    /// The degree of gcd(f, f′).
    std::size_t repeated_roots(const PrimeField& field, const Residues& f) const {
        Residues derivative;
        for (std::size_t i = 1; i < f.size(); ++i)
            derivative.push_back(field.multiply(f[i], field.reduce(i)));
        dense::trim(derivative);
        return dense::gcd(field, f, derivative, run_).size() - 1;
    }
    bool is_squarefree(const PrimeField& field, const Residues& f) const {
        return repeated_roots(field, f) == 0;
    }

    std::optional<Polynomial> attempt(const PrimeField& field, algebra::Random& random) const {
        const std::vector<FormRows> forms = forms_modulo(field, random);
        const Residues direction = random_vector(field, random);
        const auto maps = fibres(field, forms, direction, shape_->nodes, random);
        if (!maps) return std::nullopt;
        LineInterpolation interpolation(field, shape_->degree, direction, random_vector(field, random));
        const Residue inverse = field.inverse(field.reduce(shape_->fibre_size / shape_->degree));
        for (std::size_t line = 0; line < interpolation.line_count(); ++line) {
            run_.poll();
            const auto fibre = maps->over(interpolation.base(line));
            if (!fibre || fibre->algebra.dimension() != shape_->fibre_size) return std::nullopt;
            // Each point of the image is met fibre_size/degree times: so often its power sums are too large.
            Residues sums = fibre->algebra.traces_of_powers(fibre->height, shape_->degree);
            for (Residue& sum : sums) sum = field.multiply(sum, inverse);
            interpolation.set(line, from_power_sums(field, sums));
        }
        return polynomial_of(field, interpolation.terms());
    }

    Polynomial polynomial_of(const PrimeField& field,
                             const std::vector<LineInterpolation::Term>& terms) const {
        algebra::PolynomialBuilder builder(
            ring_.with_field(algebra::CoefficientField::prime(field.characteristic())));
        for (const auto& [exponents, coefficient] : terms) builder.add(Integer(coefficient), exponents);
        return builder.build().monic();
    }

    algebra::Ring ring_;
    base::Run& run_;
    std::vector<Polynomial> forms_;
    std::vector<UsedParameter> parameters_; ///< of a surface: the eliminated one, then the hidden one
    Position position_ = Position::as_given;
    bool has_learned_ = false;
    std::optional<Shape> shape_;
};

} // namespace

std::unique_ptr<ResultantMethod> resultant_method(const HypersurfaceProblem& problem, base::Run& run) {
    const std::size_t coordinates = problem.map.components.size();
    if (!problem.map.constants.empty() || (coordinates != 2 && coordinates != 3)) return nullptr;
    return std::make_unique<LineResultants>(problem, run);
}

} // namespace eliminant::implicit
