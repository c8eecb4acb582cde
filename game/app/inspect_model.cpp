// SPDX-License-Identifier: MIT
#include "engine/core/model/read_model.h"
#include "game/app/inspect.h"

namespace sl {

namespace {

std::string named(const std::string& name) { return name.empty() ? "(no name)" : name; }

std::string told(const ModelMesh& mesh) {
    std::size_t triangles = 0, vertices = 0, morphs = 0;
    for (const ModelPrimitive& primitive : mesh.primitives) {
        triangles += primitive.mesh.indices.size() / 3;
        vertices += primitive.mesh.vertices.size();
        morphs = std::max(morphs, primitive.morphs.size());
    }
    return fmt::format("{}: {} primitives, {} triangles, {} vertices{}", named(mesh.name), mesh.primitives.size(), triangles, vertices, morphs > 0 ? fmt::format(", {} morph targets", morphs) : "");
}

std::string told(const ModelMaterial& material) {
    std::string text = fmt::format("{}: colour {:.2f} {:.2f} {:.2f}, metallic {:.2f}, roughness {:.2f}", named(material.name), material.base_colour.x, material.base_colour.y, material.base_colour.z,
                                   material.metallic, material.roughness);
    if (material.emission != vec3(0.0f)) text += fmt::format(", glows {:.3g} {:.3g} {:.3g} nit", material.emission.x, material.emission.y, material.emission.z);
    if (material.alpha_mode == ModelMaterial::Alpha::mask) text += fmt::format(", cut out below {:.2f}", material.alpha_cutoff);
    if (material.alpha_mode == ModelMaterial::Alpha::blend) text += ", see-through";
    if (material.two_sided) text += ", two-sided";
    if (material.unlit) text += ", unlit";
    for (const auto& [texture, name] : {std::pair{&material.base_colour_texture, "colour"}, {&material.metallic_roughness_texture, "metallic and roughness"},
                                        {&material.normal_texture, "normal"}, {&material.emission_texture, "glow"}}) {
        if (*texture) text += fmt::format(", {} from image {}", name, texture->image);
    }
    return text;
}

std::string told(const ModelLight& light) {
    switch (light.kind) {
        case ModelLight::Kind::directional: return fmt::format("{}: directional, {:.4g} lux", named(light.name), light.intensity);
        case ModelLight::Kind::point: return fmt::format("{}: point, {:.4g} cd", named(light.name), light.intensity);
        default: return fmt::format("{}: spot, {:.4g} cd, cone {:.1f}° to {:.1f}°", named(light.name), light.intensity, glm::degrees(light.inner_cone), glm::degrees(light.outer_cone));
    }
}

std::size_t bytes_of(const Model& model) {
    std::size_t bytes = 0;
    for (const ModelImage& image : model.images) bytes += image.bytes.size();
    for (const ModelMesh& mesh : model.meshes) {
        for (const ModelPrimitive& primitive : mesh.primitives) {
            bytes += primitive.mesh.vertices.size() * sizeof(Vertex) + primitive.mesh.pictured.size() * sizeof(PicturedVertex) + primitive.mesh.indices.size() * sizeof(std::uint32_t) + primitive.joints.size() * sizeof(ModelJoints);
            for (const ModelMorph& morph : primitive.morphs) bytes += (morph.positions.size() + morph.normals.size() + morph.tangents.size()) * sizeof(vec3);
        }
    }
    return bytes;
}

/// What the file holds and nobody reads, besides what was wrong.
std::vector<std::string> ignored_of(const Model& model) {
    std::vector<std::string> ignored = model.warnings;
    for (std::size_t i = 0; i < model.materials.size(); ++i) {
        if (model.materials[i].occlusion_texture)
            ignored.push_back(fmt::format("/materials/{}/occlusionTexture: where little light arrives, it is dark without it", i));
    }
    return ignored;
}

}  // namespace

void inspect_model(const std::filesystem::path& path) {
    const Model model = read_model(path);
    fmt::print("{}\n", path.string());
    print_part("scenes", model.scenes, [&](const Model::Scene& scene) { return fmt::format("{}: {} roots{}", named(scene.name), scene.roots.size(), &scene == &model.scenes[model.scene] ? ", shown" : ""); });
    fmt::print("nodes: {}\n", model.nodes.size());
    print_part("meshes", model.meshes, [](const ModelMesh& mesh) { return told(mesh); });
    print_part("materials", model.materials, [](const ModelMaterial& material) { return told(material); });
    print_part("images", model.images, [](const ModelImage& image) { return image.same_as < 0 ? fmt::format("{}: {} bytes", image.name, image.bytes.size()) : fmt::format("{}: as image {}", image.name, image.same_as); });
    print_part("lights", model.lights, [](const ModelLight& light) { return told(light); });
    print_part("cameras", model.cameras, [](const ModelCamera& camera) {
        const std::string seen = camera.height > 0.0f ? fmt::format("orthographic, {:.3g} m", camera.height) : fmt::format("{:.1f}°", glm::degrees(camera.fov_y));
        return fmt::format("{}: {} from top to bottom, from {:.3g} m on", named(camera.name), seen, camera.near);
    });
    print_part("skins", model.skins, [](const ModelSkin& skin) { return fmt::format("{} joints", skin.joints.size()); });
    print_part("animations", model.animations, [](const ModelAnimation& animation) { return fmt::format("{}: {:.2f} s, {} channels", named(animation.name), animation.length, animation.channels.size()); });
    const Bounds bounds = bounds_of(model, model.scene);
    print_bounds(bounds);
    fmt::print("memory: {:.1f} MB\n", static_cast<double>(bytes_of(model)) / 1e6);
    print_part("ignored", ignored_of(model), [](const std::string& warning) { return warning; });
}

}  // namespace sl
