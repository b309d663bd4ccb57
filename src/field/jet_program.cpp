#include "field/jet_program.hpp"

#include "eliminant/algebra/arithmetic.hpp"
#include "eliminant/field/compiled_polynomial.hpp"

#include "field/exact_coefficients.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace eliminant::field {

namespace {

using algebra::Polynomial;

// Multiply-adds of the steps, see ProgramKernel; those of a leaf include what it stores.
constexpr std::size_t leaf_cost = jet_size;
constexpr std::size_t add_cost = jet_size;
constexpr std::size_t scale_cost = jet_size;
constexpr std::size_t multiply_cost = 31;
std::size_t power_cost(std::uint64_t exponent) { return 24 + 2 * std::bit_width(exponent); }

/// Parts larger than this together are never multiplied by each other: formulas stay far from overflow.
constexpr double max_amplification = 0x1p64;
constexpr unsigned max_depth = max_program_depth;

std::vector<Exponents> exponents_of(const Polynomial& f) {
    std::vector<Exponents> terms(f.size());
    for (std::size_t t = 0; t < f.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) terms[t][i] = static_cast<std::uint32_t>(f.exponent(t, i));
    return terms;
}

std::string description_of(const NestedScheme& scheme) {
    std::string text = "Horner in ";
    for (std::size_t level = 0; level < 3; ++level) {
        if (level > 0) text += ", ";
        text += "xyz"[scheme.coordinates[level]];
        if (scheme.powers[level] > 1) text.append("^").append(std::to_string(scheme.powers[level]));
    }
    return text;
}

/// What is known of the number that a step leaves on the stack.
struct Magnitude {
    std::vector<double> majorant = {};
    std::size_t roundings = 0;
    double amplification = 1;
};

/// More than a few hundred roundings of the sums here.
void enlarge(std::vector<double>& sums) {
    for (double& sum : sums) sum = sum * (1 + 0x1p-26) + 0x1p-900;
}

std::vector<double> product(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> result(a.size() + b.size() - 1);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < b.size(); ++j) result[i + j] += a[i] * b[j];
    enlarge(result);
    return result;
}

/// Puts a program together step by step, as it will run.
class Assembler {
  public:
    Assembler(int scale, int scale_float) : scale_(scale), scale_float_(scale_float) {}

    void push_leaf(const Polynomial& f, const base::Run& run) {
        const std::vector<Exponents> terms = exponents_of(f);
        NestedScheme scheme = make_nested_scheme(terms);
        const std::size_t first = program_.coefficients.size();
        resize(first + scheme.size);
        Magnitude magnitude;
        magnitude.majorant.assign(static_cast<std::size_t>(std::max<std::int64_t>(f.total_degree(), 0)) + 1,
                                  0);
        for (std::size_t t = 0; t < terms.size(); ++t) {
            run.poll();
            set(first + scheme.slots[t], f.coefficient(t));
            magnitude.majorant[terms[t][0] + terms[t][1] + terms[t][2]] +=
                program_.magnitudes[first + scheme.slots[t]];
        }
        enlarge(magnitude.majorant); // at most 2^24 additions each
        magnitude.roundings = scheme.roundings();
        magnitude.amplification = 0;
        for (const double sum : magnitude.majorant) magnitude.amplification += sum;
        program_.operations += scheme.cost();
        program_.description = description_of(scheme);
        program_.schemes.push_back(std::move(scheme));
        program_.leaves.push_back({program_.schemes.back().view(), static_cast<std::uint32_t>(first)});
        program_.steps.push_back({JetStep::leaf, static_cast<std::uint32_t>(program_.leaves.size() - 1)});
        stack_.push_back(std::move(magnitude));
    }
    void scale(const mpq_class& factor) {
        const std::size_t place = program_.coefficients.size();
        resize(place + 1);
        set(place, factor);
        program_.steps.push_back({JetStep::scale, static_cast<std::uint32_t>(place)});
        program_.operations += scale_cost;
        Magnitude& top = stack_.back();
        for (double& sum : top.majorant) sum *= program_.magnitudes[place];
        enlarge(top.majorant);
        top.roundings += 3;
        top.amplification *= std::max(1.0, program_.magnitudes[place]);
    }
    void add() {
        const Magnitude b = pop();
        Magnitude& a = stack_.back();
        a.majorant.resize(std::max(a.majorant.size(), b.majorant.size()), 0);
        for (std::size_t i = 0; i < b.majorant.size(); ++i) a.majorant[i] += b.majorant[i];
        enlarge(a.majorant);
        a.roundings = std::max(a.roundings, b.roundings) + 1;
        a.amplification += b.amplification;
        program_.steps.push_back({JetStep::add});
        program_.operations += add_cost;
    }
    void multiply() {
        const Magnitude b = pop();
        Magnitude& a = stack_.back();
        multiply(a, b);
        program_.steps.push_back({JetStep::multiply});
        program_.operations += multiply_cost;
    }
    void raise(std::uint64_t exponent) {
        Magnitude& top = stack_.back();
        const Magnitude base = top;
        // By squaring in any sequence: the number of roundings is that of the monomials.
        for (std::uint64_t i = 1; i < exponent; ++i) multiply(top, base);
        program_.steps.push_back({JetStep::to_power, static_cast<std::uint32_t>(exponent)});
        program_.operations += power_cost(exponent);
    }

    JetProgram finish() {
        const Magnitude& result = stack_.back();
        constexpr double unit = 0x1p-53;
        const double degree = static_cast<double>(result.majorant.size() - 1);
        // The last summands are the roundings of the bounds themselves.
        program_.error_factor =
            (static_cast<double>(result.roundings) + 4 * degree + 32) * unit * (1 + 0x1p-20);
        program_.majorant = result.majorant;
        program_.amplification = result.amplification;
        if (program_.leaves.size() == 1 && program_.steps.size() == 1) {
            program_.steps.clear();
            program_.amplification = 1;
        } else {
            program_.operations += leaf_cost * program_.leaves.size();
        }
        return std::move(program_);
    }
    double amplification() const { return stack_.back().amplification; }

  private:
    static void multiply(Magnitude& a, const Magnitude& b) {
        a.majorant = product(a.majorant, b.majorant);
        a.roundings += b.roundings + 5;
        a.amplification = std::max(a.amplification, 1.0) * std::max(b.amplification, 1.0);
    }
    Magnitude pop() {
        Magnitude result = std::move(stack_.back());
        stack_.pop_back();
        return result;
    }
    void resize(std::size_t size) {
        program_.coefficients.resize(size, 0);
        program_.magnitudes.resize(size, 0);
        program_.floats.resize(size, 0);
    }
    void set(std::size_t place, const mpq_class& c) {
        program_.coefficients[place] = to_double_double(times_power_of_two(c, -scale_)).high;
        program_.magnitudes[place] = std::abs(program_.coefficients[place]);
        program_.floats[place] = static_cast<float>(times_power_of_two(c, -scale_float_).get_d());
    }

    int scale_;
    int scale_float_;
    JetProgram program_;
    std::vector<Magnitude> stack_;
};

/// What a formula is to become.
struct Plan {
    Polynomial expanded;
    std::size_t cost = 0;
    unsigned depth = 1;
    Formula::Kind kind = Formula::Kind::polynomial; ///< a leaf
    std::vector<Plan> parts = {};
    std::uint64_t exponent = 1;
    mpq_class factor = 1;

    bool is_leaf() const { return kind == Formula::Kind::polynomial; }
};

/// Chooses for each part of a formula, from the smallest on, whether it is kept or expanded.
class Planner {
  public:
    explicit Planner(base::Run& run) : run_(run) {}

    Plan plan(const Formula& formula) {
        run_.poll();
        switch (formula.kind) {
        case Formula::Kind::polynomial:
            return leaf(formula.polynomial->scaled(formula.factor));
        case Formula::Kind::sum:
            return better(sum(formula));
        case Formula::Kind::product:
            return better(product(formula));
        case Formula::Kind::power:
            break;
        }
        return better(power(formula));
    }

  private:
    static Plan leaf(Polynomial f) {
        const std::size_t cost = make_nested_scheme(exponents_of(f)).cost() + leaf_cost;
        Plan result{std::move(f)};
        result.cost = cost;
        return result;
    }

    /// The plan, or that of a leaf.
    static Plan better(Plan kept) {
        if (kept.is_leaf()) return kept;
        Plan expanded = leaf(kept.expanded);
        return expanded.cost <= kept.cost || kept.depth > max_depth ? std::move(expanded) : std::move(kept);
    }

    Plan sum(const Formula& formula) {
        std::vector<Plan> kept;
        std::vector<Polynomial> to_expand;
        for (const Formula& part : formula.parts) {
            Plan plan_of_part = plan(part);
            if (plan_of_part.is_leaf())
                to_expand.push_back(std::move(plan_of_part.expanded));
            else
                kept.push_back(std::move(plan_of_part));
        }
        if (!to_expand.empty()) {
            Polynomial rest = total(std::move(to_expand));
            if (!rest.is_zero() || kept.empty()) kept.push_back(leaf(std::move(rest)));
        }
        std::vector<Polynomial> summands;
        for (const Plan& part : kept) summands.push_back(part.expanded);
        Plan result = combined(std::move(kept), total(std::move(summands)), add_cost);
        result.kind = result.parts.size() == 1 ? result.kind : Formula::Kind::sum;
        if (result.parts.size() == 1) {
            Plan only = std::move(result.parts.front());
            result = std::move(only);
        }
        return scaled(std::move(result), formula.factor);
    }

    Plan product(const Formula& formula) {
        std::vector<Plan> parts;
        Polynomial expanded = Polynomial::constant(ring_of(formula), 1);
        for (const Formula& part : formula.parts) {
            parts.push_back(plan(part));
            expanded = algebra::multiply(expanded, parts.back().expanded, run_);
        }
        Plan result = combined(std::move(parts), std::move(expanded), multiply_cost);
        result.kind = Formula::Kind::product;
        return scaled(std::move(result), formula.factor);
    }

    Plan power(const Formula& formula) {
        Plan base = plan(formula.parts.front());
        Plan result{algebra::pow(base.expanded, formula.exponent, run_)};
        result.kind = Formula::Kind::power;
        result.exponent = formula.exponent;
        result.cost = base.cost + power_cost(formula.exponent);
        result.depth = base.depth;
        result.parts.push_back(std::move(base));
        return scaled(std::move(result), formula.factor);
    }

    /// The deepest part comes first, while the stack is empty (Sethi and Ullman, J. ACM 17 (1970) 715–728).
    static Plan combined(std::vector<Plan> parts, Polynomial expanded, std::size_t step_cost) {
        Plan result{std::move(expanded)};
        std::ranges::stable_sort(parts, std::greater<>(), &Plan::depth);
        result.depth = 0;
        for (std::size_t i = 0; i < parts.size(); ++i) {
            result.cost += parts[i].cost + (i > 0 ? step_cost : 0);
            result.depth = std::max(result.depth, parts[i].depth + (i > 0 ? 1U : 0U));
        }
        result.parts = std::move(parts);
        return result;
    }

    /// A factor goes into the coefficients of a leaf if it can.
    static Plan scaled(Plan plan, const mpq_class& factor) {
        if (factor == 1) return plan;
        plan.expanded = plan.expanded.scaled(factor);
        if (plan.is_leaf()) return plan;
        if (plan.kind == Formula::Kind::product) {
            const auto part = std::ranges::find_if(plan.parts, &Plan::is_leaf);
            if (part != plan.parts.end()) {
                part->expanded = part->expanded.scaled(factor);
                return plan;
            }
        }
        plan.factor *= factor;
        plan.cost += scale_cost;
        return plan;
    }

    static algebra::Ring ring_of(const Formula& formula) {
        const Formula* f = &formula;
        while (!f->polynomial) f = &f->parts.front();
        return f->polynomial->ring();
    }

    /// In pairs, so that long sums take n log n.
    static Polynomial total(std::vector<Polynomial> summands) {
        while (summands.size() > 1) {
            const std::size_t half = (summands.size() + 1) / 2;
            for (std::size_t i = 0; i + half < summands.size(); ++i) summands[i] += summands[i + half];
            summands.erase(summands.begin() + static_cast<std::ptrdiff_t>(half), summands.end());
        }
        return std::move(summands.front());
    }

    base::Run& run_;
};

void assemble(Assembler& assembler, const Plan& plan, const base::Run& run) {
    if (plan.is_leaf()) return assembler.push_leaf(plan.expanded, run);
    for (std::size_t i = 0; i < plan.parts.size(); ++i) {
        assemble(assembler, plan.parts[i], run);
        if (i == 0) continue;
        if (plan.kind == Formula::Kind::sum)
            assembler.add();
        else
            assembler.multiply();
    }
    if (plan.kind == Formula::Kind::power) assembler.raise(plan.exponent);
    if (plan.factor != 1) assembler.scale(plan.factor);
}

std::string description_of(const Plan& plan) {
    if (plan.is_leaf()) return std::to_string(plan.expanded.size()) + " terms";
    const bool is_sum = plan.kind == Formula::Kind::sum;
    std::string text;
    for (const Plan& part : plan.parts) {
        if (!text.empty()) text += is_sum ? " + " : " * ";
        text.append("(").append(description_of(part)).append(")");
    }
    if (plan.kind == Formula::Kind::power) text.append("^").append(std::to_string(plan.exponent));
    return text;
}

} // namespace

ProgramView JetProgram::view() const {
    return {leaves.data(),
            steps.data(),
            steps.data() + steps.size(),
            {-center[0], -center[1], -center[2]},
            center != std::array<double, 3>{}};
}

double JetProgram::safe_radius() const {
    if (steps.empty()) return std::numeric_limits<double>::infinity();
    return std::exp2(900 / static_cast<double>(majorant.size()));
}

JetProgram expanded_program(const Polynomial& f, int scale, int scale_float, const base::Run& run) {
    Assembler assembler(scale, scale_float);
    assembler.push_leaf(f, run);
    return assembler.finish();
}

std::optional<JetProgram> structured_program(const Formula& formula, base::Run& run) {
    const Plan plan = Planner(run).plan(formula);
    if (plan.is_leaf()) return std::nullopt;
    Assembler assembler(0, 0);
    assemble(assembler, plan, run);
    if (!(assembler.amplification() <= max_amplification)) return std::nullopt;
    JetProgram program = assembler.finish();
    if (program.majorant.size() > static_cast<std::size_t>(CompiledPolynomial::max_degree) + 1)
        return std::nullopt;
    program.description = description_of(plan);
    return program;
}

} // namespace eliminant::field
