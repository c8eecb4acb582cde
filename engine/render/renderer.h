// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/image.h"
#include "engine/core/work_times.h"
#include "engine/render/data_folder.h"
#include "engine/render/execute.h"
#include "engine/render/frame.h"
#include "engine/render/gi/facet_light.h"
#include "engine/render/scene/sun_steps.h"

namespace sl {

/// Draws render scenes into images on the current GL context.
class Renderer {
  public:
    /// Draws on the current context, which must outlive it. The folder is that of the engine's shaders.
    explicit Renderer(const std::filesystem::path& shader_folder);

    /// Every frame from now on has this pass too, after those that were added before and before the picture is exposed.
    void add_pass(PicturePass pass) { passes_.push_back(std::move(pass)); }
    /// Shaders of a program's own are looked for there, after the engine's.
    void add_shaders(std::filesystem::path folder) { executor_.programs().add_folder(std::move(folder)); }

    /// What a frame is to be.
    struct Request {
        std::uint32_t width = 640;
        std::uint32_t height = 360;
        std::uint32_t frame_index = 0;
        float seconds = 1.0f / 60.0f;       ///< since the last frame
        double time = 0.0;                  ///< s; water ripples by it, and stands still where nobody sets it
        std::uint32_t slice_budget = ~0u;   ///< steps of sliced work per frame
        std::vector<std::string> wanted{};  ///< images to keep readable besides the final one
        std::vector<std::string> wanted_if_there{};  ///< the same, but a frame without them is no error
        bool want_irradiance = false;       ///< also the GI method's result, whatever it is called
        Executor::OnStep on_step{};
    };

    /// What a frame left behind; images stay readable until the next frame.
    struct Result {
        bool drawn = false;          ///< false: the scene has no camera
        FrameOutput images;
        std::uint64_t triangles_drawn = 0;
        std::uint64_t triangles_culled = 0;
        std::size_t lights_without_maps = 0;  ///< that ask for shadows or bounces, and for whose maps there is no memory
    };

    /// Throws Error when `wanted` names an image that this frame does not have, listing those it has.
    Result render(const RenderScene& given, const Request& request);

    /// Forgets what persistent images hold: the next frame draws everything anew.
    void forget() {
        states_.clear();
        facets_ = {};
        suns_ = {};
    }

    /// One layer of an image of the last frame as an Image, top row first.
    Image read(ImageId image, std::uint32_t layer = 0) const;
    /// What the last frame's picture multiplied nit with, also where the camera adapts: then it is read back, which is slow.
    float exposure() const;
    /// One pixel of it, counted from the top left; channels that it has not are 0. A black image of one pixel is black everywhere.
    vec4 read_pixel(ImageId image, uvec2 pixel, std::uint32_t layer = 0) const;
    /// Whether the image was kept in the last frame, so that it can be read.
    bool readable(ImageId image) const { return image && executor_.texture(graph_, image) != 0; }
    /// The image of that name in the last frame; none when there is none. "irradiance" is always there: without indirect
    /// light it is a black pixel.
    ImageId find_image(std::string_view name) const;
    /// The last frame's graph and compiled steps.
    const FrameGraph& graph() const { return graph_; }
    const std::vector<Step>& steps() const { return steps_; }
    Executor& executor() { return executor_; }
    /// What the method `facets` keeps on surfaces; empty while another one runs that never did.
    const FacetCache& facets() const { return facets_.cache; }
    /// What the last frame cost the processor beside its systems; passes that it draws itself count here and as passes.
    const WorkTimes& times() const { return times_; }
    /// Bytes of meshes and textures on the GPU.
    std::uint64_t gpu_bytes() const { return gpu_scene_.mesh_bytes() + executor_.texture_bytes(); }

  private:
    PersistentStates states_;
    FrameGraph graph_{states_};
    std::vector<Step> steps_;
    FrameOutput images_;
    Executor executor_;
    GpuScene gpu_scene_;
    FacetLight facets_;
    SunSteps suns_;
    std::vector<PicturePass> passes_;
    std::size_t told_without_maps_ = 0;
    WorkTimes times_;
    float exposure_ = 1.0f;  ///< of the last frame, if nothing adapted
    bool adapts_ = false;
};

/// Names of all images that a graph makes, for messages and lists.
std::vector<std::string> image_names(const FrameGraph& graph);

}  // namespace sl
