/// \file
/// `eliminant render`.
#include "command.hpp"
#include "render_options.hpp"
#include "surface_argument.hpp"

#include "eliminant/scene/algebraic_surface.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include <unistd.h>

namespace eliminant::app {

namespace {

/// A file of a picture on its way: bands are encoded and written as they come.
class PictureFile {
  public:
    PictureFile(OutputStream stream, ImageFormat format, ImageSize size)
        : stream_(std::move(stream)),
          writer_(format == ImageFormat::pfm ? render::make_seeking_writer(format, size, placing())
                                             : make_writer(format, size, appending())) {}
    PictureFile(const PictureFile&) = delete;
    PictureFile& operator=(const PictureFile&) = delete;

    void write(const render::ImageRows& rows) { writer_->write(rows); }
    void finish() {
        writer_->finish();
        stream_.finish();
    }

  private:
    render::ByteSink appending() {
        return [this](std::string_view bytes) { stream_.write(bytes); };
    }
    render::PositionedSink placing() {
        return [this](std::uint64_t offset, std::string_view bytes) { stream_.write_at(offset, bytes); };
    }

    OutputStream stream_;
    std::unique_ptr<render::ImageWriter> writer_;
};

/// The rows of a coarse picture, every pixel repeated to the size of the fine one.
void write_enlarged(const Image& coarse, ImageSize size, PictureFile& file) {
    std::vector<float> colours(3 * std::size_t{size.width});
    for (std::uint32_t row = 0; row < size.height; ++row) {
        const std::uint32_t coarse_row =
            static_cast<std::uint32_t>(std::uint64_t{row} * coarse.size().height / size.height);
        for (std::uint32_t column = 0; column < size.width; ++column) {
            const auto coarse_column =
                static_cast<std::uint32_t>(std::uint64_t{column} * coarse.size().width / size.width);
            const render::Colour colour = coarse.colour(coarse_column, coarse_row);
            std::copy(colour.begin(), colour.end(), &colours[3 * std::size_t{column}]);
        }
        file.write({size.width, row, 1, colours, {}});
    }
    file.finish();
}

class RenderCommand : public Command {
  public:
    std::string_view usage() const override { return "SURFACE -o PICTURE"; }

    std::string_view description() const override {
        static const std::string text =
            "A picture of an algebraic surface, right in every pixel: a pixel shows the surface if and only "
            "if the "
            "ray\nthrough its centre meets it.\n\n" +
            std::string(surface_help) +
            "\nWithout --clip a bounded surface is shown as a whole, another one as far as its asymptotes. "
            "Of a\n"
            "parametrization that part is shown which the parameters reach. Angles run over the full circle, "
            "the\n"
            "parameters of a control net over [0, 1]; others over [0, 1], [-1, 1] or the whole line, the "
            "last of\n"
            "these before what is reached grows threefold.\n"
            "\nPICTURE is a .png, .ppm or .pfm file. Numbers may be integers, decimals or fractions.\n"
            "\n"
            "Examples:\n"
            "  eliminant render '(x^2+y^2+z^2+3)^2 = 16*(x^2+y^2)' -o torus.png\n"
            "  eliminant render patch.par -o patch.png --size 1280x960 --antialias 4 --shadows "
            "--ambient-occlusion\n"
            "  eliminant render 'x^2 = y^2*z' -o whitney.png --clip sphere:2 --camera 4,3,5 --look-at 0,0,0 "
            "--fov 35\n"
            "  eliminant render 'x^2+y^2+z^2 = r^2' --set r=3/2 -o ball.png --orthographic 4 --clip "
            "box:-2,-2,-2,2,2,2 "
            "--clip halfspace:1,0,1,1\n"
            "  eliminant render 'x^4+y^4+z^4-5*(x^2+y^2+z^2)+11.8' -o bent.png --colouring mean-curvature\n"
            "  eliminant render 'x^3+y^3+z^3 = 1' -o sunny.png --light '1,2,1;#ffe0b0;3' --light "
            "'-1,0,1;0.3' --shadows\n";
        return text;
    }

    void declare(OptionSet& options) override {
        constants_.declare(options);
        settings_.declare(options);
    }

    ExitStatus run(std::span<const std::string> operands, Session& session) override {
        const bool has_picture = check_output(session);
        const RenderOptions options = settings_.rendering();
        const ImageFormat format = has_picture ? settings_.format_of(session.output()) : ImageFormat::png;
        for (const std::string& warning : settings_.unused()) session.console().warning(warning);
        std::optional<Destination> depth_destination;
        if (const std::string& file = settings_.depth_file(); !file.empty())
            depth_destination =
                has_picture ? session.destination_beside_result("--depth", file) : Destination(file);

        const SurfaceArgument argument = read_surface(operands, constants_, session);
        const std::unique_ptr<Surface> surface = algebraic_surface(argument.polynomial, session.run());
        const RenderSettings::View view =
            settings_.view([&] { return framed_part(argument, *surface, session.run()); });
        describe(view, session);
        session.console().expect_steady_progress();
        if (settings_.preview()) draw_previews(*surface, view, options, format, session);

        std::optional<PictureFile> picture;
        std::optional<PictureFile> depths;
        if (has_picture) picture.emplace(session.open_result(), format, options.size);
        if (depth_destination)
            depths.emplace(depth_destination->open(session.run()), ImageFormat::depth, options.size);
        const RenderStatistics statistics =
            render::render(*surface, view.camera, view.clip, view.lighting, options, session.run(),
                           [&](const render::ImageRows& rows) {
                               if (picture) picture->write(rows);
                               if (depths) depths->write(rows);
                           });
        session.console().clear_progress();
        if (depths) depths->finish();
        if (picture) picture->finish();
        if (statistics.hits == 0) session.console().warning("no ray meets the surface");
        if (argument.polynomial.is_zero())
            session.console().warning("every point is on the surface of the zero polynomial");
        describe(statistics, session);
        return exit_done;
    }

  private:
    /// Whether a picture is to be written; if not, there is a depth file.
    bool check_output(const Session& session) const {
        if (session.format() != ResultFormat::text)
            throw UsageError("--format: a picture has none of these; see --image-format");
        const bool to_file = !session.output().empty() && session.output() != "-";
        if (settings_.preview() && !to_file) throw UsageError("--preview: expected a file as -o, found none");
        if (!session.output().empty()) return true;
        if (!settings_.depth_file().empty()) return false;
        if (isatty(STDOUT_FILENO) == 1)
            throw UsageError("expected -o PICTURE, found none (and standard output is a terminal)");
        return true;
    }

    /// What is to be seen if nobody says it: the image of the parameters if there are any.
    static Ball framed_part(const SurfaceArgument& argument, const Surface& surface, Run& run) {
        std::optional<Ball> image;
        if (argument.map) image = ball_around_image(*argument.map, argument.range, run);
        return image ? *image : surface.framing_ball(run);
    }

    /// The picture at an eighth, a quarter and half of its size, each replacing the one before.
    static void draw_previews(const Surface& surface, const RenderSettings::View& view, RenderOptions options,
                              ImageFormat format, Session& session) {
        const ImageSize size = options.size;
        options.antialias = 1;
        for (const std::uint32_t divisor : {8U, 4U, 2U}) {
            options.size = {(size.width + divisor - 1) / divisor, (size.height + divisor - 1) / divisor};
            const Image coarse =
                render_image(surface, view.camera, view.clip, view.lighting, options, session.run());
            PictureFile file(session.open_result(), format, size);
            write_enlarged(coarse, size, file);
        }
    }

    static void describe(const RenderSettings::View& view, Session& session) {
        const auto text = [](const glm::dvec3& v) {
            return std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z);
        };
        session.console().detail("camera: " + text(view.camera.origin()) + " towards " +
                                 text(view.camera.forward()));
        if (const std::optional<Ball> ball = view.clip.bounding_ball())
            session.console().detail("clip: within the ball of radius " + std::to_string(ball->radius) +
                                     " around " + text(ball->center));
    }

    static void describe(const RenderStatistics& statistics, Session& session) {
        Console& console = session.console();
        console.detail("rays: " + std::to_string(statistics.rays) +
                       ", hits: " + std::to_string(statistics.hits) +
                       ", rays for shadows and occlusion: " + std::to_string(statistics.occlusion_rays) +
                       ", refined pixels: " + std::to_string(statistics.refined_pixels));
        if (const auto& stepping = statistics.stepping)
            console.detail("steps: " + std::to_string(stepping->steps) +
                           ", taken back: " + std::to_string(stepping->back_steps) +
                           "; rays that left the region: " + std::to_string(stepping->left) +
                           ", came near the surface: " + std::to_string(stepping->came_near) +
                           ", ran out of steps: " + std::to_string(stepping->ran_out));
        console.detail("seconds: " + std::to_string(session.seconds()) +
                       ", peak memory: " + std::to_string(peak_memory() >> 20) + " MiB");
    }

    ConstantValues constants_;
    RenderSettings settings_;
};

} // namespace

std::unique_ptr<Command> make_render() { return std::make_unique<RenderCommand>(); }

} // namespace eliminant::app
