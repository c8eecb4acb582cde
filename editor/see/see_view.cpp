// SPDX-License-Identifier: MIT
#include "editor/see/see_view.h"

#include "editor/see/probe_lines.h"
#include "engine/ecs/active_camera.h"

namespace sl {

void SeeView::prepare(Renderer::Request& request) const {
    image.prepare(request);
    probe.prepare(request);
    facets.prepare(request);
}

void SeeView::update(const SeenFrame& frame) {
    image.update(frame.renderer, frame.seconds);
    probe.update(frame);
    facets.update(frame);
}

void SeeView::draw(World& world, float scale) const {
    image.draw(scale);
    const Entity camera = active_camera(world);
    const auto* place = camera ? world.find<WorldTransform>(camera) : nullptr;
    if (place == nullptr) return;
    const Projection project(world.get<Camera>(camera), *place);
    facets.draw(project, scale);
    if (probe.reading()) draw_probe_lines(*probe.reading(), project, scale);
}

}  // namespace sl
