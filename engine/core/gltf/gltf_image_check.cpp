// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_image_check.h"

#include <algorithm>
#include <unordered_map>

#include "engine/core/closest_name.h"
#include "engine/core/gltf/gltf_media_type.h"
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

void check_source(const json& texture, const std::vector<PictureCoding>& codings, const std::string& where, GltfFaults& faults) {
    if (const auto source = gltf_find_whole(texture, "source")) {
        const PictureCoding coding = codings[*source];
        if (coding == PictureCoding::webp || coding == PictureCoding::ktx2) {
            faults.note(where + "/source", "image {} is {}; here it must be image/png or image/jpeg", *source,
                        gltf_media_type(coding));
        }
    }
    const json* other = gltf_extension(texture, webp_extension);
    const auto source = other ? gltf_find_whole(*other, "source") : std::nullopt;
    if (!source || codings[*source] == PictureCoding::unknown || codings[*source] == PictureCoding::webp) return;
    faults.note(fmt::format("{}/extensions/{}/source", where, webp_extension), "image {} is {}; here it must be image/webp",
                *source, gltf_media_type(codings[*source]));
}

}  // namespace

void check_gltf_images(const json& document, std::span<const std::span<const std::byte>> images, GltfFaults& faults) {
    const json& list = gltf_list(document, "images");
    const bool uses_webp = uses_extension(document, webp_extension), uses_ktx2 = uses_extension(document, ktx2_extension);
    std::vector<PictureCoding> codings(list.size(), PictureCoding::unknown);
    // Many images may be the same bytes.
    std::unordered_map<const std::byte*, PictureHeader> headers;
    for (std::size_t i = 0; i < std::min(list.size(), images.size()) && faults.takes_notes(); ++i) {
        if (images[i].empty()) continue;
        const std::string where = fmt::format("/images/{}", i);
        const auto [known, is_new] = headers.try_emplace(images[i].data());
        if (is_new) known->second = picture_header({reinterpret_cast<const char*>(images[i].data()), images[i].size()});
        const PictureHeader& header = known->second;
        codings[i] = gltf_media_type(header.coding).empty() ? PictureCoding::unknown : header.coding;
        if (!header.fault.empty()) faults.note(where, "the picture {}", header.fault);
        const std::string_view told = gltf_text_at(list[i], "mimeType"), is = gltf_media_type(header.coding);
        if (is.empty()) continue;
        if (!told.empty() && told != is) {
            faults.note(where + "/mimeType", "is '{}'; the picture is {}", for_message(told), is);
        }
        if ((header.coding == PictureCoding::webp && !uses_webp) || (header.coding == PictureCoding::ktx2 && !uses_ktx2)) {
            faults.note(where, "is {}, which needs {} among the extensions used", is,
                        header.coding == PictureCoding::webp ? webp_extension : ktx2_extension);
        }
    }
    const json& textures = gltf_list(document, "textures");
    for (std::size_t i = 0; i < textures.size() && faults.takes_notes(); ++i) {
        check_source(textures[i], codings, fmt::format("/textures/{}", i), faults);
    }
}

}  // namespace sl
