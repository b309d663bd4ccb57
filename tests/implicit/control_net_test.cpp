// Control nets against the definition of their basis functions; what their reader accepts and refuses.
#include "eliminant/implicit/control_net.hpp"

#include "eliminant/base/error.hpp"
#include "implicit/support.hpp"

#include <random>

namespace eliminant::implicit {
namespace {

ControlNet net_of(const std::string& text) {
    base::Run run;
    return parse_control_net(SourceText(text, "test"), run);
}

std::vector<NetPiece> pieces_of(const ControlNet& net) {
    base::Run run;
    return net_pieces(net, run);
}

/// Basis function i of a direction, by the recurrence of Cox and de Boor, or Bernstein's.
mpq_class basis_function(const ControlNet::Direction& direction, std::size_t i, std::size_t degree,
                         const mpq_class& u) {
    std::vector<mpq_class> knots = direction.knots;
    if (!direction.is_spline()) { // the knots of a Bézier curve
        knots.assign(direction.degree + 1, 0);
        knots.resize(2 * direction.degree + 2, 1);
    }
    if (degree == 0) return knots[i] <= u && u < knots[i + 1] ? 1 : 0;
    mpq_class sum = 0;
    const mpq_class left = knots[i + degree] - knots[i];
    const mpq_class right = knots[i + degree + 1] - knots[i + 1];
    if (left != 0) sum += (u - knots[i]) / left * basis_function(direction, i, degree - 1, u);
    if (right != 0)
        sum += (knots[i + degree + 1] - u) / right * basis_function(direction, i + 1, degree - 1, u);
    return sum;
}

/// The nonempty knot spans of a direction.
std::vector<std::pair<mpq_class, mpq_class>> spans_of(const ControlNet::Direction& direction) {
    if (!direction.is_spline()) return {{0, 1}};
    std::vector<std::pair<mpq_class, mpq_class>> spans;
    for (std::size_t i = direction.degree; i < direction.point_count(); ++i)
        if (direction.knots[i] != direction.knots[i + 1])
            spans.emplace_back(direction.knots[i], direction.knots[i + 1]);
    return spans;
}

/// The point of the net at knots (u, v), or u for a curve, by the definition.
std::vector<mpq_class> point_at(const ControlNet& net, const std::vector<mpq_class>& parameters) {
    std::vector<mpq_class> sum(net.coordinates.size());
    mpq_class weights = 0;
    for (std::size_t k = 0; k < net.points.size(); ++k) {
        const std::size_t columns = net.directions.back().point_count();
        mpq_class b = basis_function(net.directions.back(), k % columns, net.directions.back().degree,
                                     parameters.back());
        if (net.directions.size() == 2)
            b *= basis_function(net.directions[0], k / columns, net.directions[0].degree, parameters[0]);
        if (net.is_rational) b *= net.points[k].back();
        weights += b;
        for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += b * net.points[k][i];
    }
    for (mpq_class& coordinate : sum) coordinate /= weights;
    return sum;
}

/// All pieces, at a few parameters, are what the definition says.
void expect_pieces(const ControlNet& net) {
    const std::vector<NetPiece> pieces = pieces_of(net);
    const auto first = net.directions.size() == 2 ? spans_of(net.directions[0])
                                                  : std::vector<std::pair<mpq_class, mpq_class>>{{0, 1}};
    const auto last = spans_of(net.directions.back());
    ASSERT_EQ(pieces.size(), first.size() * last.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        for (const mpq_class& s : {mpq_class(0), mpq_class(1, 3), mpq_class(5, 7)}) {
            const mpq_class t = s * s / 2;
            const auto at = [](const auto& span, const mpq_class& r) {
                return mpq_class(span.first + r * (span.second - span.first));
            };
            std::vector<mpq_class> parameters = {at(last[k % last.size()], t)};
            std::vector<mpq_class> local = {t};
            if (net.directions.size() == 2) {
                parameters.insert(parameters.begin(), at(first[k / last.size()], s));
                local.insert(local.begin(), s);
            }
            const std::vector<mpq_class> expected = point_at(net, parameters);
            for (std::size_t i = 0; i < expected.size(); ++i) {
                const auto& value = pieces[k].parametrization.coordinates()[i].value;
                EXPECT_EQ(evaluate(value.numerator, local) / evaluate(value.denominator, local), expected[i]);
            }
        }
    }
}

/// Random knots of some multiplicities, and points.
ControlNet random_net(std::uint64_t seed, std::size_t directions, bool spline, bool rational) {
    std::mt19937_64 random(seed);
    ControlNet net;
    std::size_t points = 1;
    for (std::size_t k = 0; k < directions; ++k) {
        ControlNet::Direction direction{1 + random() % 3};
        mpq_class knot = -1;
        while (spline && direction.knots.size() < 2 * direction.degree + 5) {
            if (random() % 3 != 0) knot += mpq_class(1 + static_cast<int>(random() % 4), 3);
            knot.canonicalize();
            direction.knots.push_back(knot);
        }
        if (spline) direction.knots[direction.degree + 2] = direction.knots[direction.degree + 1];
        points *= direction.point_count();
        net.directions.push_back(std::move(direction));
    }
    net.coordinates = {"x", "y"};
    net.is_rational = rational;
    for (std::size_t i = 0; i < points; ++i) {
        net.points.emplace_back();
        for (int j = 0; j < 2; ++j) net.points.back().emplace_back(static_cast<int>(random() % 19) - 9);
        if (rational) net.points.back().emplace_back(1 + static_cast<int>(random() % 5));
    }
    return net;
}

TEST(ControlNet, PiecesAreSumsOfBasisFunctions) {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        for (const std::size_t directions : {1U, 2U}) {
            for (const bool spline : {false, true}) {
                SCOPED_TRACE("seed " + std::to_string(seed) + ", " + std::to_string(directions));
                expect_pieces(random_net(seed, directions, spline, seed % 2 == 0));
            }
        }
    }
}

TEST(ControlNet, CornersOfABezierNetAreInterpolated) {
    const auto pieces = pieces_of(net_of("bezier 2 1\n1 2 3\n4 5 6\n0 0 1\n1 1 1/3\n-2 7 0.5\n8 9 -1e1\n"));
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_TRUE(pieces[0].span.empty());
    const auto& coordinates = pieces[0].parametrization.coordinates();
    const auto corner = [&](int s, int t) {
        std::vector<mpq_class> point;
        for (const Coordinate& c : coordinates)
            point.push_back(evaluate(c.value.numerator, std::vector<mpq_class>{s, t}));
        return point;
    };
    EXPECT_EQ(corner(0, 0), (std::vector<mpq_class>{1, 2, 3}));
    EXPECT_EQ(corner(0, 1), (std::vector<mpq_class>{4, 5, 6}));
    EXPECT_EQ(corner(1, 0), (std::vector<mpq_class>{-2, 7, mpq_class(1, 2)}));
    EXPECT_EQ(corner(1, 1), (std::vector<mpq_class>{8, 9, -10}));
}

TEST(ControlNet, AWeightedArcIsACircle) {
    EXPECT_EQ(equations_of("rational bezier 2\n1 0 1\n1 1 1\n0 1 2\n"), "x^2+y^2-1");
    EXPECT_EQ(
        equations_of("# blanks, commas\n\nrational bezier 2 \ncoordinates u, v\n 1,0,1\n1,\t1 1 # P1\n0 1 2"),
        "u^2+v^2-1");
    EXPECT_EQ(equations_of("bezier 1 1\ncoordinates s, t, z\n0 0 0\n1 0 0\n0 1 0\n1 1 1"), "s*t-z");
}

/// The point of a triangular net at (s, t), by de Casteljau's algorithm.
std::vector<mpq_class> point_of_triangle(const ControlNet& net, const mpq_class& s, const mpq_class& t) {
    std::size_t n = net.directions[0].degree;
    const auto index = [&n](std::size_t i, std::size_t j) { return i * (n + 1) - i * (i - 1) / 2 + j; };
    std::vector<std::vector<mpq_class>> points = net.points;
    for (auto& point : points)
        for (std::size_t c = 0; net.is_rational && c < net.coordinates.size(); ++c) point[c] *= point.back();
    for (; n > 0; --n) {
        std::vector<std::vector<mpq_class>> next;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; i + j < n; ++j) {
                next.push_back(points[index(i, j)]);
                for (std::size_t c = 0; c < next.back().size(); ++c)
                    next.back()[c] = (1 - s - t) * points[index(i, j)][c] + s * points[index(i + 1, j)][c] +
                                     t * points[index(i, j + 1)][c];
            }
        }
        points = std::move(next);
    }
    if (net.is_rational)
        for (std::size_t c = 0; c < net.coordinates.size(); ++c) points[0][c] /= points[0].back();
    points[0].resize(net.coordinates.size());
    return points[0];
}

TEST(ControlNet, TrianglesAreWhatDeCasteljausAlgorithmMakesOfThem) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937_64 random(seed);
        ControlNet net;
        net.directions = {{1 + seed % 5}};
        net.coordinates = {"x", "y", "z"};
        net.is_triangular = true;
        net.is_rational = seed % 2 == 0;
        for (std::size_t i = 0; i < net.point_count(); ++i) {
            std::vector<mpq_class> point;
            for (int j = 0; j < 3; ++j) point.emplace_back(static_cast<int>(random() % 19) - 9);
            if (net.is_rational) point.emplace_back(1 + static_cast<int>(random() % 5));
            net.points.push_back(std::move(point));
        }
        const std::vector<NetPiece> pieces = pieces_of(net);
        ASSERT_EQ(pieces.size(), 1U);
        EXPECT_TRUE(pieces[0].span.empty());
        for (const mpq_class& s : {mpq_class(0), mpq_class(1, 3), mpq_class(5, 7), mpq_class(1)}) {
            const mpq_class t = (1 - s) / 3;
            const std::vector<mpq_class> expected = point_of_triangle(net, s, t);
            const std::vector<mpq_class> local = {s, t};
            for (std::size_t i = 0; i < 3; ++i) {
                const auto& value = pieces[0].parametrization.coordinates()[i].value;
                EXPECT_EQ(evaluate(value.numerator, local) / evaluate(value.denominator, local), expected[i]);
            }
        }
    }
}

TEST(ControlNet, TrianglesHaveEquations) {
    EXPECT_EQ(equations_of("triangle 1\n1 0 0\n0 1 0\n0 0 1\n"), "x+y+z-1");
    EXPECT_EQ(equations_of("triangle 2\n0 0 0\n0 1/2 0\n0 1 0\n1/2 0 0\n1/2 1/2 1/2\n1 0 0\n"), "x*y-z");
    EXPECT_EQ(equations_of("rational triangle 2 # the sphere from its south pole\n0 0 1 1\n0 1 1 1\n0 1 0 2\n"
                           "1 0 1 1\n1 1 1 1\n1 0 0 2\n"),
              "x^2+y^2+z^2-1");
    EXPECT_EQ(equations_of("triangle = t\ny = t^2"), "triangle^2-y");
}

TEST(ControlNet, ReadsKnots) {
    const ControlNet net =
        net_of("nurbs 2 1\nknots 0 0 0 1/2 1 1 1\nknots -1, -1, 2.5, 2.5\n0 0 0 1\n0 1 0 1\n"
               "1 0 0 2\n1 1 0 2\n2 0 1 1\n2 1 1 1\n3 0 0 1\n3 1 0 1\n");
    EXPECT_TRUE(net.is_rational);
    ASSERT_EQ(net.directions.size(), 2U);
    EXPECT_EQ(net.directions[0].knots[3], mpq_class(1, 2));
    EXPECT_EQ(net.directions[1].knots[2], mpq_class(5, 2));
    const auto pieces = pieces_of(net);
    ASSERT_EQ(pieces.size(), 2U);
    EXPECT_EQ(pieces[1].span, (std::vector<std::size_t>{1, 0}));
}

void expect_error(const std::string& text, const std::string& message) {
    try {
        net_of(text);
        ADD_FAILURE() << "accepted: " << text;
    } catch (const ParseError& error) {
        EXPECT_EQ(std::string(error.what()), "test:" + message) << text;
    }
}

TEST(ControlNet, ErrorsNameThePlace) {
    expect_error("", "1:1: expected a control net, as bezier 3 3, found end of text");
    expect_error(
        "spline 3\n",
        "1:1: expected bezier, triangle, rational bezier, rational triangle, bspline or nurbs, found "
        "'spline'");
    expect_error("rational 3\n", "1:10: expected bezier or triangle, found '3'");
    expect_error("triangle\n", "1:9: expected a degree, found end of line");
    expect_error("triangle 2 2\n", "1:12: expected the end of the line, found '2'");
    expect_error("triangle 1\n0 0\n1 1\n", "4:1: expected 3 control points, found 2");
    expect_error("triangle 1\n0 0\n1 1\n0 1\n2 2\n",
                 "5:1: expected no more than 3 control points, found '2'");
    expect_error("triangle 1\nknots 0 1\n",
                 "2:1: expected a control point: a Bézier net has no knots, found 'knots'");
    expect_error("bezier\n", "1:7: expected a degree, found end of line");
    expect_error("bezier 2 2 2\n", "1:12: expected the end of the line, found '2'");
    expect_error("bezier 0\n", "1:8: expected a degree from 1 to 10000, found '0'");
    expect_error("bezier 3/2\n", "1:8: expected a degree from 1 to 10000, found '3'");
    expect_error("bezier 1\n0 0\n", "3:1: expected 2 control points, found 1");
    expect_error("bezier 1\n0 0\n1 1\n2 2\n", "4:1: expected no more than 2 control points, found '2'");
    expect_error("bezier 1\n0 0\n1 1 1\n", "3:5: expected 2 coordinates, found 3 numbers");
    expect_error("bezier 1\n0 0\n1\n", "3:2: expected 2 coordinates, found 1 number");
    expect_error("bezier 1\n0\n1\n", "2:1: expected 2 or 3 coordinates, found 1 number");
    expect_error("bezier 1\nknots 0 0 1 1\n",
                 "2:1: expected a control point: a Bézier net has no knots, found 'knots'");
    expect_error("bspline 1\n0 0\n", "2:1: expected knots, found '0'");
    expect_error("bspline 1\nknots 0 1 0 1\n",
                 "2:11: expected a knot that is not below the one before it, found '0'");
    expect_error("bspline 2\nknots 0 0 1 1\n", "2:14: expected at least 6 knots for degree 2, found 4");
    expect_error("bspline 1\nknots 0 1 1 2\n",
                 "2:7: expected knots of which some differ in the middle, found '0'");
    expect_error("bspline 1 1\nknots 0 0 1 1\n0 0\n",
                 "3:1: expected the knots of the second degree, found '0'");
    expect_error("bspline 1\nknots 0 0 1 1\n", "3:1: expected 2 control points, found 0");
    EXPECT_THROW(net_of("bezier 1\n0 a\n1 1\n"), ParseError);
    EXPECT_THROW(net_of("bezier 1\n0 1/0\n1 1\n"), ParseError);
    EXPECT_THROW(net_of("bezier 1\n0 \xFF\n"), ParseError);
}

TEST(ControlNet, NetsThatDoNotFitAreDomainErrors) {
    const ControlNet good = net_of("rational bezier 1\n0 0 1\n1 1 2\n");
    const auto expect_refusal = [&](auto&& spoil) {
        ControlNet net = good;
        spoil(net);
        EXPECT_THROW(pieces_of(net), DomainError);
    };
    EXPECT_EQ(pieces_of(good).size(), 1U);
    expect_refusal([](ControlNet& net) { net.directions.clear(); });
    expect_refusal([](ControlNet& net) { net.is_triangular = true; });
    expect_refusal([](ControlNet& net) {
        net.is_triangular = true;
        net.directions.push_back(net.directions[0]);
    });
    expect_refusal([](ControlNet& net) { net.directions[0].degree = 0; });
    expect_refusal([](ControlNet& net) { net.points.pop_back(); });
    expect_refusal([](ControlNet& net) { net.points[0].pop_back(); });
    expect_refusal([](ControlNet& net) { net.directions[0].knots = {0, 1}; });
    expect_refusal([](ControlNet& net) { net.directions[0].knots = {0, 1, 1, 2}; });
    expect_refusal([](ControlNet& net) { net.directions[0].knots = {0, 0, 1, 0}; });
    expect_refusal([](ControlNet& net) { net.points[0].back() = net.points[1].back() = 0; });
}

} // namespace
} // namespace eliminant::implicit
