#include "render_options.hpp"

#include "common_options.hpp"
#include "scene_text.hpp"

#include "eliminant/field/distance.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>
#include <utility>

namespace eliminant::app {

namespace {

/// A setter that reads a value with `read` and assigns it.
template <class Target, class Read>
OptionSet::Setter into(Target& target, std::string name, Read read) {
    return [&target, name = std::move(name), read](std::string_view text) {
        target = read(SourceText(text, name));
    };
}

/// The same for a number between bounds.
template <class Target>
OptionSet::Setter number_in(Target& target, std::string name, double least, double most,
                            std::string expected) {
    return into(target, std::move(name),
                [least, most, expected = std::move(expected)](const SourceText& text) {
                    return read_number_in(text, least, most, expected);
                });
}

template <class Target>
OptionSet::Setter whole_number(Target& target, std::uint32_t least, std::uint32_t most) {
    return [&target, least, most](std::string_view text) {
        target = static_cast<std::uint32_t>(read_whole_number(text, least, most));
    };
}

std::string text_of(const glm::dvec3& v) {
    std::ostringstream text;
    text << v.x << ',' << v.y << ',' << v.z;
    return text.str();
}

/// Of a field of view: a picture of less is one point.
constexpr double least_angle = 1e-9;

std::string extension_of(const std::string& file) {
    const std::size_t dot = file.rfind('.');
    if (dot == std::string::npos || file.find('/', dot) != std::string::npos) return {};
    std::string extension = file.substr(dot + 1);
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

} // namespace

void RenderSettings::declare(OptionSet& options) {
    options.heading("Picture");
    declare_picture(options);
    options.heading("View");
    declare_view(options);
    options.heading("Lights and colours");
    declare_light(options);
    options.heading("Tracing");
    declare_tracing(options);
}

void RenderSettings::declare_picture(OptionSet& options) {
    options.value("size", 0, "WxH", "pixels (default 640x480)",
                  [this](std::string_view text) { options_.size = read_size(text); });
    options.value("antialias", 0, "N", "N x N samples a pixel where colours change (default 1, at most 16)",
                  whole_number(options_.antialias, 1, 16));
    options.choice<bool>("sampling", "where the N x N samples are taken (default adaptive)",
                         {{"adaptive", false}, {"full", true}}, full_sampling_);
    options.choice<std::optional<ImageFormat>>(
        "image-format", "the format of the picture (default: by the extension of -o, else png)",
        {{"png", ImageFormat::png}, {"ppm", ImageFormat::ppm}, {"pfm", ImageFormat::pfm}}, format_);
    options.value("depth", 0, "FILE",
                  "also write the distance of each pixel's first hit from the camera:\n"
                  "little-endian float64, row by row from the top, infinity for a miss",
                  [this](std::string_view text) { depth_file_ = text; });
    options.flag("preview", 0,
                 "write -o FILE first coarsely, then finer and finer; the last complete one\n"
                 "stays when the program is interrupted",
                 preview_);
}

void RenderSettings::declare_view(OptionSet& options) {
    options.value("camera", 0, "X,Y,Z", "where the camera stands (default: so that the surface is in view)",
                  into(origin_, "--camera", read_point));
    options.value("look-at", 0, "X,Y,Z",
                  "the point in the middle of the picture (default: that of what is shown)",
                  into(look_at_, "--look-at", read_point));
    options.value("up", 0, "X,Y,Z",
                  "the direction that is up (default 0,1,0, or 0,0,1 along the line of sight)",
                  into(up_, "--up", read_direction));
    options.value("fov", 0, "DEGREES", "vertical field of view (default 30)",
                  number_in(field_of_view_, "--fov", least_angle, 180 - least_angle,
                            "an angle between 0 and 180 degrees"));
    options.value("orthographic", 0, "HEIGHT",
                  "parallel projection of so much from top to bottom, instead of a field of view",
                  number_in(orthographic_height_, "--orthographic", 1 / most_coordinate, most_coordinate,
                            "a height from 1e-100 to 1e100"));
    options.values("clip", "REGION",
                   "draw only what is in sphere:R (around 0), box:x0,y0,z0,x1,y1,z1 or\n"
                   "halfspace:a,b,c,d (ax+by+cz <= d); may be repeated. The surface is cut open, not capped\n"
                   "(default: a ball, see above)",
                   [this](std::string_view text) { add_region(clip_, SourceText(text, "--clip")); });
}

void RenderSettings::declare_light(OptionSet& options) {
    options.values(
        "light", "X,Y,Z[;COLOUR[;DEGREES]]",
        "a light in this direction, its colour (default white), the angle from its middle to\n"
        "its edge (default 0: hard shadows); may be repeated (default: three that go with the camera)",
        [this](std::string_view text) { lights_.push_back(read_light(SourceText(text, "--light"))); });
    options.value("ambient", 0, "COLOUR", "light from everywhere", into(ambient_, "--ambient", read_colour));
    options.value("background", 0, "COLOUR", "#rrggbb, r,g,b or a grey from 0 to 1 (default #fff)",
                  into(background_, "--background", read_colour));
    options.value("outside", 0, "COLOUR", "the surface seen from where its polynomial is positive",
                  into(outside_, "--outside", read_colour));
    options.value("inside", 0, "COLOUR", "the surface seen from where it is negative",
                  into(inside_, "--inside", read_colour));
    options.value("specular", 0, "PART", "how much light highlights reflect, from 0 to 1 (default 0.05)",
                  number_in(specular_, "--specular", 0, 1, "a part from 0 to 1"));
    options.value("shininess", 0, "N", "how small highlights are, from 0 to 10000 (default 80)",
                  number_in(shininess_, "--shininess", 0, 10000, "a number from 0 to 10000"));
    options.flag("shadows", 0, "lights cast shadows", shadows_);
    options.value("shadow-rays", 0, "N", "rays for a soft shadow (default 16)",
                  whole_number(shadow_rays_, 1, 1024));
    options.flag("ambient-occlusion", 0, "hollows receive less of the ambient light", ambient_occlusion_);
    options.value("ambient-rays", 0, "N", "rays for ambient occlusion (default 16)",
                  whole_number(ambient_rays_, 1, 1024));
    options.choice<Colouring>("colouring", "what colours show (default material)",
                              {{"material", Colouring::material},
                               {"normal", Colouring::normal},
                               {"depth", Colouring::depth},
                               {"mean-curvature", Colouring::mean_curvature},
                               {"gaussian-curvature", Colouring::gaussian_curvature},
                               {"steps", Colouring::steps}},
                              options_.colouring);
}

void RenderSettings::declare_tracing(OptionSet& options) {
    options.choice<Bound>(
        "bound",
        "the distance that rays step by. With guaranteed (default) every pixel is right;\n"
        "first and second order are estimates and can miss parts of the surface",
        {{"first", Bound::first}, {"second", Bound::second}, {"guaranteed", Bound::guaranteed}}, bound_);
    options.choice<Tracing>(
        "tracing",
        "roots isolates the first root along each ray, spheres steps by the bound\n"
        "(default: roots with the guaranteed bound, otherwise spheres)",
        {{"auto", Tracing::automatic}, {"roots", Tracing::roots}, {"spheres", Tracing::spheres}}, tracing_);
    options.value("over-relaxation", 0, "F", "steps are F times the bound, 1 <= F < 2 (default 1.6)",
                  number_in(over_relaxation_, "--over-relaxation", 1, std::nextafter(2.0, 1.0),
                            "a number F with 1 <= F < 2"));
    options.value("max-steps", 0, "N", "steps of a ray before the rest is left to roots (default 256)",
                  whole_number(most_steps_, 1, 1'000'000'000));
}

ImageFormat RenderSettings::format_of(const std::string& file) const {
    if (format_) return *format_;
    const std::string extension = extension_of(file);
    if (extension == "png" || file.empty() || file == "-") return ImageFormat::png;
    if (extension == "ppm") return ImageFormat::ppm;
    if (extension == "pfm") return ImageFormat::pfm;
    throw UsageError("-o", "a format png, ppm or pfm, as the extension of the file or by --image-format",
                     extension.empty() ? "a name without extension, '" + file + "'" : "'" + extension + "'");
}

Camera RenderSettings::camera(const Ball& framed) const {
    constexpr double usual_field_of_view = 30;
    const double field_of_view = field_of_view_.value_or(usual_field_of_view);
    const Camera automatic = render::framing_camera(framed, options_.size, field_of_view);
    const glm::dvec3 origin = origin_.value_or(automatic.origin());
    const glm::dvec3 look_at = look_at_.value_or(framed.center);
    if (origin == look_at)
        throw UsageError("--camera", "a point other than the one that is looked at",
                         "'" + text_of(origin) + "'");
    const bool is_vertical = origin.x == look_at.x && origin.z == look_at.z;
    const Viewpoint viewpoint{origin, look_at,
                              up_.value_or(is_vertical ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0))};
    try {
        return orthographic_height_ ? Camera::orthographic(viewpoint, *orthographic_height_)
                                    : Camera::perspective(viewpoint, field_of_view);
    } catch (const DomainError&) { // the options were checked, one by one
        throw UsageError("--up", "a direction that is not along the line of sight",
                         "'" + text_of(viewpoint.up) + "'");
    }
}

std::vector<std::string> RenderSettings::unused() const {
    std::vector<std::string> result;
    const auto check = [&](bool is_given, bool is_used, std::string_view option, std::string_view without) {
        if (is_given && !is_used)
            result.push_back(std::string(option) + " has no effect without " + std::string(without));
    };
    const bool steps = rendering().sphere_tracing.has_value();
    check(shadow_rays_.has_value(), shadows_, "--shadow-rays", "--shadows");
    check(ambient_rays_.has_value(), ambient_occlusion_, "--ambient-rays", "--ambient-occlusion");
    check(full_sampling_, options_.antialias > 1, "--sampling", "--antialias");
    check(over_relaxation_.has_value(), steps, "--over-relaxation", "--tracing spheres");
    check(most_steps_.has_value(), steps, "--max-steps", "--tracing spheres");
    const bool lights_matter = options_.colouring == Colouring::material;
    const bool lights_given = !lights_.empty() || ambient_ || outside_ || inside_ || specular_ ||
                              shininess_ || shadows_ || ambient_occlusion_;
    if (lights_given && !lights_matter)
        result.emplace_back("lights, shadows and materials have no effect on false colours");
    return result;
}

RenderSettings::View RenderSettings::view(const std::function<Ball()>& framed_part) const {
    ClipRegion clip = clip_;
    if (!clip.bounding_ball()) clip.add(framed_part());
    const Camera camera = this->camera(*clip.bounding_ball());
    Lighting lighting = render::default_lighting(camera);
    if (!lights_.empty()) lighting.lights = lights_;
    lighting.ambient = ambient_.value_or(lighting.ambient);
    lighting.background = background_.value_or(lighting.background);
    lighting.outside.diffuse = outside_.value_or(lighting.outside.diffuse);
    lighting.inside.diffuse = inside_.value_or(lighting.inside.diffuse);
    for (Material* material : {&lighting.outside, &lighting.inside}) {
        if (specular_) material->specular.fill(static_cast<float>(*specular_));
        if (shininess_) material->shininess = static_cast<float>(*shininess_);
    }
    return {std::move(clip), camera, std::move(lighting)};
}

RenderOptions RenderSettings::rendering() const {
    if (field_of_view_ && orthographic_height_)
        throw UsageError("--fov", "a perspective camera", "--orthographic");
    RenderOptions options = options_;
    constexpr std::uint32_t usual_rays = 16;
    options.occlusion.shadow_rays = shadow_rays_.value_or(usual_rays);
    options.occlusion.ambient_rays = ambient_occlusion_ ? ambient_rays_.value_or(usual_rays) : 0;
    options.adaptive = !full_sampling_;
    options.depths = !depth_file_.empty();
    options.occlusion.shadows = shadows_;
    if (tracing_ == Tracing::roots && bound_ != Bound::guaranteed)
        throw UsageError("--tracing", "spheres with an estimate as --bound", "'roots', which needs none");
    if (tracing_ == Tracing::spheres || bound_ != Bound::guaranteed) {
        SphereTracing& stepping = options.sphere_tracing.emplace();
        stepping.over_relaxation = over_relaxation_.value_or(stepping.over_relaxation);
        stepping.most_steps = most_steps_.value_or(stepping.most_steps);
        stepping.level = bound_ == Bound::first    ? field::DistanceLevel::first_order
                         : bound_ == Bound::second ? field::DistanceLevel::second_order
                                                   : field::DistanceLevel::guaranteed;
    }
    return options;
}

} // namespace eliminant::app
