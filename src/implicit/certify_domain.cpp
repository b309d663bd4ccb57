#include "implicit/certify_domain.hpp"

#include "algebra/random.hpp"
#include "eliminant/algebra/coefficients.hpp"
#include "eliminant/algebra/evaluation.hpp"
#include "eliminant/groebner/groebner_basis.hpp"
#include "implicit/roots_modulo.hpp"

#include <algorithm>
#include <numeric>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::PrimeField;
using algebra::Ring;
using Element = PrimeField::Element;

namespace {

constexpr std::size_t max_points = 3000; // N³/3 products to check them

std::optional<std::vector<std::uint64_t>> find_weights(const DomainMap& map, base::Run& run) {
    std::vector<std::uint64_t> weights(map.ring.variable_count(), 1);
    if (as_basis(map, weights)) return weights;
    algebra::Random random(run.seed());
    constexpr int attempts = 2000;
    for (int i = 0; i < attempts; ++i) {
        run.poll();
        for (std::size_t j = 0; j < weights.size(); ++j)
            weights[j] = j < map.parameter_count ? 1 + random.below(60) : 1;
        if (as_basis(map, weights)) return weights;
    }
    return std::nullopt;
}

/// Random points of the zeros of the relations modulo a prime.
class DomainPoints {
  public:
    DomainPoints(const DomainMap& map, const PrimeField& field, base::Run& run)
        : map_(map), field_(field), run_(run), random_(run.seed()),
          ring_(map.ring.with_field(algebra::CoefficientField::prime(field.characteristic()))) {
        for (const Polynomial& f : map.relations) relations_.push_back(f.in_ring(ring_));
    }

    std::optional<std::vector<Element>> next() {
        std::vector<Element> point(ring_.variable_count());
        for (Element& value : point) value = random_.below(field_.characteristic());
        std::vector<std::size_t> unknown(map_.parameter_count);
        std::iota(unknown.begin(), unknown.end(), std::size_t{0});
        for (std::size_t i = unknown.size(); i > 1; --i)
            std::swap(unknown[i - 1], unknown[random_.below(static_cast<Element>(i))]);
        unknown.resize(std::min(unknown.size(), map_.relations.size()));
        if (!solve(point, unknown)) return std::nullopt;
        return point;
    }

  private:
    /// Finds values for the unknown coordinates of a point, one after the other: a lexicographic basis tells
    /// those of the last one.
    bool solve(std::vector<Element>& point, std::vector<std::size_t>& unknown) {
        for (; !unknown.empty(); unknown.pop_back()) {
            const std::vector<Polynomial> system = with_values(point, unknown);
            if (system.empty()) return true; // whatever the values
            const std::size_t last = unknown.size() - 1;
            const Ring& ring = system.front().ring();
            const auto basis = groebner::groebner_basis(ring, system, {}, run_);
            const Polynomial& least = basis.elements.front();
            if (least.is_constant()) return false;
            algebra::dense::Vector f(static_cast<std::size_t>(least.degree(last)) + 1, 0);
            for (std::size_t i = 0; i < least.size(); ++i) {
                for (std::size_t j = 0; j < last; ++j)
                    if (least.exponent(i, j) != 0) return false; // not of dimension 0
                f[least.exponent(i, last)] = least.residue_terms().coefficients[i];
            }
            const std::vector<Element> values = roots(field_, std::move(f), random_, run_);
            if (values.empty()) return false;
            point[unknown.back()] = values[random_.below(static_cast<Element>(values.size()))];
        }
        return true;
    }

    /// The relations in the unknown coordinates, without zeros.
    std::vector<Polynomial> with_values(const std::vector<Element>& point,
                                        const std::vector<std::size_t>& unknown) {
        std::vector<std::string> names;
        for (const std::size_t i : unknown) names.push_back(ring_.names()[i]);
        const Ring ring(ring_.field(), std::move(names), algebra::MonomialOrder::lex());
        std::vector<Polynomial> images;
        for (std::size_t i = 0; i < point.size(); ++i) {
            const auto place = std::ranges::find(unknown, i);
            images.push_back(
                place == unknown.end()
                    ? Polynomial::constant(ring, mpq_class(point[i]))
                    : Polynomial::variable(ring, static_cast<std::size_t>(place - unknown.begin())));
        }
        std::vector<Polynomial> system;
        for (const Polynomial& f : relations_) system.push_back(compose(f, ring, images, run_));
        std::erase_if(system, [](const Polynomial& f) { return f.is_zero(); });
        return system;
    }

    const DomainMap& map_;
    PrimeField field_;
    base::Run& run_;
    algebra::Random random_;
    Ring ring_;
    std::vector<Polynomial> relations_;
};

/// Points for a claim, modulo its prime. \param lower_degree as for refutation()
bool find_points(const DomainMap& map, DomainClaim& claim, std::optional<std::uint64_t> lower_degree,
                 base::Run& run) {
    const PrimeField field(claim.prime);
    const DomainModulo domain(map, field);
    DomainPoints points(map, field, run);
    std::optional<IndependentPoints> independent;
    if (lower_degree) independent.emplace(field, map.numerators.size(), *lower_degree);
    const std::size_t needed = independent ? independent->needed() : 1;
    for (std::size_t useless = 0; claim.points.size() < needed;) {
        run.poll();
        const auto point = points.next();
        const bool is_good = point && domain.rank_at(*point, run) == std::optional<std::size_t>(claim.rank) &&
                             (!independent || independent->add(domain.image(*point, run)));
        if (is_good)
            claim.points.push_back(*point);
        else if (++useless > (claim.points.empty() ? 30 : 200 + 20 * needed))
            return false;
    }
    return true;
}

/// Modulo some prime: a domain like s² = 2 has no points modulo half of them.
std::optional<DomainClaim> domain_claim(const DomainMap& map, const std::vector<std::uint64_t>& weights,
                                        std::size_t rank, std::optional<std::uint64_t> lower_degree,
                                        base::Run& run) {
    if (lower_degree && monomial_count(map.numerators.size(), *lower_degree, max_points) == max_points)
        return std::nullopt;
    constexpr int attempts = 30;
    DomainClaim claim{weights, DomainModulo::prime_bound, rank, {}};
    for (int i = 0; i < attempts; ++i) {
        claim.prime = algebra::previous_prime(claim.prime);
        claim.points.clear();
        if (find_points(map, claim, lower_degree, run)) return claim;
    }
    return std::nullopt;
}

} // namespace

std::variant<Claims, NoClaims> domain_claims(const DomainMap& map, std::span<const Polynomial> equations,
                                             std::size_t codimension, base::Run& run) {
    const std::size_t n = map.numerators.size();
    if (codimension > n) return NoClaims{"the image is empty"};
    const auto weights = find_weights(map, run);
    const auto basis = weights ? as_basis(map, *weights) : std::nullopt;
    if (!basis)
        return NoClaims{"the relations are no Groebner basis in any order tried, so that membership in their "
                        "ideal cannot be checked by division"};
    Claims claims;
    claims.codimension = codimension;
    for (const Polynomial& f : equations) {
        claims.degrees.push_back(algebra::degree_in_first(f, n));
        if (!vanishes(map, f, *basis, run))
            return NoClaims{"an equation is zero on the domain, but not by a combination of the relations"};
    }
    const std::size_t rank = n - codimension;
    if (equations.size() == 1) {
        claims.theorem = Theorem::hypersurface;
        claims.domain = domain_claim(map, *weights, rank, claims.degrees.front() - 1, run);
        if (claims.domain) return claims;
    }
    claims.theorem = equations.empty() ? Theorem::dense : Theorem::elimination;
    claims.domain = domain_claim(map, *weights, rank, std::nullopt, run);
    if (!claims.domain) return NoClaims{"no smooth points of the domain were found"};
    return claims;
}

} // namespace eliminant::implicit
