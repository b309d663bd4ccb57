// A program outside the project: it sees only the installed headers and library.
#include <eliminant/base/run.hpp>
#include <eliminant/base/version.hpp>

#include <gmpxx.h>

#include <iostream>

int main() {
    eliminant::Run run;
    run.request_stop();
    try {
        run.poll();
    } catch (const eliminant::Stopped& stopped) {
        std::cout << "eliminant " << eliminant::version_string << ": " << stopped.what() << ' '
                  << mpz_class(42) << '\n';
        return 0;
    }
    return 1;
}
