// SPDX-License-Identifier: MIT
#include "engine/ecs/systems/model_pictures.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

#include "engine/core/error.h"

namespace sl {

namespace {

constexpr std::uint32_t largest_layer = 2048;

/// What stands in for a picture that cannot be decoded.
enum class StandIn { white, flat };

/// Layers of one kind that are asked for, each once.
class Wanted {
  public:
    std::uint32_t layer_of(const ModelTexture& texture, StandIn stand_in = StandIn::white) {
        if (!texture) return no_texture;
        const auto [entry, fresh] = layers_.try_emplace({texture.image, texture.nearest, stand_in}, static_cast<std::uint32_t>(order_.size()));
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
    std::map<Key, std::uint32_t> layers_;
    std::vector<Key> order_;
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

std::uint32_t size_of(const Model& model, const std::vector<Wanted::Key>& wanted, std::uint64_t most_bytes) {
    std::uint32_t largest = 1;
    for (const Wanted::Key& picture : wanted) {
        try {
            const uvec2 size = picture_size(model.images[static_cast<std::size_t>(picture.image)]);
            largest = std::max({largest, size.x, size.y});
        } catch (const Error&) {
            // Told when it is decoded.
        }
    }
    std::uint32_t size = std::min(std::bit_ceil(largest), largest_layer);
    while (size > 16 && wanted.size() * std::uint64_t{size} * size * 4 * 4 / 3 > most_bytes) size /= 2;
    return size;
}

TextureLayers layers_of(const Model& model, const std::vector<Wanted::Key>& wanted, PictureKind kind, std::uint64_t most_bytes, ModelProgress& progress, std::vector<std::string>& warnings) {
    TextureLayers layers{.size = size_of(model, wanted, most_bytes), .layers = {}};
    layers.mips = picture_mips(layers.size);
    layers.layers.resize(wanted.size());
    std::vector<std::string> faults(wanted.size());
    tbb::parallel_for(std::size_t{0}, wanted.size(), [&](std::size_t i) {
        if (progress.unwanted) return;
        Picture picture;
        try {
            picture = decode_picture(model.images[static_cast<std::size_t>(wanted[i].image)]);
        } catch (const Error& error) {
            const bool flat = wanted[i].stand_in == StandIn::flat;
            if (flat) picture.pixels = {128, 128, 255, 255};
            faults[i] = fmt::format("{}; it is {}", error.what(), flat ? "flat" : "white");
        }
        layers.layers[i] = picture_layer(picture, layers.size, kind, !wanted[i].nearest);
        ++progress.decoded;
    });
    for (const std::string& fault : faults) {
        if (!fault.empty()) warnings.push_back(fault);
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
    Wanted colours, data;
    for (const ModelMaterial& material : model.materials) pictures.materials.push_back(params_of(material, colours, data));
    progress.pictures = colours.order().size() + data.order().size();
    const std::size_t all = std::max<std::size_t>(progress.pictures, 1);
    pictures.colours = layers_of(model, colours.order(), PictureKind::colour, most_bytes * colours.order().size() / all, progress, pictures.warnings);
    pictures.data = layers_of(model, data.order(), PictureKind::data, most_bytes * data.order().size() / all, progress, pictures.warnings);
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
