#pragma once

#include "basis.hpp"

#include "eliminant/base/run.hpp"

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace eliminant::groebner {

/// A normal form and what it took.
template <class Element>
struct Reduction {
    TermList<Element>
        terms; ///< up to a factor: monic over GF(p), primitive with positive first coefficient over ℤ
    std::uint64_t sugar = 0; ///< counting the steps above the leading term
    std::uint64_t steps = 0; ///< multiples of basis elements that were subtracted
};

/// Degrees of monomials in a grading by positive weights (all 1 when empty).
class Grading {
  public:
    explicit Grading(std::vector<std::uint64_t> weights) : weights_(std::move(weights)) {}
    std::uint64_t degree(const MonomialLayout& layout, const Word* m) const {
        if (weights_.empty()) return layout.total_degree(m);
        std::uint64_t sum = 0;
        for (std::size_t v = 0; v < weights_.size(); ++v) sum += weights_[v] * layout.exponent(m, v);
        return sum;
    }

  private:
    std::vector<std::uint64_t> weights_;
};

/// Reduces polynomials by a basis that grows. It keeps what it learns about monomials from one reduction to
/// the next. All methods throw LayoutTooNarrow where a product does not fit, Stopped when the run is stopped,
/// and may be called again after either.
template <class Domain>
class Reducer {
  public:
    using Element = typename Domain::Element;

    virtual ~Reducer() = default;
    /// Normal form of the S-polynomial of elements i and j; `lcm` is that of their leading monomials.
    virtual Reduction<Element> s_polynomial(std::size_t i, std::size_t j, const Word* lcm) = 0;
    /// Normal form of any terms of the basis's layout.
    virtual Reduction<Element> polynomial(const BasisElement<Element>& f) = 0;
    /// Element i with its tail, all but the leading term, in normal form.
    virtual Reduction<Element> tail(std::size_t i) = 0;
};

/// A reducer for the present layout of the basis, specialised for its number of words. It refers to all
/// arguments.
std::unique_ptr<Reducer<algebra::PrimeDomain>> make_reducer(const algebra::PrimeDomain& domain,
                                                            const Basis<std::uint32_t>& basis,
                                                            const Grading& grading, base::Run& run);
std::unique_ptr<Reducer<algebra::IntegerDomain>> make_reducer(const algebra::IntegerDomain& domain,
                                                              const Basis<algebra::Integer>& basis,
                                                              const Grading& grading, base::Run& run);

} // namespace eliminant::groebner
