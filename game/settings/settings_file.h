// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "game/settings/user_settings.h"

namespace sl {

/// $XDG_CONFIG_HOME/secondlight/settings.json, or in ~/.config; without a home, in the folder for temporary files.
std::filesystem::path settings_path();

/// The file that keeps the player's settings. Reading it never fails: what is wrong is told, and the settings are the usual ones.
class SettingsFile {
  public:
    explicit SettingsFile(std::filesystem::path path);

    UserSettings settings;

    const std::filesystem::path& path() const { return path_; }
    /// File, JSON pointer and what is wrong there; empty where all is well or there is no file yet.
    const std::string& fault() const { return fault_; }
    /// What nobody knows: it was ignored, and stays in the file.
    const std::vector<std::string>& warnings() const { return warnings_; }

    /// Writes the settings, whole or not at all. A file that could not be read is kept beside under another name, which is
    /// returned; else nothing is. Throws Error.
    std::filesystem::path save();

  private:
    void read();

    std::filesystem::path path_;
    nlohmann::ordered_json document_;  ///< as last read or written
    std::string fault_;
    std::vector<std::string> warnings_;
};

}  // namespace sl
