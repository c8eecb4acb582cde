// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "engine/core/fields.h"

namespace sl {

/// Sets fields from what people wrote; a source (JSON, the command line) derives from it. A field that the
/// source does not hold keeps its value. A wrong type, a number that is not finite or outside the range and
/// an unknown choice are Errors that name the place; nothing is clamped.
class FieldReader : public FieldVisitor {
  public:
    void field(std::string_view name, bool& value, const FieldInfo& info) final;
    void field(std::string_view name, std::int32_t& value, const FieldInfo& info) final;
    void field(std::string_view name, std::uint32_t& value, const FieldInfo& info) final;
    void field(std::string_view name, float& value, const FieldInfo& info) final;
    void field(std::string_view name, double& value, const FieldInfo& info) final;
    void field(std::string_view name, vec2& value, const FieldInfo& info) final;
    void field(std::string_view name, vec3& value, const FieldInfo& info) final;
    void field(std::string_view name, dvec3& value, const FieldInfo& info) final;
    void field(std::string_view name, quat& value, const FieldInfo& info) final;
    void field(std::string_view name, std::string& value, const FieldInfo& info) final;
    void choice(std::string_view name, std::size_t& index, std::span<const std::string_view> names,
                const FieldInfo& info) final;

  protected:
    /// Whether the source holds the field. Asked once per field; only then one of the three below is called.
    virtual bool has(std::string_view name) = 0;
    virtual bool read_bool(std::string_view name) = 0;
    /// Fills all of `numbers` (1 for plain numbers) or throws Error.
    virtual void read_numbers(std::string_view name, std::span<double> numbers, const FieldInfo& info) = 0;
    virtual std::string read_text(std::string_view name) = 0;
    /// The field for a message: "village.json: /entities/3/camera/near".
    virtual std::string place(std::string_view name) const = 0;

  private:
    template <class T>
    T checked(std::string_view name, double number, const FieldInfo& info) const;
    template <class Vector>
    void read_vector(std::string_view name, Vector& value, const FieldInfo& info);
};

/// A rotation of length 1 from four numbers x, y, z, w; those that already are of length 1 come back as they
/// are. Nothing where they have no length or are not finite.
std::optional<quat> unit_rotation(std::span<const double, 4> numbers);

}  // namespace sl
