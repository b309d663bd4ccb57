#include "implicit/verify_sums.hpp"

#include "base/pack.hpp"

namespace eliminant::implicit {
namespace {

using Halves = base::EightHalves;
using Words = base::EightWords;
constexpr std::size_t lanes = evaluation_lanes;
static_assert(lanes == Words::lanes);

class Montgomery {
  public:
    explicit Montgomery(const MontgomeryModulus& modulus)
        : p_(Halves::all(modulus.p)), twice_p_(Halves::all(2 * modulus.p)),
          negative_inverse_(Halves::all(modulus.negative_inverse)) {}

    /// sum/2^32 modulo p.
    Halves reduced(Words sum) const {
        const Halves factor = halves(halves(sum) * negative_inverse_);
        const Halves result = upper_halves(sum + factor * p_);
        return subtract_if_not_less(subtract_if_not_less(result, twice_p_), p_);
    }
    Halves sum(Halves a, Halves b) const { return subtract_if_not_less(a + b, p_); }

  private:
    Halves p_;
    Halves twice_p_;
    Halves negative_inverse_;
};

void make_powers(std::uint64_t* powers, const std::uint32_t* x, std::size_t count,
                 const MontgomeryModulus& modulus) {
    const Montgomery montgomery(modulus);
    const Halves factor = montgomery.reduced(Halves::load(x) * Halves::all(modulus.square_of_one));
    Halves power = Halves::all(modulus.one);
    for (std::size_t e = 0; e < power_stride; ++e) {
        if (e < count) words(power).store(powers + e * lanes);
        power = montgomery.reduced(power * factor);
    }
    for (std::size_t e = power_stride; e < count; ++e) {
        const Words before = Words::load(powers + (e - power_stride) * lanes);
        words(montgomery.reduced(halves(before) * power)).store(powers + e * lanes);
    }
}

struct LeafValues {
    const std::uint32_t* values;
    Halves operator()(std::size_t child) const { return Halves::all(values[child]); }
};

struct NodeValues {
    const std::uint32_t* values;
    Halves operator()(std::size_t child) const { return Halves::load(values + child * lanes); }
};

template <class Values>
void sum_children(std::uint32_t* sums, const TreeEdges& edges, const std::uint64_t* powers,
                  const std::uint32_t* values, const MontgomeryModulus& modulus) {
    const Montgomery montgomery(modulus);
    const Values value_of{values};
    for (std::size_t node = 0; node < edges.node_count; ++node) {
        Halves total = Halves::all(0);
        const std::size_t last = edges.first_child[node + 1];
        for (std::size_t child = edges.first_child[node]; child < last;) {
            const std::size_t stop = last - child > products_in_a_sum ? child + products_in_a_sum : last;
            Words sum = Words::all(0);
            for (; child < stop; ++child) {
                const Words power = Words::load(powers + lanes * edges.exponents[child]);
                sum = sum + halves(power) * value_of(child);
            }
            total = montgomery.sum(total, montgomery.reduced(sum));
        }
        total.store(sums + node * lanes);
    }
}

} // namespace

template <base::VectorUnit unit>
EvaluationLoops evaluation_loops_of() {
    return {make_powers, sum_children<NodeValues>, sum_children<LeafValues>};
}

template EvaluationLoops evaluation_loops_of<base::this_unit>();

} // namespace eliminant::implicit
