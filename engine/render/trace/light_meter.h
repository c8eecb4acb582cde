// SPDX-License-Identifier: MIT
#pragma once

#include <tbb/task_group.h>

#include <optional>
#include <unordered_map>

#include "engine/render/scene/surface_changes.h"
#include "engine/render/trace/path_walk.h"

namespace sl {

/// Tells games how much light falls on a point, by the path tracer's own code: the same truth as a reference, without
/// waiting for a graphics card. A few dozen paths per point and frame run on job threads between two calls of `update`;
/// readings get better over frames while nothing changes, and follow within a few frames where something does.
class LightMeter {
  public:
    /// What is known of a point by now.
    struct Reading {
        vec3 irradiance{0.0f};  ///< all but what comes straight from directional, spot and point lights, lux
        vec3 bounced{0.0f};     ///< of that, what has been reflected at least once
        float noise = 0.0f;     ///< standard error of `bounced` over itself, by luminance
        std::uint32_t paths = 0;
    };

    LightMeter() = default;
    ~LightMeter() noexcept;
    LightMeter(const LightMeter&) = delete;
    LightMeter& operator=(const LightMeter&) = delete;

    /// The light that falls on a surface at a point of the world, m, with this unit normal; albedo does not matter. Nothing
    /// until the next frame but one: asking is what has it measured, and what nobody asks for any more is forgotten. Asking
    /// costs a look-up.
    std::optional<Reading> irradiance_at(const dvec3& position, vec3 normal);

    /// Once a frame: ends what the last call began, takes what has changed in the scene, and begins to follow paths.
    /// Does nothing while nobody asks. Throws Error when the ray tracer does not start.
    void update(const RenderScene& scene);

    /// The scene as it is traced; null while nobody asks for light. Until the next update.
    const TransportWorld* world() const { return world_.get(); }

  private:
    struct Point {
        dvec3 position;
        vec3 normal;

        bool operator==(const Point&) const = default;
    };
    struct Hash {
        std::size_t operator()(const Point& point) const;
    };
    /// Sums over the paths of one frame.
    struct Batch {
        vec3 irradiance{0.0f}, bounced{0.0f};
        std::uint32_t paths = 0;
    };
    struct Measured {
        std::optional<Reading> reading;
        float squares = 0.0f;       ///< mean over batches of the luminance of `bounced`, squared
        std::uint32_t batches = 0;  ///< that the reading is the mean of, as far as they still count
        std::uint32_t paths = 0;    ///< followed so far
        std::uint32_t unasked = 0;  ///< frames
        bool moved = false;         ///< something that matters was another in the last frame than before
        Batch batch;                ///< what jobs are about
    };

    void take_over_batches();
    /// What a change of the scene means for readings.
    enum class Effect { none, little, much };
    /// Returns that of the change of lights and sky; surfaces that have changed are left in `changed_`.
    Effect take(const RenderScene& scene);
    Effect of_surfaces(const Point& point) const;
    void follow_paths(const Point& point, Measured& measured) const;

    std::unordered_map<Point, Measured, Hash> points_;
    std::unique_ptr<TransportWorld> world_;
    dvec3 origin_{0.0};
    std::uint64_t geometry_ = 0, materials_ = 0;
    SurfaceChanges surfaces_;
    std::vector<Bounds> changed_;  ///< in this update
    std::vector<RenderScene::Light> lights_;
    vec3 sky_{0.0f};
    tbb::task_group jobs_;
};

}  // namespace sl
