// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/core/fields.h"

namespace sl {

/// Shows a glTF or MagicaVoxel model at its entity: nodes, meshes, materials, lights and cameras become entities below it.
struct ModelFile {
    std::string file;
    std::int32_t scene = -1;
    std::int32_t animation = 0;
    float speed = 1.0f;

    bool operator==(const ModelFile&) const = default;
};

inline void visit_fields(FieldVisitor& visit, ModelFile& model) {
    visit.field("file", model.file, {.help = "A .gltf, .glb or .vox file; where it is no full path, beside the scene file.", .look = FieldLook::file});
    visit.field("scene", model.scene, {.min = -1, .max = 1e6, .help = "Which of the file's scenes; -1 is the one that the file calls its own."});
    visit.field("animation", model.animation, {.min = -1, .max = 1e6, .help = "Which of the file's animations plays, over and over; -1 is none. A surface that moves has light gathered anew."});
    visit.field("speed", model.speed, {.min = 0, .max = 100, .help = "How fast it plays; 0 stands still."});
}

}  // namespace sl
