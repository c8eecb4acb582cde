// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/core/field_reader.h"

namespace sl {

/// Sets one field by name from a text as written on the command line: 0.3, true, rsm_disc, "1,0.5,0.2" for
/// vectors, "x,y,z,w" for rotations; an angle in radians, or in degrees as 30deg.
class FieldSetter final : public FieldReader {
  public:
    /// `where` begins messages: "gi" gives "gi.strength: …".
    FieldSetter(std::string_view where, std::string_view name, std::string_view text)
        : where_(where), name_(name), text_(text) {}

    /// Throws Error that lists the visited fields where none of them had the name.
    void check_found() const;

  protected:
    bool has(std::string_view name) override;
    bool read_bool(std::string_view name) override;
    void read_numbers(std::string_view name, std::span<double> numbers, const FieldInfo& info) override;
    std::string read_text(std::string_view name) override;
    std::string place(std::string_view name) const override;

  private:
    std::string where_, name_, text_;
    std::vector<std::string> known_;
    bool found_ = false;
};

/// Sets one field of a component; see FieldSetter. Throws Error.
template <class Component>
void set_field(Component& component, std::string_view where, std::string_view name, std::string_view text) {
    FieldSetter setter(where, name, text);
    visit_fields(setter, component);
    setter.check_found();
}

}  // namespace sl
