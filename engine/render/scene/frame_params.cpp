// SPDX-License-Identifier: MIT
#include "engine/render/scene/frame_params.h"

#include <algorithm>
#include <cmath>

namespace sl {

FrameParams frame_params(const RenderScene& scene, std::uint32_t width, std::uint32_t height, std::uint32_t frame_index) {
    const RenderScene::View& view = *scene.view;
    const float aspect = static_cast<float>(width) / static_cast<float>(height);
    const mat4 look = view_from_world(view.position, view.forward, view.up);
    const float tangent = std::tan(0.5f * view.fov_y);
    FrameParams params{};
    params.clip_from_world = reversed_infinite_perspective(view.fov_y, aspect, view.near) * look;
    params.camera_position = vec4(view.position, view.near);
    params.ray_forward = vec4(-look[0][2], -look[1][2], -look[2][2], view.exposure());
    params.ray_right = vec4(vec3(look[0][0], look[1][0], look[2][0]) * tangent * aspect, static_cast<float>(width));
    params.ray_up = vec4(vec3(look[0][1], look[1][1], look[2][1]) * tangent, static_cast<float>(height));
    // How much air there is before an orthographic camera is not said, so there is none.
    params.sky = vec4(scene.sky_radiance, view.behind > 0.0f ? 0.0f : scene.extinction);
    const auto count = [&](auto... kinds) {
        return static_cast<std::uint32_t>(std::ranges::count_if(scene.lights, [&](const auto& light) { return ((light.kind == kinds) || ...); }));
    };
    using Kind = RenderScene::Light::Kind;
    params.counts = uvec4(static_cast<std::uint32_t>(scene.lights.size()), frame_index, count(Kind::directional),
                          count(Kind::directional, Kind::spot));
    return params;
}

}  // namespace sl
