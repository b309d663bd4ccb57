#pragma once

#include "eliminant/algebra/arithmetic.hpp"

namespace eliminant::algebra {

/// How a product is computed. Every kernel gives the same result on every input it accepts; tests force each.
enum class ProductKernel {
    automatic, ///< by the cost model in multiply_plan.hpp
    heap,      ///< Johnson's heap: very sparse products
    window,    ///< dense accumulation in a sliding window: nearly everything else
    kronecker, ///< one multiplication of huge integers: dense products of large polynomials; refused for
               ///< huge exponents, where the others step in
    points,    ///< evaluation and interpolation: products that fill a simplex or box; refused as `kronecker`
};

/// Overrides of the cost model.
struct ProductOptions {
    ProductKernel kernel = ProductKernel::automatic;
    unsigned window_bits = 0; ///< log₂ of the cells of the window; 0 for the model's choice
};

/// multiply() with overrides.
Polynomial multiply_with(const Polynomial& a, const Polynomial& b, const ProductOptions& options,
                         base::Run& run);

} // namespace eliminant::algebra
