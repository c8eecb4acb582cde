// SPDX-License-Identifier: MIT
#include "engine/render/scene/render_scene.h"

#include <algorithm>

#include "shared/exposure.h"

namespace sl {

float RenderScene::View::exposure() const { return held_exposure.value_or(exposure_of(ev100)); }

float RenderScene::View::white() const { return 1.0f / exposure_of(ev100); }

std::size_t RenderScene::lights_without_maps() const {
    return static_cast<std::size_t>(std::ranges::count(lights, false, &Light::mapped));
}

std::uint64_t RenderScene::geometry_hash() const {
    std::uint64_t hash = hash_bytes(materials_hash, &origin, sizeof origin);
    for (const Draw& draw : draws) hash = hash_mix(hash, draw.content);
    return hash;
}

}  // namespace sl
