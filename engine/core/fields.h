// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/math.h"

namespace sl {

/// How a person should see a field. A text that is a `file` names one: in full, or beside the scene file.
enum class FieldLook { plain, colour, angle, direction, logarithmic, file };

/// What is known about a field besides its value. Range, unit and help are written here once; panel, scene file,
/// command line, bench sweep and docs read them.
struct FieldInfo {
    double min = std::numeric_limits<double>::lowest();
    double max = std::numeric_limits<double>::max();
    std::string_view unit = "";
    std::string_view help = "";  ///< one sentence: what it does, what more and less of it do, what it costs
    FieldLook look = FieldLook::plain;
};

/// Reads, writes or shows the fields of a component. Beside each component stands
///     void visit_fields(FieldVisitor& visit, Component& component)
/// with one line per field. A visitor that writes a field keeps it inside its range.
class FieldVisitor {
  public:
    virtual ~FieldVisitor() = default;

    /// One field of the component, by the name that files and people use. It may be read, written or left alone.
    virtual void field(std::string_view name, bool& value, const FieldInfo& info) = 0;
    virtual void field(std::string_view name, std::int32_t& value, const FieldInfo& info) = 0;
    virtual void field(std::string_view name, std::uint32_t& value, const FieldInfo& info) = 0;
    virtual void field(std::string_view name, float& value, const FieldInfo& info) = 0;
    virtual void field(std::string_view name, double& value, const FieldInfo& info) = 0;
    virtual void field(std::string_view name, vec2& value, const FieldInfo& info) = 0;
    virtual void field(std::string_view name, vec3& value, const FieldInfo& info) = 0;
    virtual void field(std::string_view name, dvec3& value, const FieldInfo& info) = 0;
    virtual void field(std::string_view name, quat& value, const FieldInfo& info) = 0;
    virtual void field(std::string_view name, std::string& value, const FieldInfo& info) = 0;
    /// One of `names`, by index: enumerations, presets and the alternatives of a variant.
    virtual void choice(std::string_view name, std::size_t& index, std::span<const std::string_view> names,
                        const FieldInfo& info) = 0;

    /// An enumeration whose values count from 0 in the order of `names`.
    template <class Enum>
    void enumeration(std::string_view name, Enum& value, std::span<const std::string_view> names,
                     const FieldInfo& info) {
        auto index = static_cast<std::size_t>(value);
        choice(name, index, names, info);
        value = static_cast<Enum>(index);
    }
};

}  // namespace sl
