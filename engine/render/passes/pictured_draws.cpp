// SPDX-License-Identifier: MIT
#include "engine/render/passes/pictured_draws.h"

namespace sl {

ByPictures by_pictures(const RenderScene& scene, const std::vector<std::uint32_t>& draws) {
    ByPictures parts;
    for (const std::uint32_t number : draws) {
        const RenderScene::Draw& draw = scene.draws[number];
        (draw.apart ? parts.apart : draw.pictured ? parts.together : parts.plain).push_back(number);
    }
    return parts;
}

void read_picture_colours(PassBuilder& pass, const SceneInputs& inputs) {
    pass.storage("Draws", inputs.draws).storage("Materials", inputs.materials).storage("Pictures", inputs.pictures);
    pass.read("picture_colours", inputs.picture_colours, Sampling::picture);
}

void read_pictures(PassBuilder& pass, const SceneInputs& inputs) {
    read_picture_colours(pass, inputs);
    pass.read("picture_data", inputs.picture_data, Sampling::picture);
}

}  // namespace sl
