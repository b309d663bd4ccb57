#pragma once

#include "eliminant/groebner/buchberger.hpp"

#include "modular_shadow.hpp"
#include "pair_queue.hpp"
#include "reducer.hpp"
#include "row_sums.hpp"

#include "eliminant/base/error.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace eliminant::groebner {

inline const TermList<std::uint32_t>& terms_of(const algebra::Polynomial& f, const algebra::PrimeDomain&) {
    return f.residue_terms();
}
inline const TermList<algebra::Integer>& terms_of(const algebra::Polynomial& f,
                                                  const algebra::IntegerDomain&) {
    return f.integer_terms();
}

/// One run of Buchberger's algorithm: the bookkeeping of elements and pairs, and the treatment of one pair at
/// a time, which an engine that treats many together overrides. The working layout starts as narrow as the
/// input allows and is widened, the step being repeated, whenever a monomial does not fit.
template <class Domain>
class Computation {
  public:
    using Element = typename Domain::Element;

    /// `by_degree`: whether selection normal goes by the degree of the lcm before its place in the order.
    Computation(const Domain& domain, const algebra::Ring& ring,
                std::span<const algebra::Polynomial> generators, const BuchbergerOptions& options,
                base::Run& run, bool by_degree)
        : domain_(domain), ring_(ring), options_(options), run_(run), grading_(options.grading),
          layout_(&working_layout(generators)), basis_(*layout_),
          queue_(options.selection, by_degree, grading_, run) {
        for (const algebra::Polynomial& f : generators) {
            algebra::require_same_ring(ring, f.ring(), "Groebner basis");
            if (!f.is_zero()) add_generator(f);
        }
    }

    /// Passes over S-polynomials that vanish modulo a prime, from the moment at which numbers become so long
    /// that this is cheaper than to reduce them, and to do so a second time for the proof.
    void use_shadow() requires(!Domain::is_field) { shadow_.emplace(basis_, grading_, run_); }

    GroebnerBasis run() {
        while (!queue_.empty() && !stopped_) {
            run_.poll();
            run_.report([this] { return progress(); });
            if (options_.degree_bound && queue_.best().degree > *options_.degree_bound) {
                queue_.remove_best();
                truncated_ = true;
                continue;
            }
            step();
        }
        if (!stopped_ && !truncated_) return complete_result();
        return incomplete_result();
    }

    virtual ~Computation() = default;
    Computation(const Computation&) = delete;
    Computation& operator=(const Computation&) = delete;

  protected:
    /// Treats the best pair, or several; whatever does not fit the layout stays in the queue.
    virtual void step() {
        const CriticalPair pair = queue_.best();
        widening_if_needed([&] { treat(pair); });
    }
    /// Reduces the tails of the elements of the minimal basis, given ascending by leading monomial.
    virtual void reduce_tails(std::span<const std::size_t> minimal) {
        for (const std::size_t i : minimal) {
            run_.poll();
            while (!widening_if_needed([&] { reduce_tail(i); })) {
            }
        }
    }
    /// The working layout was widened: forget what depends on it.
    virtual void layout_changed() {
        reducer_.reset();
        if (shadow_) shadow_->reset();
    }

    const MonomialLayout& working_layout(std::span<const algebra::Polynomial> generators) const {
        unsigned bits = 8;
        for (const algebra::Polynomial& f : generators) {
            if (f.ring() == ring_) bits = std::max(bits, f.layout().bits());
        }
        return ring_.layout(bits);
    }

    void add_generator(const algebra::Polynomial& f) {
        BasisElement<Element> element{
            widened(terms_of(f.primitive_part(), domain_), *layout_), {}, 0, 0, 0, 0, false};
        element.field_maxima.resize(layout_->words());
        layout_->pack_fields(element.terms.field_maxima(), element.field_maxima.data());
        queue_.add_generator(*layout_, static_cast<std::uint32_t>(generators_.size()),
                             element.terms.monomial(0));
        for (std::size_t i = 0; i < element.terms.size(); ++i)
            element.sugar = std::max(element.sugar, grading_.degree(*layout_, element.terms.monomial(i)));
        generators_.push_back(std::move(element));
    }

    virtual std::string_view name() const { return "Buchberger"; }
    base::Progress progress() const {
        return {name(), result_.statistics.pairs_treated, result_.statistics.pairs_treated + queue_.size(),
                "degree " + std::to_string(queue_.best().degree) + ", " + std::to_string(basis_.size()) +
                    " elements"};
    }

    /// Runs a step; false if it met a monomial that did not fit, with everything widened for the next try.
    template <class Step>
    bool widening_if_needed(Step&& step) {
        try {
            if (!reducer_) reducer_ = make_reducer(domain_, basis_, grading_, run_);
            std::forward<Step>(step)();
            return true;
        } catch (const LayoutTooNarrow&) {
            if (layout_->bits() == 64) throw OverflowError("Groebner basis: an exponent exceeds 2^63 - 1");
            layout_changed();
            const MonomialLayout& wide = ring_.layout(2 * layout_->bits());
            queue_.widen(*layout_, wide);
            for (BasisElement<Element>& f : generators_) {
                f.terms = widened(std::move(f.terms), wide);
                f.field_maxima.resize(wide.words());
                wide.pack_fields(f.terms.field_maxima(), f.field_maxima.data());
            }
            basis_.widen(wide);
            layout_ = &wide;
            return false;
        }
    }

    void treat(const CriticalPair& pair) {
        const bool is_generator = pair.first == CriticalPair::generator;
        if (shadow_ && numbers_are_long_ && !is_generator &&
            shadow_->vanishes(pair.first, pair.second, pair.lcm.data())) {
            ++result_.statistics.zero_modulo_prime;
            result_.proof = Proof::none;
            queue_.remove_best();
            return;
        }
        Reduction<Element> reduction = is_generator
                                           ? reducer_->polynomial(generators_[pair.second])
                                           : reducer_->s_polynomial(pair.first, pair.second, pair.lcm.data());
        const std::uint64_t own_sugar = is_generator ? generators_[pair.second].sugar : pair.sugar;
        queue_.remove_best();
        Statistics& statistics = result_.statistics;
        if (!is_generator) ++statistics.pairs_treated;
        statistics.reduction_steps += reduction.steps;
        if (reduction.terms.empty()) {
            if (!is_generator) ++statistics.zero_reductions;
            return;
        }
        insert(std::move(reduction.terms), std::max(own_sugar, reduction.sugar));
    }

    void insert(TermList<Element> terms, std::uint64_t sugar) {
        const auto added = static_cast<std::uint32_t>(basis_.size());
        const std::uint64_t cost = RowSums<Domain>::cost(terms.coefficients);
        const std::uint64_t degree = grading_.degree(*layout_, terms.monomial(0));
        numbers_are_long_ = numbers_are_long_ || cost > long_cost * terms.size();
        basis_.append(std::move(terms), sugar, degree, cost);
        ++result_.statistics.basis_elements_made;
        // Pairs that do not fit the layout make it wider before anything else happens.
        while (!widening_if_needed([&] { queue_.update(basis_, added, result_.statistics); })) {
        }
        mark_redundant(added);
        if (options_.stop_at && options_.stop_at(algebra::Polynomial::from_terms(ring_, basis_[added].terms)))
            stopped_ = true;
    }

    /// The elements whose leading monomials the new one's divides; or the new one itself, if it was not
    /// reduced by an older one.
    void mark_redundant(std::uint32_t added) {
        const MonomialLayout& layout = basis_.layout();
        for (std::uint32_t i = 0; i < added; ++i) {
            if (!basis_[i].redundant && layout.divides(basis_.lead(i), basis_.lead(added)))
                return basis_.mark_redundant(added);
        }
        for (std::uint32_t i = 0; i < added; ++i) {
            if (!basis_[i].redundant && layout.divides(basis_.lead(added), basis_.lead(i)))
                basis_.mark_redundant(i);
        }
    }

    /// Minimal basis, each element reduced by the smaller ones, which are reduced already.
    GroebnerBasis complete_result() {
        std::vector<std::size_t> minimal;
        for (std::size_t i = 0; i < basis_.size(); ++i) {
            if (!basis_[i].redundant) minimal.push_back(i);
        }
        std::ranges::sort(minimal, [this](std::size_t i, std::size_t j) {
            return basis_.layout().compare(basis_.lead(i), basis_.lead(j)) < 0;
        });
        reduce_tails(minimal);
        for (const std::size_t i : minimal) {
            run_.poll();
            result_.elements.push_back(
                algebra::Polynomial::from_terms(ring_, basis_.take_terms(i)).primitive_part());
        }
        return std::move(result_);
    }

    void reduce_tail(std::size_t i) {
        TermList<Element> terms = reducer_->tail(i).terms;
        const std::uint64_t cost = RowSums<Domain>::cost(terms.coefficients);
        basis_.replace(i, std::move(terms), cost);
    }

    GroebnerBasis incomplete_result() {
        result_.complete = false;
        for (std::size_t i = 0; i < basis_.size(); ++i)
            result_.elements.push_back(algebra::Polynomial::from_terms(ring_, basis_.take_terms(i)));
        return std::move(result_);
    }

    /// Cost per term (RowSums::cost: words, roughly) from which numbers count as long. With 2, cyclic-6 takes
    /// 18 ms instead of 58, henrion-5 130 instead of 400; noon-6 and eco-8, whose numbers stay short, would
    /// take twice as long with a second pass.
    static constexpr std::uint64_t long_cost = 2;

    Domain domain_;
    algebra::Ring ring_;
    const BuchbergerOptions& options_;
    base::Run& run_;
    Grading grading_;
    const MonomialLayout* layout_;
    Basis<Element> basis_;
    PairQueue queue_;
    std::vector<BasisElement<Element>> generators_;
    std::unique_ptr<Reducer<Domain>> reducer_;
    std::optional<ModularShadow> shadow_; ///< only over ℤ
    GroebnerBasis result_;
    bool numbers_are_long_ = false;
    bool stopped_ = false;
    bool truncated_ = false;
};

/// Throws DomainError if there is a grading that does not fit the ring.
inline void check_grading(const algebra::Ring& ring, const BuchbergerOptions& options) {
    if (!options.grading.empty() && options.grading.size() != ring.variable_count())
        throw DomainError("Groebner basis: the grading has " + std::to_string(options.grading.size()) +
                          " weights, the ring has " + std::to_string(ring.variable_count()) + " variables");
}

} // namespace eliminant::groebner
