// Many shapes in a text: how it is taken apart, and what is passed on in which sequence. The Utah teapot.
#include "eliminant/implicit/batch.hpp"

#include "eliminant/base/error.hpp"
#include "eliminant/implicit/control_net.hpp"
#include "implicit/support.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

namespace eliminant::implicit {
namespace {

/// They refer to the text.
std::vector<ShapeSource> sources_of(const std::string& text) {
    base::Run run;
    return shape_sources(SourceText(text, "test"), run);
}

std::vector<std::string> names_of(const std::vector<ShapeSource>& sources) {
    std::vector<std::string> names;
    for (const ShapeSource& source : sources) names.push_back(source.name);
    return names;
}

using Names = std::vector<std::string>;

TEST(ShapeSources, AreTakenApartByNamesOrNets) {
    const std::string net = "bezier 1\n0 0\n1 1\n";
    const std::string formulas = "x = t\ny = t^2\n";
    EXPECT_EQ(names_of(sources_of(formulas)), Names{""});
    EXPECT_EQ(names_of(sources_of(net)), Names{""});
    EXPECT_EQ(names_of(sources_of("# c\n" + net + net + "\n" + net)), (Names{"1", "2", "3"}));
    const std::string batch = "# c\npatch a # the first\n" + net + "patch the second \n\n" + formulas;
    const auto sources = sources_of(batch);
    EXPECT_EQ(names_of(sources), (Names{"a", "the second"}));
    base::Run run;
    EXPECT_EQ(parse_shapes(sources[0], run).size(), 1U);
    EXPECT_EQ(parse_shapes(sources[1], run).front().name, "the second");
    EXPECT_EQ(names_of(sources_of("patch = t\nbezier = t^2\n")), Names{""}) << "coordinates of such names";
    EXPECT_EQ(names_of(sources_of("")), Names{""});
}

TEST(ShapeSources, NamesAreGivenOnceAndToAll) {
    const auto expect_error = [](const std::string& text, const std::string& place) {
        try {
            sources_of(text);
            ADD_FAILURE() << text;
        } catch (const ParseError& error) {
            EXPECT_EQ(std::string(error.what()).rfind("test:" + place + ": ", 0), 0U) << error.what();
        }
    };
    expect_error("patch\nx = t\n", "1:6");
    expect_error("patch a\nx = t\npatch a\n", "3:1");
    expect_error("\nx = t\npatch a\nx = t\n", "2:1");
}

/// What is passed on: name, then equations or the error.
std::vector<std::string> implicitize_all(const std::string& text, unsigned threads) {
    RunOptions run_options;
    run_options.threads = threads;
    base::Run run(run_options);
    std::vector<std::string> lines;
    implicitize_shapes(shape_sources(SourceText(text, "test"), run), {}, run, [&](const ShapeResult& shape) {
        std::string line = shape.name + ": ";
        if (shape.result) {
            lines.push_back(line + joined(shape.result->equations));
            EXPECT_EQ(shape.coordinate_count, shape.result->ring.variable_count());
            return;
        }
        try {
            std::rethrow_exception(shape.error);
        } catch (const Error& error) {
            lines.push_back(line + error.what());
        }
    });
    return lines;
}

TEST(Batch, ResultsComeInSequenceEachOrAnErrorOfItsOwn) {
    const std::string text = "patch line\nbezier 1\n0 0\n1 1\n"
                             "patch wrong\nx = t\ny = u +\n"
                             "patch spline\nbspline 1\nknots 0 0 1 2 2\n0 0\n1 0\n1 1\n"
                             "patch cubic\nx = t\ny = t^3\n"
                             "patch weightless\nrational bezier 1\n0 0 0\n1 1 0\n";
    const std::vector<std::string> expected = {
        "line: x-y",
        "wrong: test:7:8: expected a number, a name or a parenthesis, found end of line",
        "spline[0]: y",
        "spline[1]: x-1",
        "cubic: x^3-y",
        std::string("weightless: test:21:1: expected weights that are not all 0 on any piece, ") +
            "found a piece where they are",
    };
    for (const unsigned threads : {1U, 2U, 4U})
        EXPECT_EQ(implicitize_all(text, threads), expected) << threads;
}

TEST(Batch, StopsAsAWhole) {
    base::Run run;
    const std::string text = "patch a\nx = t\ny = t^2\npatch b\nx = t\ny = t^3\n";
    const auto sources = sources_of(text);
    int results = 0;
    EXPECT_THROW(implicitize_shapes(sources, {}, run,
                                    [&](const ShapeResult&) {
                                        ++results;
                                        run.request_stop();
                                    }),
                 Stopped);
    EXPECT_EQ(results, 1);
}

std::string teapot_text() {
    std::ifstream file(std::filesystem::path(ELIMINANT_DATA_DIR) / "teapot" / "teapot.net");
    return {std::istreambuf_iterator<char>(file), {}};
}

using Point = std::vector<mpq_class>;

std::map<std::string, ControlNet> teapot_nets(const std::string& text) {
    base::Run run;
    std::map<std::string, ControlNet> nets;
    for (const ShapeSource& source : sources_of(text))
        nets.emplace(source.name, parse_control_net(source.text, run));
    return nets;
}

TEST(Teapot, HasTheSymmetriesOfThePublishedTable) {
    const auto nets = teapot_nets(teapot_text());
    EXPECT_EQ(nets.size(), 32U);
    std::set<Point> points;
    for (const auto& [name, net] : nets) {
        EXPECT_EQ(net.points.size(), 16U) << name;
        points.insert(net.points.begin(), net.points.end());
    }
    EXPECT_EQ(points.size(), 290U);

    // Four quarters each, turned about the axis; the bottom turns the other way.
    for (const auto& [group, quarters, sign] :
         {std::tuple("rim_", 4, 1), {"body_", 8, 1}, {"lid_", 8, 1}, {"bottom_", 4, -1}}) {
        for (int i = 1; i <= quarters; ++i) {
            if (i % 4 == 0) continue;
            const ControlNet& net = nets.at(group + std::to_string(i));
            const ControlNet& next = nets.at(group + std::to_string(i + 1));
            for (std::size_t k = 0; k < net.points.size(); ++k) {
                const Point& p = net.points[k];
                EXPECT_EQ(next.points[k], (Point{sign * p[1], -sign * p[0], p[2]})) << group << i;
            }
        }
    }
    // The halves of handle and spout are mirror images.
    for (const char* group : {"handle_", "spout_"}) {
        for (const int i : {1, 3}) {
            const ControlNet& half = nets.at(group + std::to_string(i));
            const ControlNet& other = nets.at(group + std::to_string(i + 1));
            for (std::size_t k = 0; k < half.points.size(); ++k) {
                const Point& p = half.points[4 * (k / 4) + 3 - k % 4];
                EXPECT_EQ(other.points[k], (Point{p[0], -p[1], p[2]})) << group << i;
            }
        }
    }
}

TEST(Teapot, NeighboursShareTheirEdges) {
    // Each edge belongs to two patches but those that are a point, the rims of pot and lid, and the ends of
    // handle and spout, which are stuck into the pot.
    std::map<std::vector<Point>, int> edges;
    std::size_t points = 0;
    for (const auto& [name, net] : teapot_nets(teapot_text())) {
        for (const auto& [first, step] : {std::pair(0, 1), {12, 1}, {0, 4}, {3, 4}}) {
            std::vector<Point> edge;
            for (int k = 0; k < 4; ++k) {
                const int index = first + k * step;
                edge.push_back(net.points[static_cast<std::size_t>(index)]);
            }
            if (std::set<Point>(edge.begin(), edge.end()).size() == 1) {
                ++points;
                continue;
            }
            if (edge.back() < edge.front()) std::ranges::reverse(edge);
            ++edges[edge];
        }
    }
    EXPECT_EQ(points, 8U) << "four in the lid, four in the bottom";
    std::map<int, int> uses;
    for (const auto& [edge, count] : edges) ++uses[count];
    EXPECT_EQ(uses, (std::map<int, int>{{1, 16}, {2, 52}}));
}

TEST(Teapot, AllPatchesAreImplicitizedAndProved) {
    base::Run run;
    const std::string text = teapot_text();
    std::map<std::string, std::int64_t> degrees;
    std::mt19937_64 random(5);
    const std::vector<ShapeSource> sources = sources_of(text);
    implicitize_shapes(sources, {}, run, [&](const ShapeResult& shape) {
        ASSERT_TRUE(shape.result) << shape.name;
        ASSERT_EQ(shape.result->equations.size(), 1U) << shape.name;
        EXPECT_EQ(shape.result->assurance, Assurance::proved);
        degrees[shape.name] = shape.result->equations[0].total_degree();
        const auto shapes = parse_shapes(sources[degrees.size() - 1], run);
        EXPECT_EQ(shapes.front().name, shape.name);
        EXPECT_TRUE(vanishes_on_image(shape.result->equations[0], shapes.front().parametrization, random));
    });
    EXPECT_EQ(degrees.size(), 32U);
    EXPECT_EQ(degrees["rim_1"], 9);
    EXPECT_EQ(degrees["handle_3"], 18);
    EXPECT_EQ(degrees["spout_1"], 18);
    EXPECT_EQ(degrees["lid_1"], 13);
    EXPECT_EQ(degrees["bottom_4"], 9);
}

} // namespace
} // namespace eliminant::implicit
