#include "modular_shadow.hpp"

#include "row_sums.hpp"

#include <utility>

namespace eliminant::groebner {

ModularShadow::ModularShadow(const Basis<algebra::Integer>& basis, const Grading& grading, base::Run& run)
    : basis_(basis), grading_(grading), run_(run), prime_(algebra::PrimeField::max_characteristic) {}

bool ModularShadow::vanishes(std::size_t i, std::size_t j, const Word* lcm) {
    catch_up();
    return shadow_->reducer->s_polynomial(i, j, lcm).terms.empty();
}

void ModularShadow::catch_up() {
    if (!shadow_) {
        const algebra::PrimeDomain domain{algebra::PrimeField(prime_)};
        shadow_ = std::make_unique<Shadow>(Shadow{domain, Basis<std::uint32_t>(basis_.layout()), nullptr});
        shadow_->reducer = make_reducer(shadow_->domain, shadow_->basis, grading_, run_);
    }
    for (std::size_t i = 0; i < shadow_->basis.size(); ++i) {
        if (basis_[i].redundant) shadow_->basis.mark_redundant(i);
    }
    while (shadow_->basis.size() < basis_.size()) {
        if (append_image(basis_[shadow_->basis.size()])) continue;
        prime_ = algebra::previous_prime(prime_);
        shadow_.reset();
        catch_up();
        return;
    }
}

bool ModularShadow::append_image(const BasisElement<algebra::Integer>& element) {
    const algebra::PrimeField& field = shadow_->domain.field;
    const std::uint32_t lc = field.from_integer(element.terms.coefficients.front());
    if (lc == 0) return false;
    const std::uint32_t inverse = field.inverse(lc);
    TermList<std::uint32_t> image(basis_.layout());
    image.reserve(element.terms.size());
    for (std::size_t i = 0; i < element.terms.size(); ++i) {
        const std::uint32_t c = field.multiply(field.from_integer(element.terms.coefficients[i]), inverse);
        if (c != 0) image.push_back(element.terms.monomial(i), c);
    }
    const std::uint64_t cost = RowSums<algebra::PrimeDomain>::cost(image.coefficients);
    shadow_->basis.append(std::move(image), element.sugar, element.sugar - element.excess, cost);
    return true;
}

} // namespace eliminant::groebner
