// SPDX-License-Identifier: MIT
#include "game/hall/arch.h"

namespace sl {

namespace {

constexpr double band_width = 0.16, band_height = 0.06;  // m, of the moulding round the opening

/// One side of the wall, towards +z where `side` is 1; -1 turns it by half.
class ArchFace {
  public:
    ArchFace(HallMesh& mesh, const ArchShape& shape, double side, int round) : mesh_(mesh), shape_(shape), side_(side), round_(round), depth_(0.5 * shape.thickness) {}

    void add() {
        const double half = 0.5 * shape_.width, r = shape_.radius;
        for (const double left : {-half, r}) {
            add_rectangle(mesh_, place(left, 0.0, depth_), dvec3(side_ * (half - r), 0, 0), dvec3(0, shape_.height, 0));
        }
        // Straight up from the opening to the top.
        add_surface(mesh_, {.across = round_, .size = {2.0 * r, shape_.height}}, [&](double u, double v) {
            const dvec2 point = r * direction(u);
            return place(point.x, glm::mix(point.y, shape_.height, v), depth_);
        });
        add_band();
    }

  private:
    dvec3 place(double x, double y, double z) const { return {side_ * x, y, side_ * z}; }
    /// From the opening's left end to its right.
    static dvec2 direction(double u) {
        const double angle = glm::pi<double>() * (1.0 - u);
        return {std::cos(angle), std::sin(angle)};
    }
    /// Half a ring between two circles, each at a depth of its own.
    void add_ring(double inner, double inner_depth, double outer, double outer_depth) {
        const double breadth = glm::length(dvec2(outer - inner, outer_depth - inner_depth));
        add_surface(mesh_, {.across = round_, .size = {glm::pi<double>() * outer, breadth}}, [&](double u, double v) {
            const dvec2 point = glm::mix(inner, outer, v) * direction(u);
            return place(point.x, point.y, glm::mix(inner_depth, outer_depth, v));
        });
    }
    void add_band() {
        const double inner = shape_.radius, outer = inner + band_width, front = depth_ + band_height;
        add_ring(inner, depth_, inner, front);
        add_ring(inner, front, outer - 0.5 * band_height, front);
        add_ring(outer - 0.5 * band_height, front, outer, depth_);
        for (const double left : {-outer, inner}) add_rectangle(mesh_, place(left, 0.0, depth_), dvec3(side_ * band_width, 0, 0), dvec3(0, 0, side_ * band_height));
    }

    HallMesh& mesh_;
    const ArchShape& shape_;
    double side_;
    int round_;
    double depth_;
};

}  // namespace

HallMesh arch(const ArchShape& shape, const HallDetail& detail) {
    HallMesh mesh;
    const int round = 2 * detail.steps(14, 3);
    for (const double side : {1.0, -1.0}) ArchFace(mesh, shape, side, round).add();
    const double half = 0.5 * shape.width, depth = 0.5 * shape.thickness, r = shape.radius;
    add_surface(mesh, {.across = round, .along = detail.steps(2, 1), .size = {glm::pi<double>() * r, shape.thickness}}, [&](double u, double v) {
        const double angle = glm::pi<double>() * u;
        return dvec3(-r * std::cos(angle), r * std::sin(angle), glm::mix(-depth, depth, v));
    });
    for (const double left : {-half, r}) add_rectangle(mesh, {left, 0.0, -depth}, {half - r, 0, 0}, {0, 0, shape.thickness});
    return mesh;
}

}  // namespace sl
