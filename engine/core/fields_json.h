// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "engine/core/field_reader.h"

namespace sl {

/// Sets fields from the keys of a JSON object: numbers, booleans and strings; vectors as arrays, rotations as
/// [x, y, z, w], choices by name. Absent keys leave their fields alone.
class JsonReader final : public FieldReader {
  public:
    /// `where` is the file and the object's JSON pointer, "village.json: /entities/3/camera"; messages begin
    /// with it. Throws Error unless `object` is an object. It must live as long as the reader.
    JsonReader(const nlohmann::json& object, std::string where);

    /// Throws Error where the object has a key that no visited field has, naming the nearest one.
    void check_all_used() const;

  protected:
    bool has(std::string_view name) override;
    bool read_bool(std::string_view name) override;
    void read_numbers(std::string_view name, std::span<double> numbers, const FieldInfo& info) override;
    std::string read_text(std::string_view name) override;
    std::string place(std::string_view name) const override;

  private:
    const nlohmann::json& object_;
    std::string where_;
    std::vector<std::string> known_;
};

/// Writes every field as JsonReader reads it, in the order of the visit. A float is written with the fewest
/// digits that read back to the same bits. What JsonReader would refuse (out of range, not finite) is written
/// as the nearest value that it accepts: a saved file can always be loaded.
class JsonWriter final : public FieldVisitor {
  public:
    /// Replaces the value of `object`, which must live as long as the writer.
    explicit JsonWriter(nlohmann::ordered_json& object);

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
    nlohmann::ordered_json& object_;
};

/// The double with the fewest decimal digits that rounds to this float: 0.3 rather than 0.30000001192092896.
double shortest_double(float value);

}  // namespace sl
