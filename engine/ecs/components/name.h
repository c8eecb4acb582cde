// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "engine/core/fields.h"

namespace sl {

/// What people call an entity in scene files, the editor and --set NAME.component.field=value.
struct Name {
    std::string value;
};

inline void visit_fields(FieldVisitor& visit, Name& name) {
    visit.field("value", name.value, {.help = "What the entity is called; scene files and --set find it by this."});
}

}  // namespace sl
