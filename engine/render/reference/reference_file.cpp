// SPDX-License-Identifier: MIT
#include "engine/render/reference/reference_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/json_text.h"

namespace sl {

namespace {

using Json = nlohmann::json;

constexpr int file_version = 1;
constexpr std::size_t sums_per_layer = 3;

const double* values_of(const PixelSums& sums) { return reinterpret_cast<const double*>(&sums); }
double* values_of(PixelSums& sums) { return reinterpret_cast<double*>(&sums); }

std::string sum_layer(std::size_t first, const char* part) { return fmt::format("sum_{:02}_{}", first, part); }

void add_sums(const Film& film, std::vector<ImageLayer>& layers) {
    const uvec2 size = film.size();
    for (std::size_t first = 0; first < pixel_sum_count; first += sums_per_layer) {
        const std::size_t count = std::min(sums_per_layer, pixel_sum_count - first);
        Image high(size.x, size.y, static_cast<std::uint32_t>(count)), low = high;
        for (std::uint32_t y = 0; y < size.y; ++y) {
            for (std::uint32_t x = 0; x < size.x; ++x) {
                for (std::size_t i = 0; i < count; ++i) {
                    const double value = values_of(film.at({x, y}))[first + i];
                    high.pixel(x, y)[i] = static_cast<float>(value);
                    low.pixel(x, y)[i] = static_cast<float>(value - double{high.pixel(x, y)[i]});
                }
            }
        }
        layers.push_back({sum_layer(first, "high"), std::move(high)});
        layers.push_back({sum_layer(first, "low"), std::move(low)});
    }
}

void read_sums(const std::vector<ImageLayer>& layers, const std::string& file, Film& film) {
    const uvec2 size = film.size();
    const auto layer = [&](const std::string& name, std::uint32_t channels) -> const Image& {
        const auto found = std::ranges::find(layers, name, &ImageLayer::name);
        if (found == layers.end() || found->image.channels != channels || found->image.width != size.x || found->image.height != size.y) {
            fail("{}: it lacks the layer '{}' that a reference continues from", file, name);
        }
        return found->image;
    };
    for (std::size_t first = 0; first < pixel_sum_count; first += sums_per_layer) {
        const auto count = static_cast<std::uint32_t>(std::min(sums_per_layer, pixel_sum_count - first));
        const Image &high = layer(sum_layer(first, "high"), count), &low = layer(sum_layer(first, "low"), count);
        for (std::uint32_t y = 0; y < size.y; ++y) {
            for (std::uint32_t x = 0; x < size.x; ++x) {
                for (std::size_t i = 0; i < count; ++i) {
                    const double value = double{high.pixel(x, y)[i]} + double{low.pixel(x, y)[i]};
                    if (!std::isfinite(value)) fail("{}: the sums of pixel {},{} are damaged", file, x, y);
                    values_of(film.at({x, y}))[first + i] = value;
                }
            }
        }
    }
    const Image &albedo = layer("albedo", 3), &normal = layer("normal", 3), &position = layer("position", 3), &depth = layer("depth", 1);
    const auto colour = [](const Image& image, std::uint32_t x, std::uint32_t y) { return vec3(image.pixel(x, y)[0], image.pixel(x, y)[1], image.pixel(x, y)[2]); };
    for (std::uint32_t y = 0; y < size.y; ++y) {
        for (std::uint32_t x = 0; x < size.x; ++x) {
            film.first_surface({x, y}) = {.albedo = colour(albedo, x, y), .normal = colour(normal, x, y), .position = colour(position, x, y), .depth = *depth.pixel(x, y)};
        }
    }
}

std::string note_of(const ReferenceInfo& info, const Film& film) {
    Json blocks = Json::array();
    for (const FilmBlock& b : film.blocks()) blocks.push_back({b.low.x, b.low.y, b.high.x, b.high.y, b.first, b.last});
    const TransportSettings& t = info.transport;
    return Json{{"secondlight_reference", file_version}, {"scene", info.scene}, {"content", fmt::format("{:016x}", info.content)},
                {"size", {info.size.x, info.size.y}}, {"bounces", t.bounces}, {"occlusion", t.occlusion},
                {"reflection", t.reflection == Reflection::full ? "full" : "diffuse"}, {"pixel_area", t.pixel_area}, {"seed", t.seed},
                {"blocks", blocks}}.dump();
}

template <class Number>
Number whole_number(const Json& json, const std::string& file) {
    const double number = json.is_number_integer() ? json.get<double>() : -1e30;
    if (number < std::numeric_limits<Number>::min() || number > std::numeric_limits<Number>::max()) fail("{}: its description is damaged ({:.40} is no such number)", file, json.dump());
    return json.get<Number>();
}

ReferenceInfo info_of(const Json& json, const std::string& file) {
    ReferenceInfo info;
    info.scene = json.at("scene");
    const std::string content = json.at("content");
    std::from_chars(content.data(), content.data() + content.size(), info.content, 16);
    const auto number = [&](const Json& from) { return whole_number<std::uint32_t>(from, file); };
    info.size = {number(json.at("size").at(0)), number(json.at("size").at(1))};
    info.transport = {.bounces = whole_number<int>(json.at("bounces"), file), .occlusion = json.at("occlusion"),
                      .reflection = json.at("reflection") == "full" ? Reflection::full : Reflection::diffuse,
                      .pixel_area = json.at("pixel_area"), .seed = number(json.at("seed"))};
    return info;
}

FilmBlock block_of(const Json& json, uvec2 size, const std::string& file) {
    const auto number = [&](std::size_t i) { return whole_number<std::uint32_t>(json.at(i), file); };
    const FilmBlock block{.low = {number(0), number(1)}, .high = {number(2), number(3)}, .first = number(4), .last = number(5)};
    const bool inside = glm::all(glm::lessThan(block.low, block.high)) && glm::all(glm::lessThanEqual(block.high, size)) && block.first < block.last;
    if (!inside) fail("{}: its description is damaged (there can be no block {:.80})", file, json.dump());
    return block;
}

}  // namespace

void ReferenceInfo::check_same(const ReferenceInfo& a, const std::string& a_name, const ReferenceInfo& b, const std::string& b_name) {
    const auto compare = [&](const char* what, const auto& x, const auto& y) {
        if (x != y) fail("{} and {} are not of one picture: their {} differs", a_name, b_name, what);
    };
    compare("size", a.size, b.size);
    compare("scene (or what was set in it)", a.content, b.content);
    compare("number of bounces", a.transport.bounces, b.transport.bounces);
    compare("occlusion", a.transport.occlusion, b.transport.occlusion);
    compare("kind of reflection", a.transport.reflection, b.transport.reflection);
    compare("pixel filter", a.transport.pixel_area, b.transport.pixel_area);
    compare("seed", a.transport.seed, b.transport.seed);
}

void write_reference(const std::filesystem::path& path, const ReferenceInfo& info, const Film& film) {
    std::vector<ImageLayer> layers = film.layers();
    add_sums(film, layers);
    write_exr(path, layers, note_of(info, film));
}

ReferenceFile read_reference(const std::filesystem::path& path) {
    const std::string file = path.string();
    const std::string note = read_exr_note(path);
    if (note.empty()) fail("{}: it was not written by `secondlight reference`", file);
    const Json json = parse_json(note, file);
    try {
        if (json.at("secondlight_reference") != file_version) fail("{}: it was written by another version of this program", file);
        const ReferenceInfo info = info_of(json, file);
        const std::vector<ImageLayer> layers = read_exr(path);
        if (layers.empty() || uvec2(layers[0].image.width, layers[0].image.height) != info.size) fail("{}: its size is not what it says", file);
        ReferenceFile result{.info = info, .film = Film(info.size)};
        read_sums(layers, file, result.film);
        for (const Json& block : json.at("blocks")) result.film.add_block(block_of(block, info.size, file));
        return result;
    } catch (const Json::exception& error) {
        fail("{}: its description is damaged ({})", file, error.what());
    }
}

}  // namespace sl
