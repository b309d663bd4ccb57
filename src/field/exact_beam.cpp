#include "exact_beam.hpp"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace eliminant::field {
namespace {

using Coefficients = std::vector<mpz_class>;

bool is_ray(const BeamForms& forms) {
    return std::ranges::all_of(forms, [](const LinearForm& form) { return form.u == 0 && form.v == 0; });
}

/// The least common multiple of all denominators.
mpz_class common_denominator(const BeamForms& forms) {
    mpz_class result = 1;
    for (const LinearForm& form : forms)
        for (const mpq_class* part : {&form.constant, &form.u, &form.v, &form.w})
            mpz_lcm(result.get_mpz_t(), result.get_mpz_t(), part->get_den_mpz_t());
    return result;
}

/// The integer coefficients of f by exponents: (i, j, k) of x, y, z at start(i, j) + k; a null pointer is 0.
class Table {
  public:
    explicit Table(const algebra::Polynomial& f, std::size_t degree)
        : layout_(degree, false), entries_(layout_.size(), nullptr) {
        const std::size_t variables = f.ring().variable_count();
        const auto& terms = f.integer_terms();
        for (std::size_t i = 0; i < f.size(); ++i) {
            const auto exponent = [&](std::size_t variable) {
                return variable < variables ? static_cast<std::size_t>(f.exponent(i, variable)) : 0;
            };
            entries_[layout_.start(exponent(0), exponent(1)) + exponent(2)] = &terms.coefficients[i];
        }
    }
    const algebra::Integer* at(std::size_t x, std::size_t y, std::size_t z) const {
        return entries_[layout_.start(x, y) + z];
    }

  private:
    BeamLayout layout_;
    std::vector<const algebra::Integer*> entries_;
};

} // namespace

/// p, of total degree `degree`, times the form, in place: every coefficient collects what its lower
/// neighbours send, from the highest monomial down.
void ExactBeam::multiply(Coefficients& p, std::size_t degree, const IntegerForm& form) const {
    const std::size_t m = degree + 1;
    for (std::size_t k = m + 1; k-- > 0;)
        for (std::size_t b = layout_.rows(k, m) + 1; b-- > 0;)
            for (std::size_t a = layout_.columns(k, b, m) + 1; a-- > 0;) {
                mpz_class& c = p[layout_.start(k, b) + a];
                if (k + b + a <= degree) c *= form.constant;
                if (a > 0)
                    mpz_addmul(c.get_mpz_t(), p[layout_.start(k, b) + a - 1].get_mpz_t(), form.u.get_mpz_t());
                if (b > 0)
                    mpz_addmul(c.get_mpz_t(), p[layout_.start(k, b - 1) + a].get_mpz_t(), form.v.get_mpz_t());
                if (k > 0 && b <= layout_.rows(k - 1, m))
                    mpz_addmul(c.get_mpz_t(), p[layout_.start(k - 1, b) + a].get_mpz_t(), form.w.get_mpz_t());
            }
}

ExactBeam::ExactBeam(const algebra::Polynomial& f, const BeamForms& forms, base::Run& run)
    : layout_(static_cast<std::size_t>(std::max<std::int64_t>(f.total_degree(), 0)), is_ray(forms)),
      coefficients_(layout_.size()) {
    const std::size_t n = layout_.degree();
    const Table table(f, n);
    // Everything is homogeneous of degree n, so one positive factor of all forms changes nothing.
    const mpz_class denominator = common_denominator(forms);
    std::array<IntegerForm, 4> scaled;
    for (std::size_t i = 0; i < 4; ++i) {
        const auto integer = [&](const mpq_class& part) { return mpz_class(part * denominator); };
        scaled[i] = {integer(forms[i].constant), integer(forms[i].u), integer(forms[i].v),
                     integer(forms[i].w)};
    }
    std::vector<Coefficients> t_powers; // t^m
    t_powers.emplace_back(layout_.size())[0] = 1;
    for (std::size_t m = 0; m < n; ++m) {
        t_powers.push_back(t_powers.back());
        multiply(t_powers.back(), m, scaled[3]);
    }
    const auto add_multiple = [](Coefficients& p, const Coefficients& q, mpz_srcptr factor) {
        for (std::size_t i = 0; i < p.size(); ++i)
            if (q[i] != 0) mpz_addmul(p[i].get_mpz_t(), q[i].get_mpz_t(), factor);
    };
    const auto add = [](Coefficients& p, const Coefficients& q) {
        for (std::size_t i = 0; i < p.size(); ++i) p[i] += q[i];
    };
    // Σ_i x^i Σ_j y^j Σ_k z^k t^(n−i−j−k) c_ijk, Horner's scheme in x, y and z. A partial sum that lacks the
    // outer powers is homogeneous of the degree named beside it.
    Coefficients& in_x = coefficients_;
    for (std::size_t i = n + 1; i-- > 0;) {
        if (i < n) multiply(in_x, n - i - 1, scaled[0]); // degree n − i
        Coefficients in_y(layout_.size());
        for (std::size_t j = n - i + 1; j-- > 0;) {
            run.poll();
            if (j < n - i) multiply(in_y, n - i - j - 1, scaled[1]); // degree n − i − j
            Coefficients in_z(layout_.size());
            bool empty = true;
            for (std::size_t k = n - i - j + 1; k-- > 0;) {
                if (!empty) multiply(in_z, n - i - j - k - 1, scaled[2]); // degree n − i − j − k
                if (const algebra::Integer* c = table.at(i, j, k)) {
                    add_multiple(in_z, t_powers[n - i - j - k], algebra::Integer::View(*c));
                    empty = false;
                }
            }
            if (!empty) add(in_y, in_z);
        }
        add(in_x, in_y);
    }
}

bool ExactBeam::is_zero() const {
    return std::ranges::all_of(coefficients_, [](const mpz_class& c) { return c == 0; });
}

std::vector<mpz_class> ExactBeam::on_ray(const mpq_class& u, const mpq_class& v) const {
    // With u = U/D and v = V/D a monomial of degree m in (u, v) is multiplied by D^(n − m) to clear
    // fractions.
    const std::size_t n = layout_.degree();
    mpz_class denominator;
    mpz_lcm(denominator.get_mpz_t(), u.get_den_mpz_t(), v.get_den_mpz_t());
    const mpz_class numerator_u(u * denominator);
    const mpz_class numerator_v(v * denominator);
    std::vector<mpz_class> powers{1};
    for (std::size_t i = 0; i < n; ++i) powers.emplace_back(powers.back() * denominator);
    Coefficients result(n + 1);
    for (std::size_t k = 0; k <= n; ++k) {
        for (std::size_t b = layout_.rows(k, n) + 1; b-- > 0;) {
            const mpz_class* const row = &coefficients_[layout_.start(k, b)];
            mpz_class in_u = 0;
            const std::size_t last = layout_.columns(k, b, n);
            for (std::size_t a = last + 1; a-- > 0;) in_u = in_u * numerator_u + row[a] * powers[last - a];
            // in_u is cleared of D^last; the rest is cleared here, where v^b takes D^b.
            result[k] = result[k] * numerator_v + in_u * powers[n - b - last];
        }
    }
    return result;
}

} // namespace eliminant::field
