// SPDX-License-Identifier: MIT
#include "engine/core/image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <string_view>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/memory_reader.h"
#include "engine/core/picture_header.h"
#include "engine/core/png.h"
#include "engine/core/text_file.h"

namespace sl {
namespace {

namespace fs = std::filesystem;

constexpr int max_side = 1 << 16;
constexpr std::uint64_t max_pixels = std::uint64_t{1} << 28;
constexpr std::uint64_t max_compression = 100000;  // beyond what any picture reaches: the header lies
constexpr std::uint64_t most_file_bytes = std::uint64_t{1} << 32;
constexpr const char* layer_order = "secondlight:layers";
constexpr const char* note_name = "secondlight:note";

std::string first_line(const std::string& text) {
    return text.substr(0, text.find('\n'));
}

void check_folder(const fs::path& path) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code ignored;
    if (!fs::is_directory(folder, ignored)) {
        fail("{}: cannot be written: there is no folder {}", path.string(), folder.string());
    }
}

std::vector<std::string> channel_names(const ImageLayer& layer) {
    const std::string prefix = layer.name.empty() ? "" : layer.name + ".";
    if (layer.image.channels == 1) return {prefix + "Y"};
    std::vector<std::string> names;
    for (std::uint32_t c = 0; c < layer.image.channels; ++c) names.push_back(prefix + "RGBA"[c]);
    return names;
}

/// A file that is open; its bytes outlive the reader.
struct OpenImage {
    std::unique_ptr<std::string> bytes;
    std::unique_ptr<MemoryReader> reader;
    std::unique_ptr<OIIO::ImageInput> input;
};

/// Of one format: the library, left to itself, would try the parsers of thirty of them on a file from anywhere.
OpenImage open_image(const fs::path& path, PictureCoding coding, const char* shown) {
    std::error_code ignored;
    if (!fs::is_regular_file(path, ignored)) fail("{}: cannot be read: there is no such file", path.string());
    OpenImage open{.bytes = std::make_unique<std::string>(read_text_file(path, most_file_bytes)), .reader = {}, .input = {}};
    const PictureHeader header = picture_header(*open.bytes);
    if (header.coding != coding) fail("{}: it is not {}", path.string(), shown);
    if (!header.fault.empty()) fail("{}: it {}", path.string(), header.fault);
    open.reader = std::make_unique<MemoryReader>(open.bytes->data(), open.bytes->size());
    // The library's newer reader of EXR believes fewer lengths that files tell.
    OIIO::attribute("openexr:core", 1);
    open.input = OIIO::ImageInput::create(picture_coding_name(coding));
    OIIO::ImageSpec config, spec;
    config["oiio:UnassociatedAlpha"] = 1;  // colours as stored, not multiplied by alpha
    if (!open.input || !open.input->set_ioproxy(open.reader.get()) || !open.input->open(path.string(), spec, config)) {
        fail("{}: cannot be read: {}", path.string(), first_line(open.input ? open.input->geterror() : OIIO::geterror()));
    }
    return open;
}

OpenImage open_exr(const fs::path& path) { return open_image(path, PictureCoding::openexr, "an EXR"); }

void check_size(const fs::path& path, const OIIO::ImageSpec& spec) {
    if (spec.width < 1 || spec.height < 1 || spec.depth > 1 || spec.deep || spec.nchannels < 1) {
        fail("{}: it is not a flat two-dimensional image", path.string());
    }
    const auto width = static_cast<std::uint64_t>(spec.width),
               height = static_cast<std::uint64_t>(spec.height);
    const std::uint64_t values = width * height * static_cast<std::uint64_t>(spec.nchannels);
    if (std::max(spec.width, spec.height) > max_side || width * height > max_pixels ||
        values > 4 * max_pixels || values * sizeof(float) > fs::file_size(path) * max_compression) {
        fail("{}: {} x {} pixels of {} channels are too many, or the file is damaged", path.string(),
             spec.width, spec.height, spec.nchannels);
    }
}

/// All channels of one part, as floats, interleaved.
std::vector<float> read_part(const fs::path& path, OIIO::ImageInput& input, int part) {
    const OIIO::ImageSpec& spec = input.spec();
    check_size(path, spec);
    try {
        std::vector<float> pixels(static_cast<std::size_t>(spec.image_pixels()) *
                                  static_cast<std::size_t>(spec.nchannels));
        if (!input.read_image(part, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, pixels.data())) {
            fail("{}: cannot be read: {}", path.string(), first_line(input.geterror()));
        }
        return pixels;
    } catch (const std::bad_alloc&) {
        fail("{}: cannot be read: not enough memory for {} x {} pixels", path.string(), spec.width,
             spec.height);
    }
}

/// Splits the channels of one part into layers by the name before the last dot.
void split_layers(const OIIO::ImageSpec& spec, const std::vector<float>& pixels,
                  std::vector<ImageLayer>& layers) {
    struct Source {
        std::string name;
        std::vector<std::pair<int, int>> channels;  // place in R, G, B, A; index in the file
    };
    std::vector<Source> sources;
    for (int c = 0; c < spec.nchannels; ++c) {
        const std::string& full = spec.channelnames[static_cast<std::size_t>(c)];
        const auto dot = full.rfind('.');
        const std::string name = dot == std::string::npos ? "" : full.substr(0, dot);
        const auto rank =
            std::string_view("RGBA").find(dot == std::string::npos ? full : full.substr(dot + 1));
        auto found =
            std::find_if(sources.begin(), sources.end(), [&](const Source& s) { return s.name == name; });
        if (found == sources.end()) found = sources.insert(sources.end(), {name, {}});
        found->channels.emplace_back(rank == std::string_view::npos ? 4 + c : static_cast<int>(rank), c);
    }
    // OpenEXR keeps channels sorted by name; our own files say how their layers were ordered.
    const std::string order = fmt::format("\n{}\n", std::string(spec.get_string_attribute(layer_order)));
    std::stable_sort(sources.begin(), sources.end(), [&](const Source& a, const Source& b) {
        return order.find("\n" + a.name + "\n") < order.find("\n" + b.name + "\n");
    });
    for (Source& source : sources) {
        std::sort(source.channels.begin(), source.channels.end());
        Image image(static_cast<std::uint32_t>(spec.width), static_cast<std::uint32_t>(spec.height),
                    static_cast<std::uint32_t>(source.channels.size()));
        auto out = image.data.begin();
        for (std::size_t base = 0; base < pixels.size(); base += static_cast<std::size_t>(spec.nchannels)) {
            for (const auto& channel : source.channels)
                *out++ = pixels[base + static_cast<std::size_t>(channel.second)];
        }
        layers.push_back({source.name, std::move(image)});
    }
}

}  // namespace

void write_exr(const fs::path& path, const std::vector<ImageLayer>& layers, const std::string& note) {
    CHECK(!layers.empty(), "an EXR without layers");
    check_folder(path);
    const Image& first = layers.front().image;
    OIIO::ImageSpec spec(static_cast<int>(first.width), static_cast<int>(first.height), 0,
                         OIIO::TypeDesc::FLOAT);
    std::string order;
    for (const ImageLayer& layer : layers) {
        const Image& image = layer.image;
        CHECK(
            image.width == first.width && image.height == first.height && image.width > 0 && image.height > 0,
            "layer \"{}\" is {} x {}", layer.name, image.width, image.height);
        CHECK(image.channels >= 1 && image.channels <= 4, "layer \"{}\" has {} channels", layer.name,
              image.channels);
        for (std::string& name : channel_names(layer)) spec.channelnames.push_back(std::move(name));
        order += (&layer == &layers.front() ? "" : "\n") + layer.name;
    }
    spec.nchannels = static_cast<int>(spec.channelnames.size());
    spec.attribute("compression", "zip");
    spec.attribute("DateTime",
                   "1970:01:01 00:00:00");  // else the library writes now: equal pictures, unequal files
    spec.attribute(layer_order, order);
    if (!note.empty()) spec.attribute(note_name, note);

    std::vector<float> pixels;
    pixels.reserve(std::size_t{first.width} * first.height * spec.channelnames.size());
    for (std::size_t p = 0; p < std::size_t{first.width} * first.height; ++p) {
        for (const ImageLayer& layer : layers) {
            const auto begin =
                layer.image.data.begin() + static_cast<std::ptrdiff_t>(p * layer.image.channels);
            pixels.insert(pixels.end(), begin, begin + layer.image.channels);
        }
    }
    // Encoded in memory, and then the file is replaced: the library does not notice a disk that is full.
    OIIO::Filesystem::IOVecOutput memory;
    const auto output = OIIO::ImageOutput::create("exr");
    if (!output || !output->set_ioproxy(&memory) || !output->open(path.filename().string(), spec) ||
        !output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) || !output->close()) {
        fail("{}: cannot be written: {}", path.string(),
             first_line(output ? output->geterror() : OIIO::geterror()));
    }
    const auto& bytes = memory.buffer();
    write_text_file(path, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

std::vector<ImageLayer> read_exr(const fs::path& path) {
    const OpenImage open = open_exr(path);
    std::vector<ImageLayer> layers;
    for (int part = 0; open.input->seek_subimage(part, 0); ++part) {
        split_layers(open.input->spec(), read_part(path, *open.input, part), layers);
    }
    return layers;
}

std::string read_exr_note(const fs::path& path) { return std::string(open_exr(path).input->spec().get_string_attribute(note_name)); }

void write_png(const fs::path& path, const Image& image) {
    check_folder(path);
    write_text_file(path, png_bytes(image));
}

Image read_png(const fs::path& path) {
    const OpenImage open = open_image(path, PictureCoding::png, "a PNG");
    const OIIO::ImageSpec& spec = open.input->spec();
    std::vector<float> pixels = read_part(path, *open.input, 0);
    Image image;
    image.width = static_cast<std::uint32_t>(spec.width);
    image.height = static_cast<std::uint32_t>(spec.height);
    image.channels = static_cast<std::uint32_t>(spec.nchannels);
    image.data = std::move(pixels);
    return image;
}

Image side_by_side(const std::vector<Image>& images, std::uint32_t gap) {
    CHECK(!images.empty(), "no pictures to place");
    const Image& first = images.front();
    std::uint32_t width = gap * static_cast<std::uint32_t>(images.size() - 1);
    for (const Image& image : images) {
        CHECK(image.height == first.height && image.channels == first.channels,
              "pictures side by side differ in height or channels: {} x {} and {} x {}", first.height,
              first.channels, image.height, image.channels);
        width += image.width;
    }
    Image result(width, first.height, first.channels);
    std::fill(result.data.begin(), result.data.end(), 1.0f);
    std::uint32_t left = 0;
    for (const Image& image : images) {
        for (std::uint32_t y = 0; y < image.height; ++y) {
            std::copy_n(image.pixel(0, y), std::size_t{image.width} * image.channels, result.pixel(left, y));
        }
        left += image.width + gap;
    }
    return result;
}

}  // namespace sl
