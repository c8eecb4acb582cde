// SPDX-License-Identifier: MIT
#include "engine/core/gltf/gltf_resources.h"

#include <algorithm>
#include <numeric>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/gltf/gltf_media_type.h"
#include "engine/core/gltf/gltf_uri.h"
#include "engine/core/gltf/gltf_value.h"

namespace sl {

using nlohmann::json;

void GltfResources::load(const json& document, const Container& container, const GltfLoad& load, GltfFaults& faults) {
    const auto& [is_container, binary] = container;
    if (binary) stored_bytes_ += binary->size();
    const GltfPlace root, buffer_list(root, "buffers"), image_list(root, "images");
    const json& buffers = gltf_list(document, "buffers");
    for (std::size_t i = 0; i < buffers.size() && !faults.is_done(); ++i) {
        const GltfPlace place(buffer_list, i);
        const bool is_chunk = i == 0 && is_container && !buffers[i].contains("uri");
        if (is_chunk && !binary) faults.fatal(place.text(), "has no uri, and the container has no BIN chunk for it");
        buffers_.push_back(read_buffer(buffers[i], is_chunk ? binary : std::nullopt, load, place, faults));
    }
    buffers_.resize(buffers.size());
    const json& images = gltf_list(document, "images");
    const json& views = gltf_list(document, "bufferViews");
    for (std::size_t i = 0; i < images.size() && !faults.is_done(); ++i) {
        images_.push_back(read_image(images[i], views, load, GltfPlace(image_list, i), faults));
    }
    images_.resize(images.size());
    leave_out_overlapping_images(faults);
}

void GltfResources::leave_out_overlapping_images(GltfFaults& faults) {
    std::vector<std::size_t> order(images_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const std::less<const std::byte*> before;
    // The largest that begin at a place first, and of those that are the same the first.
    std::ranges::sort(order, [&](std::size_t a, std::size_t b) {
        if (images_[a].data() != images_[b].data()) return before(images_[a].data(), images_[b].data());
        return images_[a].size() != images_[b].size() ? images_[a].size() > images_[b].size() : a < b;
    });
    std::size_t last = 0;
    Bytes kept;
    for (const std::size_t i : order) {
        Bytes& image = images_[i];
        if (image.empty() || (image.data() == kept.data() && image.size() == kept.size())) continue;
        if (!kept.empty() && before(image.data(), kept.data() + kept.size())) {
            faults.note(fmt::format("/images/{}", i), "shares a part of its bytes with image {}, and is left out", last);
            image = {};
            continue;
        }
        kept = image;
        last = i;
    }
}

GltfResources::Bytes GltfResources::read_buffer(const json& buffer, std::optional<Bytes> binary, const GltfLoad& load,
                                                const GltfPlace& place, GltfFaults& faults) {
    Bytes bytes = binary.value_or(Bytes());
    bool is_there = binary.has_value();
    if (const auto uri = buffer.find("uri"); uri != buffer.end()) {
        const Found found = find(uri->get_ref<const std::string&>(), load, GltfPlace(place, "uri"));
        bytes = found.bytes;
        is_there = bytes.data() != nullptr;
        if (!found.fault.empty()) faults.fatal(place.text() + "/uri", "{}", found.fault);
        const bool is_data = is_there && !found.media_type.empty();
        if (is_data && found.media_type != "application/octet-stream" && found.media_type != "application/gltf-buffer") {
            faults.note(place.text() + "/uri",
                        "holds data of the type '{}', not application/octet-stream or application/gltf-buffer",
                        for_message(found.media_type));
        }
    }
    const std::size_t length = gltf_whole_at(buffer, "byteLength", 0);
    if (!is_there) return {};
    if (bytes.size() >= length) return bytes.first(length);
    faults.fatal(place.text() + "/byteLength", "is {}, but there are only {} bytes", length, bytes.size());
    return {};
}

GltfResources::Bytes GltfResources::read_image(const json& image, const json& views, const GltfLoad& load,
                                               const GltfPlace& place, GltfFaults& faults) {
    if (const auto uri = image.find("uri"); uri != image.end()) {
        const Found found = find(uri->get_ref<const std::string&>(), load, GltfPlace(place, "uri"));
        if (!found.fault.empty()) faults.note(place.text() + "/uri", "{}", found.fault);
        const std::string_view told = gltf_text_at(image, "mimeType");
        const bool is_picture = gltf_picture_coding(found.media_type) != PictureCoding::unknown;
        if (!found.media_type.empty() && (!is_picture || (!told.empty() && told != found.media_type))) {
            faults.note(place.text() + "/uri", "holds data of the type '{}', not {}", for_message(found.media_type),
                        told.empty() ? "a picture that the format knows" : for_message(told));
        }
        return found.bytes;
    }
    const auto index = gltf_find_whole(image, "bufferView");
    if (!index) return {};
    const json& view = views[*index];
    const Bytes buffer = buffers_[gltf_whole_at(view, "buffer", 0)];
    const std::size_t offset = gltf_whole_at(view, "byteOffset", 0), length = gltf_whole_at(view, "byteLength", 0);
    // A view that leads outside its buffer has been told.
    if (offset > buffer.size() || length > buffer.size() - offset) return {};
    return buffer.subspan(offset, length);
}

GltfResources::Found GltfResources::find(const std::string& text, const GltfLoad& load, const GltfPlace& place) {
    GltfUri uri = read_gltf_uri(text);
    switch (uri.kind) {
        case GltfUri::Kind::invalid: return {.fault = fmt::format("'{}' is no URI", for_message(text))};
        case GltfUri::Kind::absolute: elsewhere_.push_back(place.text()); return {};
        case GltfUri::Kind::data: {
            // A media type is optional; without one the data are a text.
            const std::string type = uri.media_type.empty() ? "text/plain" : uri.media_type;
            // One byte more, so that there is an address even where there are no data.
            uri.data.reserve(uri.data.size() + 1);
            stored_bytes_ += uri.data.size();
            const auto& kept = decoded_.emplace_back(std::move(uri.data));
            return {.bytes = kept, .media_type = type};
        }
        case GltfUri::Kind::relative: break;
    }
    if (!load) return {};
    const auto [entry, is_new] = files_.try_emplace(uri.path);
    File& file = entry->second;
    if (is_new) {
        try {
            file.bytes = load(uri.path);
        } catch (const Error& error) {
            file.fault = error.what();
        }
        stored_bytes_ += file.bytes.size();
        // An address even where there are no bytes.
        file.bytes.reserve(1);
    }
    if (!file.fault.empty()) return {.fault = file.fault};
    return {.bytes = file.bytes};
}

}  // namespace sl
