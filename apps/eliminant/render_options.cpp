#include "render_options.hpp"

#include "common_options.hpp"
#include "scene_text.hpp"

#include "eliminant/field/distance.hpp"

#include <algorithm>
#include <cctype>
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

OptionSet::Setter whole_number(std::uint32_t& target, std::uint32_t least, std::uint32_t most) {
    return [&target, least, most](std::string_view text) {
        target = static_cast<std::uint32_t>(read_whole_number(text, least, most));
    };
}

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
    options_.occlusion.ambient_rays = 16; // if there is to be ambient occlusion
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
    options.flag("preview", 0, "write -o FILE first coarsely, then finer and finer", preview_);
}

void RenderSettings::declare_view(OptionSet& options) {
    options.value("camera", 0, "X,Y,Z", "where the camera stands (default: so that the surface is in view)",
                  into(origin_, "--camera", read_point));
    options.value("look-at", 0, "X,Y,Z",
                  "the point in the middle of the picture (default: that of what is shown)",
                  into(look_at_, "--look-at", read_point));
    options.value("up", 0, "X,Y,Z",
                  "the direction that is up (default 0,1,0, or 0,0,1 along the line of sight)",
                  into(up_, "--up", read_point));
    options.value("fov", 0, "DEGREES", "vertical field of view (default 30)",
                  into(field_of_view_, "--fov", read_number));
    options.value("orthographic", 0, "HEIGHT", "parallel projection of so much from top to bottom",
                  into(orthographic_height_, "--orthographic", read_number));
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
                  into(specular_, "--specular", read_number));
    options.value("shininess", 0, "N", "how small highlights are, from 0 to 10000 (default 80)",
                  into(shininess_, "--shininess", read_number));
    options.flag("shadows", 0, "lights cast shadows", shadows_);
    options.value("shadow-rays", 0, "N", "rays for a soft shadow (default 16)",
                  whole_number(options_.occlusion.shadow_rays, 1, 1024));
    options.flag("ambient-occlusion", 0, "hollows receive less of the ambient light", ambient_occlusion_);
    options.value("ambient-rays", 0, "N", "rays for ambient occlusion (default 16)",
                  whole_number(options_.occlusion.ambient_rays, 1, 1024));
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
                  into(stepping_.over_relaxation, "--over-relaxation", read_number));
    options.value("max-steps", 0, "N", "steps of a ray before the rest is left to roots (default 256)",
                  whole_number(stepping_.most_steps, 1, 1'000'000'000));
}

ImageFormat RenderSettings::format_of(const std::string& file) const {
    if (format_) return *format_;
    const std::string extension = extension_of(file);
    if (extension == "png" || file.empty() || file == "-") return ImageFormat::png;
    if (extension == "ppm") return ImageFormat::ppm;
    if (extension == "pfm") return ImageFormat::pfm;
    throw UsageError("picture", "a format png, ppm or pfm, as the extension of the file or by --image-format",
                     extension.empty() ? "a name without extension, '" + file + "'" : "'" + extension + "'");
}

Camera RenderSettings::camera(const Ball& framed) const {
    const Camera automatic = render::framing_camera(framed, options_.size, field_of_view_);
    const glm::dvec3 origin = origin_.value_or(automatic.origin());
    const glm::dvec3 look_at = look_at_.value_or(framed.center);
    const bool is_vertical = origin.x == look_at.x && origin.z == look_at.z;
    const Viewpoint viewpoint{origin, look_at,
                              up_.value_or(is_vertical ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0))};
    return orthographic_height_ ? Camera::orthographic(viewpoint, *orthographic_height_)
                                : Camera::perspective(viewpoint, field_of_view_);
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
    RenderOptions options = options_;
    options.adaptive = !full_sampling_;
    options.depths = !depth_file_.empty();
    options.occlusion.shadows = shadows_;
    if (!ambient_occlusion_) options.occlusion.ambient_rays = 0;
    if (tracing_ == Tracing::roots && bound_ != Bound::guaranteed)
        throw UsageError("--tracing", "spheres with an estimate as --bound", "'roots', which needs none");
    if (tracing_ == Tracing::spheres || bound_ != Bound::guaranteed) {
        options.sphere_tracing = stepping_;
        options.sphere_tracing->level = bound_ == Bound::first    ? field::DistanceLevel::first_order
                                        : bound_ == Bound::second ? field::DistanceLevel::second_order
                                                                  : field::DistanceLevel::guaranteed;
    }
    return options;
}

} // namespace eliminant::app
