#pragma once

#include "gcd_problem.hpp"
#include "random.hpp"

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <compare>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace eliminant::algebra {

/// Coefficients of an image of (a multiple of) the gcd by places, which increase.
struct ModularImage {
    std::vector<std::size_t> places;
    std::vector<std::uint32_t> residues;
};

/// A method of finding images of a multiple H of the gcd, and the way back from H's coefficients to the gcd.
///
/// H is the same for every field, so that images modulo several primes can be put together.
class ImageMethod {
  public:
    ImageMethod() = default;
    ImageMethod(const ImageMethod&) = delete;
    ImageMethod& operator=(const ImageMethod&) = delete;
    virtual ~ImageMethod() = default;

    /// Nothing if the prime or the random choices were unlucky.
    virtual std::optional<ModularImage> image(const PrimeField& field) = 0;
    virtual std::optional<ModularImage> image(const GaloisField& field) = 0;
    /// After too many failures: forget what was learnt from earlier images.
    virtual void reset() = 0;
    /// Less or greater if the degrees of a are less or greater than those of b. Images of the gcd have the
    /// least degrees, unlucky ones are of proper multiples.
    virtual std::strong_ordering compare(const ModularImage& a, const ModularImage& b) const = 0;
    virtual std::span<const std::size_t> variables() const = 0;
    virtual void exponents_of(std::size_t place, std::span<std::uint64_t> row) const = 0;
    /// The normalised gcd from H.
    virtual Polynomial gcd_from(const Polynomial& multiple, base::Run& run) const = 0;
};

/// Brown's method; any two nonzero polynomials.
std::unique_ptr<ImageMethod> dense_method(GcdProblem problem, Random& random, base::Run& run);

/// Zippel's method; polynomials in at least two variables that are primitive with respect to the first.
std::unique_ptr<ImageMethod> sparse_method(GcdProblem problem, Random& random, base::Run& run);

} // namespace eliminant::algebra
