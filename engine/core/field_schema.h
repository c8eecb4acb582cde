// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/core/fields.h"

namespace sl {

/// Describes each field by a JSON Schema (draft 2020-12) of what JsonReader takes and JsonWriter writes: type, range, choices,
/// the value that it has as the default, help and unit.
class FieldSchema final : public FieldVisitor {
  public:
    /// Replaces the value of `properties`, which must live as long as the visitor, by an object with a schema per field.
    /// Where fields depend on a choice, `choice` is first set to `alternative`, and nothing else is allowed for it.
    explicit FieldSchema(nlohmann::ordered_json& properties, std::string_view choice = {}, std::size_t alternative = 0);

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
    void add(std::string_view name, T& value, const FieldInfo& info, nlohmann::ordered_json schema);

    nlohmann::ordered_json& properties_;
    std::string_view choice_;
    std::size_t alternative_;
};

}  // namespace sl
