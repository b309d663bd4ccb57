#include "implicit/hypersurface.hpp"

#include "base/parallel.hpp"
#include "implicit/remaindering.hpp"

#include <algorithm>
#include <list>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::PrimeField;

ScaledProblem hypersurface_problem(const RationalMap& map, const algebra::Ring& ring, base::Run& run) {
    ScaledProblem scaled{{map, ring}, {}};
    RationalMap& target = scaled.problem.map;
    const Parts bottom = split(map.denominator, map.parameters, map.constants, run);
    const Parts unit = split(Polynomial::constant(map.ring, 1), map.parameters, map.constants, run);
    target.denominator = bottom.primitive;
    for (std::size_t i = 0; i + map.constants.size() < map.components.size(); ++i) {
        Parts top = split(map.components[i].numerator, map.parameters, map.constants, run);
        scaled.scales.push_back(quotient_of(top, map.components[i].over_denominator ? bottom : unit, run));
        target.components[i].numerator = std::move(top.primitive);
    }
    return scaled;
}

std::optional<HypersurfaceEquation> equation_from_images(const algebra::Ring& ring, std::uint64_t prime_bound,
                                                         const ImageModulo& image, base::Run& run) {
    constexpr std::uint64_t max_useless = 20; // primes
    std::list<Remaindering> attempts;
    std::optional<Polynomial> candidate;
    std::uint64_t used = 0;
    std::uint64_t useless = 0;
    for (std::uint64_t p = prime_bound; useless < max_useless;) {
        // The first prime goes alone: a method may learn from it. The images are taken in the sequence of
        // their primes, so the result does not depend on the number of threads.
        std::vector<PrimeField> fields;
        while (fields.size() < (used == 0 ? 1 : run.threads()))
            fields.emplace_back(p = algebra::previous_prime(p));
        run.report([&] {
            return base::Progress{"images modulo primes", used, 0, "prime " + std::to_string(p)};
        });
        std::vector<std::optional<Polynomial>> images(fields.size());
        base::parallel_for(run, fields.size(),
                           [&](std::size_t i, std::size_t) { images[i] = image(fields[i]); });
        for (const std::optional<Polynomial>& f : images) {
            ++used;
            if (!f || f->is_zero()) {
                ++useless;
                continue;
            }
            if (candidate && candidate->in_ring(f->ring()).monic() == *f)
                return HypersurfaceEquation{std::move(*candidate), used, {}};
            auto attempt =
                std::ranges::find_if(attempts, [&](const Remaindering& a) { return a.accepts({*f}); });
            if (attempt == attempts.end()) attempt = attempts.emplace(attempts.end(), ring);
            attempt->add({*f}, run);
            if (auto elements = attempt->reconstruct(run)) candidate = std::move(elements->front());
        }
    }
    return std::nullopt;
}

} // namespace eliminant::implicit
