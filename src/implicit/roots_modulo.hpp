// Roots of univariate polynomials in a prime field.
#pragma once

#include "algebra/random.hpp"
#include "algebra/univariate_mod_p.hpp"
#include "eliminant/base/run.hpp"

#include <vector>

namespace eliminant::implicit {

/// The distinct roots of f in GF(p), p odd and f not zero: of gcd(f, t^p − t), which is split by its gcd with
/// (t + a)^((p−1)/2) − 1 for random a (Cantor and Zassenhaus 1981). O(d² log p) for degree d.
std::vector<algebra::dense::Element> roots(const algebra::PrimeField& field, algebra::dense::Vector f,
                                           algebra::Random& random, base::Run& run);

} // namespace eliminant::implicit
