// SPDX-License-Identifier: MIT
#include "game/app/picture_file.h"

#include "engine/render/image_layers.h"

namespace sl {

namespace {

std::filesystem::path free_path(const char* extension) {
    const std::filesystem::path folder = "out";
    std::filesystem::create_directories(folder);
    for (int number = 1;; ++number) {
        auto path = folder / fmt::format("play_{:04}{}", number, extension);
        if (!std::filesystem::exists(path)) return path;
    }
}

}  // namespace

std::filesystem::path save_frame(const Renderer& renderer, const FrameOutput& images, PictureFormat format) {
    if (format == PictureFormat::exr) {
        const auto path = free_path(".exr");
        write_exr(path, linear_layers(renderer, images));
        return path;
    }
    const auto path = free_path(".png");
    write_png(path, without_alpha(renderer.read(images.final)));
    return path;
}

}  // namespace sl
