// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/ecs/component_registry.h"

namespace sl {

/// How the names of files change when what names them moves to another folder.
class MovedReferences {
  public:
    /// Empty folders are the current one.
    MovedReferences(const std::filesystem::path& from, const std::filesystem::path& to);

    /// A name relative to `from` becomes one relative to `to` of the same file. Full paths and empty names stay, and so
    /// do all where both are one folder.
    std::string moved(const std::string& name) const;

    /// Moves the fields of a component's JSON that name files, FieldLook::file.
    template <class Json>
    void move_in(const ComponentType& type, Json& component) const {
        for (const std::string& field : fields_to_move(type)) {
            const auto found = component.find(field);
            if (found != component.end() && found->is_string()) *found = moved(found->template get<std::string>());
        }
    }

  private:
    std::vector<std::string> fields_to_move(const ComponentType& type) const;

    std::filesystem::path from_, to_;
};

}  // namespace sl
