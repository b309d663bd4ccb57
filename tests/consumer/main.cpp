// A program outside the project: it sees only the installed headers and library.
#include <eliminant/algebra/print.hpp>
#include <eliminant/implicit/implicitize.hpp>

#include <iostream>
#include <string>

int main() {
    eliminant::Run run;
    const std::string text = "x = (1 - t^2)/(1 + t^2)\n"
                             "y = 2*t/(1 + t^2)\n";
    const auto curve = eliminant::parse_parametrization({text, "circle"}, run);
    const eliminant::ImplicitResult result = eliminant::implicitize(curve, {}, run);
    for (const eliminant::Polynomial& f : result.equations) std::cout << to_string(f) << '\n';
    return result.assurance == eliminant::Assurance::proved ? 0 : 1;
}
