#include "pack_avx512.hpp"
#include "ray_stars_kernel.hpp"

namespace eliminant::field {

void detail::solve_stars_avx512(const StarPolynomial& f, const StarRays& rays, std::size_t first,
                                double* workspace) {
    solve_stars<Pack8>(f, rays, first, workspace);
}

} // namespace eliminant::field
