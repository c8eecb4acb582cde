// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/core/fields.h"

namespace sl {

/// Shows a glTF model at its entity: nodes, meshes, materials, lights and cameras become entities below it.
struct ModelFile {
    std::string file;
    std::int32_t scene = -1;

    bool operator==(const ModelFile&) const = default;
};

inline void visit_fields(FieldVisitor& visit, ModelFile& model) {
    visit.field("file", model.file, {.help = "A .gltf or .glb file; where it is no full path, beside the scene file."});
    visit.field("scene", model.scene, {.min = -1, .max = 1e6, .help = "Which of the file's scenes; -1 is the one that the file calls its own."});
}

}  // namespace sl
