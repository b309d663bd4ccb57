// Singular (the Debian package `singular`) as a second opinion: questions about ideals, answered by one run
// of it.
#pragma once

#include "eliminant/algebra/parse.hpp"
#include "support/random_ideals.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

namespace eliminant::testing {

/// Skips the test, loudly, where there is no Singular.
#define ELIMINANT_REQUIRE_SINGULAR()                                                                         \
    if (!std::filesystem::exists(eliminant::testing::Singular::program))                                     \
    GTEST_SKIP() << "NOTHING WAS COMPARED: Singular is not installed (Debian package singular)"

/// Collects questions, whose answers are ideals of their rings, and asks them all at once.
class Singular {
  public:
    static constexpr const char* program = "/usr/bin/Singular";

    /// `expression` is an ideal in Singular's language, the arguments being A, B, ….
    /// Returns the number of the question.
    std::size_t ask(const std::vector<Ideal>& arguments, const std::string& expression) {
        const Ring& ring = arguments.front().ring();
        const std::size_t number = rings_.size();
        rings_.push_back(ring);
        script_ << "ring r" << number << " = " << ring.field().characteristic() << ",(";
        write_list(ring.names(), std::identity());
        script_ << "),M(";
        write_list(order_matrix(ring), std::identity());
        script_ << ");\nshort = 0; option(redSB);\n";
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            script_ << "ideal " << static_cast<char>('A' + i) << " = 0";
            for (const Polynomial& f : arguments[i].generators()) script_ << "," << to_string(f);
            script_ << ";\n";
        }
        script_ << "ideal R = " << expression << ";\nfor (k = 1; k <= ncols(R); k++) { print(\"" << number
                << " \" + string(R[k])); }\n";
        return number;
    }

    /// The generators that Singular names, nonzero, normalised and ascending: where the question asked for
    /// std(…), the reduced Groebner basis. One list a question.
    std::vector<std::vector<Polynomial>> answers() {
        std::vector<std::vector<Polynomial>> result(rings_.size());
        std::istringstream lines(output());
        for (std::string line; std::getline(lines, line);) {
            std::istringstream fields(line);
            std::size_t number = 0;
            std::string polynomial;
            if (!(fields >> number >> polynomial) || number >= rings_.size())
                throw std::runtime_error("Singular says: " + line);
            const Polynomial f = parse_polynomial(rings_[number], {polynomial, "Singular"}).primitive_part();
            if (!f.is_zero()) result[number].push_back(f);
        }
        for (auto& basis : result) {
            std::ranges::sort(basis, [](const Polynomial& f, const Polynomial& g) {
                return f.leading_monomial() < g.leading_monomial();
            });
        }
        return result;
    }

  private:
    template <class Items, class Print>
    void write_list(const Items& items, Print&& print) {
        for (std::size_t i = 0; i < items.size(); ++i) script_ << (i == 0 ? "" : ",") << print(items[i]);
    }

    /// The order as the square matrix that Singular wants: of our sort keys those that earlier ones do not
    /// imply.
    static std::vector<std::int64_t> order_matrix(const Ring& ring) {
        const std::size_t n = ring.variable_count();
        std::vector<std::vector<mpq_class>> echelon;
        std::vector<std::int64_t> entries;
        for (const MonomialOrder::Key& key : ring.order().keys(n)) {
            std::vector<mpq_class> row;
            for (const std::uint64_t w : key.weights) row.emplace_back(static_cast<unsigned long>(w));
            for (const auto& other : echelon) {
                const auto pivot = std::ranges::find_if(other, [](const mpq_class& c) { return c != 0; });
                const mpq_class factor = row[static_cast<std::size_t>(pivot - other.begin())] / *pivot;
                for (std::size_t j = 0; j < n; ++j) row[j] -= factor * other[j];
            }
            if (std::ranges::all_of(row, [](const mpq_class& c) { return c == 0; })) continue;
            echelon.push_back(std::move(row));
            for (const std::uint64_t w : key.weights)
                entries.push_back(key.reversed ? -static_cast<std::int64_t>(w)
                                               : static_cast<std::int64_t>(w));
        }
        return entries;
    }

    std::string output() const {
        std::string path = (std::filesystem::temp_directory_path() / "eliminant_singular_XXXXXX").string();
        const int descriptor = mkstemp(path.data());
        if (descriptor < 0) throw std::runtime_error("cannot make the file " + path);
        close(descriptor);
        std::ofstream(path) << "LIB \"primdec.lib\";\n"
                            << saturation_procedure << "int k;\n"
                            << script_.str() << "exit;\n";
        // A script with an error makes some versions wait, or complain without end.
        std::ostringstream command;
        command << "timeout 100 " << program << " -q --no-rc " << path << " < /dev/null 2>&1";
        const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.str().c_str(), "r"), pclose);
        if (!pipe) throw std::runtime_error("cannot start Singular");
        std::string text;
        std::array<char, 4096> buffer{};
        while (std::fgets(buffer.data(), buffer.size(), pipe.get()) != nullptr) {
            text += buffer.data();
            if (text.find("   ? ") != std::string::npos) break; // an error message
        }
        std::filesystem::remove(path);
        return text;
    }

    /// By its definition: what Singular's own `sat` returns differs between its versions.
    static constexpr const char* saturation_procedure =
        "proc saturated(ideal I, ideal J) {\n"
        "    ideal K = std(quotient(I, J)); ideal L = std(I);\n"
        "    while (size(reduce(K, L)) > 0) { L = K; K = std(quotient(L, J)); }\n"
        "    return(L);\n}\n";

    std::vector<Ring> rings_;
    std::ostringstream script_;
};

} // namespace eliminant::testing
