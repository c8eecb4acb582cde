// SPDX-License-Identifier: MIT
#include "game/hall/furniture.h"

#include "game/hall/lathe.h"

namespace sl {

namespace {

constexpr double tau = 2.0 * glm::pi<double>();

void add_handle(HallMesh& mesh, double side, const HallDetail& detail) {
    // Both ends are within the wall.
    const TubeWay way{.at = [=](double t) { return dvec3(side * (glm::mix(0.285, 0.115, t) + 0.14 * std::sin(0.5 * tau * t)), glm::mix(0.63, 0.93, t), 0); },
                      .side = [](double) { return dvec3(0, 0, 1); },
                      .radius = 0.022,
                      .length = 0.5};
    add_tube(mesh, way, detail.steps(8, 4), detail.steps(16, 5));
}

}  // namespace

HallMesh baluster(const HallDetail& detail) {
    HallMesh mesh;
    const int around = detail.steps(12, 4), bend = detail.steps(3, 1);
    const double side = 0.08, foot = 0.06, head = baluster_height - foot;
    add_box(mesh, {-side, 0.0, -side}, {side, foot, side});
    add_lathe(mesh,
              {bent({0.045, foot}, {0.08, foot + 0.03}, {0.04, foot + 0.07}, bend), bent({0.04, foot + 0.07}, {0.12, 0.26}, {0.04, 0.46}, bend),
               bent({0.04, 0.46}, {0.03, 0.56}, {0.05, head}, bend)},
              around);
    add_box(mesh, {-side, head, -side}, {side, baluster_height, side});
    return mesh;
}

HallMesh vase(const HallDetail& detail) {
    HallMesh mesh;
    const int around = detail.steps(32, 6), bend = detail.steps(7, 2), small = detail.steps(2, 1);
    const dvec2 shoulder(0.3, 0.62), neck(0.13, 0.92), lip(0.2, 1.1), inner_lip(0.17, 1.1), inner_neck(0.1, 0.92);
    add_lathe(mesh,
              {straight({0.0, 0.0}, {0.16, 0.0}), straight({0.16, 0.0}, {0.16, 0.03}), bent({0.16, 0.03}, {0.1, 0.06}, {0.11, 0.1}, small),
               bent({0.11, 0.1}, {0.28, 0.28}, shoulder, bend),
               bent(shoulder, {0.32, 0.86}, neck, bend), bent(neck, {0.13, 1.04}, lip, small), straight(lip, inner_lip), bent(inner_lip, {0.1, 1.02}, inner_neck, small),
               bent(inner_neck, {0.29, 0.84}, {0.27, 0.62}, bend), bent({0.27, 0.62}, {0.2, 0.2}, {0.0, 0.14}, bend)},
              around);
    for (const double side : {1.0, -1.0}) add_handle(mesh, side, detail);
    return mesh;
}

HallMesh pedestal(const HallDetail& detail) {
    HallMesh mesh;
    const int around = detail.steps(32, 8), bend = detail.steps(5, 1);
    add_box(mesh, {-0.3, 0.0, -0.3}, {0.3, 0.12, 0.3});
    add_lathe(mesh,
              {bent({0.26, 0.12}, {0.3, 0.17}, {0.22, 0.22}, bend), straight({0.22, 0.22}, {0.2, 0.7}), bent({0.2, 0.7}, {0.2, 0.78}, {0.28, 0.8}, bend)}, around);
    add_box(mesh, {-0.3, 0.8, -0.3}, {0.3, pedestal_height, 0.3});
    return mesh;
}

HallMesh knot(const HallDetail& detail) {
    HallMesh mesh;
    constexpr double ring = 0.26, round = 0.12, radius = 0.065, middle = ring + round + radius;
    const auto out = [](double t) { return dvec3(std::cos(2.0 * tau * t), std::sin(2.0 * tau * t), 0); };
    const TubeWay way{.at = [=](double t) { return dvec3(0, middle, 0) + (ring + round * std::cos(3.0 * tau * t)) * out(t) + dvec3(0, 0, round * std::sin(3.0 * tau * t)); },
                      .side = [=](double t) { return std::cos(3.0 * tau * t) * out(t) + dvec3(0, 0, std::sin(3.0 * tau * t)); },
                      .radius = radius,
                      .length = 4.0};
    add_tube(mesh, way, detail.steps(18, 6), detail.steps(120, 30));
    return mesh;
}

}  // namespace sl
