// SPDX-License-Identifier: MIT
#pragma once

#include <unordered_map>

#include "engine/render/scene/render_scene.h"

namespace sl {

/// Tells where a scene's surfaces differ from those that were last looked at.
class SurfaceChanges {
  public:
    /// Something came, went or moved here.
    struct Change {
        Bounds box;
        bool edited = false;  ///< a part of a mesh that is otherwise as it was, which somebody looks at
        bool came = false;    ///< nothing of it was there before
    };

    std::vector<Change> since_last_look(const RenderScene& scene) const;
    void look_at(const RenderScene& scene);
    /// Positions of what was looked at change by `offset`, m: the scene's origin is another one.
    void move(vec3 offset);
    /// Nothing was looked at yet, or there was nothing.
    bool empty() const { return boxes_.empty(); }

  private:
    std::unordered_map<std::uint64_t, Bounds> boxes_;  ///< of draws, by their content
};

/// Whether what has changed is so small from there that little of its light can matter: the ratio of radius to distance.
bool hardly_shows(const Bounds& box, vec3 from);

}  // namespace sl
