// SPDX-License-Identifier: MIT
#pragma once

#include "engine/core/model/model.h"

namespace sl {

/// Where a model's nodes are, each in its parent, and how far its morphs have gone.
struct ModelPose {
    /// Relative to its parent.
    struct Node {
        dvec3 translation{0.0};
        quat rotation{1, 0, 0, 0};
        vec3 scale{1.0f};
    };
    std::vector<Node> nodes;
    std::vector<std::vector<float>> weights;  ///< per node; empty where nothing morphs
};

/// The model at rest.
ModelPose rest_of(const Model& model);
/// The model as an animation has it, which begins anew when it is over. Rotations turn at an even speed between two keys (slerp), cubic
/// ones follow Hermite splines, as in glTF 2.0, appendix C.
ModelPose pose_at(const Model& model, const ModelAnimation& animation, double seconds);

/// Whether anything but its node moves a mesh's vertices.
bool deforms(const ModelPrimitive& primitive);
/// model_from_node of all nodes; in which scene does not matter.
std::vector<mat4> places_of(const Model& model, const ModelPose& pose);
/// model_from_joint · joint_from_mesh of each joint of a skin, from the places of all nodes.
std::vector<mat4> joint_matrices(const ModelSkin& skin, const std::vector<mat4>& places);
/// Moves a mesh's vertices from where the file has them: morphs first, then joints. A skin moves a mesh in the space of the whole model.
/// `joints` may be empty. Normals of skinned vertices are those of the blended matrix's cofactors;
/// tangents move along with the surface.
void deform(const ModelPrimitive& primitive, const MeshData& rest, const std::vector<float>& weights, const std::vector<mat4>& joints, MeshData& mesh);

}  // namespace sl
