#include "eliminant/algebra/print.hpp"

#include <array>
#include <charconv>
#include <ostream>
#include <vector>

namespace eliminant::algebra {

namespace {

template <class Number>
void append_number(std::string& text, Number value) {
    std::array<char, 24> digits; // written before it is read
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text.append(digits.data(), end);
}

void append_integer(std::string& text, const Integer& value) {
    if (value.is_small())
        append_number(text, value.small_value());
    else
        text += value.to_string();
}

/// Appends terms `+c*m`, the sign of the first one only if it is a minus.
class TermPrinter {
  public:
    TermPrinter(const Polynomial& f, const base::Run& run)
        : f_(f), run_(run), exponents_(f.ring().variable_count()) {
        text_.reserve(f.size() * 16);
    }

    void append(std::size_t i, const Integer& numerator, const Integer& denominator) {
        run_.poll();
        if (i != 0 && numerator.sign() > 0) text_ += '+';
        f_.layout().decode(f_.packed_monomial(i), exponents_);
        bool is_first_factor = true;
        const bool is_monomial = !f_.layout().is_one(f_.packed_monomial(i));
        const bool is_unit = denominator.is_one() && (numerator.is_one() || (-numerator).is_one());
        if (is_unit && is_monomial) {
            if (numerator.sign() < 0) text_ += '-';
        } else {
            append_integer(text_, numerator);
            if (!denominator.is_one()) {
                text_ += '/';
                append_integer(text_, denominator);
            }
            is_first_factor = false;
        }
        for (std::size_t v = 0; v < exponents_.size(); ++v) {
            if (exponents_[v] == 0) continue;
            if (!is_first_factor) text_ += '*';
            is_first_factor = false;
            text_ += f_.ring().names()[v];
            if (exponents_[v] == 1) continue;
            text_ += '^';
            append_number(text_, exponents_[v]);
        }
    }
    std::string take() { return std::move(text_); }

  private:
    const Polynomial& f_;
    const base::Run& run_;
    std::vector<std::uint64_t> exponents_;
    std::string text_;
};

} // namespace

std::string to_string(const Polynomial& f) {
    const base::Run run;
    return to_string(f, run);
}

std::string to_string(const Polynomial& f, const base::Run& run) {
    if (f.is_zero()) return "0";
    TermPrinter printer(f, run);
    if (!f.ring().field().is_rationals()) {
        const auto& residues = f.residue_terms().coefficients;
        for (std::size_t i = 0; i < residues.size(); ++i) printer.append(i, Integer(residues[i]), Integer(1));
        return printer.take();
    }
    const auto& numerators = f.integer_terms().coefficients;
    const Integer& common = f.denominator();
    for (std::size_t i = 0; i < numerators.size(); ++i) {
        if (common.is_one()) {
            printer.append(i, numerators[i], common);
            continue;
        }
        const Integer divisor = gcd(numerators[i], common);
        Integer numerator = numerators[i];
        Integer denominator = common;
        numerator.divide_exactly(divisor);
        denominator.divide_exactly(divisor);
        printer.append(i, numerator, denominator);
    }
    return printer.take();
}

std::ostream& operator<<(std::ostream& out, const Polynomial& f) { return out << to_string(f); }
std::ostream& operator<<(std::ostream& out, const Ring& ring) { return out << ring.to_string(); }

} // namespace eliminant::algebra
