#include "eliminant/implicit/implicitize.hpp"

#include "implicit/closure.hpp"
#include "implicit/cylinder.hpp"
#include "implicit/domain.hpp"
#include "implicit/hypersurface.hpp"
#include "implicit/kernel.hpp"
#include "implicit/map_degree.hpp"
#include "implicit/map_of.hpp"
#include "implicit/method_choice.hpp"
#include "implicit/toric_method.hpp"
#include "implicit/verify_hypersurface.hpp"

#include <utility>

namespace eliminant::implicit {

using algebra::MonomialOrder;
using algebra::Polynomial;

namespace {

constexpr const char* dense_warning = "the image is dense: no polynomial other than 0 vanishes on it";
constexpr const char* empty_warning =
    "the image is empty: the relations leave no parameter values at which all "
    "coordinates are defined";
constexpr std::string_view confirmation = "the equation was put together from images modulo primes whose "
                                          "product is 40 bits longer than each coefficient needs; no "
                                          "theorem bounds the error";
constexpr const char* closure_note =
    "the equations describe the closure of the image, which may contain (real) points that no parameter "
    "values reach";

/// Whether the image is closed because it is a graph: all parameters are coordinates, up to scale, and there
/// are no denominators.
bool is_graph(const Parametrization& parametrization, const ProjectiveMap& map) {
    if (!parametrization.relations().empty() || !parametrization.rotations().empty()) return false;
    if (!map.forms.front().is_constant()) return false;
    for (const std::size_t parameter : parametrization.parameters()) {
        const Polynomial t = Polynomial::variable(parametrization.ring(), parameter);
        bool occurs = false;
        bool is_coordinate = false;
        for (const Polynomial& form : map.forms) {
            occurs |= form.degree(parameter) > 0;
            is_coordinate |= form == t;
        }
        if (occurs && !is_coordinate) return false;
    }
    return true;
}

class Implicitization {
  public:
    Implicitization(const Parametrization& parametrization, const ImplicitizeOptions& options, base::Run& run)
        : parametrization_(parametrization), method_(options.method), assurance_(options.assurance),
          wants_degree_(options.parametrization_degree), run_(run),
          map_(over_common_denominator(parametrization, run)),
          hypersurface_ring_(closure_ring(parametrization, MonomialOrder::degrevlex())),
          several_ring_(closure_ring(parametrization, options.order)),
          result_{hypersurface_ring_,         {},           0, Method::groebner, Assurance::proved, {},
                  parametrization.warnings(), std::nullopt, {}} {}

    ImplicitResult compute() {
        if (parametrization_.relations().empty()) {
            without_relations();
            if (wants_degree_ && result_.method != Method::toric)
                result_.parametrization_degree = map_degree(map_of(parametrization_, run_), run_);
        } else {
            with_relations();
        }
        return std::move(result_);
    }

  private:
    void without_relations() {
        if (method_ == Method::automatic && by_exponents()) return;
        const std::size_t n = parametrization_.coordinates().size();
        const std::size_t dimension = dimension_at_least(parametrization_, map_, run_);
        if (dimension == n) {
            result_.proof =
                "the differential of the parametrization has full rank at a point modulo 2147483647";
            warn(dense_warning);
            return;
        }
        if (dimension + 1 == n && by_method_for_hypersurfaces()) return;
        const GradedMap graded = graded_map(parametrization_, map_, {});
        const auto codimension = dimension + 1 == n ? Codimension::one_at_most : Codimension::unknown;
        const Kernel kernel =
            kernel_by_primes(graded, codimension, run_, elimination_ ? &*elimination_ : nullptr);
        accept(graded, kernel);
        result_.proof =
            codimension == Codimension::one_at_most
                ? "the equations are the kernel of a graded map, which is principal, since the "
                  "differential of the parametrization has rank n - 1 at a point modulo 2147483647"
                : "the equations are the kernel of a graded map";
        result_.proof +=
            "; coefficients from images modulo primes whose product exceeds twice the bound of what "
            "has to vanish";
    }

    /// Whether the coordinates are terms, and their image a hypersurface.
    bool by_exponents() {
        const RationalMap map = map_of(parametrization_, run_);
        const auto terms = term_map(map);
        auto f = terms ? toric_equation(*terms, hypersurface_ring_) : std::nullopt;
        if (!f) return false;
        result_.equations.push_back(*std::move(f));
        result_.codimension = 1;
        result_.method = Method::toric;
        result_.proof = toric_theorem;
        if (wants_degree_) result_.parametrization_degree = toric_degree(*terms, map);
        if (!is_graph(parametrization_, map_)) result_.notes.emplace_back(closure_note);
        return true;
    }

    /// Whether a method for hypersurfaces, of those that may be tried, found the equation; it is proved.
    bool by_method_for_hypersurfaces() {
        const RationalMap map = map_of(parametrization_, run_);
        std::vector<Cylinder> cylinders; // each over the base of the one before
        std::vector<algebra::Ring> rings = {hypersurface_ring_};
        while (auto cylinder = as_cylinder(cylinders.empty() ? map : cylinders.back().base)) {
            rings.push_back(base_ring(*cylinder, rings.back()));
            cylinders.push_back(std::move(*cylinder));
        }
        const ScaledProblem scaled =
            hypersurface_problem(cylinders.empty() ? map : cylinders.back().base, rings.back(), run_);
        MethodChoice choice = methods_for(scaled.problem);
        result_.predicted = std::move(choice.costs);
        say(choice.reason);
        elimination_ = std::move(choice.elimination);
        for (const auto& method : choice.methods) {
            const std::string name(to_string(method->name()));
            const auto found = method->equation();
            if (!found) {
                say("the method " + name + " gave up");
                continue;
            }
            Polynomial f = with_scales(found->equation, scaled.scales, run_);
            for (std::size_t i = cylinders.size(); i-- > 0;) f = lifted(cylinders[i], f, rings[i], run_);
            if (assurance_ == Assurance::proved) {
                result_.claims = prove_hypersurface(map, f, run_);
                if (!result_.claims) {
                    say("what the method " + name + " found could not be proved");
                    continue;
                }
            }
            accept(std::move(f), method->name(), *found);
            return true;
        }
        return false;
    }

    /// What was asked for, or those that are expected to be faster than elimination.
    MethodChoice methods_for(const HypersurfaceProblem& problem) {
        if (method_ != Method::automatic) return method_asked_for(method_, problem, run_);
        return choose_method(
            problem, [this] { return graded_map(parametrization_, map_, {}); }, run_);
    }

    void accept(Polynomial f, Method method, const HypersurfaceEquation& found) {
        result_.equations.push_back(std::move(f));
        result_.codimension = 1;
        result_.method = method;
        result_.assurance = assurance_;
        result_.proof = assurance_ == Assurance::proved ? hypersurface_theorem : confirmation;
        say(found.how);
        result_.statistics.primes_used = found.primes_used;
        if (!is_graph(parametrization_, map_)) result_.notes.emplace_back(closure_note);
    }

    void with_relations() {
        const auto domain = homogenized_domain(parametrization_, run_);
        if (!domain) {
            result_.equations = {Polynomial::constant(hypersurface_ring_, 1)};
            result_.codimension = parametrization_.coordinates().size() + 1;
            result_.proof = "the ideal of the domain is the unit ideal";
            warn(empty_warning);
            return;
        }
        const GradedMap graded = graded_map(parametrization_, map_, *domain);
        accept(graded, kernel_over_rationals(graded, run_));
        result_.proof = "the equations are the kernel of a graded map into a ring without nilpotent "
                        "elements, by a Groebner "
                        "basis over QQ";
    }

    void accept(const GradedMap& graded, const Kernel& kernel) {
        result_.statistics = {kernel.primes_used, kernel.statistics};
        if (kernel.generators.empty()) {
            warn(dense_warning);
            return;
        }
        const bool several = kernel.generators.size() > 1;
        if (several) result_.ring = several_ring_;
        std::vector<Polynomial> equations =
            dehomogenized(map_, graded, kernel.generators, result_.ring, run_);
        if (several) equations = reduced_closure_basis(parametrization_, result_.ring, equations, run_);
        if (several && equations.size() == 1) move_to_hypersurface_ring(equations);
        result_.codimension = closure_codimension(parametrization_, equations, run_);
        result_.equations = std::move(equations);
        if (!is_graph(parametrization_, map_)) result_.notes.emplace_back(closure_note);
    }

    /// A single equation is printed by degrevlex, whatever order was asked for several.
    void move_to_hypersurface_ring(std::vector<Polynomial>& equations) {
        result_.ring = hypersurface_ring_;
        equations.front() = equations.front().in_ring(hypersurface_ring_).primitive_part();
    }

    void say(const std::string& words) {
        if (!words.empty()) result_.choice.append(result_.choice.empty() ? "" : "; ").append(words);
    }

    void warn(const char* sentence) { result_.warnings.emplace_back(sentence); }

    const Parametrization& parametrization_;
    Method method_;       ///< as asked for
    Assurance assurance_; ///< that is enough
    bool wants_degree_;
    base::Run& run_;
    ProjectiveMap map_;
    algebra::Ring hypersurface_ring_;
    algebra::Ring several_ring_;
    std::optional<EliminationEffort> elimination_; ///< begun when the method was chosen
    ImplicitResult result_;
};

} // namespace

std::string_view to_string(Method method) {
    switch (method) {
    case Method::automatic:
        return "auto";
    case Method::toric:
        return "toric";
    case Method::groebner:
        return "groebner";
    case Method::linear:
        return "linear";
    case Method::resultant:
        return "resultant";
    }
    return "";
}

std::string_view to_string(Assurance assurance) {
    return assurance == Assurance::proved ? "proved" : "probable";
}

ImplicitResult implicitize(const Parametrization& parametrization, const ImplicitizeOptions& options,
                           base::Run& run) {
    return Implicitization(parametrization, options, run).compute();
}

} // namespace eliminant::implicit
