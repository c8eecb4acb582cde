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

/// What stands in for a picture that cannot be decoded.
enum class StandIn { white, flat };

/// Layers of one kind that are asked for, each once.
class Wanted {
  public:
    explicit Wanted(const Model& model) : images_(model.images) {}

    std::uint32_t layer_of(const ModelTexture& texture, StandIn stand_in = StandIn::white) {
        if (!texture) return no_texture;
        const std::int32_t same = images_[static_cast<std::size_t>(texture.image)].same_as;
        const Key key{same >= 0 ? same : texture.image, texture.nearest, stand_in};
        if (order_.size() >= most_layers && !layers_.contains(key)) return no_texture;
        const auto [entry, fresh] = layers_.try_emplace(key, static_cast<std::uint32_t>(order_.size()));
        if (fresh) order_.push_back(entry->first);
        return entry->second;
    }
    struct Key {
        std::int32_t image;
        bool nearest;
        StandIn stand_in;
        auto operator<=>(const Key&) const = default;
    };
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

PicturePlace place_of(const ModelTexture& texture) {
    return {.axes = vec4(texture.transform[0], texture.transform[1]), .offset = vec4(texture.transform[2], wrap_of(texture.wrap_u), wrap_of(texture.wrap_v))};
}

std::optional<PictureParams> params_of(const ModelMaterial& material, Wanted& colours, Wanted& data) {
    const std::array<const ModelTexture*, 4> slots{&material.base_colour_texture, &material.emission_texture, &material.metallic_roughness_texture, &material.normal_texture};
    const auto first = std::ranges::find_if(slots, [](const ModelTexture* texture) { return bool(*texture); });
    if (first == slots.end() && material.alpha_mode == ModelMaterial::Alpha::opaque && !material.unlit) return std::nullopt;
    PictureParams params{};
    params.layers = uvec4(colours.layer_of(material.base_colour_texture), colours.layer_of(material.emission_texture), data.layer_of(material.metallic_roughness_texture),
                          data.layer_of(material.normal_texture, StandIn::flat));
    const std::array<PicturePlace*, 4> places{&params.colour, &params.emission, &params.data, &params.relief};
    for (int i = 0; i < 4; ++i) {
        const ModelTexture& own = *slots[static_cast<std::size_t>(i)];
        // Where there is none it lies as the others do, so that it does not take a material's pictures apart.
        *places[static_cast<std::size_t>(i)] = place_of(own || first == slots.end() ? own : **first);
        params.second[i] = own.second_uv ? 1 : 0;
    }
    params.alpha = vec4(material.alpha, 0, 0, material.normal_scale);
    if (material.alpha_mode == ModelMaterial::Alpha::mask) params.alpha.y = material.alpha_cutoff;
    if (material.alpha_mode == ModelMaterial::Alpha::blend) params.alpha.y = -1.0f;
    return params;
}

/// `faults` says of each why it is not decoded.
std::uint32_t size_of(const Model& model, const std::vector<Wanted::Key>& wanted, std::uint64_t most_bytes, DecodedPixels& decoded, std::vector<std::string>& faults) {
    std::uint32_t largest = 1;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        try {
            const uvec2 size = decoded.take(model.images[static_cast<std::size_t>(wanted[i].image)]);
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
std::vector<std::uint8_t> plain_layer(std::uint32_t size, StandIn stand_in) {
    std::size_t texels = 0;
    for (std::size_t side = size; side > 0; side /= 2) texels += side * side;
    std::vector<std::uint8_t> bytes(4 * texels, 255);
    for (std::size_t texel = 0; stand_in == StandIn::flat && texel < texels; ++texel) bytes[4 * texel] = bytes[4 * texel + 1] = 128;
    return bytes;
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
            if (faults[i].empty()) layers.layers[i] = picture_layer(decode_picture(model.images[static_cast<std::size_t>(wanted[i].image)]), layers.size, kind, !wanted[i].nearest);
        } catch (const Error& error) {
            faults[i] = error.what();
        }
        if (!faults[i].empty()) layers.layers[i] = plain_layer(layers.size, wanted[i].stand_in);
        ++progress.decoded;
    });
    for (std::size_t i = 0; i < faults.size(); ++i) {
        if (!faults[i].empty()) warnings.push_back(fmt::format("{}; it is {}", faults[i], wanted[i].stand_in == StandIn::flat ? "flat" : "white"));
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
    for (const ModelMaterial& material : model.materials) pictures.materials.push_back(params_of(material, colours, data));
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
