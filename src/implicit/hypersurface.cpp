#include "implicit/hypersurface.hpp"

#include "algebra/rational_lifting.hpp"
#include "base/parallel.hpp"

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

namespace {

/// Images of one shape, and the polynomial over ℚ behind them.
class Attempt {
  public:
    /// \param ring over ℚ
    /// \param image tells the shape
    Attempt(algebra::Ring ring, const Polynomial& image)
        : ring_(std::move(ring)), shape_(image), lifting_({image.size()}) {}

    /// Whether the image has the same leading monomial and no other terms; then it is added.
    bool take(const Polynomial& image) {
        auto residues = residues_of(image);
        if (!residues) return false;
        lifting_.add(image.ring().field().characteristic(), std::move(*residues));
        return true;
    }

    /// The polynomial, once there are enough images. When there are many it is tried only after some more.
    std::optional<Polynomial> lift(base::Run& run) {
        if (lifting_.prime_count() < next_trial_) return std::nullopt;
        next_trial_ = lifting_.prime_count() + 1 + lifting_.prime_count() / 64;
        if (!lifting_.lift(run)) return std::nullopt;
        const auto found = lifting_.take_vectors();
        algebra::PolynomialBuilder builder(ring_);
        std::vector<std::uint64_t> exponents(ring_.variable_count());
        for (std::size_t i = 0; i < shape_.size(); ++i) {
            for (std::size_t j = 0; j < exponents.size(); ++j) exponents[j] = shape_.exponent(i, j);
            builder.add(found[0].numerators[i], exponents);
        }
        return builder.build().primitive_part();
    }

  private:
    std::optional<std::vector<std::uint32_t>> residues_of(const Polynomial& image) const {
        std::vector<std::uint32_t> residues(shape_.size(), 0);
        std::size_t i = 0;
        for (std::size_t term = 0; term < image.size(); ++term, ++i) {
            while (i < shape_.size() && !is_term(i, image, term)) ++i;
            if (i == shape_.size()) return std::nullopt;
            residues[i] = image.residue_terms().coefficients[term];
        }
        if (residues.front() == 0) return std::nullopt;
        return residues;
    }

    bool is_term(std::size_t i, const Polynomial& image, std::size_t term) const {
        for (std::size_t j = 0; j < ring_.variable_count(); ++j)
            if (shape_.exponent(i, j) != image.exponent(term, j)) return false;
        return true;
    }

    algebra::Ring ring_;
    Polynomial shape_; ///< the first image: its monomials
    algebra::RationalLifting lifting_;
    std::size_t next_trial_ = 0;
};

} // namespace

std::optional<HypersurfaceEquation> equation_from_images(const algebra::Ring& ring, std::uint64_t prime_bound,
                                                         const ImageModulo& image, base::Run& run) {
    constexpr std::uint64_t max_useless = 20; // primes
    std::list<Attempt> attempts;
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
            auto attempt = std::ranges::find_if(attempts, [&](Attempt& a) { return a.take(*f); });
            if (attempt == attempts.end()) {
                attempt = attempts.emplace(attempts.end(), ring, *f);
                attempt->take(*f);
            }
            if (auto equation = attempt->lift(run))
                return HypersurfaceEquation{std::move(*equation), used, {}};
        }
    }
    return std::nullopt;
}

} // namespace eliminant::implicit
