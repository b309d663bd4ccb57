#include "eliminant/implicit/control_net.hpp"

#include "eliminant/algebra/integer.hpp"

#include <algorithm>
#include <utility>

namespace eliminant::implicit {

using algebra::Integer;
using algebra::Polynomial;
using algebra::RationalFunction;

namespace {

void require(bool condition, const std::string& message) {
    if (!condition) throw DomainError("control net: " + message);
}

/// Knots i with knots[i] < knots[i + 1] in the domain of the spline, where all basis functions sum to 1.
std::vector<std::size_t> nonempty_spans(const ControlNet::Direction& direction) {
    std::vector<std::size_t> spans;
    for (std::size_t i = direction.degree; i < direction.point_count(); ++i)
        if (direction.knots[i] < direction.knots[i + 1]) spans.push_back(i);
    return spans;
}

void check(const ControlNet& net) {
    require(net.directions.size() == 1 || net.directions.size() == 2, "there are one or two directions");
    require(!net.is_triangular || (net.directions.size() == 1 && !net.directions[0].is_spline()),
            "a triangle has one degree and no knots");
    for (const ControlNet::Direction& direction : net.directions) {
        require(direction.degree > 0, "degrees are positive");
        if (direction.is_spline()) {
            require(direction.knots.size() >= 2 * direction.degree + 2,
                    "degree " + std::to_string(direction.degree) + " needs at least " +
                        std::to_string(2 * direction.degree + 2) + " knots");
            require(std::ranges::is_sorted(direction.knots), "knots do not decrease");
            require(!nonempty_spans(direction).empty(), "all spans between knots are empty");
        }
    }
    require(net.point_count() == net.points.size(), std::to_string(net.point_count()) + " points are needed");
    for (const auto& point : net.points)
        require(point.size() == net.coordinates.size() + (net.is_rational ? 1 : 0),
                "a point has a number for each coordinate, and a weight if the net is rational");
}

/// A function of one or two parameters by numbers in a grid, the last direction first in memory: control
/// points or coefficients of one coordinate.
struct Grid {
    std::size_t rows;
    std::size_t columns;
    std::vector<mpq_class> cells;

    mpq_class& at(std::size_t row, std::size_t column) { return cells[row * columns + column]; }
    Grid transposed() const {
        Grid result{columns, rows, std::vector<mpq_class>(cells.size())};
        for (std::size_t i = 0; i < rows; ++i)
            for (std::size_t j = 0; j < columns; ++j) result.cells[j * rows + i] = cells[i * columns + j];
        return result;
    }
};

/// The polar form f(t₁, …, tₙ) of the piece over [knots[span], knots[span + 1]] of a spline of degree n, at
/// arguments of which `at_end` are the end of the span and the others its beginning: de Boor's algorithm with
/// an argument of its own in each step.
mpq_class polar_value(const ControlNet::Direction& direction, std::size_t span,
                      const std::vector<mpq_class>& points, std::size_t at_end) {
    const std::size_t n = direction.degree;
    const std::vector<mpq_class>& knots = direction.knots;
    std::vector<mpq_class> d(points.begin() + static_cast<std::ptrdiff_t>(span - n),
                             points.begin() + static_cast<std::ptrdiff_t>(span + 1));
    for (std::size_t r = 1; r <= n; ++r) {
        const mpq_class& argument = r <= at_end ? knots[span + 1] : knots[span];
        for (std::size_t i = n; i >= r; --i) {
            const mpq_class& left = knots[span - n + i];
            const mpq_class& right = knots[span + 1 + i - r];
            const mpq_class ratio = (argument - left) / (right - left);
            d[i] = (1 - ratio) * d[i - 1] + ratio * d[i];
        }
    }
    return d[n];
}

/// The Bézier points of a span, along the columns.
Grid bezier_points(const ControlNet::Direction& direction, std::size_t span, const Grid& grid) {
    Grid result{grid.rows, direction.degree + 1, {}};
    for (std::size_t row = 0; row < grid.rows; ++row) {
        const auto begin = grid.cells.begin() + static_cast<std::ptrdiff_t>(row * grid.columns);
        const std::vector<mpq_class> points(begin, begin + static_cast<std::ptrdiff_t>(grid.columns));
        for (std::size_t j = 0; j <= direction.degree; ++j)
            result.cells.push_back(polar_value(direction, span, points, j));
    }
    return result;
}

/// Bernstein coefficients become those of powers, along the columns: Σ bᵢBᵢⁿ(t) = Σ (n choose i)·Δⁱb₀·tⁱ.
void to_powers(Grid& grid, base::Run& run) {
    const std::size_t n = grid.columns - 1;
    for (std::size_t row = 0; row < grid.rows; ++row) {
        run.poll();
        for (std::size_t r = 1; r <= n; ++r)
            for (std::size_t i = n; i >= r; --i) grid.at(row, i) -= grid.at(row, i - 1);
        mpz_class binomial = 1;
        for (std::size_t i = 0; i <= n; ++i) {
            grid.at(row, i) *= binomial;
            binomial = binomial * (n - i) / (i + 1);
        }
    }
}

/// The same for a triangle of cells (i, j), i + j ≤ n: Σ bᵢⱼ·n!/(i! j! k!)·sⁱtʲ(1−s−t)ᵏ has the coefficients
/// n!/(i! j! k!)·Δₛⁱ Δₜʲ b₀₀, of differences along the columns and the rows.
void triangle_to_powers(Grid& grid, base::Run& run) {
    const std::size_t n = grid.columns - 1;
    for (std::size_t line = 0; line < n; ++line) {
        run.poll();
        for (std::size_t r = 1; line + r <= n; ++r)
            for (std::size_t j = n - line; j >= r; --j) grid.at(line, j) -= grid.at(line, j - 1);
    }
    for (std::size_t line = 0; line < n; ++line) {
        run.poll();
        for (std::size_t r = 1; line + r <= n; ++r)
            for (std::size_t i = n - line; i >= r; --i) grid.at(i, line) -= grid.at(i - 1, line);
    }
    mpz_class row_factor = 1; // n choose i
    for (std::size_t i = 0; i <= n; ++i) {
        mpz_class factor = row_factor; // n!/(i! j! k!)
        for (std::size_t j = 0; i + j <= n; ++j) {
            grid.at(i, j) *= factor;
            factor = factor * (n - i - j) / (j + 1);
        }
        row_factor = row_factor * (n - i) / (i + 1);
    }
}

/// The polynomial whose coefficient of sⁱtʲ, or for a curve sʲ, is the number in row i, column j.
Polynomial polynomial_of(const algebra::Ring& ring, const Grid& grid) {
    algebra::PolynomialBuilder builder(ring);
    for (std::size_t i = 0; i < grid.rows; ++i) {
        for (std::size_t j = 0; j < grid.columns; ++j) {
            const mpq_class& c = grid.cells[i * grid.columns + j];
            if (c == 0) continue;
            std::vector<std::uint64_t> exponents = {i, j};
            if (ring.variable_count() == 1) exponents = {j};
            builder.add(Integer(c.get_num()), Integer(c.get_den()), exponents);
        }
    }
    return builder.build();
}

/// The pieces of a net that is known to be well formed.
class Pieces {
  public:
    Pieces(const ControlNet& net, base::Run& run) : net_(net), run_(run), ring_(ring_of(net)) {
        columns_ = net.directions.back().point_count();
        if (net.is_triangular) rows_ = columns_;
        if (net.directions.size() == 2) rows_ = net.directions[0].point_count();
        for (std::size_t i = 0; i < net.coordinates.size() + (net.is_rational ? 1 : 0); ++i)
            grids_.push_back(grid_of(i));
    }

    std::vector<NetPiece> all() const {
        std::vector<NetPiece> result;
        const std::vector<std::size_t> first =
            net_.directions.size() == 2 ? spans_of(net_.directions[0]) : std::vector<std::size_t>(1);
        const std::vector<std::size_t> last = spans_of(net_.directions.back());
        for (std::size_t i = 0; i < first.size(); ++i) {
            for (std::size_t j = 0; j < last.size(); ++j) {
                std::vector<std::size_t> name;
                if (net_.directions.size() == 2 && net_.directions[0].is_spline()) name.push_back(i);
                if (net_.directions.back().is_spline()) name.push_back(j);
                result.push_back({std::move(name), piece(first[i], last[j])});
            }
        }
        return result;
    }

  private:
    static algebra::Ring ring_of(const ControlNet& net) {
        std::vector<std::string> names = {"t"};
        if (net.directions.size() == 2 || net.is_triangular) names = {"s", "t"};
        for (std::string& name : names)
            while (std::ranges::find(net.coordinates, name) != net.coordinates.end()) name += '_';
        return {algebra::CoefficientField::rationals(), std::move(names)};
    }

    static std::vector<std::size_t> spans_of(const ControlNet::Direction& direction) {
        return direction.is_spline() ? nonempty_spans(direction) : std::vector<std::size_t>(1);
    }

    /// Coordinate i of all points, times the weight; i = number of coordinates is the weight. Of a triangle
    /// the upper left half of the grid, with zeros in the rest.
    Grid grid_of(std::size_t i) const {
        Grid grid{rows_, columns_, std::vector<mpq_class>(rows_ * columns_)};
        auto point = net_.points.begin();
        for (std::size_t row = 0; row < rows_; ++row) {
            const std::size_t length = net_.is_triangular ? columns_ - row : columns_;
            for (std::size_t column = 0; column < length; ++column, ++point) {
                mpq_class& cell = grid.at(row, column);
                cell = (*point)[i];
                if (net_.is_rational && i < net_.coordinates.size()) cell *= point->back();
            }
        }
        return grid;
    }

    Polynomial function(Grid grid, std::size_t first_span, std::size_t last_span) const {
        if (net_.is_triangular) {
            triangle_to_powers(grid, run_);
            return polynomial_of(ring_, grid);
        }
        if (net_.directions.back().is_spline()) grid = bezier_points(net_.directions.back(), last_span, grid);
        to_powers(grid, run_);
        if (net_.directions.size() == 2) {
            grid = grid.transposed();
            if (net_.directions[0].is_spline()) grid = bezier_points(net_.directions[0], first_span, grid);
            to_powers(grid, run_);
            grid = grid.transposed();
        }
        return polynomial_of(ring_, grid);
    }

    Parametrization piece(std::size_t first_span, std::size_t last_span) const {
        Polynomial weight = Polynomial::constant(ring_, 1);
        if (net_.is_rational) weight = function(grids_.back(), first_span, last_span);
        require(!weight.is_zero(), "the weights of a piece are not all 0");
        std::vector<Coordinate> coordinates;
        for (std::size_t i = 0; i < net_.coordinates.size(); ++i) {
            const RationalFunction value(function(grids_[i], first_span, last_span), weight);
            coordinates.push_back({net_.coordinates[i], in_lowest_terms(value, run_)});
        }
        return {ring_, {}, std::move(coordinates)};
    }

    const ControlNet& net_;
    base::Run& run_;
    algebra::Ring ring_;
    std::size_t rows_ = 1;
    std::size_t columns_ = 1;
    std::vector<Grid> grids_; ///< one a coordinate, the weights last
};

} // namespace

std::size_t ControlNet::point_count() const {
    const std::size_t last = directions.back().point_count();
    if (is_triangular) return last * (last + 1) / 2;
    return directions.size() == 2 ? directions.front().point_count() * last : last;
}

std::vector<NetPiece> net_pieces(const ControlNet& net, base::Run& run) {
    check(net);
    return Pieces(net, run).all();
}

} // namespace eliminant::implicit
