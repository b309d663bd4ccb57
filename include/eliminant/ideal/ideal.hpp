/// \file
/// Ideals of polynomial rings: a value with generators and, computed when asked for, reduced Groebner bases.
#pragma once

#include "eliminant/algebra/polynomial.hpp"
#include "eliminant/base/run.hpp"

#include <memory>
#include <vector>

namespace eliminant::ideal {

/// An ideal of a polynomial ring over a field, given by generators; an immutable shared value.
///
/// Reduced Groebner bases are computed when first needed, one an order, and kept: copies of an ideal share
/// them. All members may be called from several threads at once; two threads that ask for the same missing
/// basis both compute it (neither can be stopped by the other's Run), and the first result is kept. A
/// computation that is stopped, or fails, leaves the kept bases as they were.
///
/// Conventions that need one: the zero ideal has no generators and the empty basis; the unit ideal has the
/// basis {1}. In a ring without variables these two are all.
class Ideal {
  public:
    /// The zero ideal.
    explicit Ideal(algebra::Ring ring);
    /// The ideal that the generators generate; zeros among them are dropped.
    /// \throws RingMismatchError if a generator is not of `ring`
    Ideal(algebra::Ring ring, std::vector<algebra::Polynomial> generators);
    /// The whole ring.
    static Ideal unit(const algebra::Ring& ring);

    const algebra::Ring& ring() const;
    /// As given, without zeros. Valid as long as any copy of the ideal.
    const std::vector<algebra::Polynomial>& generators() const&;
    std::vector<algebra::Polynomial> generators() &&;

    /// The reduced Groebner basis in the order of the ring, ascending by leading monomial; over ℚ primitive
    /// integer polynomials with positive leading coefficient, over GF(p) monic. Valid as long as any copy of
    /// the ideal.
    const std::vector<algebra::Polynomial>& groebner_basis(base::Run& run) const&;
    std::vector<algebra::Polynomial> groebner_basis(base::Run& run) &&;
    /// The same in another order: its elements are of `ring().with_order(order)`.
    /// \throws DomainError if the order does not fit the ring
    const std::vector<algebra::Polynomial>& groebner_basis(const algebra::MonomialOrder& order,
                                                           base::Run& run) const&;
    std::vector<algebra::Polynomial> groebner_basis(const algebra::MonomialOrder& order, base::Run& run) &&;

    /// A basis for questions whose answer does not depend on the order: the one of the ring's order if that
    /// order is graded, else the one of degrevlex, unless one that is kept already serves as well.
    const std::vector<algebra::Polynomial>& some_groebner_basis(base::Run& run) const&;

    /// Polynomials that generate the ideal, the ones to hand on to another computation: a kept basis in a
    /// cheap order if there is one (of `ring()` in that order), else generators().
    const std::vector<algebra::Polynomial>& known_generators() const&;

    /// The unique element of f + *this none of whose terms is a leading monomial of *this in the ring's
    /// order. 0 exactly for the elements of the ideal (Cox, Little, O'Shea, Ideals, Varieties, and
    /// Algorithms, §2.6).
    algebra::Polynomial normal_form(const algebra::Polynomial& f, base::Run& run) const;

    /// Whether f belongs to the ideal. It needs a basis in some order only, a cheap one if none is known.
    bool contains(const algebra::Polynomial& f, base::Run& run) const;
    /// Whether `other` is a subset.
    bool contains(const Ideal& other, base::Run& run) const;
    /// Whether both have the same elements.
    bool equals(const Ideal& other, base::Run& run) const;
    bool is_zero() const { return generators().empty(); } ///< Whether 0 is the only element.
    bool is_unit(base::Run& run) const;                   ///< Whether 1 is an element.
    /// Whether it has homogeneous generators (by total degree). No basis is needed if it is given by such.
    bool is_homogeneous(base::Run& run) const;

    /// For algorithms that come by a reduced Groebner basis themselves: the ideal it generates, with the
    /// basis kept. `basis` is of `ring.with_order(order)` and must be exactly what groebner_basis(order)
    /// would return; that is not checked, and answers are wrong if it is not so.
    static Ideal from_groebner_basis(const algebra::Ring& ring, const algebra::MonomialOrder& order,
                                     std::vector<algebra::Polynomial> basis);

  private:
    class State;
    explicit Ideal(std::shared_ptr<const State> state);

    std::shared_ptr<const State> state_;
};

} // namespace eliminant::ideal

namespace eliminant {
using ideal::Ideal;
} // namespace eliminant
