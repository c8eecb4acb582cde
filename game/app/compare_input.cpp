// SPDX-License-Identifier: MIT
#include <algorithm>

#include "engine/core/error.h"
#include "engine/measure/flip_colour.h"
#include "engine/render/reference/film.h"
#include "game/app/compare.h"

namespace sl {

namespace {

namespace fs = std::filesystem;

bool is_exr(const fs::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension == ".exr";
}

std::string shown(const std::string& layer) {
    return layer.empty() ? "'' (the unnamed one)" : layer;
}

const Image* find_layer(const std::vector<ImageLayer>& layers, const std::string& name) {
    const auto found = std::ranges::find(layers, name, &ImageLayer::name);
    return found == layers.end() ? nullptr : &found->image;
}

const Image& layer_of(const fs::path& path, const std::vector<ImageLayer>& layers, const std::string& name) {
    if (const Image* image = find_layer(layers, name)) return *image;
    std::string there;
    for (const ImageLayer& layer : layers) there += (there.empty() ? "" : ", ") + shown(layer.name);
    fail("{}: there is no layer {}; choose with --layer or --reference-layer from: {}", path.string(), shown(name),
         there);
}

/// Grey becomes three equal channels; alpha is dropped.
Image three_channels(const std::string& name, const Image& image) {
    if (image.channels == 2) fail("{}: two channels are no colour; compare layers of 1, 3 or 4 channels", name);
    Image result(image.width, image.height, 3);
    for (std::size_t i = 0; i < std::size_t{image.width} * image.height; ++i) {
        for (std::size_t c = 0; c < 3; ++c)
            result.data[i * 3 + c] = image.data[i * image.channels + (image.channels >= 3 ? c : 0)];
    }
    return result;
}

Image decoded_picture(const fs::path& path) {
    Image image = read_png(path);
    // Grey with alpha: grey.
    if (image.channels == 2) {
        for (std::size_t i = 0; i < image.data.size() / 2; ++i) image.data[i] = image.data[2 * i];
        image.data.resize(image.data.size() / 2);
        image.channels = 1;
    }
    Image result = three_channels(path.string(), image);
    for (std::size_t i = 0; i < result.data.size(); i += 3) {
        const vec3 linear = linear_from_srgb({result.data[i], result.data[i + 1], result.data[i + 2]});
        for (int c = 0; c < 3; ++c) result.data[i + static_cast<std::size_t>(c)] = linear[c];
    }
    return result;
}

/// Reversed depth is 0 where nothing was hit. Of two files that have it, the reference decides.
void mask_background(ImagePair& pair, const Image* depth, const Image* reference_depth) {
    const Image* decides = reference_depth != nullptr ? reference_depth : depth;
    if (decides == nullptr) return;
    for (std::size_t i = 0; i < decides->data.size(); i += decides->channels)
        pair.mask.push_back(decides->data[i] == 0.0f ? 0.0f : 1.0f);
    if (depth == nullptr || depth == decides || depth->width != decides->width || depth->height != decides->height)
        return;
    for (std::size_t i = 0; i < pair.mask.size(); ++i) {
        if ((depth->data[i * depth->channels] == 0.0f) != (pair.mask[i] == 0.0f)) ++pair.background_differs;
    }
}

void check_same_size(const ImagePair& pair) {
    if (pair.image.width == pair.reference.width && pair.image.height == pair.reference.height) return;
    fail("{} has {} x {} pixels and {} has {} x {}; only images of one size can be compared", pair.image_name,
         pair.image.width, pair.image.height, pair.reference_name, pair.reference.width, pair.reference.height);
}

void load_layers(ImagePair& pair, const CompareFlags& flags) {
    const std::vector<ImageLayer> layers = read_exr(flags.image), reference_layers = read_exr(flags.reference);
    const bool both = find_layer(layers, "irradiance") != nullptr &&
                      (flags.reference_layer.has_value() || find_layer(reference_layers, "irradiance") != nullptr);
    pair.layer = flags.layer.value_or(both ? "irradiance" : "");
    const std::string reference_layer = flags.reference_layer.value_or(pair.layer);
    pair.image_name = fmt::format("{}, layer {}", flags.image.string(), shown(pair.layer));
    pair.reference_name = fmt::format("{}, layer {}", flags.reference.string(), shown(reference_layer));
    pair.image = three_channels(pair.image_name, layer_of(flags.image, layers, pair.layer));
    pair.reference = three_channels(pair.reference_name, layer_of(flags.reference, reference_layers, reference_layer));
    check_same_size(pair);
    if (!flags.no_mask) mask_background(pair, find_layer(layers, "depth"), find_layer(reference_layers, "depth"));
    const Image* half = reference_layer == "irradiance" ? find_layer(reference_layers, "irradiance_half") : nullptr;
    if (half != nullptr && half->data.size() == pair.reference.data.size()) {
        pair.reference_noise = noise_of_halves(pair.reference, *half, pair.mask);
    }
}

void load_pictures(ImagePair& pair, const CompareFlags& flags) {
    if (flags.layer || flags.reference_layer)
        fail("--layer and --reference-layer are for EXR files; {} has no layers", flags.image.string());
    if (flags.ev100) fail("--ev100 is for EXR files; the picture {} is already exposed", flags.image.string());
    pair.image_name = flags.image.string();
    pair.reference_name = flags.reference.string();
    pair.decoded = true;
    pair.image = decoded_picture(flags.image);
    pair.reference = decoded_picture(flags.reference);
    check_same_size(pair);
}

}  // namespace

ImagePair load_pair(const CompareFlags& flags) {
    if (is_exr(flags.image) != is_exr(flags.reference)) {
        fail(
            "{} and {}: compare two EXR files or two PNG files; a tonemapped picture says too little about linear "
            "light",
            flags.image.string(), flags.reference.string());
    }
    ImagePair pair;
    if (is_exr(flags.image))
        load_layers(pair, flags);
    else
        load_pictures(pair, flags);
    check_finite(pair.image_name, pair.image, pair.mask);
    check_finite(pair.reference_name, pair.reference, pair.mask);
    return pair;
}

}  // namespace sl
