#include "eliminant/export/formats.hpp"

#include "eliminant/algebra/print.hpp"

#include "base/parallel.hpp"
#include "names.hpp"
#include "orders.hpp"

#include <numeric>
#include <utility>
#include <vector>

namespace eliminant::exporting {

namespace {

using algebra::Polynomial;
using algebra::Ring;

/// The same ring with names that are legal in a system, whose formulas are otherwise written as ours.
class Renamed {
  public:
    Renamed(const Ring& ring, Format format)
        : original_(ring), ring_(ring.field(), legal_names(ring, format), ring.order()),
          identity_(ring.variable_count()) {
        std::iota(identity_.begin(), identity_.end(), std::size_t{0});
    }

    const Ring& ring() const { return ring_; }
    std::string formula(const Polynomial& f, const base::Run& run) const {
        algebra::require_same_ring(original_, f.ring(), "export of polynomials");
        return original_.names() == ring_.names() ? to_string(f, run)
                                                  : to_string(f.in_ring(ring_, identity_), run);
    }
    /// One comment a replaced name.
    std::string comments(std::string_view comment_sign) const {
        std::string text;
        for (std::size_t i = 0; i < identity_.size(); ++i) {
            const std::string& now = ring_.names()[i];
            const std::string& before = original_.names()[i];
            if (now != before)
                text.append(comment_sign)
                    .append(" ")
                    .append(now)
                    .append(" stands for ")
                    .append(before)
                    .append("\n");
        }
        return text;
    }
    std::string names() const {
        std::string text;
        for (const std::string& name : ring_.names()) text.append(text.empty() ? "" : ",").append(name);
        return text;
    }

  private:
    Ring original_;
    Ring ring_;
    std::vector<std::size_t> identity_;
};

std::string latex_formula(const Polynomial& f, const base::Run& run) {
    if (f.is_zero()) return "0";
    const auto names = latex_names(f.ring());
    std::string text;
    for (std::size_t i = 0; i < f.size(); ++i) {
        run.poll();
        const mpq_class c = f.coefficient(i);
        const mpz_class numerator = abs(c.get_num());
        text += c < 0 ? "-" : i == 0 ? "" : "+";
        std::string monomial;
        for (std::size_t v = 0; v < names.size(); ++v) {
            const std::uint64_t e = f.exponent(i, v);
            if (e == 0) continue;
            // A command ends where no letter follows.
            if (!monomial.empty()) monomial += ' ';
            monomial += names[v];
            if (e != 1) monomial.append("^{").append(std::to_string(e)).append("}");
        }
        if (c.get_den() != 1)
            text.append("\\frac{")
                .append(numerator.get_str())
                .append("}{")
                .append(c.get_den().get_str())
                .append("}");
        else if (numerator != 1 || monomial.empty())
            text += numerator.get_str();
        if (!monomial.empty() && !text.empty() && text.back() != '-' && text.back() != '+') text += ' ';
        text += monomial;
    }
    return text;
}

std::string characteristic(const Ring& ring) { return std::to_string(ring.field().characteristic()); }

std::string declared_ring(const Renamed& renamed, Format format) {
    const Ring& ring = renamed.ring();
    const bool is_rational = ring.field().is_rationals();
    std::string text;
    switch (format) {
    case Format::singular:
        text = renamed.comments("//");
        return text.append("ring r = ")
            .append(characteristic(ring))
            .append(",(")
            .append(renamed.names())
            .append("),")
            .append(singular_order(ring))
            .append(";\n");
    case Format::macaulay2:
        text = renamed.comments("--");
        return text.append("R = ")
            .append(is_rational ? "QQ" : "ZZ/")
            .append(is_rational ? "" : characteristic(ring))
            .append("[")
            .append(renamed.names())
            .append(", MonomialOrder => ")
            .append(macaulay2_order(ring))
            .append("];\n");
    case Format::sage:
        text = renamed.comments("#");
        text.append("R.<")
            .append(renamed.names())
            .append("> = PolynomialRing(")
            .append(ring.field().to_string());
        // A ring of one variable is univariate in Sage and takes no order.
        if (ring.variable_count() > 1) text.append(", order=").append(sage_order(ring));
        return text.append(")\n");
    case Format::maple:
        text = renamed.comments("#");
        if (!is_rational)
            text.append("# over GF(p): give the commands characteristic=")
                .append(characteristic(ring))
                .append("\n");
        return text;
    default:
        return text;
    }
}

} // namespace

std::string formula(const Polynomial& f, Format format) {
    const base::Run run;
    return formula(f, format, run);
}

std::string formula(const Polynomial& f, Format format, const base::Run& run) {
    if (format == Format::text) return to_string(f, run);
    if (format == Format::latex) return latex_formula(f, run);
    return Renamed(f.ring(), format).formula(f, run);
}

std::string declared(const Polynomial& f, Format format) {
    const base::Run run;
    return declared(f, format, run);
}

std::string declared(const Polynomial& f, Format format, const base::Run& run) {
    if (format == Format::text) return to_string(f, run).append("\n");
    if (format == Format::latex) return std::string("\\[ ").append(latex_formula(f, run)).append(" \\]\n");
    const Renamed renamed(f.ring(), format);
    std::string text = declared_ring(renamed, format);
    const bool is_sage = format == Format::sage;
    text.append(format == Format::singular ? "poly f = " : format == Format::maple ? "f := " : "f = ");
    // A constant is a polynomial only where the ring says so.
    if (format == Format::macaulay2 || is_sage)
        return text.append(is_sage ? "R(" : "sub(")
            .append(renamed.formula(f, run))
            .append(is_sage ? ")\n" : ",R);\n");
    return text.append(renamed.formula(f, run)).append(";\n");
}

namespace {

/// The texts one after the other, behind `start`.
std::string joined(const std::vector<std::string>& texts, std::string_view separator,
                   std::string_view start = {}) {
    std::size_t size = start.size();
    for (const std::string& text : texts) size += text.size() + separator.size();
    std::string result;
    result.reserve(size);
    result.append(start);
    for (std::size_t i = 0; i < texts.size(); ++i) result.append(i == 0 ? "" : separator).append(texts[i]);
    return result;
}

} // namespace

std::string declared(const Ring& ring, std::span<const Polynomial> generators, Format format) {
    base::Run run;
    return declared(ring, generators, format, run);
}

std::string declared(const Ring& ring, std::span<const Polynomial> generators, Format format,
                     base::Run& run) {
    const Renamed renamed(ring, format);
    std::string text = declared_ring(renamed, format);
    // A basis can be a hundred megabytes: written on all threads, then copied once.
    const auto written = [&](auto&& print) {
        std::vector<std::string> formulas(generators.size());
        base::parallel_for(run, generators.size(),
                           [&](std::size_t i, std::size_t) { formulas[i] = print(generators[i]); });
        return formulas;
    };
    const auto list = [&](std::string_view separator, std::string_view of_none, auto&& print) {
        return generators.empty() ? std::string(of_none) : joined(written(print), separator);
    };
    const auto formula_of = [&](const Polynomial& f) { return renamed.formula(f, run); };
    const auto latex_of = [&](const Polynomial& f) { return latex_formula(f, run); };
    switch (format) {
    case Format::text:
        return generators.empty() ? text : joined(written(formula_of), "\n", text).append("\n");
    case Format::latex:
        return text.append("\\begin{align*}\n  & ")
            .append(list(" \\\\\n  & ", "0", latex_of))
            .append("\n\\end{align*}\n");
    case Format::singular:
        return text.append("ideal I =\n  ").append(list(",\n  ", "0", formula_of)).append(";\n");
    case Format::macaulay2: // sub: a list of constants alone would be an ideal of ZZ or QQ
        return text.append("I = sub(ideal(\n  ").append(list(",\n  ", "0", formula_of)).append("), R);\n");
    case Format::sage:
        return text.append("I = R.ideal([\n  ").append(list(",\n  ", "", formula_of)).append("])\n");
    case Format::maple:
        return text.append("F := [\n  ")
            .append(list(",\n  ", "", formula_of))
            .append("]:\nT := ")
            .append(maple_order(renamed.ring(), renamed.ring().names()))
            .append(":\n");
    }
    return text;
}

} // namespace eliminant::exporting
