// SPDX-License-Identifier: MIT
#include "engine/render/scene/surface_changes.h"

namespace sl {

namespace {

/// Radius over distance of a change that hardly shows.
constexpr float shows_little = 0.2f;

}  // namespace

std::vector<SurfaceChanges::Change> SurfaceChanges::since_last_look(const RenderScene& scene) const {
    std::vector<Change> changes;
    std::unordered_map<std::uint64_t, Bounds> left = boxes_;
    for (const RenderScene::Draw& draw : scene.draws) {
        if (left.erase(draw.content) > 0) continue;
        // Of a mesh that was edited once, only the edited part is another one.
        const bool edited = !draw.changed.empty() && left.erase(draw.content_before) > 0;
        changes.push_back({.box = edited ? draw.changed : draw.bounds, .edited = edited, .came = !edited});
    }
    for (const auto& [content, bounds] : left) changes.push_back({.box = bounds});
    std::erase_if(changes, [](const Change& change) { return change.box.empty(); });
    return changes;
}

void SurfaceChanges::look_at(const RenderScene& scene) {
    boxes_.clear();
    for (const RenderScene::Draw& draw : scene.draws) boxes_[draw.content] = draw.bounds;
}

void SurfaceChanges::move(vec3 offset) {
    for (auto& [content, box] : boxes_) box = box.moved(offset);
}

bool hardly_shows(const Bounds& box, vec3 from) { return box.radius() < shows_little * glm::length(box.centre() - from); }

}  // namespace sl
