// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_image_check.h"

#include <algorithm>

#include "engine/core/closest_name.h"
#include "engine/core/gltf/gltf_image_header.h"
#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

namespace {

constexpr std::string_view webp_extension = "EXT_texture_webp";
constexpr std::string_view ktx2_extension = "KHR_texture_basisu";

bool uses_extension(const json& document, std::string_view name) {
    const json& used = gltf_list(document, "extensionsUsed");
    return std::any_of(used.begin(), used.end(), [&](const json& entry) { return entry.get_ref<const std::string&>() == name; });
}

void check_source(const json& texture, const std::vector<GltfImageKind>& kinds, const std::string& where, GltfFaults& faults) {
    if (const auto source = gltf_find_whole(texture, "source")) {
        const GltfImageKind kind = kinds[*source];
        if (kind == GltfImageKind::webp || kind == GltfImageKind::ktx2) {
            faults.note(where + "/source", "image {} is {}; here it must be image/png or image/jpeg", *source,
                        gltf_media_type(kind));
        }
    }
    const json* other = gltf_extension(texture, webp_extension);
    const auto source = other ? gltf_find_whole(*other, "source") : std::nullopt;
    if (!source || kinds[*source] == GltfImageKind::unknown || kinds[*source] == GltfImageKind::webp) return;
    faults.note(fmt::format("{}/extensions/{}/source", where, webp_extension), "image {} is {}; here it must be image/webp",
                *source, gltf_media_type(kinds[*source]));
}

}  // namespace

void check_gltf_images(const json& document, std::span<const std::span<const std::byte>> images, GltfFaults& faults) {
    const json& list = gltf_list(document, "images");
    const bool uses_webp = uses_extension(document, webp_extension), uses_ktx2 = uses_extension(document, ktx2_extension);
    std::vector<GltfImageKind> kinds(list.size(), GltfImageKind::unknown);
    for (std::size_t i = 0; i < std::min(list.size(), images.size()) && faults.takes_notes(); ++i) {
        if (images[i].empty()) continue;
        const std::string where = fmt::format("/images/{}", i);
        const GltfImageHeader header = read_gltf_image_header(images[i]);
        kinds[i] = header.kind;
        if (!header.fault.empty()) faults.note(where, "the picture {}", header.fault);
        if (header.kind == GltfImageKind::unknown) continue;
        const std::string_view told = gltf_text_at(list[i], "mimeType"), is = gltf_media_type(header.kind);
        if (!told.empty() && told != is) {
            faults.note(where + "/mimeType", "is '{}'; the picture is {}", for_message(told), is);
        }
        if ((header.kind == GltfImageKind::webp && !uses_webp) || (header.kind == GltfImageKind::ktx2 && !uses_ktx2)) {
            faults.note(where, "is {}, which needs {} among the extensions used", is,
                        header.kind == GltfImageKind::webp ? webp_extension : ktx2_extension);
        }
    }
    const json& textures = gltf_list(document, "textures");
    for (std::size_t i = 0; i < textures.size() && faults.takes_notes(); ++i) {
        check_source(textures[i], kinds, fmt::format("/textures/{}", i), faults);
    }
}

}  // namespace sl
