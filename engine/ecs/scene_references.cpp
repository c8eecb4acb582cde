// SPDX-License-Identifier: MIT
#include "engine/ecs/scene_references.h"

#include "engine/core/field_list.h"

namespace sl {

namespace fs = std::filesystem;

namespace {

/// Without links, so that ".." can be counted. It need not exist.
fs::path real_folder(const fs::path& folder) {
    std::error_code error;
    const fs::path absolute = fs::absolute(folder.empty() ? "." : folder);
    const fs::path real = fs::weakly_canonical(absolute, error);
    return error ? absolute.lexically_normal() : real;
}

}  // namespace

MovedReferences::MovedReferences(const fs::path& from, const fs::path& to) {
    if (from == to) return;  // as for each entity of a scene without includes
    from_ = real_folder(from);
    to_ = real_folder(to);
}

std::string MovedReferences::moved(const std::string& name) const {
    const fs::path file(name);
    if (name.empty() || file.is_absolute() || from_ == to_) return name;
    return (real_folder((from_ / file).parent_path()) / file.filename()).lexically_relative(to_).generic_string();
}

std::vector<std::string> MovedReferences::fields_to_move(const ComponentType& type) const {
    if (from_ == to_) return {};
    FieldLister lister;
    type.visit_default(lister);
    std::vector<std::string> fields;
    for (FieldRow& row : lister.rows) {
        if (row.type == "file") fields.push_back(std::move(row.name));
    }
    return fields;
}

}  // namespace sl
