// SPDX-License-Identifier: MIT
#include "engine/core/model/vox_model.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>
#include <string_view>

#include "engine/core/closest_name.h"
#include "engine/core/error.h"
#include "engine/core/model/file_bytes.h"
#include "engine/core/model/voxel_mesh.h"
#include "engine/core/srgb.h"

namespace sl {

namespace {

constexpr int longest_side = 256;
/// Nodes, of the file and of the model.
constexpr std::size_t most_nodes = 100000;
constexpr std::size_t most_pairs = 1000, deepest_node = 64, most_visits = 1000000;
/// Cells of all models of a file.
constexpr std::size_t most_cells = std::size_t{1} << 27;

/// The bytes of one chunk, read from front to back.
class Reader {
  public:
    Reader(const unsigned char* bytes, std::size_t size, std::size_t first) : bytes_(bytes), size_(size), first_(first) {}

    bool at_end() const { return at_ == size_; }
    std::size_t byte() const { return first_ + at_; }
    std::size_t left() const { return size_ - at_; }
    const unsigned char* take(std::size_t count, const char* what) {
        if (count > left()) fail("byte {}: {} needs {} bytes, and {} are left", byte(), what, count, left());
        const unsigned char* taken = bytes_ + at_;
        at_ += count;
        return taken;
    }
    std::int32_t number(const char* what) {
        std::int32_t value = 0;
        std::memcpy(&value, take(4, what), sizeof value);
        return value;
    }
    std::size_t count(const char* what, std::size_t most) {
        const std::int32_t value = number(what);
        if (value < 0 || static_cast<std::size_t>(value) > most) fail("byte {}: {} of {}; 0 to {} can be read", byte() - 4, what, value, most);
        return static_cast<std::size_t>(value);
    }
    std::string text(const char* what) {
        const std::size_t length = count(what, left());
        return {reinterpret_cast<const char*>(take(length, what)), length};
    }
    Reader part(std::size_t count, const char* what) {
        const std::size_t first = byte();
        return {take(count, what), count, first};
    }

  private:
    const unsigned char* bytes_;
    std::size_t size_, at_ = 0, first_;
};

using Attributes = std::map<std::string, std::string>;

Attributes attributes(Reader& reader) {
    Attributes result;
    for (std::size_t left = reader.count("a number of attributes", most_pairs); left > 0; --left) {
        const std::string key = reader.text("an attribute's name");
        result[key] = reader.text("an attribute");
    }
    return result;
}

float number_of(const Attributes& attributes, const char* key, float otherwise) {
    const auto found = attributes.find(key);
    if (found == attributes.end()) return otherwise;
    float value = otherwise;
    const auto parsed = std::from_chars(found->second.data(), found->second.data() + found->second.size(), value);
    return parsed.ec == std::errc() && std::isfinite(value) ? value : otherwise;
}

/// A turn by right angles, as a row per axis: which axis it takes, and with which sign.
struct Turn {
    ivec3 axis{0, 1, 2}, sign{1};

    vec3 operator*(vec3 v) const { return {v[axis.x] * static_cast<float>(sign.x), v[axis.y] * static_cast<float>(sign.y), v[axis.z] * static_cast<float>(sign.z)}; }
};

struct Node {
    enum class Kind { transform, group, shape } kind = Kind::group;
    std::vector<std::int32_t> children;  ///< nodes, or a shape's models
    vec3 shift{0.0f};
    Turn turn;
    std::string name;
};

/// What a file holds, before it is put together.
struct Contents {
    std::vector<VoxelGrid> grids;
    std::size_t cells = 0;
    std::array<std::array<std::uint8_t, 4>, 256> palette{};
    bool own_palette = false;
    std::map<std::int32_t, Node> nodes;
    std::map<std::int32_t, Attributes> materials;
};

ivec3 size_of(Reader& reader) {
    ivec3 size;
    for (int axis = 0; axis < 3; ++axis) size[axis] = static_cast<int>(reader.count("a model's side", longest_side));
    return size;
}

void read_voxels(Reader& reader, VoxelGrid& grid, std::size_t& cells) {
    const std::size_t count = static_cast<std::size_t>(grid.size.x) * static_cast<std::size_t>(grid.size.y) * static_cast<std::size_t>(grid.size.z);
    cells += count;
    if (cells > most_cells) fail("byte {}: the models have more than {} cells", reader.byte(), most_cells);
    grid.cells.assign(count, 0);
    for (std::size_t left = reader.count("a number of voxels", reader.left() / 4); left > 0; --left) {
        const unsigned char* voxel = reader.take(4, "a voxel");
        const ivec3 cell(voxel[0], voxel[1], voxel[2]);
        if (!glm::all(glm::lessThan(cell, grid.size))) fail("byte {}: the voxel {} {} {} lies outside its model of {} x {} x {}", reader.byte() - 4, cell.x, cell.y, cell.z, grid.size.x, grid.size.y, grid.size.z);
        grid.cells[grid.index(cell)] = voxel[3];
    }
}

Turn turn_of(const Attributes& frame) {
    Turn turn;
    const int packed = static_cast<int>(std::clamp(number_of(frame, "_r", 4.0f), 0.0f, 127.0f));
    const int first = packed & 3, second = packed >> 2 & 3;
    // Two rows that name one axis, or a fourth one, are no turn.
    if (first > 2 || second > 2 || first == second) return turn;
    turn.axis = ivec3(first, second, 3 - first - second);
    turn.sign = ivec3((packed & 16) != 0 ? -1 : 1, (packed & 32) != 0 ? -1 : 1, (packed & 64) != 0 ? -1 : 1);
    return turn;
}

vec3 shift_of(const Attributes& frame) {
    vec3 shift(0.0f);
    const auto found = frame.find("_t");
    if (found == frame.end()) return shift;
    const char *at = found->second.data(), *end = at + found->second.size();
    for (int axis = 0; axis < 3; ++axis) {
        const auto parsed = std::from_chars(at, end, shift[axis]);
        if (parsed.ec != std::errc() || !std::isfinite(shift[axis])) return vec3(0.0f);
        at = parsed.ptr + (parsed.ptr != end ? 1 : 0);
    }
    return shift;
}

void read_node(Reader& reader, std::string_view kind, Contents& contents) {
    if (contents.nodes.size() >= most_nodes) fail("byte {}: more than {} nodes", reader.byte(), most_nodes);
    const std::int32_t id = reader.number("a node's number");
    Node node;
    const Attributes own = attributes(reader);
    if (const auto name = own.find("_name"); name != own.end()) node.name = for_message(name->second);
    if (kind == "nTRN") {
        node.kind = Node::Kind::transform;
        node.children = {reader.number("a child")};
        (void)reader.take(8, "a layer");
        // Only the first frame of an animation.
        if (reader.count("a number of frames", most_pairs) > 0) {
            const Attributes frame = attributes(reader);
            node.turn = turn_of(frame);
            node.shift = shift_of(frame);
        }
    } else {
        node.kind = kind == "nGRP" ? Node::Kind::group : Node::Kind::shape;
        for (std::size_t left = reader.count("a number of children", reader.left() / 4); left > 0; --left) {
            node.children.push_back(reader.number("a child"));
            if (node.kind == Node::Kind::shape) (void)attributes(reader);
        }
    }
    contents.nodes[id] = std::move(node);
}

void read_chunks(Reader& file, Contents& contents) {
    while (!file.at_end()) {
        const std::size_t begin = file.byte();
        const std::string_view kind(reinterpret_cast<const char*>(file.take(4, "a chunk's name")), 4);
        const std::size_t size = file.count("a chunk's length", file.left()), children = file.count("the length of a chunk's children", file.left());
        if (size + children > file.left()) fail("byte {}: a chunk of {} bytes, and {} are left", begin, size + children, file.left());
        Reader chunk = file.part(size, "a chunk");
        if (kind == "MAIN") continue;  // its children follow
        if (kind == "SIZE" && contents.grids.size() == most_nodes) fail("byte {}: more than {} models", begin, most_nodes);
        if (kind == "SIZE") contents.grids.push_back({.size = size_of(chunk), .cells = {}});
        if (kind == "XYZI") {
            if (contents.grids.empty() || !contents.grids.back().cells.empty()) fail("byte {}: voxels without a size before them", begin);
            read_voxels(chunk, contents.grids.back(), contents.cells);
        }
        if (kind == "RGBA") {
            contents.own_palette = true;
            // Colour 1 of a voxel is the first.
            for (std::size_t i = 0; i < 256; ++i) std::memcpy(contents.palette[(i + 1) % 256].data(), chunk.take(4, "a colour"), 4);
        }
        if (kind == "nTRN" || kind == "nGRP" || kind == "nSHP") read_node(chunk, kind, contents);
        if (kind == "MATL") {
            const std::int32_t id = chunk.number("a material's number");
            contents.materials[id] = attributes(chunk);
        }
    }
}

/// The palette of files without one: a cube of 6 x 6 x 6 colours from white down, then shades of red, green, blue and grey.
void make_palette(Contents& contents) {
    std::size_t number = 1;
    const auto add = [&](int red, int green, int blue) {
        if (number < 256) contents.palette[number++] = {static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green), static_cast<std::uint8_t>(blue), 255};
    };
    for (int red = 255; red >= 0; red -= 51) {
        for (int green = 255; green >= 0; green -= 51) {
            for (int blue = 255; blue >= 0; blue -= 51) {
                if (red + green + blue > 0) add(red, green, blue);
            }
        }
    }
    for (const ivec3 channel : {ivec3(1, 0, 0), ivec3(0, 1, 0), ivec3(0, 0, 1), ivec3(1, 1, 1)}) {
        for (const int shade : {238, 221, 187, 170, 136, 119, 85, 68, 34, 17}) add(shade * channel.x, shade * channel.y, shade * channel.z);
    }
}

ModelMaterial material_of(const Contents& contents, std::size_t number) {
    ModelMaterial material{.name = fmt::format("colour {}", number), .metallic = 0.0f, .roughness = 1.0f, .specular = 0.0f};
    for (int k = 0; k < 3; ++k) material.base_colour[k] = linear_from_srgb(static_cast<float>(contents.palette[number][static_cast<std::size_t>(k)]) / 255.0f);
    const auto found = contents.materials.find(static_cast<std::int32_t>(number));
    if (found == contents.materials.end()) return material;
    const auto type = found->second.find("_type");
    const std::string kind = type == found->second.end() ? "" : type->second;
    if (kind == "_emit") {
        const float flux = std::clamp(number_of(found->second, "_flux", 0.0f), 0.0f, 6.0f);
        material.emission = material.base_colour * (vox_emission * std::clamp(number_of(found->second, "_emit", 0.0f), 0.0f, 1.0f) * std::pow(10.0f, flux));
    }
    if (kind == "_metal") {
        material.metallic = std::clamp(number_of(found->second, "_metal", 1.0f), 0.0f, 1.0f);
        material.roughness = std::clamp(number_of(found->second, "_rough", 0.1f), 0.0f, 1.0f);
    }
    return material;
}

/// Builds the nodes of a model out of the file's.
class Assembler {
  public:
    Assembler(const Contents& contents, Model& model) : contents_(contents), model_(model) {}

    void place_all() {
        if (contents_.nodes.empty()) {
            for (std::size_t i = 0; i < contents_.grids.size(); ++i) show(i, vec3(0.0f), mat3(1.0f), "");
        } else if (const auto root = contents_.nodes.begin(); root != contents_.nodes.end()) {
            place(root->first, vec3(0.0f), mat3(1.0f), "", 0);
        }
    }

  private:
    void place(std::int32_t id, vec3 shift, mat3 turn, const std::string& name, std::size_t depth) {
        const auto found = contents_.nodes.find(id);
        if (found == contents_.nodes.end()) fail("there is no node {}", id);
        if (depth > deepest_node || ++visits_ > most_visits) fail("node {} stands above itself, or there are too many", id);
        const Node& node = found->second;
        if (node.kind == Node::Kind::transform) {
            shift += turn * node.shift;
            mat3 own(0.0f);
            for (int row = 0; row < 3; ++row) own[node.turn.axis[row]][row] = static_cast<float>(node.turn.sign[row]);
            turn = turn * own;
        }
        for (const std::int32_t child : node.children) {
            if (node.kind != Node::Kind::shape) {
                place(child, shift, turn, node.name.empty() ? name : node.name, depth + 1);
            } else if (child >= 0 && static_cast<std::size_t>(child) < contents_.grids.size()) {
                show(static_cast<std::size_t>(child), shift, turn, name);
            } else {
                fail("node {}: there is no model {}", id, child);
            }
        }
    }
    /// The file's z is up. A turn that mirrors has a negative scale.
    void show(std::size_t grid, vec3 shift, mat3 turn, const std::string& name) {
        if (model_.nodes.size() >= most_nodes) fail("its models are shown more than {} times", most_nodes);
        ModelNode node{.name = name};
        const mat3 y_up(vec3(1, 0, 0), vec3(0, 0, -1), vec3(0, 1, 0));
        mat3 placed = y_up * turn;
        if (glm::determinant(placed) < 0.0f) {
            node.scale.x = -1.0f;
            placed[0] = -placed[0];
        }
        node.rotation = glm::normalize(glm::quat_cast(placed));
        node.scale *= vox_voxel_size;
        node.translation = dvec3(vox_voxel_size * (y_up * shift));
        node.mesh = static_cast<std::int32_t>(grid);
        model_.scenes[0].roots.push_back(static_cast<std::int32_t>(model_.nodes.size()));
        model_.nodes.push_back(std::move(node));
    }

    const Contents& contents_;
    Model& model_;
    std::size_t visits_ = 0;
};

Model model_of(Contents& contents) {
    Model model;
    model.scenes.emplace_back();
    if (!contents.own_palette) make_palette(contents);
    for (std::size_t i = 1; i < 256; ++i) model.materials.push_back(material_of(contents, i));
    std::size_t faces_left = most_voxel_faces;
    for (const VoxelGrid& grid : contents.grids) {
        if (grid.cells.empty()) fail("a model has a size and no voxels");
        // A file with a scene places models by their middles, in whole cells.
        const vec3 low = contents.nodes.empty() ? vec3(0.0f) : -glm::floor(0.5f * vec3(grid.size));
        model.meshes.push_back({.name = "", .primitives = {ModelPrimitive{.mesh = voxel_mesh(grid, low, faces_left), .material = 0}}, .weights = {}});
    }
    if (model.meshes.empty()) model.warnings.emplace_back("there are no voxels in it");
    Assembler(contents, model).place_all();
    return model;
}

}  // namespace

Model read_vox(const std::filesystem::path& path, const ModelReading& reading) {
    const std::vector<std::byte> bytes = file_bytes(path, reading.most_bytes);
    try {
        Reader file(reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size(), 0);
        if (std::string_view(reinterpret_cast<const char*>(file.take(4, "the format's name")), 4) != "VOX ") fail("byte 0: it is no MagicaVoxel file, which begins with 'VOX '");
        (void)file.number("the version");
        Contents contents;
        read_chunks(file, contents);
        return model_of(contents);
    } catch (const std::bad_alloc&) {
        fail("{}: it needs more memory than there is", path.string());
    } catch (const Error& error) {
        fail("{}: {}", path.string(), error.what());
    }
}

}  // namespace sl
