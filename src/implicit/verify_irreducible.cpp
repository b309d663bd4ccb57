#include "implicit/verify_irreducible.hpp"

#include "algebra/random.hpp"
#include "algebra/residue_classes.hpp"
#include "algebra/univariate_mod_p.hpp"
#include "eliminant/algebra/coefficients.hpp"
#include "implicit/verify_values.hpp"

#include <algorithm>
#include <numeric>

namespace eliminant::implicit {

using algebra::Polynomial;
using algebra::PrimeField;
namespace dense = algebra::dense;
using dense::Element;
using dense::Vector;

namespace {

constexpr std::uint64_t prime_bound = std::uint64_t{1} << 20;

} // namespace

namespace {

/// f on lines modulo one prime.
class Sections {
  public:
    Sections(const Polynomial& f, std::size_t coordinates, const PrimeField& field)
        : field_(field), degree_(algebra::degree_in_first(f, coordinates)), tree_(f),
          values_(tree_, f, field) {}

    Vector on(const SectionClaim& line, base::Run& run) {
        constexpr std::size_t lanes = ValuesModulo::lanes;
        Vector parameters(degree_ + 1);
        std::iota(parameters.begin(), parameters.end(), Element{0});
        Vector values;
        std::vector<ValuesModulo::Lanes> points(line.base.size());
        for (std::size_t first = 0; first < parameters.size(); first += lanes) {
            run.poll();
            for (std::size_t i = 0; i < points.size(); ++i)
                for (std::size_t lane = 0; lane < lanes; ++lane)
                    points[i][lane] =
                        field_.add(line.base[i], field_.multiply(line.direction[i],
                                                                 field_.reduce(std::uint64_t{first + lane})));
            const ValuesModulo::Lanes at = values_(points);
            values.insert(values.end(), at.begin(), at.end());
        }
        values.resize(parameters.size());
        Vector section = dense::interpolate<PrimeField>(field_, parameters, values);
        if (section.size() != parameters.size()) return {};
        dense::make_monic(field_, section);
        return section;
    }

  private:
    PrimeField field_;
    std::uint64_t degree_;
    ExponentTree tree_;
    ValuesModulo values_;
};

} // namespace

bool is_irreducible(const std::vector<std::uint32_t>& f, const PrimeField& field, base::Run& run) {
    if (f.size() < 2) return false;
    dense::ResidueClasses classes(field, f);
    Vector frobenius = {0, 1};
    for (std::size_t k = 1; 2 * k <= f.size() - 1; ++k) {
        run.poll();
        frobenius = classes.power(frobenius, field.characteristic());
        Vector difference = frobenius;
        difference.resize(std::max<std::size_t>(difference.size(), 2), 0);
        difference[1] = field.subtract(difference[1], 1);
        dense::trim(difference);
        if (dense::gcd(field, f, difference, run).size() != 1) return false;
    }
    return true;
}

std::optional<SectionClaim> irreducible_section(const Polynomial& f, std::size_t coordinates,
                                                base::Run& run) {
    const PrimeField field(algebra::previous_prime(prime_bound));
    const std::uint64_t attempts = 40 * (algebra::degree_in_first(f, coordinates) + 1);
    Sections sections(f, coordinates, field);
    algebra::Random random(run.seed());
    const std::size_t n = f.ring().variable_count();
    SectionClaim line{field.characteristic(), Vector(n), Vector(n, 0), {}};
    for (std::uint64_t i = 0; i < attempts; ++i) {
        for (Element& a : line.base) a = random.below(field.characteristic());
        for (std::size_t j = 0; j < coordinates; ++j)
            line.direction[j] = random.below(field.characteristic());
        line.section = sections.on(line, run);
        if (!line.section.empty() && is_irreducible(line.section, field, run)) return line;
    }
    return std::nullopt;
}

bool holds(const Polynomial& f, std::size_t coordinates, const SectionClaim& claim, base::Run& run) {
    const std::size_t n = f.ring().variable_count();
    if (claim.prime >= prime_bound || claim.prime == 2 || !algebra::is_prime(claim.prime)) return false;
    if (claim.base.size() != n || claim.direction.size() != n) return false;
    const auto too_large = [&](Element value) { return value >= claim.prime; };
    if (std::ranges::any_of(claim.base, too_large) || std::ranges::any_of(claim.direction, too_large))
        return false;
    for (std::size_t i = coordinates; i < n; ++i)
        if (claim.direction[i] != 0) return false;
    if (algebra::degree_in_first(f, coordinates) >= claim.prime)
        return false; // the points of interpolation differ
    const PrimeField field(claim.prime);
    const Vector section = Sections(f, coordinates, field).on(claim, run);
    return !section.empty() && section == claim.section && is_irreducible(section, field, run);
}

} // namespace eliminant::implicit
