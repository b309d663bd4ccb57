#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace eliminant::algebra {

/// An admissible monomial order (a total order, compatible with products, with 1 the least monomial), as
/// data.
///
/// It speaks of variables by index; a Ring binds it to a number of variables and compiles it to sort keys.
/// Every order is a sequence of linear forms on exponent vectors compared lexicographically (Robbiano 1985).
class MonomialOrder {
  public:
    enum class Kind { lex, deglex, degrevlex, weighted, elimination, matrix };
    enum class TieBreak { lex, revlex };

    static MonomialOrder lex();
    static MonomialOrder deglex();
    static MonomialOrder degrevlex();
    /// Weighted degree first, then lex or reverse lex. Weights are non-negative; with the tie-break revlex
    /// they are positive, since otherwise 1 would exceed a variable. Throws DomainError.
    static MonomialOrder weighted(std::vector<std::uint64_t> weights, TieBreak tie_break);
    /// Product order: the named variables first, then all others, degrevlex in each block. It eliminates the
    /// named ones. Indices are distinct. Throws DomainError.
    static MonomialOrder elimination(std::vector<std::size_t> eliminated);
    /// Like `elimination`, with several blocks, each degrevlex in the sequence given; variables in no block
    /// form the last one.
    static MonomialOrder blocks(std::vector<std::vector<std::size_t>> blocks);
    /// Rows are compared in turn. Admissible if the rows have full column rank and the first nonzero entry of
    /// every column is positive; throws DomainError with the reason otherwise.
    static MonomialOrder matrix(std::vector<std::vector<std::int64_t>> rows);

    Kind kind() const { return kind_; }
    const std::vector<std::uint64_t>& weights() const { return weights_; }
    TieBreak tie_break() const { return tie_break_; }
    const std::vector<std::vector<std::size_t>>& blocks() const { return blocks_; }
    const std::vector<std::vector<std::int64_t>>& rows() const { return rows_; }

    /// Whether degrees (weighted by non-negative, not all zero weights) are compared first.
    bool is_graded() const {
        return kind_ != Kind::lex && kind_ != Kind::elimination && kind_ != Kind::matrix;
    }

    /// Throws DomainError if the order does not fit a ring of `variable_count` variables.
    void check(std::size_t variable_count) const;

    /// In the syntax of the command line: `lex`, `degrevlex`, `weight(1,2;lex)`, `elim(x,y)`,
    /// `matrix(1,1;0,-1)`.
    std::string to_string(std::span<const std::string> names) const;

    friend bool operator==(const MonomialOrder&, const MonomialOrder&) = default;

    /// A sort key: a non-negative linear form on exponents; with `reversed`, the smaller value is the larger
    /// monomial.
    struct Key {
        std::vector<std::uint64_t> weights;
        bool reversed = false;
    };
    /// Keys that decide the order for `variable_count` variables, most significant first.
    ///
    /// Matrix rows with negative entries are made non-negative by adding multiples of earlier rows, which
    /// does not change the order. So every key is monotone for divisibility, and a packed monomial may hold
    /// its keys beside its exponents and still be divided word by word. Throws DomainError as check(), and
    /// where a matrix entry becomes too large.
    std::vector<Key> keys(std::size_t variable_count) const;

  private:
    explicit MonomialOrder(Kind kind) : kind_(kind) {}

    Kind kind_;
    TieBreak tie_break_ = TieBreak::revlex;
    std::vector<std::uint64_t> weights_;
    std::vector<std::vector<std::size_t>> blocks_;
    std::vector<std::vector<std::int64_t>> rows_;
};

} // namespace eliminant::algebra

namespace eliminant {
using algebra::MonomialOrder;
} // namespace eliminant
