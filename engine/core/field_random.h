// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/fields.h"

namespace sl {

/// Gives every field except texts a random value inside its range, for tests: logarithmically spread where
/// the field is looked at so, evenly elsewhere, and now and then exactly a limit. A side without limit ends
/// at 1000. The same seed gives the same values on every machine.
class RandomFields final : public FieldVisitor {
  public:
    explicit RandomFields(std::uint64_t seed) : seed_(seed) {}

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

    /// Evenly in [0, 1).
    double uniform();

  private:
    double inside(const FieldInfo& info);
    template <class Number>
    Number number(FieldInfo info);

    std::uint64_t seed_;
    std::uint64_t count_ = 0;
};

}  // namespace sl
