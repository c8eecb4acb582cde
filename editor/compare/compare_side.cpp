// SPDX-License-Identifier: MIT
#include "editor/compare/compare_side.h"

namespace sl {

namespace {

constexpr std::size_t first_method = static_cast<std::size_t>(CompareSource::method);

}  // namespace

std::string compare_source_name(CompareSource source) {
    switch (source) {
        case CompareSource::live: return "live";
        case CompareSource::frozen: return "frozen";
        case CompareSource::reference: return "path-traced reference";
        case CompareSource::error: return "error of live light";
        case CompareSource::method: break;
    }
    return std::string(gi_method_names()[static_cast<std::size_t>(source) - first_method]);
}

std::size_t compare_source_count() { return first_method + gi_method_names().size(); }

void CompareSide::draw(RenderScene scene, const Renderer::Request& request, float exposure) {
    const auto number = static_cast<std::size_t>(source);
    if (number < first_method) return rest();
    const std::string_view method = gi_method_names()[number - first_method];
    // Its own settings where the live picture has them, and those that the method comes with otherwise.
    if (!scene.gi || scene.gi->method.name() != method) scene.gi = GiSettings{make_gi_method(method)};
    if (renderer_ == nullptr) renderer_ = std::make_unique<Renderer>(shader_folder());
    scene.view->auto_exposure = false;
    scene.view->held_exposure = exposure;
    size_ = {request.width, request.height};
    result_ = renderer_->render(scene, {.width = request.width, .height = request.height, .frame_index = request.frame_index, .slice_budget = request.slice_budget});
}

void CompareSide::rest() {
    renderer_.reset();
    result_ = {};
}

ShownPicture CompareSide::drawn() {
    if (renderer_ == nullptr || !result_.drawn) return {};
    return {renderer_->executor().texture(renderer_->graph(), result_.images.final), size_};
}

}  // namespace sl
