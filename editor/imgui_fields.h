// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/fields.h"

namespace sl {

/// Draws one row per field, name and unit on the left and a widget on the right, between begin and end of a
/// table of two columns (see FieldTable). Values change only by what people do; clamp them afterwards with
/// FieldClamp where changed() says so.
class ImguiFields final : public FieldVisitor {
  public:
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

    bool changed() const { return !changed_field_.empty(); }
    /// The name of the field that a person changed; empty where nobody did.
    const std::string& changed_field() const { return changed_field_; }
    std::size_t rows() const { return rows_; }

  private:
    void note(std::string_view name, bool changed) {
        if (changed) changed_field_ = name;
        ++rows_;
    }

    std::string changed_field_;
    std::size_t rows_ = 0;
};

/// The table that ImguiFields draws into: from construction to destruction.
class FieldTable {
  public:
    explicit FieldTable(const char* id);
    ~FieldTable();
    FieldTable(const FieldTable&) = delete;
    FieldTable& operator=(const FieldTable&) = delete;
    /// False: it is out of sight, and nothing may be drawn into it.
    explicit operator bool() const { return open_; }

  private:
    bool open_;
};

}  // namespace sl
