// SPDX-License-Identifier: MIT
#include "engine/core/field_clamp.h"

#include <array>

#include "engine/core/field_range.h"
#include "engine/core/field_reader.h"

namespace sl {

namespace {

template <class Vector>
void clamp_vector(Vector& value, const FieldInfo& info) {
    for (int axis = 0; axis < Vector::length(); ++axis) value[axis] = clamped_to_range(value[axis], info);
}

}  // namespace

quat nearest_rotation(quat rotation) {
    const std::array<double, 4> numbers{rotation.x, rotation.y, rotation.z, rotation.w};
    return unit_rotation(numbers).value_or(quat(1, 0, 0, 0));
}

void FieldClamp::field(std::string_view, bool&, const FieldInfo&) {}
void FieldClamp::field(std::string_view, std::int32_t& value, const FieldInfo& info) {
    value = clamped_to_range(value, info);
}
void FieldClamp::field(std::string_view, std::uint32_t& value, const FieldInfo& info) {
    value = clamped_to_range(value, info);
}
void FieldClamp::field(std::string_view, float& value, const FieldInfo& info) {
    value = clamped_to_range(value, info);
}
void FieldClamp::field(std::string_view, double& value, const FieldInfo& info) {
    value = clamped_to_range(value, info);
}
void FieldClamp::field(std::string_view, vec2& value, const FieldInfo& info) {
    clamp_vector(value, info);
}
void FieldClamp::field(std::string_view, vec3& value, const FieldInfo& info) {
    clamp_vector(value, info);
}
void FieldClamp::field(std::string_view, dvec3& value, const FieldInfo& info) {
    clamp_vector(value, info);
}
void FieldClamp::field(std::string_view, quat& value, const FieldInfo&) {
    value = nearest_rotation(value);
}
void FieldClamp::field(std::string_view, std::string&, const FieldInfo&) {}
void FieldClamp::choice(std::string_view, std::size_t& index, std::span<const std::string_view> names,
                        const FieldInfo&) {
    index = std::min(index, names.size() - 1);
}

}  // namespace sl
