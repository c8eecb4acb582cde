// SPDX-License-Identifier: MIT
#pragma once

#include <array>

#include "engine/core/fields.h"

namespace sl {

/// A simple solid, made into a mesh by the system build_shapes.
struct Shape {
    enum class Kind { box, quad, disc, sphere, octahedron };
    Kind kind = Kind::box;
    vec3 size{1.0f};
};

inline constexpr std::array<std::string_view, 5> shape_kind_names{"box", "quad", "disc", "sphere", "octahedron"};

inline void visit_fields(FieldVisitor& visit, Shape& shape) {
    visit.enumeration("kind", shape.kind, shape_kind_names,
                      {.help = "box, sphere and octahedron are centred; quad and disc lie in the local xz plane and face +y, one-sided."});
    visit.field("size", shape.size, {.min = 0, .max = 1e6, .unit = "m", .help = "Full extent per axis; discs and spheres fill it."});
}

}  // namespace sl
