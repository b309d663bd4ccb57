#pragma once

#include "basis.hpp"

#include "eliminant/base/run.hpp"

#include <gmpxx.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace eliminant::groebner {

/// Sums of rows, a row being a multiple coefficient·monomial·element of the basis: what has accumulated at
/// each monomial of a reduction. One type a domain, the same interface:
///
///     begin()                       a new reduction
///     add_row(element, q)           the terms that follow belong to q·element
///     add_term(cell, term)          adds q·(coefficient of that term) to a cell
///     collect(cell)                 the value of the cell, which is left empty
///     eliminate(value, element)     the q for which value + q·lc(element) = 0, scaling all the rest if
///     needed emit(value)                   the next coefficient of the result finish(coefficients) the
///     result, monic over GF(p), primitive over ℤ wants_collapse(), collapse()  whether scaling has blown up
///     the numbers, and the cure; see below
template <class Domain>
class RowSums;

/// Over GF(p) products are added up at once. A sum stays below p² < 2^62, so one comparison replaces the
/// division.
template <>
class RowSums<algebra::PrimeDomain> {
  public:
    using Element = std::uint32_t;
    struct Cell {
        std::uint64_t sum = 0;
    };

    RowSums(const algebra::PrimeDomain& domain, const base::Run&)
        : field_(domain.field),
          square_(static_cast<std::uint64_t>(domain.field.characteristic()) * domain.field.characteristic()) {
    }

    void begin() { result_.clear(); }
    void add_row(const BasisElement<Element>& element, Element q) {
        coefficients_ = element.terms.coefficients.data();
        q_ = q;
    }
    void add_term(Cell& cell, std::size_t term) {
        const std::uint64_t sum = cell.sum + static_cast<std::uint64_t>(q_) * coefficients_[term];
        cell.sum = sum >= square_ ? sum - square_ : sum;
    }
    Element collect(Cell& cell) {
        const Element value = field_.reduce(cell.sum);
        cell.sum = 0;
        return value;
    }
    Element eliminate(Element value, const BasisElement<Element>&) const {
        return field_.negate(value);
    } // monic
    void emit(Element value) { result_.push_back(value); }
    void finish(std::vector<Element>& coefficients) {
        if (!result_.empty() && result_.front() != 1) {
            const Element inverse = field_.inverse(result_.front());
            for (Element& c : result_) c = field_.multiply(c, inverse);
        }
        coefficients.swap(result_);
    }
    static constexpr bool wants_collapse() { return false; }
    void collapse(const std::vector<Element>&) {}
    static std::uint64_t cost(const std::vector<Element>& coefficients) { return coefficients.size(); }

  private:
    algebra::PrimeField field_;
    std::uint64_t square_;
    const Element* coefficients_ = nullptr;
    Element q_ = 0;
    std::vector<Element> result_;
};

/// Over ℤ a cell only lists its products, and the sum is formed when its monomial is reached. So when a step
/// needs the pending rows multiplied by a number, that is one multiplication a row, not one a term; and every
/// product is computed once, at its final size. (The idea is that of lazily scaled quotients in Monagan and
/// Pearce 2011.)
///
/// The price is that a common content of all that is pending stays unseen: on cyclic-6 numbers of 5,000 bits
/// hid results of 400. So once the scale has grown much, everything is evaluated and divided by its content.
///
///     cell ──▶ node (row, term) ──▶ node ──▶ …         nodes are recycled when a cell is collected
///     rows     | element, q, terms still pending | …
template <>
class RowSums<algebra::IntegerDomain> {
  public:
    using Element = algebra::Integer;
    struct Cell {
        std::uint32_t head = 0; ///< index of a node plus one
    };

    /// Polls `run`: a single product of long numbers can take milliseconds.
    RowSums(const algebra::IntegerDomain&, const base::Run& run) : run_(run) {}

    void begin();
    void add_row(const BasisElement<Element>& element, Element q) {
        rows_.push_back({element.terms.coefficients.data(), std::move(q), 0});
    }
    void add_term(Cell& cell, std::size_t term);
    Element collect(Cell& cell);
    Element eliminate(const Element& value, const BasisElement<Element>& element);
    void emit(Element value) { result_.push_back(std::move(value)); }
    void finish(std::vector<Element>& coefficients);
    bool wants_collapse() const { return scale_bits_ > collapse_bits_; }
    /// Takes the values of all pending cells (collected), divides them and the result so far by their common
    /// content and continues with a single row of them: term i of it is values[i].
    void collapse(std::vector<Element> values);
    static std::uint64_t cost(const std::vector<Element>& coefficients);

  private:
    struct Node {
        std::uint32_t row;
        std::uint32_t term;
        std::uint32_t next;
    };
    struct Row {
        const Element* coefficients;
        Element q;
        std::uint32_t pending;
    };
    /// Brings the result so far to the present scale.
    void settle_result();
    /// From here on (a position in result_) values carry this additional factor.
    struct Rescaling {
        std::size_t emitted_before;
        Element factor;
    };

    std::vector<Node> nodes_;
    std::uint32_t free_ = 0; ///< head of the list of recycled nodes
    std::vector<Row> rows_;
    std::vector<Element> result_;
    std::vector<Rescaling> rescalings_;
    std::size_t scale_bits_ = 0;    ///< by which rescaling has lengthened the numbers since the last collapse
    std::size_t collapse_bits_ = 0; ///< when the next one is due
    std::vector<Element> collapsed_; ///< coefficients of the single row after a collapse
    mpz_class large_sum_;
    const base::Run& run_;
};

} // namespace eliminant::groebner
