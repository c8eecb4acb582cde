// SPDX-License-Identifier: MIT
#include "game/app/find_models.h"

#include <algorithm>
#include <set>

#include "engine/core/error.h"
#include "engine/core/model/read_model.h"

namespace sl {

namespace fs = std::filesystem;

namespace {

std::vector<FoundModel> models_below(const fs::path& folder) {
    std::vector<FoundModel> found;
    for (const auto& entry : fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied)) {
        if (entry.is_regular_file() && is_model(entry.path())) found.push_back({entry.path().lexically_relative(folder).generic_string(), entry.path()});
    }
    if (found.empty()) fail("{}: no model (.gltf, .glb or .vox) is below this folder", folder.string());
    std::ranges::sort(found, {}, &FoundModel::name);
    return found;
}

}  // namespace

std::vector<FoundModel> find_models(const std::vector<std::string>& paths) {
    std::vector<FoundModel> all;
    std::set<fs::path> files;
    std::set<std::string> names;
    for (const fs::path path : paths) {
        if (!fs::exists(path)) fail("{}: there is no such file or folder", path.string());
        if (!fs::is_directory(path) && !is_model(path)) fail("{}: it is no model; give .gltf, .glb or .vox files, or folders with such files", path.string());
        for (FoundModel& model : fs::is_directory(path) ? models_below(path) : std::vector{FoundModel{path.filename().string(), path}}) {
            if (!files.insert(fs::weakly_canonical(model.path)).second) continue;
            if (!names.insert(model.name).second) model.name = model.path.generic_string();
            all.push_back(std::move(model));
        }
    }
    return all;
}

}  // namespace sl
