#pragma once

#include "reducer.hpp"

#include <cstdint>
#include <memory>

namespace eliminant::groebner {

/// The image modulo a word-size prime of a basis over ℤ, kept beside it: it tells quickly that an
/// S-polynomial very probably reduces to zero. It is a hint and never part of a proof.
class ModularShadow {
  public:
    /// Refers to all arguments.
    ModularShadow(const Basis<algebra::Integer>& basis, const Grading& grading, base::Run& run);

    /// Whether the S-polynomial of elements i and j reduces to zero modulo the prime. Throws LayoutTooNarrow.
    bool vanishes(std::size_t i, std::size_t j, const Word* lcm);
    /// The basis was widened.
    void reset() { shadow_.reset(); }

  private:
    struct Shadow {
        algebra::PrimeDomain domain;
        Basis<std::uint32_t> basis;
        std::unique_ptr<Reducer<algebra::PrimeDomain>> reducer;
    };
    /// Brings the image up to date; with another prime where this one divides a leading coefficient.
    void catch_up();
    bool append_image(const BasisElement<algebra::Integer>& element);

    const Basis<algebra::Integer>& basis_;
    const Grading& grading_;
    base::Run& run_;
    std::uint64_t prime_;
    std::unique_ptr<Shadow> shadow_;
};

} // namespace eliminant::groebner
