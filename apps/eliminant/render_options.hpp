/// \file
/// What `eliminant render` can be told, and what it means for a given surface.
#pragma once

#include "option_set.hpp"

#include "eliminant/render/image_writer.hpp"
#include "eliminant/render/renderer.hpp"
#include "eliminant/scene/clip_region.hpp"

#include <glm/vec3.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace eliminant::app {

/// The options of the command as they were given.
class RenderSettings {
  public:
    /// Adds them to the options of a command. `*this` must outlive `options`.
    void declare(OptionSet& options);

    ImageSize size() const { return options_.size; }
    const std::string& depth_file() const { return depth_file_; } ///< empty if none was asked for
    bool preview() const { return preview_; }

    /// The format of a picture by the name of its file; empty is standard output. \throws UsageError
    ImageFormat format_of(const std::string& file) const;

    /// A view of a surface: what was not said is chosen so that the surface is seen.
    struct View {
        ClipRegion clip;
        Camera camera;
        Lighting lighting;
    };
    /// \param framed_part what is drawn and looked at if no bounded region was given; not asked otherwise
    /// \throws UsageError for a camera that is none; what the function throws
    View view(const std::function<Ball()>& framed_part) const;
    /// \throws UsageError for options that exclude each other
    RenderOptions rendering() const;
    /// What was said to no effect, a sentence each.
    std::vector<std::string> unused() const;

  private:
    void declare_picture(OptionSet& options);
    void declare_view(OptionSet& options);
    void declare_light(OptionSet& options);
    void declare_tracing(OptionSet& options);
    Camera camera(const Ball& framed) const;

    enum class Tracing { automatic, roots, spheres };
    enum class Bound { first, second, guaranteed };

    RenderOptions options_;
    std::string depth_file_;
    std::optional<ImageFormat> format_;
    bool preview_ = false;

    std::optional<glm::dvec3> origin_;
    std::optional<glm::dvec3> look_at_;
    std::optional<glm::dvec3> up_;
    std::optional<double> field_of_view_;
    std::optional<double> orthographic_height_;
    ClipRegion clip_;

    std::vector<DirectionalLight> lights_;
    std::optional<render::Colour> ambient_;
    std::optional<render::Colour> background_;
    std::optional<render::Colour> outside_;
    std::optional<render::Colour> inside_;
    std::optional<double> specular_;
    std::optional<double> shininess_;
    bool shadows_ = false;
    bool ambient_occlusion_ = false;
    std::optional<std::uint32_t> shadow_rays_;
    std::optional<std::uint32_t> ambient_rays_;

    Bound bound_ = Bound::guaranteed;
    Tracing tracing_ = Tracing::automatic;
    std::optional<double> over_relaxation_;
    std::optional<std::uint32_t> most_steps_;
    bool full_sampling_ = false;
};

} // namespace eliminant::app
