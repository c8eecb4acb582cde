// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/model_pictures.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

#include "engine/core/error.h"

namespace sl {

namespace {

constexpr std::uint32_t largest_layer = 2048;
/// Of one array texture, which OpenGL 4.5 promises.
constexpr std::size_t most_layers = 2048;

/// Pixels that are decoded for one model, by the bytes of its pictures: those of one colour take few bytes, and long to decode.
constexpr std::uint64_t most_decoded_pixels(std::uint64_t bytes) { return 16 * bytes + (std::uint64_t{1} << 27); }

/// Layers of one kind that are asked for, each once.
class Wanted {
  public:
    explicit Wanted(const Model& model) : images_(model.images) {}

    std::uint32_t layer_of(const ModelTexture& texture) {
        if (!texture) return no_texture;
        const std::int32_t same = images_[static_cast<std::size_t>(texture.image)].same_as;
        const Key key{same >= 0 ? same : texture.image, texture.nearest};
        if (order_.size() >= most_layers && !layers_.contains(key)) return no_texture;
        const auto [entry, fresh] = layers_.try_emplace(key, static_cast<std::uint32_t>(order_.size()));
        if (fresh) order_.push_back(entry->first);
        return entry->second;
    }
    using Key = std::pair<std::int32_t, bool>;
    const std::vector<Key>& order() const { return order_; }

  private:
    const std::vector<ModelImage>& images_;
    std::map<Key, std::uint32_t> layers_;
    std::vector<Key> order_;
};

/// What is decoded of a model, and what is not because it would take too long.
class DecodedPixels {
  public:
    explicit DecodedPixels(const Model& model) {
        std::uint64_t bytes = 0;
        for (const ModelImage& image : model.images) bytes += image.bytes.size();
        most_ = left_ = most_decoded_pixels(bytes);
    }
    /// Throws Error where a picture has too many.
    uvec2 take(const ModelImage& image) {
        const uvec2 size = picture_size(image);
        const std::uint64_t pixels = std::uint64_t{size.x} * size.y;
        if (pixels > left_) fail("{}: it is {} x {}, and the pictures before it leave {} of {} million pixels", image.name, size.x, size.y, left_ >> 20, most_ >> 20);
        left_ -= pixels;
        return size;
    }

  private:
    std::uint64_t most_, left_;
};

float wrap_of(ModelTexture::Wrap wrap) {
    switch (wrap) {
        case ModelTexture::Wrap::mirror: return picture_mirror;
        case ModelTexture::Wrap::clamp: return picture_clamp;
        default: return picture_repeat;
    }
}

/// Where one is placed, all of a material's pictures are.
bool same_place(const ModelTexture& a, const ModelTexture& b) { return a.wrap_u == b.wrap_u && a.wrap_v == b.wrap_v && a.transform == b.transform; }

std::optional<PictureParams> params_of(const ModelMaterial& material, Wanted& colours, Wanted& data, std::vector<std::string>& warnings) {
    const std::array<const ModelTexture*, 3> slots{&material.base_colour_texture, &material.emission_texture, &material.metallic_roughness_texture};
    const auto first = std::ranges::find_if(slots, [](const ModelTexture* texture) { return bool(*texture); });
    if (material.normal_texture) warnings.push_back(fmt::format("material '{}': its normal texture is not shown", material.name));
    if (first == slots.end() && material.alpha_mode == ModelMaterial::Alpha::opaque) return std::nullopt;
    const ModelTexture place = first == slots.end() ? ModelTexture{} : **first;
    if (std::ranges::any_of(slots, [&](const ModelTexture* texture) { return bool(*texture) && !same_place(*texture, place); })) {
        warnings.push_back(fmt::format("material '{}': its textures are placed in different ways; all are shown as the first", material.name));
    }
    PictureParams params{};
    params.layers = uvec4(colours.layer_of(material.base_colour_texture), colours.layer_of(material.emission_texture), data.layer_of(material.metallic_roughness_texture), no_texture);
    params.axes = vec4(place.transform[0], place.transform[1]);
    params.place = vec4(place.transform[2], wrap_of(place.wrap_u), wrap_of(place.wrap_v));
    params.alpha.x = material.alpha;
    if (material.alpha_mode == ModelMaterial::Alpha::mask) params.alpha.y = material.alpha_cutoff;
    if (material.alpha_mode == ModelMaterial::Alpha::blend) params.alpha.y = -1.0f;
    return params;
}

/// `faults` says of each why it is not decoded.
std::uint32_t size_of(const Model& model, const std::vector<Wanted::Key>& wanted, std::uint64_t most_bytes, DecodedPixels& decoded, std::vector<std::string>& faults) {
    std::uint32_t largest = 1;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        try {
            const uvec2 size = decoded.take(model.images[static_cast<std::size_t>(wanted[i].first)]);
            largest = std::max({largest, size.x, size.y});
        } catch (const Error& error) {
            faults[i] = error.what();
        }
    }
    std::uint32_t size = std::min(std::bit_ceil(largest), largest_layer);
    while (size > 16 && wanted.size() * std::uint64_t{size} * size * 4 * 4 / 3 > most_bytes) size /= 2;
    return size;
}

/// With all its mips.
std::vector<std::uint8_t> white_layer(std::uint32_t size) {
    std::size_t bytes = 0;
    for (std::size_t side = size; side > 0; side /= 2) bytes += 4 * side * side;
    return std::vector<std::uint8_t>(bytes, 255);
}

TextureLayers layers_of(const Model& model, const std::vector<Wanted::Key>& wanted, PictureKind kind, std::uint64_t most_bytes, DecodedPixels& decoded, ModelProgress& progress,
                        std::vector<std::string>& warnings) {
    std::vector<std::string> faults(wanted.size());
    TextureLayers layers{.size = size_of(model, wanted, most_bytes, decoded, faults), .layers = {}};
    layers.mips = picture_mips(layers.size);
    layers.layers.resize(wanted.size());
    tbb::parallel_for(std::size_t{0}, wanted.size(), [&](std::size_t i) {
        if (progress.unwanted) return;
        try {
            if (faults[i].empty()) layers.layers[i] = picture_layer(decode_picture(model.images[static_cast<std::size_t>(wanted[i].first)]), layers.size, kind, !wanted[i].second);
        } catch (const Error& error) {
            faults[i] = error.what();
        }
        if (!faults[i].empty()) layers.layers[i] = white_layer(layers.size);
        ++progress.decoded;
    });
    for (const std::string& fault : faults) {
        if (!fault.empty()) warnings.push_back(fault + "; it is white");
    }
    return layers;
}

/// Layers made as large as asked for. Colours are averaged as they are encoded, which darkens edges a little.
TextureLayers with_size(const TextureLayers& from, std::uint32_t size) {
    TextureLayers result{.size = size, .mips = picture_mips(size), .layers = {}};
    for (const auto& layer : from.layers) {
        Picture picture{.width = from.size, .height = from.size, .pixels = {layer.begin(), layer.begin() + static_cast<std::ptrdiff_t>(std::size_t{from.size} * from.size * 4)}};
        result.layers.push_back(picture_layer(picture, size, PictureKind::data, true));
    }
    return result;
}

std::uint32_t append(std::shared_ptr<const TextureLayers>& to, const TextureLayers& from) {
    const auto before = to == nullptr ? 0u : static_cast<std::uint32_t>(to->layers.size());
    if (from.layers.empty()) return before;
    if (before == 0) {
        to = std::make_shared<TextureLayers>(from);
        return before;
    }
    const std::uint32_t size = std::max(to->size, from.size);
    TextureLayers all = to->size == size ? *to : with_size(*to, size);
    const TextureLayers fitted = from.size == size ? from : with_size(from, size);
    all.layers.insert(all.layers.end(), fitted.layers.begin(), fitted.layers.end());
    to = std::make_shared<TextureLayers>(std::move(all));
    return before;
}

}  // namespace

ModelPictures model_pictures(const Model& model, ModelProgress& progress, std::uint64_t most_bytes) {
    ModelPictures pictures;
    Wanted colours(model), data(model);
    for (const ModelMaterial& material : model.materials) pictures.materials.push_back(params_of(material, colours, data, pictures.warnings));
    progress.pictures = colours.order().size() + data.order().size();
    if (std::max(colours.order().size(), data.order().size()) >= most_layers) pictures.warnings.push_back(fmt::format("more than {} pictures of one kind are not shown", most_layers));
    DecodedPixels decoded(model);
    const std::size_t all = std::max<std::size_t>(progress.pictures, 1);
    pictures.colours = layers_of(model, colours.order(), PictureKind::colour, most_bytes * colours.order().size() / all, decoded, progress, pictures.warnings);
    pictures.data = layers_of(model, data.order(), PictureKind::data, most_bytes * data.order().size() / all, decoded, progress, pictures.warnings);
    for (auto& params : pictures.materials) {
        if (params) params->alpha.z = 0.5f / static_cast<float>(std::min(pictures.colours.size, pictures.data.layers.empty() ? pictures.colours.size : pictures.data.size));
    }
    return pictures;
}

std::pair<std::uint32_t, std::uint32_t> add_pictures(PictureTable& table, const ModelPictures& pictures) {
    ++table.version;
    return {append(table.colours, pictures.colours), append(table.data, pictures.data)};
}

}  // namespace sl
