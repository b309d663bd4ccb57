#include "field/scheme_choice.hpp"

#include "eliminant/algebra/evaluation.hpp"

#include "field/arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

namespace eliminant::field {

namespace {

using algebra::Polynomial;

struct Candidate {
    EvaluationScheme scheme;
    JetProgram program;
};

/// f(center + q) in q; the center in doubles.
Polynomial expanded_at(const Polynomial& f, const std::array<double, 3>& center, base::Run& run) {
    std::vector<Polynomial> images;
    for (std::size_t i = 0; i < 3; ++i)
        images.push_back(Polynomial::variable(f.ring(), i) +
                         Polynomial::constant(f.ring(), mpq_class(center[i])));
    return algebra::compose(f, f.ring(), images, run);
}

std::array<double, 3> center_of(const Box& box) {
    std::array<double, 3> center{};
    for (int i = 0; i < 3; ++i) {
        const double middle = box.lower[i] + 0.5 * (box.upper[i] - box.lower[i]);
        center[static_cast<std::size_t>(i)] = std::isfinite(middle) ? middle : 0;
    }
    return center;
}

/// Error bound over value, at most 1.
double uncertainty_at(const JetProgram& program, const glm::dvec3& point) {
    const auto& c = program.center;
    const glm::dvec3 p(point.x - c[0], point.y - c[1], point.z - c[2]);
    const double value =
        ProgramKernel<PointArithmetic<double>>::value(program.view(), program.coefficients.data(), &p.x);
    const double r = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    double sum = 0;
    for (std::size_t k = program.majorant.size(); k-- > 0;) sum = sum * r + program.majorant[k];
    const double share = program.error_factor * sum / std::abs(value);
    return share < 1 ? share : 1; // also NaN
}

/// The same points for every polynomial.
std::vector<glm::dvec3> sample_of(const Box& box) {
    std::mt19937_64 random(1);
    std::vector<glm::dvec3> sample(64);
    for (glm::dvec3& point : sample)
        for (int i = 0; i < 3; ++i) {
            const double t = static_cast<double>(random() >> 11) * 0x1p-53;
            point[i] = (1 - t) * box.lower[i] + t * box.upper[i];
        }
    return sample;
}

Candidate candidate(SchemeKind kind, JetProgram program, std::span<const glm::dvec3> sample) {
    EvaluationScheme scheme{kind, static_cast<double>(program.operations), 0, program.description};
    for (const glm::dvec3& point : sample) scheme.uncertainty += uncertainty_at(program, point);
    scheme.uncertainty /= static_cast<double>(sample.size());
    return {std::move(scheme), std::move(program)};
}

/// Finding factors takes gcds; larger polynomials come from implicitization and have none.
constexpr std::size_t max_terms_to_factor = 5000;

std::optional<Formula> structure_of(const CompiledData& data, const std::optional<Formula>& formula,
                                    base::Run& run) {
    if (formula) return formula;
    if (data.degree < 2 || data.exact.size() < 2 || data.exact.size() > max_terms_to_factor)
        return std::nullopt;
    Formula found = obvious_factors(data.exact, run);
    if (found.kind == Formula::Kind::polynomial) return std::nullopt;
    return found;
}

} // namespace

std::string_view to_string(SchemeKind kind) {
    switch (kind) {
    case SchemeKind::horner:
        return "horner";
    case SchemeKind::taylor:
        return "taylor";
    case SchemeKind::structured:
        break;
    }
    return "structured";
}

void choose_scheme(CompiledData& data, const std::optional<Formula>& formula, const std::optional<Box>& box,
                   base::Run& run) {
    const std::vector<glm::dvec3> sample = sample_of(box.value_or(Box{glm::dvec3(-1), glm::dvec3(1)}));
    std::vector<Candidate> candidates;
    candidates.push_back(
        candidate(SchemeKind::horner,
                  expanded_program(data.exact, data.scale_exponent, data.scale_exponent_float, run), sample));
    // Coefficients of parts are not scaled.
    const bool is_moderate = data.scale_exponent == 0 && data.scale_exponent_float == 0;
    if (is_moderate)
        if (const auto structure = structure_of(data, formula, run))
            if (auto program = structured_program(*structure, run))
                candidates.push_back(candidate(SchemeKind::structured, *std::move(program), sample));
    if (box && data.degree > 0) {
        const std::array<double, 3> center = center_of(*box);
        const Polynomial at_center = expanded_at(data.exact, center, run);
        JetProgram program = expanded_program(at_center, data.scale_exponent, data.scale_exponent_float, run);
        program.center = center;
        // Each factor of a monomial has the rounding of the subtraction.
        program.error_factor += static_cast<double>(data.degree) * 0x1.1p-53;
        program.description += " from the center of the box";
        candidates.push_back(candidate(SchemeKind::taylor, std::move(program), sample));
    }
    std::ranges::stable_sort(candidates, {}, [](const Candidate& c) { return c.scheme.expected_cost(); });
    for (const Candidate& c : candidates) data.schemes.push_back(c.scheme);
    data.program = std::move(candidates.front().program);
    data.program_view = data.program.view();
}

} // namespace eliminant::field
