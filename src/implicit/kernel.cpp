#include "implicit/kernel.hpp"

#include "eliminant/base/error.hpp"
#include "implicit/remaindering.hpp"

#include <algorithm>
#include <exception>
#include <list>
#include <thread>
#include <utility>

namespace eliminant::implicit {

using algebra::Polynomial;

namespace {

constexpr std::uint64_t first_prime = algebra::PrimeField::max_characteristic;

/// The elements of the ideal of the graph, over some field, in the kept variables: a reduced basis, or the
/// first element.
struct KeptElements {
    std::vector<Polynomial> elements;
    groebner::Statistics statistics;
};

KeptElements kept_elements(const GradedMap& map, const algebra::Ring& ring, bool first_only, base::Run& run) {
    std::vector<Polynomial> generators;
    for (const Polynomial& f : map.generators) generators.push_back(f.in_ring(ring));
    groebner::BuchbergerOptions options;
    options.grading = map.weights;
    const auto is_kept = [&map](const Polynomial& f) { return map.is_kept(f); };
    if (first_only) options.stop_at = is_kept;
    groebner::GroebnerBasis basis = buchberger(ring, generators, options, run);
    if (!basis.complete) return {{basis.elements.back()}, basis.statistics};
    std::erase_if(basis.elements, [&](const Polynomial& f) { return !is_kept(f); });
    return {std::move(basis.elements), basis.statistics};
}

/// The kernels modulo some primes, each monic, at the same time. The first error of a thread is thrown again.
std::vector<KeptElements> kernels_modulo(const GradedMap& map, const std::vector<std::uint64_t>& primes,
                                         bool first_only, base::Run& run) {
    std::vector<KeptElements> kernels(primes.size());
    std::vector<std::exception_ptr> errors(primes.size());
    const auto compute = [&](std::size_t i) {
        try {
            const auto field = algebra::CoefficientField::prime(primes[i]);
            kernels[i] = kept_elements(map, map.ring.with_field(field), first_only, run);
            for (Polynomial& f : kernels[i].elements) f = f.monic();
        } catch (...) {
            errors[i] = std::current_exception();
        }
    };
    {
        std::vector<std::jthread> threads;
        for (std::size_t i = 1; i < primes.size(); ++i) threads.emplace_back(compute, i);
        compute(0);
    }
    for (const std::exception_ptr& error : errors)
        if (error) std::rethrow_exception(error);
    return kernels;
}

bool proves(const mpz_class& modulus, const GradedMap& map, const std::vector<Polynomial>& elements) {
    return std::ranges::all_of(
        elements, [&](const Polynomial& f) { return 2 * vanishing_bound(map, f).to_mpz() < modulus; });
}

/// log₂ of the greatest ∏ ‖φ(xᵢ)‖₁^eᵢ of a term of f: of vanishing_bound() without coefficients.
double bits_of_largest_image(const GradedMap& map, const Polynomial& f) {
    double largest = 0;
    for (std::size_t i = 0; i < f.size(); ++i) {
        double bits = 0;
        for (std::size_t variable = map.eliminated; variable < map.norms.size(); ++variable)
            bits += static_cast<double>(f.exponent(i, variable)) *
                    static_cast<double>(mpz_sizeinbase(Integer::View(map.norms[variable]), 2) - 1);
        largest = std::max(largest, bits);
    }
    return largest;
}

} // namespace

Kernel kernel_by_primes(const GradedMap& map, Codimension codimension, base::Run& run,
                        const EliminationEffort* known) {
    const bool first_only = codimension == Codimension::one_at_most;
    Kernel kernel;
    if (first_only) {
        // A generator Xᵢ − fᵢ^h without eliminated variables is irreducible, being linear in Xᵢ, so it
        // generates a principal prime. Modulo p it could be met before elements of lower degree.
        const auto kept =
            std::ranges::find_if(map.generators, [&](const Polynomial& f) { return map.is_kept(f); });
        if (kept != map.generators.end()) {
            kernel.generators.push_back(kept->primitive_part());
            return kernel;
        }
    }
    std::list<Remaindering> attempts;
    std::uint64_t p = first_prime + 1;
    for (;;) {
        // One prime is often enough, so the first goes alone; the primes are the same for every thread count.
        std::vector<std::uint64_t> primes(kernel.primes_used == 0 ? 1 : run.threads());
        for (std::uint64_t& prime : primes) prime = p = algebra::previous_prime(p);
        run.report([&] {
            return Progress{"elimination modulo primes", kernel.primes_used, 0, "prime " + std::to_string(p)};
        });
        const bool is_known = known && kernel.primes_used == 0;
        for (const KeptElements& image : is_known ? std::vector{KeptElements{{known->image}, {}}}
                                                  : kernels_modulo(map, primes, first_only, run)) {
            ++kernel.primes_used;
            kernel.statistics += image.statistics;
            if (image.elements.empty()) return kernel; // N(p) = 0, so N = 0
            auto attempt = std::ranges::find_if(
                attempts, [&](const Remaindering& a) { return a.accepts(image.elements); });
            if (attempt == attempts.end()) attempt = attempts.emplace(attempts.end(), map.ring);
            attempt->add(image.elements, run);
            auto elements = attempt->reconstruct(run);
            if (!elements || !proves(attempt->modulus(), map, *elements)) continue;
            kernel.generators = std::move(*elements);
            return kernel;
        }
    }
}

std::optional<EliminationEffort> elimination_effort(const GradedMap& map, double max_products,
                                                    base::Run& run) {
    const auto ring = map.ring.with_field(algebra::CoefficientField::prime(first_prime));
    std::vector<Polynomial> generators;
    for (const Polynomial& f : map.generators) generators.push_back(f.in_ring(ring));
    std::vector<double> sizes;
    double products = 0;
    std::optional<Polynomial> kernel;
    groebner::BuchbergerOptions options;
    options.grading = map.weights;
    options.stop_at = [&](const Polynomial& f) {
        sizes.push_back(static_cast<double>(f.size()));
        products += sizes.back() * static_cast<double>(sizes.size()); // a step for each of the others
        if (map.is_kept(f)) kernel = f;
        return kernel || products > max_products;
    };
    const auto statistics = buchberger(ring, generators, options, run).statistics;
    if (!kernel) return std::nullopt;
    const auto median = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::ranges::nth_element(sizes, median);
    return EliminationEffort{static_cast<double>(statistics.reduction_steps) * *median,
                             bits_of_largest_image(map, *kernel), kernel->monic()};
}

Kernel kernel_over_rationals(const GradedMap& map, base::Run& run) {
    KeptElements kept = kept_elements(map, map.ring, false, run);
    return {std::move(kept.elements), 0, kept.statistics};
}

} // namespace eliminant::implicit
