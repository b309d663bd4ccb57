#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace eliminant::field {

/// Where the coefficient of u^a·v^b·w^k stands in the dense array of a polynomial of total degree n; a ray
/// has no u and v.
///
///     w^0:  v^0: u^0 … u^n | v^1: u^0 … u^(n−1) | … | v^n: u^0      a triangle for each power of w,
///     w^1:  v^0: u^0 … u^(n−1) | … | v^(n−1): u^0                    each smaller by one
///     …
///     w^n:  v^0: u^0
class BeamLayout {
  public:
    BeamLayout(std::size_t degree, bool is_ray) : degree_(degree), spread_(is_ray ? 0 : degree) {
        starts_.resize((degree + 1) * (degree + 1));
        for (std::size_t k = 0; k <= degree; ++k)
            for (std::size_t b = 0; b <= rows(k, degree); ++b) {
                starts_[k * (degree + 1) + b] = size_;
                size_ += columns(k, b, degree) + 1;
            }
    }

    std::size_t degree() const { return degree_; }
    std::size_t size() const { return size_; }
    /// Index of v^b·w^k; the powers of u follow it.
    std::size_t start(std::size_t k, std::size_t b) const { return starts_[k * (degree_ + 1) + b]; }
    /// Largest power of v beside w^k in a polynomial of degree `m`.
    std::size_t rows(std::size_t k, std::size_t m) const { return std::min(spread_, m - k); }
    /// Largest power of u beside v^b·w^k.
    std::size_t columns(std::size_t k, std::size_t b, std::size_t m) const {
        return std::min(spread_, m - k - b);
    }

  private:
    std::size_t degree_;
    std::size_t spread_; ///< largest power of u and v
    std::size_t size_ = 0;
    std::vector<std::size_t> starts_;
};

} // namespace eliminant::field
