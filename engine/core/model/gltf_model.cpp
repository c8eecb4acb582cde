// SPDX-License-Identifier: MIT
#include "engine/core/model/gltf_model.h"

#include <algorithm>
#include <array>
#include <unordered_map>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/gltf/gltf_check.h"
#include "engine/core/gltf/gltf_uri.h"
#include "engine/core/model/file_bytes.h"
#include "engine/core/model/gltf_expansion.h"
#include "engine/core/model/gltf_floats.h"
#include "engine/core/model/gltf_material.h"
#include "engine/core/model/gltf_mesh.h"
#include "engine/core/model/gltf_nodes.h"

namespace sl {

using nlohmann::json;

namespace {

constexpr std::array<std::string_view, 8> known_extensions{
    "KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_ior",     "KHR_materials_specular",
    "KHR_materials_unlit", "KHR_mesh_quantization",           "KHR_texture_transform", "EXT_texture_webp"};

/// Where a model may read from.
struct Folder {
    std::filesystem::path path;
    ModelReading reading;

    std::vector<std::byte> read(const std::string& beside) const {
        const std::filesystem::path file = path / beside;
        if (!allows(file))
            fail("{}: it lies outside the model's folder; --allow-outside lets models read such files", for_message(beside, 200));
        return file_bytes(file, reading.most_bytes);
    }

  private:
    bool allows(const std::filesystem::path& file) const {
        if (reading.files_anywhere) return true;
        std::error_code error;
        // Links are followed: one may lead out of the folder.
        const auto real = std::filesystem::weakly_canonical(file, error), inside = std::filesystem::weakly_canonical(path, error);
        const auto relative = real.lexically_relative(inside);
        return !error && !relative.empty() && *relative.begin() != "..";
    }
};

std::string line_of(const GltfFault& fault) {
    return fault.where.empty() ? fault.message : fmt::format("{}: {}", fault.where, fault.message);
}

void stop_at_fatal(const GltfFaults& faults) {
    for (const GltfFault& fault : faults.list()) {
        if (fault.fatal) fail("{}", line_of(fault));
    }
}

void warn_of_unknown_extensions(GltfReader& reader) {
    for (const json& name : gltf_list(reader.document(), "extensionsUsed")) {
        const auto& text = name.get_ref<const std::string&>();
        if (std::ranges::find(known_extensions, text) == known_extensions.end())
            reader.warn("/extensionsUsed", fmt::format("{} is not known here, and left out", for_message(text)));
    }
}

std::vector<ModelImage> images_of(GltfReader& reader) {
    std::vector<ModelImage> images;
    const json& list = gltf_list(reader.document(), "images");
    std::unordered_map<const std::byte*, std::int32_t> first;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const std::string where = fmt::format("/images/{}", i);
        const std::string_view uri = gltf_text_at(list[i], "uri");
        const auto bytes = reader.resources().images()[i];
        ModelImage& image = images.emplace_back();
        image.name = uri.empty() || uri.starts_with(gltf_data_scheme) ? where : for_message(uri, 120);
        if (bytes.empty()) {
            reader.warn(where, "the picture cannot be read, and is white");
            continue;
        }
        const auto [found, is_new] = first.try_emplace(bytes.data(), static_cast<std::int32_t>(i));
        if (is_new) {
            image.bytes.assign(bytes.begin(), bytes.end());
        } else {
            image.same_as = found->second;
        }
    }
    return images;
}

ModelMesh mesh_of(const json& from, const std::vector<ModelMaterial>& materials, const std::string& where, GltfReader& reader) {
    ModelMesh mesh;
    mesh.name = gltf_text_at(from, "name");
    for (const json& weight : gltf_list(from, "weights")) mesh.weights.push_back(gltf_float(weight.get<double>()));
    const json& primitives = gltf_list(from, "primitives");
    for (std::size_t i = 0; i < primitives.size(); ++i) {
        auto primitive = gltf_primitive(primitives[i], materials, fmt::format("{}/primitives/{}", where, i), reader);
        if (primitive) mesh.primitives.push_back(std::move(*primitive));
    }
    return mesh;
}

Model model_of(const GltfChecked& file) {
    GltfReader reader(file);
    for (const GltfFault& fault : file.faults.list()) reader.warn(fault.where, fault.message);
    for (const std::string& where : file.resources.elsewhere()) reader.warn(where, "only files beside the model are read");
    warn_of_unknown_extensions(reader);
    Model model;
    model.materials = gltf_materials(reader);
    check_gltf_expansion(file, model.materials);
    model.images = images_of(reader);
    const json& meshes = gltf_list(reader.document(), "meshes");
    for (std::size_t i = 0; i < meshes.size(); ++i)
        model.meshes.push_back(mesh_of(meshes[i], model.materials, fmt::format("/meshes/{}", i), reader));
    read_gltf_nodes(reader, model);
    model.warnings = reader.take_warnings();
    return model;
}

}  // namespace

Model read_gltf(const std::filesystem::path& path, const ModelReading& reading) {
    std::vector<std::byte> bytes = file_bytes(path, reading.most_bytes);
    const Folder folder{.path = path.has_parent_path() ? path.parent_path() : ".", .reading = reading};
    try {
        const GltfChecked file = check_gltf(
            bytes, [&](const std::string& beside) { return folder.read(beside); }, known_extensions);
        stop_at_fatal(file.faults);
        // Of a text nothing is needed any more.
        if (!file.file.is_container) std::vector<std::byte>().swap(bytes);
        return model_of(file);
    } catch (const std::bad_alloc&) {
        fail("{}: it needs more memory than there is", path.string());
    } catch (const Error& error) {
        fail("{}: {}", path.string(), error.what());
    }
}

}  // namespace sl
