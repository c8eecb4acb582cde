// SPDX-License-Identifier: MIT
#include "engine/core/model/gltf_model.h"

#include <tiny_gltf.h>

#include <algorithm>
#include <array>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/model/file_bytes.h"
#include "engine/core/model/gltf_material.h"
#include "engine/core/model/gltf_mesh.h"
#include "engine/core/model/gltf_nodes.h"

namespace sl {

namespace {

constexpr std::array<std::string_view, 8> known_extensions{"KHR_lights_punctual", "KHR_materials_emissive_strength", "KHR_materials_ior", "KHR_materials_specular",
                                                           "KHR_materials_unlit", "KHR_mesh_quantization", "KHR_texture_transform", "EXT_texture_webp"};

/// Where a file may read from, and what it could not.
struct Folder {
    std::filesystem::path path;
    ModelReading reading;
    std::string refused;  ///< the first file that was, and why

    bool allows(const std::filesystem::path& file) const {
        if (reading.files_anywhere) return true;
        std::error_code error;
        // Links are followed: one may lead out of the folder.
        const auto real = std::filesystem::weakly_canonical(file, error), inside = std::filesystem::weakly_canonical(path, error);
        const auto relative = real.lexically_relative(inside);
        return !error && !relative.empty() && *relative.begin() != "..";
    }
    void refuse(const std::string& file, std::string_view why) {
        if (refused.empty()) refused = fmt::format("{}: {}", for_message(file, 200), why);
    }
};

bool read_beside(std::vector<unsigned char>* bytes, std::string*, const std::string& file, void* data) {
    auto& folder = *static_cast<Folder*>(data);
    if (!folder.allows(file)) {
        folder.refuse(file, "it lies outside the model's folder; --allow-outside lets models read such files");
        return false;
    }
    try {
        *bytes = file_bytes(file, folder.reading.most_bytes);
        return !bytes->empty();
    } catch (const Error& error) {
        if (folder.refused.empty()) folder.refused = error.what();
        return false;
    }
}

bool exists(const std::string&, void*) { return true; }  // what is not there is told when it is read
std::string as_it_is(const std::string& path, void*) { return path; }
bool write_nothing(std::string*, const std::string&, const std::vector<unsigned char>&, void*) { return false; }

/// Keeps a picture's file as it is. Those in buffer views are taken from there later, with a look at where these end.
bool keep_picture(tinygltf::Image* image, int, std::string*, std::string*, int, int, const unsigned char* bytes, int size, void*) {
    if (image->bufferView < 0 && size > 0) image->image.assign(bytes, bytes + size);
    return true;
}

ModelImage image_of(const tinygltf::Model& file, const tinygltf::Image& from, const std::string& where, std::vector<std::string>& warnings) {
    ModelImage image{.name = from.uri.empty() || from.uri.starts_with("data:") ? where : for_message(from.uri, 120), .bytes = {}};
    const auto take = [&](const unsigned char* bytes, std::size_t size) {
        const auto* first = reinterpret_cast<const std::byte*>(bytes);
        image.bytes.assign(first, first + size);
    };
    if (from.bufferView < 0) {
        take(from.image.data(), from.image.size());
    } else if (static_cast<std::size_t>(from.bufferView) < file.bufferViews.size()) {
        const tinygltf::BufferView& view = file.bufferViews[static_cast<std::size_t>(from.bufferView)];
        const bool has_buffer = view.buffer >= 0 && static_cast<std::size_t>(view.buffer) < file.buffers.size();
        const std::size_t size = has_buffer ? file.buffers[static_cast<std::size_t>(view.buffer)].data.size() : 0;
        if (view.byteOffset <= size && view.byteLength <= size - view.byteOffset && has_buffer) take(file.buffers[static_cast<std::size_t>(view.buffer)].data.data() + view.byteOffset, view.byteLength);
    }
    if (image.bytes.empty()) warnings.push_back(fmt::format("{}: the picture {} cannot be read, and is white", where, image.name));
    return image;
}

void check_extensions(const tinygltf::Model& file, std::vector<std::string>& warnings) {
    const auto known = [](const std::string& name) { return std::ranges::find(known_extensions, name) != known_extensions.end(); };
    for (const std::string& name : file.extensionsRequired) {
        if (!known(name)) fail("/extensionsRequired: it needs {}, which is not known here", for_message(name));
    }
    for (const std::string& name : file.extensionsUsed) {
        if (!known(name)) warnings.push_back(fmt::format("/extensionsUsed: {} is not known here, and left out", for_message(name)));
    }
}

/// One line of a library's message.
std::string first_line(const std::string& text) {
    const std::size_t begin = text.find_first_not_of(" \n"), end = text.find('\n', begin);
    return begin == std::string::npos ? "it is no glTF file" : for_message(text.substr(begin, end - begin), 200);
}

tinygltf::Model parsed(const std::vector<unsigned char>& bytes, Folder& folder) {
    tinygltf::TinyGLTF loader;
    loader.SetFsCallbacks({.FileExists = exists, .ExpandFilePath = as_it_is, .ReadWholeFile = read_beside, .WriteWholeFile = write_nothing, .user_data = &folder});
    loader.SetImageLoader(keep_picture, nullptr);
    tinygltf::Model file;
    std::string error, warning;
    const bool binary = bytes.size() >= 4 && std::equal(bytes.begin(), bytes.begin() + 4, "glTF");
    const auto size = static_cast<unsigned>(bytes.size());
    bool fine = false;
    try {
        fine = binary ? loader.LoadBinaryFromMemory(&file, &error, &warning, bytes.data(), size, folder.path.string())
                      : loader.LoadASCIIFromString(&file, &error, &warning, reinterpret_cast<const char*>(bytes.data()), size, folder.path.string());
    } catch (const std::exception& thrown) {
        error = fmt::format("it is no glTF file ({})", thrown.what());
    }
    if (!fine) fail("{}", folder.refused.empty() ? first_line(error) : folder.refused);
    if (!file.asset.version.starts_with("2.")) fail("/asset/version: it is '{}', and version 2.0 can be read", for_message(file.asset.version));
    return file;
}

Model model_of(const tinygltf::Model& file) {
    Model model;
    check_extensions(file, model.warnings);
    model.materials = gltf_materials(file, model.warnings);
    for (std::size_t i = 0; i < file.images.size(); ++i) model.images.push_back(image_of(file, file.images[i], fmt::format("/images/{}", i), model.warnings));
    for (std::size_t i = 0; i < file.meshes.size(); ++i) {
        ModelMesh& mesh = model.meshes.emplace_back();
        mesh.name = file.meshes[i].name;
        for (const double weight : file.meshes[i].weights) mesh.weights.push_back(static_cast<float>(weight));
        for (std::size_t k = 0; k < file.meshes[i].primitives.size(); ++k) {
            auto primitive = gltf_primitive(file, file.meshes[i].primitives[k], model, fmt::format("/meshes/{}/primitives/{}", i, k), model.warnings);
            if (primitive) mesh.primitives.push_back(std::move(*primitive));
        }
    }
    read_gltf_nodes(file, model);
    return model;
}

}  // namespace

Model read_gltf(const std::filesystem::path& path, const ModelReading& reading) {
    const std::vector<unsigned char> bytes = file_bytes(path, std::min(reading.most_bytes, std::uint64_t{0xffffffffu}));
    Folder folder{.path = path.has_parent_path() ? path.parent_path() : ".", .reading = reading, .refused = {}};
    try {
        Model model = model_of(parsed(bytes, folder));
        if (!folder.refused.empty()) model.warnings.push_back(folder.refused);
        return model;
    } catch (const std::bad_alloc&) {
        fail("{}: it needs more memory than there is", path.string());
    } catch (const Error& error) {
        fail("{}: {}", path.string(), error.what());
    }
}

}  // namespace sl
