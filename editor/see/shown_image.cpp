// SPDX-License-Identifier: MIT
#include "editor/see/shown_image.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>

#include "editor/see/rsm_normals.h"
#include "editor/text_over_picture.h"
#include "engine/render/displayable.h"

namespace sl {

namespace {

constexpr double seconds_between = 0.25;
/// Reading a large image takes long; of the whole time it may take this share.
constexpr double largest_share = 0.15;

}  // namespace

std::vector<ListedImage> listed_images(const FrameGraph& graph) {
    std::vector<ListedImage> result;
    for (const std::string& name : image_names(graph)) {
        const TextureDesc& desc = graph.resources()[graph.find_image(name).index].image;
        result.push_back({name, {desc.width, desc.height}, desc.layers});
        if (name == rsm_flux_image) result.push_back({rsm_normal_image, {desc.width, desc.height}, desc.layers});
    }
    return result;
}

void ShownImage::prepare(Renderer::Request& request) const {
    if (!name.empty()) request.wanted_if_there.push_back(holder());
}

std::string ShownImage::holder() const { return name == rsm_normal_image ? rsm_flux_image : name; }

const ListedImage* ShownImage::chosen() const {
    const auto found = std::ranges::find(listed_, name, &ListedImage::name);
    return found == listed_.end() ? nullptr : &*found;
}

void ShownImage::clear() {
    picture_.clear();
    range_.clear();
    has_exposure_ = false;
    source_ = {};
}

void ShownImage::update(const Renderer& renderer, double seconds) {
    listed_ = listed_images(renderer.graph());
    until_read_ -= seconds;
    const ListedImage* image = chosen();
    const ImageId id = image == nullptr ? ImageId{} : renderer.graph().find_image(holder());
    if (!renderer.readable(id)) return clear();
    layer = std::min(layer, std::max(image->layers, 1u) - 1);
    if (until_read_ <= 0.0 || source_ != Source{name, layer, stops}) read(renderer, id);
}

void ShownImage::read(const Renderer& renderer, ImageId image) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    Image values = renderer.read(image, layer);
    if (name == rsm_normal_image) values = rsm_normals(values);
    const DisplayMapping mapping = display_mapping(name, values, renderer.exposure()).brighter(stops);
    picture_.upload(displayable(values, mapping));
    range_ = mapping.range(name);
    has_exposure_ = mapping.has_exposure();
    source_ = {name, layer, stops};
    until_read_ = std::max(seconds_between, std::chrono::duration<double>(Clock::now() - start).count() / largest_share);
}

void ShownImage::draw(float scale) const {
    if (!picture_) return;
    const ImGuiViewport& screen = *ImGui::GetMainViewport();
    const ShownPicture shown = picture_.shown();
    const vec2 size(shown.size), room(screen.Size.x, screen.Size.y);
    const vec2 half = 0.5f * size * std::min(room.x / size.x, room.y / size.y);
    const ImVec2 middle = screen.GetCenter(), end(screen.Pos.x + room.x, screen.Pos.y + room.y);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddRectFilled(screen.Pos, end, IM_COL32_BLACK);
    // Rows lie in the texture from the bottom up.
    list.AddImage(reinterpret_cast<ImTextureID>(std::uintptr_t{shown.texture}), ImVec2(middle.x - half.x, middle.y - half.y),
                  ImVec2(middle.x + half.x, middle.y + half.y), ImVec2(0.0f, 1.0f), ImVec2(1.0f, 0.0f));
    const std::string title = chosen() != nullptr && chosen()->layers > 0 ? fmt::format("{}, layer {}", name, layer) : name;
    text_over_picture(fmt::format("{}: {}", title, range_), ImVec2(screen.Pos.x + 8.0f * scale, end.y - 3.0f * ImGui::GetFontSize()));
}

}  // namespace sl
