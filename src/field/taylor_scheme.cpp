#include "field/taylor_scheme.hpp"

#include <algorithm>
#include <numeric>

namespace eliminant::field {

namespace {

constexpr std::size_t max_cost = std::size_t{1} << 21;

/// Lengths of the lines along w, over a rectangle of the exponents i, j.
class LineLengths {
  public:
    LineLengths(std::size_t rows, std::size_t columns) : columns_(columns), lengths_(rows * columns) {}
    std::uint32_t& at(std::size_t i, std::size_t j) { return lengths_[i * columns_ + j]; }
    std::uint32_t at(std::size_t i, std::size_t j) const { return lengths_[i * columns_ + j]; }
    std::size_t rows() const { return lengths_.size() / columns_; }
    std::size_t columns() const { return columns_; }

  private:
    std::size_t columns_;
    std::vector<std::uint32_t> lengths_;
};

/// Builds the scheme for one sequence of the coordinates.
class Layout {
  public:
    Layout(std::span<const Exponents> terms, std::array<std::uint8_t, 3> coordinates)
        : terms_(terms.begin(), terms.end()), lengths_(1, 1) {
        scheme_.coordinates = coordinates;
        Exponents degrees = {};
        for (std::size_t t = 0; t < terms.size(); ++t)
            for (std::size_t level = 0; level < 3; ++level) {
                terms_[t][level] = terms[t][coordinates[level]];
                degrees[level] = std::max(degrees[level], terms_[t][level]);
            }
        lengths_ = LineLengths(degrees[0] + 1, degrees[1] + 1);
        for (const Exponents& e : terms_)
            lengths_.at(e[0], e[1]) = std::max(lengths_.at(e[0], e[1]), e[2] + 1);
    }

    /// About the operations of the scheme and the size of its description.
    std::size_t cost() const {
        const LineLengths along_v = filled_along_v(lengths_);
        const LineLengths filled = filled_along_u(along_v);
        std::size_t cost = 0;
        for (std::size_t i = 0; i < filled.rows(); ++i)
            for (std::size_t j = 0; j < filled.columns(); ++j)
                cost += filled.at(i, j) + std::size_t{lengths_.at(i, j)} * lengths_.at(i, j) / 2 +
                        j * along_v.at(i, j) + i * filled.at(i, j);
        return cost;
    }

    TaylorScheme scheme() {
        const LineLengths original = lengths_;
        const LineLengths along_v = filled_along_v(original);
        const LineLengths filled = filled_along_u(along_v);
        place(filled);
        for (std::size_t i = 0; i < original.rows(); ++i)
            for (std::size_t j = 0; j < original.columns(); ++j)
                if (original.at(i, j) > 1) scheme_.lines.push_back({first(i, j), original.at(i, j)});
        add_steps_along_v(original);
        add_steps_along_u(along_v);
        for (const Exponents& e : terms_) scheme_.slots.push_back(first(e[0], e[1]) + e[2]);
        add_parts(filled);
        scheme_.is_complete = true;
        return std::move(scheme_);
    }

  private:
    static LineLengths filled_along_v(LineLengths lengths) {
        for (std::size_t i = 0; i < lengths.rows(); ++i)
            for (std::size_t j = lengths.columns() - 1; j-- > 0;)
                lengths.at(i, j) = std::max(lengths.at(i, j), lengths.at(i, j + 1));
        return lengths;
    }
    static LineLengths filled_along_u(LineLengths lengths) {
        for (std::size_t i = lengths.rows() - 1; i-- > 0;)
            for (std::size_t j = 0; j < lengths.columns(); ++j)
                lengths.at(i, j) = std::max(lengths.at(i, j), lengths.at(i + 1, j));
        return lengths;
    }

    void place(const LineLengths& filled) {
        firsts_.resize(filled.rows() * filled.columns());
        for (std::size_t i = 0; i < filled.rows(); ++i)
            for (std::size_t j = 0; j < filled.columns(); ++j) {
                firsts_[i * filled.columns() + j] = static_cast<std::uint32_t>(scheme_.size);
                if (filled.at(i, j) > 0)
                    scheme_.filled.push_back({first(i, j), filled.at(i, j), static_cast<std::uint32_t>(i),
                                              static_cast<std::uint32_t>(j)});
                scheme_.size += filled.at(i, j);
            }
    }
    std::uint32_t first(std::size_t i, std::size_t j) const { return firsts_[i * lengths_.columns() + j]; }

    /// Neighbouring steps that move on together are one.
    void add_step(std::uint32_t to, std::uint32_t from, std::uint32_t count, std::uint32_t level) {
        if (count == 0) return;
        if (!scheme_.steps.empty()) {
            TaylorScheme::Step& last = scheme_.steps.back();
            if (last.level == level && last.to + last.count == to && last.from + last.count == from) {
                last.count += count;
                return;
            }
        }
        scheme_.steps.push_back({to, from, count, level});
    }

    void add_steps_along_v(LineLengths lengths) {
        for (std::size_t i = 0; i < lengths.rows(); ++i)
            for (std::size_t done = 0; done + 1 < lengths.columns(); ++done)
                for (std::size_t j = lengths.columns() - 1; j > done; --j) {
                    add_step(first(i, j - 1), first(i, j), lengths.at(i, j), 1);
                    lengths.at(i, j - 1) = std::max(lengths.at(i, j - 1), lengths.at(i, j));
                }
    }
    void add_steps_along_u(LineLengths lengths) {
        for (std::size_t done = 0; done + 1 < lengths.rows(); ++done)
            for (std::size_t i = lengths.rows() - 1; i > done; --i)
                for (std::size_t j = 0; j < lengths.columns(); ++j) {
                    add_step(first(i - 1, j), first(i, j), lengths.at(i, j), 0);
                    lengths.at(i - 1, j) = std::max(lengths.at(i - 1, j), lengths.at(i, j));
                }
    }

    /// α!/(α₀+α₁+α₂)!, the reciprocal of a multinomial coefficient, rounded a few times.
    static double weight(const Exponents& alpha) {
        double result = 1;
        double total = 0;
        for (const std::uint32_t exponent : alpha)
            for (std::uint32_t i = 1; i <= exponent; ++i) result *= i / ++total;
        return result;
    }

    void add_parts(const LineLengths& filled) {
        scheme_.low.fill(TaylorScheme::none);
        for (std::uint32_t i = 0; i < filled.rows(); ++i)
            for (std::uint32_t j = 0; j < filled.columns(); ++j)
                for (std::uint32_t k = 0; k < filled.at(i, j); ++k) {
                    const std::size_t order = i + j + k;
                    if (scheme_.parts.size() <= order) scheme_.parts.resize(order + 1);
                    const Exponents alpha = {i, j, k};
                    scheme_.parts[order].push_back({first(i, j) + k, weight(alpha)});
                    if (order <= 2) scheme_.low[low_position(alpha)] = first(i, j) + k;
                }
    }
    std::size_t low_position(const Exponents& alpha) const {
        constexpr std::array<Exponents, 10> order = {{{0, 0, 0},
                                                      {1, 0, 0},
                                                      {0, 1, 0},
                                                      {0, 0, 1},
                                                      {2, 0, 0},
                                                      {1, 1, 0},
                                                      {1, 0, 1},
                                                      {0, 2, 0},
                                                      {0, 1, 1},
                                                      {0, 0, 2}}};
        Exponents in_coordinates = {};
        for (std::size_t level = 0; level < 3; ++level)
            in_coordinates[scheme_.coordinates[level]] = alpha[level];
        return static_cast<std::size_t>(std::ranges::find(order, in_coordinates) - order.begin());
    }

    std::vector<Exponents> terms_; ///< of u, v, w
    LineLengths lengths_;
    std::vector<std::uint32_t> firsts_;
    TaylorScheme scheme_;
};

} // namespace

TaylorScheme make_taylor_scheme(std::span<const Exponents> terms) {
    std::array<std::uint8_t, 3> best = {0, 1, 2};
    std::size_t least = max_cost + 1;
    std::array<std::uint8_t, 3> sequence = best;
    do {
        const std::size_t cost = Layout(terms, sequence).cost();
        if (cost >= least) continue;
        least = cost;
        best = sequence;
    } while (std::ranges::next_permutation(sequence).found);
    return least > max_cost ? TaylorScheme{} : Layout(terms, best).scheme();
}

} // namespace eliminant::field
