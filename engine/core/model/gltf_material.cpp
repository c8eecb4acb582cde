// SPDX-License-Identifier: MIT
#include "engine/core/model/gltf_material.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/core/model/gltf_values.h"

namespace sl {

namespace {

constexpr const char* transform_extension = "KHR_texture_transform";
/// Reflectance along the normal at n = 1.5, which `specular` counts in.
constexpr float usual_reflectance = 0.04f;

float finite(double value, float otherwise, float low, float high) { return std::isfinite(value) ? static_cast<float>(std::clamp(value, double{low}, double{high})) : otherwise; }

vec3 colour_of(const std::vector<double>& values, vec3 otherwise, float high) {
    for (std::size_t i = 0; i < 3 && values.size() >= 3; ++i) otherwise[static_cast<int>(i)] = finite(values[i], otherwise[static_cast<int>(i)], 0.0f, high);
    return otherwise;
}

ModelTexture::Wrap wrap_of(int mode) {
    switch (mode) {
        case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE: return ModelTexture::Wrap::clamp;
        case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT: return ModelTexture::Wrap::mirror;
        default: return ModelTexture::Wrap::repeat;
    }
}

vec2 pair_of(const tinygltf::ExtensionMap& extensions, const char* member, vec2 otherwise) {
    const tinygltf::Value* value = gltf_member(extensions, transform_extension, member);
    if (value == nullptr || !value->IsArray() || value->ArrayLen() != 2) return otherwise;
    for (int i = 0; i < 2; ++i) {
        const tinygltf::Value& number = value->Get(i);
        if (number.IsNumber() && std::isfinite(static_cast<float>(number.GetNumberAsDouble()))) otherwise[i] = static_cast<float>(number.GetNumberAsDouble());
    }
    return otherwise;
}

class MaterialReader {
  public:
    MaterialReader(const tinygltf::Model& file, std::vector<std::string>& warnings) : file_(file), warnings_(warnings) {}

    ModelMaterial read(const tinygltf::Material& from, const std::string& where) {
        where_ = where;
        const tinygltf::PbrMetallicRoughness& pbr = from.pbrMetallicRoughness;
        ModelMaterial material;
        material.name = from.name;
        material.base_colour = colour_of(pbr.baseColorFactor, vec3(1.0f), 1.0f);
        if (pbr.baseColorFactor.size() == 4) material.alpha = finite(pbr.baseColorFactor[3], 1.0f, 0.0f, 1.0f);
        material.metallic = finite(pbr.metallicFactor, 1.0f, 0.0f, 1.0f);
        material.roughness = finite(pbr.roughnessFactor, 1.0f, 0.0f, 1.0f);
        material.specular = specular_of(from.extensions);
        const float strength = std::max(gltf_number(from.extensions, "KHR_materials_emissive_strength", "emissiveStrength", 1.0f), 0.0f);
        material.emission = strength * colour_of(from.emissiveFactor, vec3(0.0f), 1.0f);
        material.normal_scale = finite(from.normalTexture.scale, 1.0f, -100.0f, 100.0f);
        material.alpha_mode = from.alphaMode == "MASK" ? ModelMaterial::Alpha::mask : from.alphaMode == "BLEND" ? ModelMaterial::Alpha::blend : ModelMaterial::Alpha::opaque;
        material.alpha_cutoff = finite(from.alphaCutoff, 0.5f, 0.0f, 1e6f);
        material.two_sided = from.doubleSided;
        material.base_colour_texture = texture(pbr.baseColorTexture, "baseColorTexture");
        material.metallic_roughness_texture = texture(pbr.metallicRoughnessTexture, "metallicRoughnessTexture");
        material.normal_texture = texture(from.normalTexture, "normalTexture");
        material.emission_texture = texture(from.emissiveTexture, "emissiveTexture");
        return material;
    }

  private:
    /// Of a TextureInfo of any kind.
    template <class Info>
    ModelTexture texture(const Info& info, const char* slot) {
        ModelTexture result;
        if (info.index < 0 || static_cast<std::size_t>(info.index) >= file_.textures.size()) return result;
        const tinygltf::Texture& texture = file_.textures[static_cast<std::size_t>(info.index)];
        result.image = image_of(texture);
        if (result.image < 0) {
            warnings_.push_back(fmt::format("{}/{}: its texture {} has no picture that can be read", where_, slot, info.index));
            return {};
        }
        int set = info.texCoord;
        if (const tinygltf::Value* other = gltf_member(info.extensions, transform_extension, "texCoord"); other != nullptr && other->IsInt()) set = other->GetNumberAsInt();
        if (set != 0) warnings_.push_back(fmt::format("{}/{}: texture coordinates {} are not read, the first are taken", where_, slot, set));
        if (texture.sampler >= 0 && static_cast<std::size_t>(texture.sampler) < file_.samplers.size()) {
            const tinygltf::Sampler& sampler = file_.samplers[static_cast<std::size_t>(texture.sampler)];
            result.wrap_u = wrap_of(sampler.wrapS);
            result.wrap_v = wrap_of(sampler.wrapT);
            result.nearest = sampler.magFilter == TINYGLTF_TEXTURE_FILTER_NEAREST;
        }
        if (info.extensions.contains(transform_extension)) result.transform = transform_of(info.extensions);
        return result;
    }
    /// Translation * rotation * scale, as the extension orders them.
    static std::array<vec2, 3> transform_of(const tinygltf::ExtensionMap& extensions) {
        const vec2 scale = pair_of(extensions, "scale", vec2(1.0f));
        const float angle = gltf_number(extensions, transform_extension, "rotation", 0.0f), sine = std::sin(angle), cosine = std::cos(angle);
        return {vec2(cosine, -sine) * scale.x, vec2(sine, cosine) * scale.y, pair_of(extensions, "offset", vec2(0.0f))};
    }
    std::int32_t image_of(const tinygltf::Texture& texture) const {
        int source = texture.source;
        if (const tinygltf::Value* webp = gltf_member(texture.extensions, "EXT_texture_webp", "source"); webp != nullptr && webp->IsInt()) source = webp->GetNumberAsInt();
        return source >= 0 && static_cast<std::size_t>(source) < file_.images.size() ? source : -1;
    }
    static float specular_of(const tinygltf::ExtensionMap& extensions) {
        const float ior = gltf_number(extensions, "KHR_materials_ior", "ior", 1.5f), root = ior > 0.0f ? (ior - 1.0f) / (ior + 1.0f) : 1.0f;
        const float strength = gltf_number(extensions, "KHR_materials_specular", "specularFactor", 1.0f);
        return std::clamp(strength * root * root / usual_reflectance, 0.0f, 1.0f);
    }

    const tinygltf::Model& file_;
    std::vector<std::string>& warnings_;
    std::string where_;
};

}  // namespace

std::vector<ModelMaterial> gltf_materials(const tinygltf::Model& file, std::vector<std::string>& warnings) {
    MaterialReader reader(file, warnings);
    std::vector<ModelMaterial> materials;
    for (std::size_t i = 0; i < file.materials.size(); ++i) materials.push_back(reader.read(file.materials[i], fmt::format("/materials/{}", i)));
    return materials;
}

}  // namespace sl
