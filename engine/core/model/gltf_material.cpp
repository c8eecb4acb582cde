// SPDX-License-Identifier: MIT
#include "engine/core/model/gltf_material.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/model/gltf_floats.h"

namespace sl {

using nlohmann::json;

namespace {

/// Reflectance along the normal at n = 1.5, which `specular` counts in.
constexpr float usual_reflectance = 0.04f;

constexpr FloatRange fraction{0.0f, 1.0f};

constexpr std::size_t most_uv_sets = 2;

/// As the format numbers them.
enum class Wrap : std::size_t { clamp = 33071, mirror = 33648, repeat = 10497 };
constexpr std::size_t nearest_filter = 9728;

ModelTexture::Wrap wrap_at(const json& sampler, std::string_view key) {
    switch (static_cast<Wrap>(gltf_whole_at(sampler, key, 0))) {
        case Wrap::clamp:
            return ModelTexture::Wrap::clamp;
        case Wrap::mirror:
            return ModelTexture::Wrap::mirror;
        default:
            return ModelTexture::Wrap::repeat;
    }
}

/// A number of an extension of a material.
float extension_number(const json& material, std::string_view extension, std::string_view key, float otherwise) {
    const json* content = gltf_extension(material, extension);
    return content ? gltf_float_at(*content, key, otherwise, {.low = 0.0f}) : otherwise;
}

/// From n; 0 stands for a surface that reflects all.
float specular_of(const json& material) {
    const float ior = extension_number(material, "KHR_materials_ior", "ior", 1.5f),
                root = ior > 0.0f ? (ior - 1.0f) / (ior + 1.0f) : 1.0f;
    const float strength = extension_number(material, "KHR_materials_specular", "specularFactor", 1.0f);
    return std::clamp(strength * root * root / usual_reflectance, 0.0f, 1.0f);
}

/// Translation * rotation * scale, as the extension orders them.
std::array<vec2, 3> transform_of(const json& extension) {
    vec2 scale(1.0f), offset(0.0f);
    take_gltf_numbers(extension, "scale", scale);
    take_gltf_numbers(extension, "offset", offset);
    const float angle = gltf_float_at(extension, "rotation", 0.0f), sine = std::sin(angle), cosine = std::cos(angle);
    return {vec2(cosine, -sine) * scale.x, vec2(sine, cosine) * scale.y, offset};
}

class MaterialReader {
  public:
    explicit MaterialReader(GltfReader& reader)
        : reader_(reader),
          textures_(gltf_list(reader.document(), "textures")),
          samplers_(gltf_list(reader.document(), "samplers")) {}

    ModelMaterial read(const json& from, const std::string& where) {
        where_ = where;
        const json& pbr = gltf_part(from, "pbrMetallicRoughness");
        const std::string_view alpha_mode = gltf_text_at(from, "alphaMode");
        ModelMaterial material;
        material.name = gltf_text_at(from, "name");
        vec4 base_colour(1.0f);
        take_gltf_numbers(pbr, "baseColorFactor", base_colour, fraction);
        material.base_colour = vec3(base_colour);
        material.alpha = base_colour.a;
        material.metallic = gltf_float_at(pbr, "metallicFactor", 1.0f, fraction);
        material.roughness = gltf_float_at(pbr, "roughnessFactor", 1.0f, fraction);
        material.specular = specular_of(from);
        take_gltf_numbers(from, "emissiveFactor", material.emission, fraction);
        material.emission *= extension_number(from, "KHR_materials_emissive_strength", "emissiveStrength", 1.0f);
        material.normal_scale = gltf_float_at(gltf_part(from, "normalTexture"), "scale", 1.0f, {-100.0f, 100.0f});
        material.alpha_mode = alpha_mode == "MASK"    ? ModelMaterial::Alpha::mask
                              : alpha_mode == "BLEND" ? ModelMaterial::Alpha::blend
                                                      : ModelMaterial::Alpha::opaque;
        material.alpha_cutoff = gltf_float_at(from, "alphaCutoff", 0.5f, {0.0f, 1e6f});
        material.two_sided = gltf_flag_at(from, "doubleSided");
        uv_sets_.clear();
        material.base_colour_texture = texture(pbr, "baseColorTexture");
        material.unlit = gltf_extension(from, "KHR_materials_unlit") != nullptr;
        if (material.unlit) return with_coordinates(material);
        material.metallic_roughness_texture = texture(pbr, "metallicRoughnessTexture");
        material.normal_texture = texture(from, "normalTexture");
        material.emission_texture = texture(from, "emissiveTexture");
        material.occlusion_texture.image = image_of(gltf_part(from, "occlusionTexture")).value_or(-1);
        return with_coordinates(material);
    }

  private:
    ModelMaterial with_coordinates(ModelMaterial material) const {
        if (!uv_sets_.empty()) material.uv_sets = {uv_sets_.front(), uv_sets_.back()};
        return material;
    }

    /// Whether a texture reads the second of the material's coordinates. The first are those of its first texture: where that
    /// is the base colour, whoever reads this alone needs no others.
    bool is_second(std::size_t set, std::string_view slot) {
        const bool is_new = std::ranges::find(uv_sets_, set) == uv_sets_.end();
        if (is_new && uv_sets_.size() == most_uv_sets) {
            reader_.warn(fmt::format("{}/{}", where_, slot),
                         fmt::format("a third set of texture coordinates ({}) is not read; those of its first texture are taken", set));
            return false;
        }
        if (is_new) uv_sets_.push_back(set);
        return set != uv_sets_.front();
    }

    /// The image that a texture reads, where there is one.
    std::optional<std::int32_t> image_of(const json& info) const {
        const auto index = gltf_find_whole(info, "index");
        if (!index) return std::nullopt;
        const json* webp = gltf_extension(textures_[*index], "EXT_texture_webp");
        const auto source = gltf_find_whole(webp ? *webp : textures_[*index], "source");
        return source ? std::optional(static_cast<std::int32_t>(*source)) : std::nullopt;
    }

    ModelTexture texture(const json& owner, std::string_view slot) {
        const json& info = gltf_part(owner, slot);
        const auto index = gltf_find_whole(info, "index");
        if (!index) return {};
        const json& texture = textures_[*index];
        const auto image = image_of(info);
        if (!image) {
            reader_.warn(fmt::format("{}/{}", where_, slot),
                         fmt::format("its texture {} has no picture that can be read", *index));
            return {};
        }
        ModelTexture result{.image = *image};
        const json* transform = gltf_extension(info, "KHR_texture_transform");
        const std::size_t own_set = gltf_whole_at(info, "texCoord", 0),
                          set = transform ? gltf_whole_at(*transform, "texCoord", own_set) : own_set;
        result.second_uv = is_second(set, slot);
        if (const auto sampler = gltf_find_whole(texture, "sampler")) {
            result.wrap_u = wrap_at(samplers_[*sampler], "wrapS");
            result.wrap_v = wrap_at(samplers_[*sampler], "wrapT");
            result.nearest = gltf_whole_at(samplers_[*sampler], "magFilter", 0) == nearest_filter;
        }
        if (transform) result.transform = transform_of(*transform);
        return result;
    }

    GltfReader& reader_;
    const json &textures_, &samplers_;
    std::string where_;
    std::vector<std::size_t> uv_sets_;  ///< that the material has read so far
};

}  // namespace

std::vector<ModelMaterial> gltf_materials(GltfReader& reader) {
    MaterialReader materials(reader);
    const json& list = gltf_list(reader.document(), "materials");
    std::vector<ModelMaterial> read;
    for (std::size_t i = 0; i < list.size(); ++i) read.push_back(materials.read(list[i], fmt::format("/materials/{}", i)));
    return read;
}

}  // namespace sl
