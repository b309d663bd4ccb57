// verify() with polynomial arithmetic and nothing else: this program is linked from the objects of base and
// algebra, and those of verify and its certificates. It accepts a certificate written by hand, and rejects it
// with one coefficient changed.
#include "eliminant/implicit/verify.hpp"

int main() {
    using namespace eliminant;
    Certificate cusp;
    cusp.input.parameters = {"t"};
    cusp.input.coordinates = {{"x", "t^2"}, {"y", "t^3"}};
    cusp.equations = {"x^3-y^2"};
    cusp.claims.theorem = Theorem::hypersurface;
    cusp.claims.codimension = 1;
    cusp.claims.degrees = {3};
    cusp.claims.vanishing = {{{6}, 6, 2, {1073741789}}};
    cusp.claims.rank = {2147483647, {1}, 1, 2}; // the derivative of t² at 1
    // On x = t, y = 1 + 2t modulo 7, (x³ − y²) is t³ − 4t² − 4t − 1, which has no root.
    cusp.claims.irreducible = SectionClaim{7, {0, 1}, {1, 2}, {6, 3, 3, 1}};

    Run run;
    if (!verify(cusp, run).holds) return 1;
    cusp.equations = {"x^3-2*y^2"};
    return verify(cusp, run).holds ? 2 : 0;
}
