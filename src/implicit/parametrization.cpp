#include "eliminant/implicit/parametrization.hpp"

#include "eliminant/algebra/arithmetic.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace eliminant::implicit {

using algebra::Polynomial;

namespace {

void require(bool condition, const std::string& message) {
    if (!condition) throw DomainError("parametrization: " + message);
}

} // namespace

Parametrization::Parametrization(algebra::Ring ring, std::vector<std::size_t> constants,
                                 std::vector<Coordinate> coordinates, std::vector<Rotation> rotations,
                                 std::vector<Polynomial> relations, std::vector<std::string> warnings)
    : ring_(std::move(ring)), constants_(std::move(constants)), coordinates_(std::move(coordinates)),
      rotations_(std::move(rotations)), relations_(std::move(relations)), warnings_(std::move(warnings)) {
    require(ring_.field().is_rationals(), "the coefficients are rational numbers");
    require(!coordinates_.empty(), "there is no coordinate");

    std::vector<char> is_constant(ring_.variable_count(), 0);
    for (const std::size_t index : constants_) {
        require(index < ring_.variable_count() && !is_constant[index],
                "the constants are distinct variables of the ring");
        is_constant[index] = 1;
    }
    for (std::size_t i = 0; i < ring_.variable_count(); ++i)
        if (!is_constant[i]) parameters_.push_back(i);

    std::set<std::size_t> bound;
    for (const auto& [cosine, sine] : rotations_) {
        for (const std::size_t index : {cosine, sine})
            require(index < ring_.variable_count() && !is_constant[index] && bound.insert(index).second,
                    "the rotations are pairs of distinct parameters");
    }

    base::Run run;
    const std::vector<Polynomial> circles = rotation_relations();
    std::set<std::string> names;
    for (const auto& [name, value] : coordinates_) {
        require(algebra::is_identifier(name), "'" + name + "' is not a name");
        require(names.insert(name).second, "the coordinate " + name + " is given twice");
        require(!ring_.index_of(name), name + " is a coordinate and a parameter or constant");
        algebra::require_same_ring(ring_, value.numerator.ring(), "parametrization");
        algebra::require_same_ring(ring_, value.denominator.ring(), "parametrization");
        require(!normal_form(value.denominator, circles, run).is_zero(),
                "the denominator of " + name + " is zero");
    }
    for (const Polynomial& relation : relations_)
        algebra::require_same_ring(ring_, relation.ring(), "parametrization");
    std::erase_if(relations_, [](const Polynomial& relation) { return relation.is_zero(); });
}

std::vector<Polynomial> Parametrization::rotation_relations() const {
    std::vector<Polynomial> result;
    for (const auto& [cosine, sine] : rotations_) {
        const Polynomial c = Polynomial::variable(ring_, cosine);
        const Polynomial s = Polynomial::variable(ring_, sine);
        result.push_back(c * c + s * s - Polynomial::constant(ring_, 1));
    }
    return result;
}

} // namespace eliminant::implicit
