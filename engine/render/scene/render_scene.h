// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <vector>

#include "engine/core/mesh_data.h"
#include "engine/ecs/components/gi_settings.h"
#include "engine/ecs/components/mesh_instance.h"
#include "engine/ecs/entity.h"

namespace sl {

/// Everything a frame is drawn from, as plain arrays: the renderer and the path tracer see this and never the World.
/// Positions are relative to `origin`, so that float is exact enough wherever the camera stands.
struct RenderScene {
    /// The camera.
    struct View {
        vec3 position{0.0f};
        vec3 forward{0, 0, -1};
        vec3 up{0, 1, 0};
        float fov_y = 1.0f;  ///< rad
        float near = 0.02f;  ///< m
        float behind = 0.0f; ///< m: how far behind its place an orthographic camera is thought to stand; see lens_of
        float ev100 = 12.0f;
        bool auto_exposure = false;
        std::optional<float> held_exposure{};  ///< multiplies nit in place of what EV100 asks for; what is unlit keeps to EV100
        bool antialias = true;
        bool in_water = false;

        /// Of the camera itself.
        vec3 place() const { return position + behind * forward; }
        /// Multiplies nit where nothing adapts.
        float exposure() const;
        /// Nit that EV100 exposes as 1: 1.2 · 2^EV100 (ISO 2720).
        float white() const;
    };

    /// A mesh at a place.
    struct Draw {
        MeshHandle mesh;
        mat4 world_from_local{1.0f};
        std::uint32_t first_material = 0;
        Bounds bounds;              ///< of the drawn mesh
        std::uint64_t content = 0;  ///< hash of everything that can change how it looks in a light's map, but for the origin
        std::uint64_t content_before = 0;  ///< the same with the mesh's last version
        Bounds changed;             ///< where the two differ; empty: anywhere
        Entity entity{};            ///< that it was made from, if any
        bool pictured = false;      ///< its material reads pictures
        bool apart = false;         ///< which do not all lie together, or one of which is of normals; or it is unlit
        bool open = false;          ///< and has holes, or is see-through
    };

    /// A light of any kind; each reads the fields that mean something to it.
    struct Light {
        enum class Kind { directional, spot, point };
        Kind kind = Kind::directional;
        vec3 position{0.0f};
        vec3 direction{0, -1, 0};  ///< unit, in which light travels
        vec3 intensity{0.0f};      ///< lux (directional) or candela
        float range = 0.0f;        ///< m, 0 = without end
        float inner_cone = 0.0f;   ///< rad, half angle
        float outer_cone = 0.5f;
        bool casts_shadow = false;
        bool bounces = false;
        bool mapped = true;        ///< else there is no memory for its maps: in pictures nothing stands in its way, and it does not bounce
        std::uint32_t shadow_size = 1024;  ///< texels, of each of a point light's six faces
        float shadow_distance = 100.0f;  ///< m, directional
        Entity entity{};                 ///< that it was made from, if any

        bool operator==(const Light&) const = default;
    };

    dvec3 origin{0.0};
    std::optional<View> view;  ///< none: there is nothing to draw from
    std::vector<Draw> draws;
    std::vector<Draw> waters;  ///< surfaces of water, which no light meets
    std::vector<Light> lights;  ///< directional first, then spots, then points
    std::vector<MaterialEntry> materials;
    std::uint64_t materials_hash = 0;
    vec3 sky_radiance{0.0f};  ///< nit
    float extinction = 0.0f;  ///< 1/m: of the air between camera and surfaces, which is as bright as the sky
    std::optional<GiSettings> gi;
    Bounds bounds;  ///< of all draws
    const MeshPool* meshes = nullptr;
    const TextureLayers* textures = nullptr;
    PictureTable pictures;

    /// Bytes that shadow maps of directional lights may take, and those of spot and point lights together; see Light::mapped.
    static constexpr std::uint64_t most_shadow_bytes = std::uint64_t{512} << 20;

    /// How many lights have no maps because they would take more than that.
    std::size_t lights_without_maps() const;

    /// Hash of all geometry and materials, and of where the origin is.
    std::uint64_t geometry_hash() const;
};

}  // namespace sl
