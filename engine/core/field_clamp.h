// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/fields.h"

namespace sl {

/// Moves every field to the nearest value inside its range, makes numbers finite and rotations of length 1.
/// For after edits and sweeps.
class FieldClamp final : public FieldVisitor {
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
};

/// Brings every field of a component into its range.
template <class Component>
void clamp_fields(Component& component) {
    FieldClamp clamp;
    visit_fields(clamp, component);
}

/// The rotation made of length 1; the identity where that cannot be.
quat nearest_rotation(quat rotation);

}  // namespace sl
