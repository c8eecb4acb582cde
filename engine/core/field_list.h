// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "engine/core/fields.h"

namespace sl {

/// What people are told about one field.
struct FieldRow {
    std::string name;
    std::string type;   ///< bool, int, float, vec3, rotation, text, file, choice …
    std::string value;  ///< as FieldSetter reads it
    double min = 0.0;   ///< both 0 for fields without numbers
    double max = 0.0;
    std::string range;  ///< "0 to 10", "at least 0", "off, rsm_disc", or nothing
    std::string unit;
    std::string help;
    std::vector<std::string> choices;
};

/// Collects a row per field.
class FieldLister final : public FieldVisitor {
  public:
    std::vector<FieldRow> rows;

    void field(std::string_view name, bool& value, const FieldInfo& info) override;
    void field(std::string_view name, std::int32_t& value, const FieldInfo& info) override;
    void field(std::string_view name, std::uint32_t& value, const FieldInfo& info) override;
    void field(std::string_view name, float& value, const FieldInfo& info) override;
    void field(std::string_view name, double& value, const FieldInfo& info) override;
    void field(std::string_view name, vec2& value, const FieldInfo& info) override;
    void field(std::string_view name, vec3& value, const FieldInfo& info) override;
    void field(std::string_view name, dvec3& value, const FieldInfo& info) override;
    void field(std::string_view name, quat& value, const FieldInfo& info) override;
    void field(std::string_view name, std::string& value, const FieldInfo& info) override;
    void choice(std::string_view name, std::size_t& index, std::span<const std::string_view> names,
                const FieldInfo& info) override;

  private:
    template <class T>
    void add_number(std::string_view name, std::string_view type, std::string value, const FieldInfo& info);
};

/// The rows for a component with the values that it has.
template <class Component>
std::vector<FieldRow> list_fields(Component component) {
    FieldLister lister;
    visit_fields(lister, component);
    return std::move(lister.rows);
}

/// Markdown table: field, value, range, unit, help.
std::string markdown_table(std::span<const FieldRow> rows);

}  // namespace sl
