// SPDX-License-Identifier: MIT
// A player's settings.json: reading it never fails, and what is saved after it is read again.
#include "engine/core/check.h"
#include "game/settings/settings_file.h"
#include "tests/fuzz/input_folder.h"

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const sl::InputFolder files;
    sl::SettingsFile file(files.write("settings.json", sl::text_of(data, size)));
    const auto kept = file.save();
    const sl::SettingsFile again(file.path());
    CHECK(again.fault().empty() && again.settings == file.settings, "settings that were saved are others: {}", again.fault());
    if (!kept.empty()) std::filesystem::remove(kept);
    return 0;
}
