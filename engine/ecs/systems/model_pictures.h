// SPDX-License-Identifier: MIT
#pragma once

#include <atomic>
#include <map>

#include "engine/core/model/picture.h"
#include "engine/ecs/components/mesh_instance.h"

namespace sl {

/// Bytes that the pictures of one model may take with their mips; where they would take more, they are made smaller.
inline constexpr std::uint64_t most_picture_bytes = std::uint64_t{256} << 20;

/// What the materials of one model read, with layers counted from 0, decoded and of one size.
struct ModelPictures {
    std::vector<std::optional<PictureParams>> materials;  ///< one per material of the model
    TextureLayers colours, data;
    std::vector<std::string> warnings;
};

/// How far the reading of a model has come, told by the threads that read to the one that shows it.
struct ModelProgress {
    std::atomic<std::size_t> pictures{0}, decoded{0};  ///< 0 pictures: the file itself is being read
    std::atomic<bool> unwanted{false};                 ///< set by who does not wait any more: what is left is left out
};

/// Decodes what a model's materials read. A picture that cannot be decoded is white, or flat, and a warning tells. Of any thread.
ModelPictures model_pictures(const Model& model, ModelProgress& progress, std::uint64_t most_bytes = most_picture_bytes);

/// Adds a model's layers to a world's, made as large as the larger of both; returns how far its layers have moved: colours, data.
std::pair<std::uint32_t, std::uint32_t> add_pictures(PictureTable& table, const ModelPictures& pictures);

}  // namespace sl
