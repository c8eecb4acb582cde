// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <map>

#include "engine/render/capture.h"
#include "engine/render/reference/film.h"
#include "game/session.h"

namespace sl {

/// One truth about a view's indirect irradiance, and how exact it is itself.
struct Truth {
    Image irradiance;    ///< lux, linear
    double noise = 0.0;  ///< NRMSE of itself, from two independent halves; 0 where nothing is random
};

/// What the methods are measured against in one view.
struct ViewTruths {
    Truth open;      ///< path traced: one diffuse bounce of the lights that bounce, through everything
    Truth one;       ///< path traced: one diffuse bounce of all lights, blocked by what stands between
    Truth full;      ///< path traced: all that arrives, sky and glowing surfaces as well, until the rest is nothing
    Image picture;   ///< of the full transport, exposed like the camera's
    std::vector<float> mask;  ///< 0 where there is no surface
};

/// Makes or continues the references of a scene in `folder`, one EXR each. `tell` gets a share of this work, 0 to 1.
ViewTruths make_truths(const SceneChoice& choice, uvec2 size, std::uint32_t spp, const std::filesystem::path& folder, const std::function<void(double)>& tell);

/// What one view holds in truth, all transport counted.
struct FullTruth {
    Truth truth;
    Image picture;            ///< exposed like the camera's, adapted where that adapts
    std::vector<float> mask;  ///< 0 where there is no surface
};
/// Makes or continues the reference of all transport alone; as make_truths.
FullTruth make_full_truth(const SceneChoice& choice, uvec2 size, std::uint32_t spp, const std::filesystem::path& folder);

/// What is compared is drawn with this: the references' samples go through pixel centres.
inline constexpr const char* no_antialiasing = "camera.antialias=false";

/// A scene drawn by a method: irradiance, and the picture.
struct Drawn {
    Image irradiance, picture;
};
Drawn draw_once(const SceneChoice& choice, Renderer& renderer, uvec2 size, const Executor::OnStep& on_step = {});

}  // namespace sl
