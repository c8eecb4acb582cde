// SPDX-License-Identifier: MIT
#include "game/hall/hall_glb.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "engine/core/png.h"

namespace sl {

namespace {

using Json = nlohmann::ordered_json;

// As the format numbers them.
constexpr int float_numbers = 5126, whole_numbers = 5125, vertex_data = 34962, index_data = 34963, repeat = 10497, linear = 9729, linear_mipmaps = 9987;

template <class Vector>
Json numbers_of(const Vector& vector) {
    Json numbers = Json::array();
    for (int i = 0; i < Vector::length(); ++i) numbers.push_back(vector[i]);
    return numbers;
}

/// From a rotation in glTF's order: the real part last.
Json rotation_of(const glm::dquat& turn) { return {turn.x, turn.y, turn.z, turn.w}; }

class GlbWriter {
  public:
    explicit GlbWriter(const Hall& hall) : hall_(hall) {}

    std::string write() {
        json_ = {{"asset", {{"version", "2.0"}, {"generator", "Secondlight"}}},
                 {"extensionsUsed", {"KHR_lights_punctual"}},
                 {"scene", 0},
                 {"scenes", {{{"name", "hall"}, {"nodes", Json::array()}}}}};
        add_cameras();
        add_sun();
        for (const HallMaterial& material : hall_.materials) add_material(material);
        json_["samplers"] = {{{"magFilter", linear}, {"minFilter", linear_mipmaps}, {"wrapS", repeat}, {"wrapT", repeat}}};
        for (const HallPicture& picture : hall_.pictures) add_picture(picture);
        for (const HallPart& part : hall_.parts) add_part(part);
        json_["buffers"] = {{{"byteLength", data_.size()}}};
        return file();
    }

  private:
    std::size_t add(const char* list, Json entry) {
        json_[list].push_back(std::move(entry));
        return json_[list].size() - 1;
    }
    void show(Json node) { json_["scenes"][0]["nodes"].push_back(add("nodes", std::move(node))); }

    std::size_t add_view(const void* bytes, std::size_t count, int target) {
        data_.resize((data_.size() + 3) / 4 * 4, '\0');
        Json view{{"buffer", 0}, {"byteOffset", data_.size()}, {"byteLength", count}};
        if (target != 0) view["target"] = target;
        data_.append(static_cast<const char*>(bytes), count);
        return add("bufferViews", std::move(view));
    }
    template <class Element>
    std::size_t add_accessor(const std::vector<Element>& elements, int target, int component, const char* type, Json more = Json::object()) {
        const std::size_t view = add_view(elements.data(), elements.size() * sizeof(Element), target);
        Json accessor{{"bufferView", view}, {"componentType", component}, {"count", elements.size()}, {"type", type}};
        accessor.update(more);
        return add("accessors", std::move(accessor));
    }

    void add_material(const HallMaterial& material) {
        Json surface{{"baseColorFactor", numbers_of(vec4(material.colour, 1.0f))}, {"metallicFactor", 0}, {"roughnessFactor", material.roughness}};
        if (material.picture >= 0) surface["baseColorTexture"] = {{"index", material.picture}};
        Json json{{"name", material.name}, {"pbrMetallicRoughness", std::move(surface)}};
        if (material.two_sided) json["doubleSided"] = true;
        add("materials", std::move(json));
    }
    void add_picture(const HallPicture& picture) {
        const std::string bytes = png_bytes(picture.image);
        const std::size_t image = add("images", {{"name", picture.name}, {"mimeType", "image/png"}, {"bufferView", add_view(bytes.data(), bytes.size(), 0)}});
        add("textures", {{"sampler", 0}, {"source", image}});
    }
    void add_part(const HallPart& part) {
        Bounds bounds;
        for (const vec3 position : part.mesh.positions) bounds.add(position);
        Json attributes{{"POSITION", add_accessor(part.mesh.positions, vertex_data, float_numbers, "VEC3", {{"min", numbers_of(bounds.low)}, {"max", numbers_of(bounds.high)}})},
                        {"NORMAL", add_accessor(part.mesh.normals, vertex_data, float_numbers, "VEC3")}};
        if (hall_.materials[static_cast<std::size_t>(part.material)].picture >= 0) attributes["TEXCOORD_0"] = add_accessor(part.mesh.uvs, vertex_data, float_numbers, "VEC2");
        const std::size_t indices = add_accessor(part.mesh.indices, index_data, whole_numbers, "SCALAR");
        Json primitive{{"attributes", std::move(attributes)}, {"indices", indices}, {"material", part.material}};
        const std::size_t mesh = add("meshes", {{"name", part.name}, {"primitives", Json::array({std::move(primitive)})}});
        for (std::size_t i = 0; i < part.places.size(); ++i) {
            Json node{{"name", part.places.size() == 1 ? part.name : fmt::format("{} {}", part.name, i + 1)}, {"mesh", mesh}};
            const HallPlace& place = part.places[i];
            if (place.position != dvec3(0.0)) node["translation"] = numbers_of(place.position);
            if (place.turn != 0.0) node["rotation"] = rotation_of(glm::angleAxis(place.turn, dvec3(0, 1, 0)));
            show(std::move(node));
        }
    }
    void add_cameras() {
        constexpr double near = 0.05;
        for (const HallCamera& camera : hall_.cameras) {
            const std::size_t number = add("cameras", {{"name", camera.name}, {"type", "perspective"}, {"perspective", {{"yfov", camera.fov_y}, {"znear", near}}}});
            const glm::dquat turn = glm::quatLookAt(glm::normalize(camera.target - camera.eye), dvec3(0, 1, 0));
            show({{"name", camera.name}, {"camera", number}, {"translation", numbers_of(camera.eye)}, {"rotation", rotation_of(turn)}});
        }
    }
    void add_sun() {
        const HallSun& sun = hall_.sun;
        json_["extensions"]["KHR_lights_punctual"]["lights"] = {{{"name", "sun"}, {"type", "directional"}, {"color", numbers_of(sun.colour)}, {"intensity", sun.illuminance}}};
        const glm::dquat turn = glm::quatLookAt(glm::normalize(sun.towards), dvec3(0, 1, 0));
        show({{"name", "sun"}, {"rotation", rotation_of(turn)}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    }

    std::string file() {
        std::string text = json_.dump();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        data_.resize((data_.size() + 3) / 4 * 4, '\0');
        std::string file = "glTF";
        const auto append = [&](std::size_t number) {
            const auto word = static_cast<std::uint32_t>(number);
            file.append(reinterpret_cast<const char*>(&word), sizeof word);
        };
        append(2);
        append(12 + 8 + text.size() + 8 + data_.size());
        append(text.size());
        file += "JSON" + text;
        append(data_.size());
        return file + std::string("BIN\0", 4) + data_;
    }

    const Hall& hall_;
    Json json_;
    std::string data_;
};

}  // namespace

std::string hall_glb(const Hall& hall) { return GlbWriter(hall).write(); }

}  // namespace sl
