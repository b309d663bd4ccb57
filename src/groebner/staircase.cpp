#include "groebner/staircase.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace eliminant::groebner {

using algebra::Monomial;
using algebra::Polynomial;
using algebra::Ring;

class Staircase::Builder {
  public:
    Builder(std::span<const Polynomial> basis, base::Run& run)
        : basis_(basis), ring_(basis.front().ring()), n_(ring_.variable_count()), run_(run) {
        for (std::uint32_t i = 0; i < basis.size(); ++i) leads_.emplace(exponents_of(basis[i], 0), i);
    }

    bool has_all_powers() const {
        std::vector<bool> seen(n_, false);
        for (const auto& [lead, element] : leads_) {
            const auto occurs = [](std::uint64_t e) { return e != 0; };
            const auto first = std::ranges::find_if(lead, occurs);
            if (first == lead.end()) return true; // the unit ideal
            if (std::ranges::count_if(lead, occurs) == 1)
                seen[static_cast<std::size_t>(first - lead.begin())] = true;
        }
        return std::ranges::all_of(seen, [](bool s) { return s; });
    }

    bool find_standard_monomials(std::size_t limit) {
        // Degree by degree. A monomial is got once, from its quotient by its last variable; it is standard if
        // it is no leading monomial and its quotients by single variables are standard.
        std::vector<Exponents> level;
        if (Exponents one(n_, 0); !leads_.contains(one)) level.push_back(std::move(one));
        while (!level.empty()) {
            if (standard_.size() + level.size() > limit) return false;
            for (const Exponents& m : level) standard_.emplace(m, 0);
            std::vector<Exponents> next;
            for (Exponents& m : level) {
                run_.poll();
                for (std::size_t i = last_variable(m); i < n_; ++i) {
                    ++m[i];
                    if (is_standard(m)) next.push_back(m);
                    --m[i];
                }
            }
            level = std::move(next);
        }
        return true;
    }

    Staircase build() {
        Staircase result;
        result.size_ = standard_.size();
        number(standard_);
        for (const auto& [m, index] : standard_) {
            result.by_exponents_.push_back(m);
            result.index_by_exponents_.push_back(index);
        }
        find_border(result);
        for (const Polynomial& f : basis_) {
            std::vector<std::uint32_t>& tail = result.tails_.emplace_back();
            for (std::size_t t = 1; t < f.size(); ++t) tail.push_back(standard_.at(exponents_of(f, t)));
        }
        return result;
    }

  private:
    using Index = std::map<Exponents, std::uint32_t>;

    static Exponents exponents_of(const Polynomial& f, std::size_t term) {
        Exponents e(f.ring().variable_count());
        for (std::size_t i = 0; i < e.size(); ++i) e[i] = f.exponent(term, i);
        return e;
    }
    std::size_t last_variable(const Exponents& m) const {
        for (std::size_t i = n_; i-- > 0;)
            if (m[i] != 0) return i;
        return 0;
    }
    bool is_standard(Exponents& m) const {
        if (leads_.contains(m)) return false;
        for (std::size_t j = 0; j < n_; ++j) {
            if (m[j] == 0) continue;
            --m[j];
            const bool standard = standard_.contains(m);
            ++m[j];
            if (!standard) return false;
        }
        return true;
    }
    /// Numbers the monomials ascending in the ring's order.
    void number(Index& monomials) const {
        std::vector<std::pair<Monomial, std::uint32_t*>> sorted;
        for (auto& [m, index] : monomials) sorted.emplace_back(Monomial(ring_, m), &index);
        std::ranges::sort(sorted, [](const auto& a, const auto& b) { return a.first < b.first; });
        for (std::uint32_t i = 0; i < sorted.size(); ++i) *sorted[i].second = i;
    }

    void find_border(Staircase& result) {
        const auto D = static_cast<std::uint32_t>(standard_.size());
        Index border;
        for (const auto& [b, index] : standard_) {
            run_.poll();
            Exponents m = b;
            for (std::size_t i = 0; i < n_; ++i) {
                ++m[i];
                if (!standard_.contains(m)) border.emplace(m, 0);
                --m[i];
            }
        }
        number(border);
        result.products_.assign(n_, std::vector<std::uint32_t>(D));
        for (const auto& [b, index] : standard_) {
            Exponents m = b;
            for (std::size_t i = 0; i < n_; ++i) {
                ++m[i];
                const auto found = standard_.find(m);
                result.products_[i][index] = found != standard_.end() ? found->second : D + border.at(m);
                --m[i];
            }
        }
        result.border_.resize(border.size());
        for (const auto& [m, index] : border) result.border_[index] = describe(m, border);
    }
    Border describe(Exponents m, const Index& border) const {
        if (const auto lead = leads_.find(m); lead != leads_.end()) return {lead->second, 0, 0};
        // m = xᵢ·b is not minimal outside the standard monomials: some m/xⱼ is outside too, with j ≠ i, and
        // is xᵢ·(b/xⱼ), a border monomial.
        for (std::uint32_t j = 0;; ++j) {
            if (m[j] == 0) continue;
            --m[j];
            if (const auto below = border.find(m); below != border.end()) return {none, j, below->second};
            ++m[j];
        }
    }

    std::span<const Polynomial> basis_;
    const Ring& ring_;
    std::size_t n_;
    base::Run& run_;
    Index leads_;
    Index standard_;
};

std::optional<Staircase> Staircase::of(std::span<const Polynomial> reduced_basis, std::size_t limit,
                                       base::Run& run) {
    if (reduced_basis.empty()) return std::nullopt;
    Builder builder(reduced_basis, run);
    if (!builder.has_all_powers() || !builder.find_standard_monomials(limit)) return std::nullopt;
    return builder.build();
}

std::uint32_t Staircase::index_of(std::span<const std::uint64_t> exponents) const {
    const auto found = std::lower_bound(by_exponents_.begin(), by_exponents_.end(), exponents,
                                        [](const Exponents& a, std::span<const std::uint64_t> b) {
                                            return std::ranges::lexicographical_compare(a, b);
                                        });
    if (found == by_exponents_.end() || !std::ranges::equal(*found, exponents)) return none;
    return index_by_exponents_[static_cast<std::size_t>(found - by_exponents_.begin())];
}

} // namespace eliminant::groebner
