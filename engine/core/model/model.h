// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/mesh_data.h"

namespace sl {

/// A picture as its file holds it: PNG, JPEG or whatever else; decoded by `decode_picture`.
struct ModelImage {
    std::string name;  ///< for messages: a file's, or where in the model it stands
    std::vector<std::byte> bytes;
    std::int32_t same_as = -1;  ///< the image before it that holds the bytes of both; -1: its own
};

/// How a material reads a picture: uv_in_picture = transform * (uv, 1), v down as in glTF.
struct ModelTexture {
    enum class Wrap { repeat, mirror, clamp };
    std::int32_t image = -1;  ///< of Model::images; -1: none
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
    bool nearest = false;                     ///< texels stay squares when they are large
    bool second_uv = false;                   ///< reads the second of its material's coordinates
    std::array<vec2, 3> transform{vec2(1, 0), vec2(0, 1), vec2(0)};  ///< columns

    explicit operator bool() const { return image >= 0; }
    bool operator==(const ModelTexture&) const = default;
};

/// Metallic-roughness surface, linear Rec. 709, as in glTF 2.0.
struct ModelMaterial {
    enum class Alpha { opaque, mask, blend };
    std::string name;
    vec3 base_colour{1.0f};
    float alpha = 1.0f;
    float metallic = 1.0f, roughness = 1.0f;
    float specular = 1.0f;      ///< strength of the dielectric reflection; 1 is n = 1.5
    vec3 emission{0.0f};        ///< nit
    float normal_scale = 1.0f;  ///< of what leans sideways in the normal texture
    Alpha alpha_mode = Alpha::opaque;
    float alpha_cutoff = 0.5f;
    bool two_sided = false;
    bool unlit = false;                        ///< base colour and alpha alone count, whatever light there is
    ModelTexture base_colour_texture;          ///< sRGB, alpha
    ModelTexture metallic_roughness_texture;   ///< green: roughness, blue: metallic
    ModelTexture normal_texture;               ///< right, up and out of the surface as red, green, blue; 0 is -1
    ModelTexture emission_texture;             ///< sRGB
    ModelTexture occlusion_texture;            ///< red; for renderers that do not reckon how little light reaches corners
    /// Which of a mesh's texture coordinates (TEXCOORD_n) are its first and its second; one number twice where it has one alone.
    std::array<std::size_t, 2> uv_sets{0, 0};

    /// Whether meshes need PicturedVertex for it.
    bool needs_pictured_vertices() const { return normal_texture || uv_sets[0] != uv_sets[1]; }
};

/// What moves a mesh's vertices, besides its node.
struct ModelMorph {
    std::vector<vec3> positions, normals, tangents;  ///< added, weighted; empty or one per vertex
};
/// Which joints of its skin move a vertex, and how much of each; the weights add up to 1.
struct ModelJoints {
    std::array<std::uint16_t, 4> joints{};
    vec4 weights{0.0f};
};

/// Triangles of one material. Those that face both ways are there twice, the second time turned.
struct ModelPrimitive {
    MeshData mesh;
    std::int32_t material = -1;        ///< of Model::materials; -1: a plain one
    std::vector<ModelMorph> morphs;
    std::vector<ModelJoints> joints;   ///< one per vertex where a skin may move it

    /// Calls a function with each array that has an element per vertex, or is empty.
    template <class Function>
    void visit_vertex_arrays(const Function& function) {
        function(mesh.vertices);
        function(mesh.pictured);
        for (ModelMorph& morph : morphs) {
            function(morph.positions);
            function(morph.normals);
            function(morph.tangents);
        }
        function(joints);
    }
};
/// What a node shows.
struct ModelMesh {
    std::string name;
    std::vector<ModelPrimitive> primitives;
    std::vector<float> weights;  ///< of its morphs, where neither node nor animation says otherwise
};

/// As in KHR_lights_punctual: along -z, lux or candela, half angles in rad, range in m (0: without end).
struct ModelLight {
    enum class Kind { directional, point, spot };
    std::string name;
    Kind kind = Kind::point;
    vec3 colour{1.0f};
    float intensity = 1.0f;
    float range = 0.0f;
    float inner_cone = 0.0f, outer_cone = 0.7854f;
};

/// A view along -z of its node, in perspective or orthographic.
struct ModelCamera {
    std::string name;
    float fov_y = 1.0f;  ///< rad
    float height = 0.0f; ///< m: what an orthographic one sees from bottom to top; 0 for perspective
    float near = 0.01f;  ///< m
};

/// A place in its parent, or in the model, and what is there.
struct ModelNode {
    std::string name;
    std::int32_t parent = -1;  ///< a node before it, or none
    dvec3 translation{0.0};
    quat rotation{1, 0, 0, 0};
    vec3 scale{1.0f};
    std::int32_t mesh = -1, skin = -1, light = -1, camera = -1;
    std::vector<float> weights;
};

/// Nodes that move a skinned mesh; vertex_in_world = Σ weight · world_from_joint · joint_from_mesh · vertex.
struct ModelSkin {
    std::vector<std::int32_t> joints;     ///< nodes
    std::vector<mat4> joint_from_mesh;    ///< one per joint
};

/// What a node's property is at given times, s.
struct ModelChannel {
    enum class Path { translation, rotation, scale, weights };
    enum class Between { step, linear, cubic };
    std::int32_t node = 0;
    Path path = Path::translation;
    Between between = Between::linear;
    std::vector<float> times;   ///< rising
    std::vector<float> values;  ///< `width` for each time; of cubic ones three times as many: slope in, value, slope out
    std::size_t width = 3;
};
/// Channels that run together, from 0 to `length`.
struct ModelAnimation {
    std::string name;
    std::vector<ModelChannel> channels;
    float length = 0.0f;  ///< s
};

/// A model file as plain arrays; nodes in an order in which parents come first.
struct Model {
    std::vector<ModelNode> nodes;
    std::vector<ModelMesh> meshes;
    std::vector<ModelMaterial> materials;
    std::vector<ModelImage> images;
    std::vector<ModelLight> lights;
    std::vector<ModelCamera> cameras;
    std::vector<ModelSkin> skins;
    std::vector<ModelAnimation> animations;
    /// A file may hold several scenes.
    struct Scene {
        std::string name;
        std::vector<std::int32_t> roots;
    };
    std::vector<Scene> scenes;
    std::size_t scene = 0;              ///< the one that is meant
    std::vector<std::string> warnings;  ///< what is wrong or not understood in it, and was left out; a line each
};

/// Where each node of one scene is with all its parents, local to the model; none for nodes that are not in it.
std::vector<std::optional<mat4>> places_of(const Model& model, std::size_t scene);

/// Of all that a scene shows, as it stands without animation. Empty where it shows nothing.
Bounds bounds_of(const Model& model, std::size_t scene);

}  // namespace sl
