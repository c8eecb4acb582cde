// SPDX-License-Identifier: MIT
#include "editor/light_gizmos.h"

#include "editor/projection.h"
#include "engine/ecs/active_camera.h"
#include "engine/ecs/components.h"

namespace sl {

namespace {

constexpr ImU32 strong = IM_COL32(255, 215, 90, 230), faint = IM_COL32(255, 215, 90, 120);
/// For lights that reach without end, m.
constexpr double shown_reach = 2.0, shown_radius = 0.25;
/// How far before the camera the arrows of sunlight are, and how long, m.
constexpr double sun_distance = 4.0, sun_length = 1.5;
constexpr int circle_sides = 48;

/// A place to draw at: the light looks along -z, and its space has no scale.
struct Frame {
    dvec3 origin, x, y, z;

    explicit Frame(const WorldTransform& place)
        : origin(place.origin), x(axis(place, 0)), y(axis(place, 1)), z(axis(place, 2)) {}

    /// One without length stays where it would be without rotation.
    static dvec3 axis(const WorldTransform& place, int number) {
        const dvec3 scaled(place.linear[number]);
        const double length = glm::length(scaled);
        return length > 0.0 ? scaled / length : dvec3(glm::dmat3(1.0)[number]);
    }
};

class Pen {
  public:
    Pen(const Projection& project, float scale) : project_(project), width_(1.5f * scale) {}

    void line(const dvec3& from, const dvec3& to, ImU32 colour) const { project_.line(from, to, colour, width_); }
    /// Round `centre`, in the plane of two unit vectors.
    void circle(const dvec3& centre, const dvec3& u, const dvec3& v, double radius, ImU32 colour) const {
        const auto at = [&](int side) {
            const double angle = 2.0 * glm::pi<double>() * side / circle_sides;
            return centre + radius * (std::cos(angle) * u + std::sin(angle) * v);
        };
        for (int side = 0; side < circle_sides; ++side) line(at(side), at(side + 1), colour);
    }
    void arrow(const dvec3& from, const dvec3& to, const dvec3& aside, ImU32 colour) const {
        line(from, to, colour);
        const dvec3 back = 0.2 * (from - to);
        for (const double side : {-0.1, 0.1}) {
            line(to, to + back + side * glm::length(to - from) * aside, colour);
        }
    }

  private:
    const Projection& project_;
    float width_;
};

void draw_cone(const Pen& pen, const Frame& at, double angle, double reach, ImU32 colour) {
    const dvec3 centre = at.origin - at.z * (reach * std::cos(angle));
    const double radius = reach * std::sin(angle);
    pen.circle(centre, at.x, at.y, radius, colour);
    for (const dvec3& side : {at.x, -at.x, at.y, -at.y}) pen.line(at.origin, centre + radius * side, colour);
}

void draw_spot(const Pen& pen, const Frame& at, const SpotLight& light) {
    const double reach = light.range > 0.0f ? double{light.range} : shown_reach;
    draw_cone(pen, at, light.outer_cone, reach, strong);
    draw_cone(pen, at, std::min(light.inner_cone, light.outer_cone), reach, faint);
    pen.line(at.origin, at.origin - at.z * reach, faint);
}

void draw_point(const Pen& pen, const Frame& at, const PointLight& light) {
    const double radius = light.range > 0.0f ? double{light.range} : shown_radius;
    pen.circle(at.origin, at.x, at.y, radius, strong);
    pen.circle(at.origin, at.y, at.z, radius, strong);
    pen.circle(at.origin, at.z, at.x, radius, strong);
}

void draw_sunlight(const Pen& pen, const Frame& at, const Frame& eye) {
    const dvec3 centre = eye.origin - eye.z * sun_distance;
    for (const double aside : {-0.5, 0.0, 0.5}) {
        const dvec3 middle = centre + aside * at.x;
        pen.arrow(middle + 0.5 * sun_length * at.z, middle - 0.5 * sun_length * at.z, at.x, strong);
    }
}

}  // namespace

void draw_light_gizmos(World& world, Entity entity, float scale) {
    const Entity camera = active_camera(world);
    const auto* eye = camera ? world.find<WorldTransform>(camera) : nullptr;
    const auto* place = world.find<WorldTransform>(entity);
    if (eye == nullptr || place == nullptr) return;
    const Projection project(world.get<Camera>(camera), *eye);
    const Pen pen(project, scale);
    const Frame at(*place);
    if (const auto* light = world.find<SpotLight>(entity)) draw_spot(pen, at, *light);
    if (const auto* light = world.find<PointLight>(entity)) draw_point(pen, at, *light);
    if (world.has<DirectionalLight>(entity)) draw_sunlight(pen, at, Frame(*eye));
}

}  // namespace sl
