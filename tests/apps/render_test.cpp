// Pictures and depth maps as the program writes them.
#include "program.hpp"

#include <nlohmann/json.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

namespace eliminant::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The arguments for a ball of radius 1, seen from (0, 0, 5) in 40 × 30 pixels.
std::vector<std::string> ball(std::vector<std::string> further) {
    std::vector<std::string> arguments{"render", "x^2+y^2+z^2 = 1", "--size", "40x30",  "--camera",
                                       "0,0,5",  "--look-at",       "0,0,0",  "--clip", "sphere:2"};
    arguments.insert(arguments.end(), further.begin(), further.end());
    return arguments;
}

void expect_quiet_success(const ProcessResult& result) {
    EXPECT_EQ(result.status, 0);
    EXPECT_EQ(result.errors, "");
    EXPECT_EQ(result.output, "");
}

std::vector<double> depths_of(const std::string& bytes) {
    std::vector<double> depths;
    for (std::size_t begin = 0; begin + 8 <= bytes.size(); begin += 8) {
        std::uint64_t word = 0;
        for (std::size_t i = 0; i < 8; ++i)
            word |= std::uint64_t{static_cast<unsigned char>(bytes[begin + i])} << (8 * i);
        depths.push_back(std::bit_cast<double>(word));
    }
    return depths;
}

/// A surface of data/surfaces and what is seen at some of the pixels of its 128 × 128 picture.
struct Case {
    std::string name;
    int degree = 0;
    std::vector<std::string> arguments;
    std::vector<std::string> expected; ///< 32 × 32 words, as in the file of data/surfaces/rays
};

std::string joined(const nlohmann::json& words) {
    std::string text;
    for (const auto& word : words) {
        if (!text.empty()) text += ',';
        text += word.get<std::string>();
    }
    return text;
}

std::vector<Case> cases() {
    const std::string folder = std::string(ELIMINANT_DATA_DIR) + "/surfaces/";
    std::ifstream surfaces(folder + "surfaces.jsonl");
    std::vector<Case> result;
    for (std::string line; std::getline(surfaces, line);) {
        const nlohmann::json surface = nlohmann::json::parse(line);
        const auto& camera = surface.at("camera");
        Case item;
        item.name = surface.at("name");
        item.degree = surface.at("degree");
        // tan(vertical field of view / 2) is 27/100.
        item.arguments = {"render",    surface.at("poly"),
                          "--size",    "128x128",
                          "--camera",  joined(camera.at("origin")),
                          "--look-at", joined(camera.at("look_at")),
                          "--up",      joined(camera.at("up")),
                          "--fov",     "30.219150244680932",
                          "--clip",    "sphere:" + surface.at("clip").at("sphere_radius").get<std::string>()};
        std::ifstream rays(folder + "rays/" + item.name + ".txt");
        std::string word;
        std::getline(rays, word); // a heading
        while (rays >> word) item.expected.push_back(word);
        EXPECT_EQ(item.expected.size(), 32U * 32U) << item.name;
        result.push_back(std::move(item));
    }
    return result;
}

/// How many of the pixels differ from what exact arithmetic found.
int wrong_pixels(const Case& item, const std::vector<double>& depths) {
    int wrong = 0;
    for (std::size_t i = 0; i < item.expected.size(); ++i) {
        const std::string& expected = item.expected[i];
        if (expected == "?") continue;
        const double found = depths.at((4 * (i / 32) + 2) * 128 + 4 * (i % 32) + 2);
        const double right = expected == "-" ? infinity : std::stod(expected);
        if (found != right && !(std::abs(found - right) <= 1e-9 * right)) ++wrong;
    }
    return wrong;
}

TEST(Render, DepthMapsAgreeWithExactArithmetic) {
    const ScratchDirectory scratch;
    const std::vector<Case> all = cases();
    ASSERT_EQ(all.size(), 14U);
    for (const Case& item : all) {
        std::vector<std::string> arguments = item.arguments;
        arguments.insert(arguments.end(), {"--depth", scratch.path("depths")});
        expect_quiet_success(run(arguments));
        EXPECT_EQ(wrong_pixels(item, depths_of(scratch.read("depths"))), 0) << item.name;
    }
}

TEST(Render, SphereTracingByTheGuaranteedBoundAgreesToo) {
    const ScratchDirectory scratch;
    for (const Case& item : cases()) {
        if (item.degree > 6) continue; // for the time it takes
        std::vector<std::string> arguments = item.arguments;
        arguments.insert(arguments.end(), {"--depth", scratch.path("depths"), "--tracing", "spheres"});
        expect_quiet_success(run(arguments));
        EXPECT_EQ(wrong_pixels(item, depths_of(scratch.read("depths"))), 0) << item.name;
    }
}

TEST(Render, EstimatesAreMostlyRight) {
    const ScratchDirectory scratch;
    for (const Case& item : cases()) {
        if (item.degree > 4) continue;
        for (const std::string bound : {"first", "second"}) {
            std::vector<std::string> arguments = item.arguments;
            arguments.insert(arguments.end(), {"--depth", scratch.path("depths"), "--bound", bound});
            expect_quiet_success(run(arguments));
            EXPECT_LE(wrong_pixels(item, depths_of(scratch.read("depths"))), 100)
                << item.name << ' ' << bound;
        }
    }
}

TEST(Render, WritesEachFormat) {
    const ScratchDirectory scratch;
    expect_quiet_success(run(ball({"-o", scratch.path("ball.png")})));
    EXPECT_EQ(scratch.read("ball.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
    expect_quiet_success(run(ball({"-o", scratch.path("ball.ppm")})));
    EXPECT_EQ(scratch.read("ball.ppm").size(), std::string("P6\n40 30\n255\n").size() + 40 * 30 * 3);
    expect_quiet_success(run(ball({"-o", scratch.path("ball.pfm")})));
    EXPECT_EQ(scratch.read("ball.pfm").substr(0, 3), "PF\n");
    expect_quiet_success(run(ball({"-o", scratch.path("picture"), "--image-format", "ppm"})));
    EXPECT_EQ(scratch.read("picture"), scratch.read("ball.ppm"));
    const ProcessResult piped = run(ball({"--image-format", "ppm"}));
    EXPECT_EQ(piped.output, scratch.read("ball.ppm"));
    EXPECT_EQ(scratch.names(), (std::vector<std::string>{"ball.pfm", "ball.png", "ball.ppm", "picture"}));
}

TEST(Render, DepthComesWithThePicture) {
    const ScratchDirectory scratch;
    expect_quiet_success(run(ball({"-o", scratch.path("ball.png"), "--depth", scratch.path("depths")})));
    const std::vector<double> depths = depths_of(scratch.read("depths"));
    ASSERT_EQ(depths.size(), 40U * 30U);
    EXPECT_EQ(depths[0], infinity);
    // The centre of a pixel beside the middle: T = tan 15°, one thirtieth of it to each side.
    const double offset = std::tan(15 * 3.14159265358979323846 / 180) / 30;
    const double length = std::sqrt(1 + 2 * offset * offset);
    const double along = 5 / length;
    EXPECT_NEAR(depths[15 * 40 + 20], along - std::sqrt(1 - (25 - along * along)), 1e-12);
    EXPECT_EQ(run(ball({"--depth", scratch.path("alone")})).output, "");
    EXPECT_EQ(scratch.read("alone"), scratch.read("depths"));
}

TEST(Render, ThreadsDoNotChangeTheFile) {
    const ScratchDirectory scratch;
    std::vector<std::string> pictures;
    for (const std::string threads : {"1", "2", "3"}) {
        expect_quiet_success(run({"render", "x^4+y^4+z^4-5*(x^2+y^2+z^2)+11.8", "--size", "150x140",
                                  "--antialias", "2", "--shadows", "--ambient-occlusion", "--seed", "7",
                                  "--threads", threads, "-o", scratch.path("picture.png")}));
        pictures.push_back(scratch.read("picture.png"));
    }
    EXPECT_EQ(pictures[0], pictures[1]);
    EXPECT_EQ(pictures[0], pictures[2]);
}

TEST(Render, AParametrizationIsImplicitizedFirst) {
    const ScratchDirectory scratch;
    const std::string file = scratch.write(
        "ball.par",
        "constants r\nx = 2*r*s/(s^2+t^2+1)\ny = 2*r*t/(s^2+t^2+1)\nz = r*(s^2+t^2-1)/(s^2+t^2+1)\n");
    std::vector<std::string> arguments = ball({"--set", "r=1", "-o", scratch.path("from_map.ppm")});
    arguments[1] = file;
    expect_quiet_success(run(arguments));
    expect_quiet_success(run(ball({"-o", scratch.path("from_equation.ppm")})));
    EXPECT_EQ(scratch.read("from_map.ppm"), scratch.read("from_equation.ppm"));
}

/// What the program chooses to show of a surface.
struct ShownBall {
    double radius = 0;
    double x = 0;
    double y = 0;
    double z = 0;

    bool contains(double px, double py, double pz) const {
        return std::hypot(px - x, py - y, pz - z) <= radius;
    }
};

ShownBall shown(const std::vector<std::string>& surface) {
    const ScratchDirectory scratch;
    std::vector<std::string> arguments{"render", "-o", scratch.path("a.png"), "--size", "8x6", "-v"};
    arguments.insert(arguments.end(), surface.begin(), surface.end());
    const ProcessResult result = run(arguments);
    EXPECT_EQ(result.status, 0) << result.errors;
    const std::string before = "clip: within the ball of radius ";
    const std::size_t begin = result.errors.find(before);
    ShownBall ball;
    if (begin == std::string::npos) {
        ADD_FAILURE() << "it said: " << result.errors;
        return ball;
    }
    EXPECT_EQ(std::sscanf(result.errors.c_str() + begin + before.size(), "%lf around %lf,%lf,%lf",
                          &ball.radius, &ball.x, &ball.y, &ball.z),
              4);
    return ball;
}

TEST(Render, ShowsWhatTheParametersReach) {
    // Corners and the centre of the image of the unit square; the asymptotes of the polynomial of degree 18
    // would need a ball a thousand times as large.
    const ShownBall patch = shown({std::string(ELIMINANT_DATA_DIR) + "/implicit/bicubic_hoffmann.par"});
    EXPECT_TRUE(patch.contains(-1, 0, 0));
    EXPECT_TRUE(patch.contains(3, 4, 0));
    EXPECT_TRUE(patch.contains(1.75, 2, 0.140625));
    EXPECT_LT(patch.radius, 5);

    const ScratchDirectory scratch;
    const ShownBall net =
        shown({scratch.write("a.net", "patch far\nbezier 1 1\n100 0 0\n101 0 0\n100 1 0\n101 1 1\n")});
    EXPECT_TRUE(net.contains(100, 0, 0));
    EXPECT_TRUE(net.contains(101, 1, 1));
    EXPECT_LT(net.radius, 2);

    const ShownBall ball = shown(
        {"x = r*cos(u)*cos(v)", "y = r*sin(u)*cos(v)", "z = 7 + r*sin(v)", "constants r", "--set", "r=1/8"});
    EXPECT_NEAR(ball.z, 7, 1e-5);
    EXPECT_NEAR(ball.radius, 0.13, 0.01);
}

TEST(Render, ChoosesTheRangeOfParameters) {
    // [-1, 1] for an even map, the whole line for a bounded one.
    const ShownBall even = shown({"x = u*v", "y = u", "z = v^2"});
    EXPECT_TRUE(even.contains(-1, -1, 1));
    EXPECT_LT(even.radius, 3);
    const ShownBall bounded =
        shown({"x = 2*u/(1+u^2+v^2)", "y = 2*v/(1+u^2+v^2)", "z = (u^2+v^2-1)/(1+u^2+v^2)"});
    EXPECT_TRUE(bounded.contains(0, 0, -1));
    EXPECT_TRUE(bounded.contains(0, 0, 1));
    EXPECT_LT(bounded.radius, 1.2);
    const ShownBall with_pole = shown({"x = u", "y = v", "z = 1/(1000*u*v + u + 1)"});
    EXPECT_LT(with_pole.radius, 10);
}

TEST(Render, PreviewsEndInTheSamePicture) {
    const ScratchDirectory scratch;
    expect_quiet_success(run(ball({"-o", scratch.path("a.ppm")})));
    expect_quiet_success(run(ball({"-o", scratch.path("b.ppm"), "--preview"})));
    EXPECT_EQ(scratch.read("a.ppm"), scratch.read("b.ppm"));
}

TEST(Render, RegionsAreIntersected) {
    const ScratchDirectory scratch;
    // Looking along −z at the half z ≤ 0: the sphere's far side, and nothing where x > 1/2.
    expect_quiet_success(run({"render", "x^2+y^2+z^2 = 1", "--size", "41x41", "--camera", "0,0,5",
                              "--look-at", "0,0,0", "--orthographic", "2", "--clip", "halfspace:0,0,1,0",
                              "--clip", "box:-2,-2,-2,1/2,2,2", "--depth", scratch.path("depths")}));
    const std::vector<double> depths = depths_of(scratch.read("depths"));
    ASSERT_EQ(depths.size(), 41U * 41U);
    EXPECT_NEAR(depths[20 * 41 + 20], 6, 1e-12);
    for (std::size_t column = 0; column < 41; ++column) {
        const double x = (2.0 * static_cast<double>(column) + 1 - 41) / 41;
        const double expected = x <= 0.5 ? 5 + std::sqrt(1 - x * x) : infinity;
        EXPECT_TRUE(depths[20 * 41 + column] == expected ||
                    std::abs(depths[20 * 41 + column] - expected) < 1e-9);
    }
}

TEST(Render, SaysWhatIsWrong) {
    const auto expect = [](const std::vector<std::string>& arguments, const std::string& part) {
        expect_error_with(run(ball(arguments)), 2, part);
    };
    const ScratchDirectory scratch;
    const std::string file = scratch.path("picture.png");
    expect({"-o", file, "--camera", "0,0,0"},
           "--camera: expected a point other than the one that is looked at, found '0,0,0'");
    expect({"-o", file, "--up", "0,0,1"},
           "--up: expected a direction that is not along the line of sight, found '0,0,1'");
    expect({"-o", file, "--fov", "180"},
           "eliminant: --fov: expected an angle between 0 and 180 degrees, found '180'");
    expect({"-o", file, "--fov", "20", "--orthographic", "3"}, "--fov: expected a perspective camera");
    expect({"-o", file, "--orthographic", "0"}, "--orthographic: expected a height");
    expect({"-o", file, "--specular", "3"}, "--specular: expected a part from 0 to 1, found '3'");
    expect({"-o", file, "--shininess", "-1"}, "--shininess: expected a number from 0 to 10000");
    expect({"-o", file, "--camera", "1e300,0,0"},
           "eliminant: --camera: expected numbers from -1e100 to 1e100");
    expect({"-o", file, "--up", "0,0,0"}, "--up: expected a direction other than 0,0,0");
    expect({"-o", file, "--light", "1,0,0;1;90"},
           "--light: expected an angle from 0 to 45 degrees, found '90'");
    expect({"-o", file, "--clip", "halfspace:0,0,0,1"}, "--clip: expected a half-space with a normal");
    expect({"-o", file, "--fov", "wide"}, "--fov");
    expect({"-o", file, "--camera", "1,2"}, "--camera: expected 3 numbers separated by commas, found '1,2'");
    expect({"-o", file, "--camera", "1,2,1/0"}, "--camera:1:");
    expect({"-o", file, "--camera", "1,2,1e999"}, "a number that floating point can hold");
    expect({"-o", file, "--size", "640"}, "--size: expected WIDTHxHEIGHT");
    expect({"-o", file, "--size", "0x5"}, "--size: expected a whole number from 1");
    expect({"-o", file, "--clip", "cube:1"}, "--clip: expected sphere:R, box:");
    expect({"-o", file, "--clip", "box:1,1,1,0,0,0"}, "--clip: expected the lower corner");
    expect({"-o", file, "--clip", "sphere:-1"}, "--clip: expected a radius from 0");
    expect({"-o", file, "--antialias", "17"}, "--antialias");
    expect({"-o", file, "--light", "0,0,0"}, "eliminant: --light: expected a direction other than 0,0,0");
    expect({"-o", file, "--light", "0,0,1;#12"}, "a colour as #e8a33d");
    expect({"-o", file, "--background", "2"}, "channels from 0 to 1");
    expect({"-o", file, "--over-relaxation", "2", "--tracing", "spheres"},
           "--over-relaxation: expected a number F");
    expect({"-o", file, "--bound", "first", "--tracing", "roots"}, "--tracing");
    expect({"-o", file, "--bound", "third"}, "--bound: expected");
    expect({"-o", scratch.path("picture.jpeg")}, "a format png, ppm or pfm");
    expect({"-o", scratch.path("picture")}, "a name without extension");
    expect({"-o", scratch.path("none/picture.png")}, "no such directory");
    expect({"-o", file, "--depth", scratch.path("none/depths")}, "no such directory");
    expect({"-o", file, "--format", "json"}, "--format");
    expect({"--preview"}, "--preview");
    expect_error_with(run({"render", "x^2+y^2 = r", "-o", file}), 2, "--set r=2");
    EXPECT_EQ(scratch.names(), std::vector<std::string>{});
}

TEST(Render, SaysWhatHasNoEffect) {
    const ScratchDirectory scratch;
    const std::string file = scratch.path("picture.png");
    const auto expect_warning = [&](std::vector<std::string> options, const std::string& part) {
        options.insert(options.end(), {"-o", file});
        const ProcessResult outcome = run(ball(options));
        EXPECT_EQ(outcome.status, 0);
        EXPECT_NE(outcome.errors.find("warning: " + part), std::string::npos) << outcome.errors;
    };
    expect_warning({"--shadow-rays", "4"}, "--shadow-rays has no effect without --shadows");
    expect_warning({"--ambient-rays", "4"}, "--ambient-rays has no effect without --ambient-occlusion");
    expect_warning({"--max-steps", "4"}, "--max-steps has no effect without --tracing spheres");
    expect_warning({"--sampling", "full"}, "--sampling has no effect without --antialias");
    expect_warning({"--shadows", "--colouring", "normal"}, "lights, shadows and materials have no effect");
}

TEST(Render, PfmIsTheSameInFilesAndPipes) {
    const ScratchDirectory scratch;
    expect_quiet_success(run(ball({"-o", scratch.path("a.pfm"), "--size", "33x17"})));
    const ProcessResult piped = run(ball({"--image-format", "pfm", "--size", "33x17"}));
    EXPECT_EQ(piped.status, 0);
    EXPECT_EQ(scratch.read("a.pfm"), piped.output);
    EXPECT_EQ(piped.output.size(), std::string("PF\n33 17\n-1.0\n").size() + 33 * 17 * 12);
}

/// A picture that takes minutes.
std::vector<std::string> endless_picture(const std::string& file) {
    return {"render",      "x^4+y^4+z^4-5*(x^2+y^2+z^2)+11.8",
            "--size",      "8000x8000",
            "--antialias", "16",
            "--sampling",  "full",
            "-o",          file};
}

TEST(Render, InterruptionLeavesNoFile) {
    const ScratchDirectory scratch;
    const ProcessResult result = run(endless_picture(scratch.path("picture.png")),
                                     {.terminal = true, .signals = {SIGINT}, .signal_after = "left"});
    EXPECT_EQ(result.status, 130);
    EXPECT_NE(result.errors.find(" picture "), std::string::npos);
    EXPECT_EQ(scratch.names(), std::vector<std::string>{});
}

TEST(Render, ALimitLeavesNoFile) {
    const ScratchDirectory scratch;
    std::vector<std::string> arguments = endless_picture(scratch.path("picture.ppm"));
    arguments.insert(arguments.end(), {"--time-limit", "0.3"});
    expect_error(run(arguments), 3, "time limit reached");
    EXPECT_EQ(scratch.names(), std::vector<std::string>{});
}

TEST(Render, DegenerateSurfacesAreDrawn) {
    const ScratchDirectory scratch;
    const auto depths = [&](const std::string& polynomial, const std::string& warning = "") {
        std::vector<std::string> arguments = ball({"--depth", scratch.path("depths")});
        arguments[1] = polynomial;
        const ProcessResult result = run(arguments);
        EXPECT_EQ(result.status, 0) << polynomial;
        EXPECT_EQ(result.errors, warning.empty() ? "" : "eliminant: warning: " + warning + "\n");
        return depths_of(scratch.read("depths"));
    };
    for (const char* nowhere : {"1", "x^2+y^2+z^2+1"})
        for (const double depth : depths(nowhere, "no ray meets the surface")) EXPECT_EQ(depth, infinity);
    // Everywhere: where the clip region begins.
    EXPECT_NEAR(depths("0", "every point is on the surface of the zero polynomial")[15 * 40 + 20], 3, 0.01);
    EXPECT_NEAR(depths("z^2")[15 * 40 + 20], 5, 0.01); // a double plane is met by every ray
    EXPECT_EQ(depths("(x^2+y^2+z^2-1)^3"), depths("x^2+y^2+z^2-1"));
}

} // namespace
} // namespace eliminant::test
