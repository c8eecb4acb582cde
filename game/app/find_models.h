// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace sl {

/// A model's file, and what tables call it: its way from the folder that was asked for, or its own name.
struct FoundModel {
    std::string name;
    std::filesystem::path path;
};

/// The models among these files and below these folders, in the order of the paths and by name, each once. Throws Error for a
/// path that is not there, a file that is no model, and a folder without any.
std::vector<FoundModel> find_models(const std::vector<std::string>& paths);

}  // namespace sl
