// SPDX-License-Identifier: MIT
#include "editor/compare/compare_side.h"

#include <algorithm>

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

void UploadedPicture::upload(const Image& picture) {
    const TextureDesc desc{.width = picture.width, .height = picture.height, .format = Format::rgba8};
    if (texture_.desc() != desc || !texture_) texture_ = gl::Texture(desc, "compared picture");
    std::vector<std::byte> bytes(std::size_t{4} * picture.width * picture.height, std::byte{255});
    for (std::uint32_t y = 0; y < picture.height; ++y) {
        for (std::uint32_t x = 0; x < picture.width; ++x) {
            const float* pixel = picture.pixel(x, picture.height - 1 - y);
            std::byte* out = &bytes[4 * (std::size_t{y} * picture.width + x)];
            for (int c = 0; c < 3; ++c) out[c] = static_cast<std::byte>(std::clamp(pixel[c], 0.0f, 1.0f) * 255.0f + 0.5f);
        }
    }
    texture_.upload(0, 0, bytes);
}

void CompareSide::draw(RenderScene scene, const Renderer::Request& request) {
    const auto number = static_cast<std::size_t>(source);
    if (number < first_method) {
        renderer_.reset();
        result_ = {};
        return;
    }
    const std::string_view method = gi_method_names()[number - first_method];
    // Its own settings where the live picture has them, and those that the method comes with otherwise.
    if (!scene.gi || gi_method_name(scene.gi->method) != method) scene.gi = GiSettings{make_gi_method(method)};
    if (renderer_ == nullptr) renderer_ = std::make_unique<Renderer>(shader_folder());
    size_ = {request.width, request.height};
    result_ = renderer_->render(scene, {.width = request.width, .height = request.height, .frame_index = request.frame_index, .slice_budget = request.slice_budget});
}

ShownPicture CompareSide::drawn() {
    if (renderer_ == nullptr || !result_.drawn) return {};
    return {renderer_->executor().texture(renderer_->graph(), result_.images.final), size_};
}

}  // namespace sl
