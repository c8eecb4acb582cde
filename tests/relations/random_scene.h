// SPDX-License-Identifier: MIT
#pragma once

#include <iosfwd>

#include "tests/support/scene_builder.h"

namespace sl {

/// A small scene as plain numbers, so that a failing one can be shrunk and read.
struct ScenePlan {
    struct Thing {
        Shape::Kind kind = Shape::Kind::box;
        vec3 size{1.0f};
        vec3 place{0.0f};
        vec3 turn{0.0f};  ///< rad, about x, y, z
        vec3 albedo{0.5f};
    };
    struct Lamp {
        RenderScene::Light::Kind kind = RenderScene::Light::Kind::directional;
        float azimuth = 0.0f, elevation = 1.0f;  ///< rad, where it stands, seen from the middle of the floor
        float height = 4.0f;                     ///< m above the floor; directional lights have none
        vec3 intensity{1.0f};
        float outer_cone = 0.5f;
    };
    std::vector<Thing> things;  ///< on a floor of 8 m × 8 m
    vec3 floor_albedo{0.5f};
    std::vector<Lamp> lamps;
    float eye_azimuth = 0.0f, eye_elevation = 0.6f, eye_distance = 6.0f;
};

/// What is done to a whole scene, its lights and camera included.
struct SceneChange {
    mat4 place{1.0f};     ///< rigid, or a mirror
    float scale = 1.0f;   ///< about the origin, after `place`
    float light = 1.0f;   ///< factor on all lights
    uvec3 channels{0, 1, 2};  ///< which channel of the plan becomes red, green and blue
};

/// Fills a builder. Lights stand in the order of their kinds.
void build(const ScenePlan& plan, const SceneChange& change, SceneBuilder& builder);

/// RapidCheck prints a failing plan by this.
void showValue(const ScenePlan& plan, std::ostream& out);

}  // namespace sl
