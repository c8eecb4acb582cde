// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

#include "engine/core/error.h"
#include "engine/core/image.h"

namespace sl {

/// A folder of its own for each test, and pictures to put there.
class ImageTest : public testing::Test {
  protected:
    std::filesystem::path folder;

    void SetUp() override {
        const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
        folder = std::filesystem::temp_directory_path() / fmt::format("sl_image_{}_{}", ::getpid(), test);
        std::filesystem::create_directories(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    std::size_t files_in_folder() const {
        return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder),
                                                      std::filesystem::directory_iterator()));
    }
    static std::string bytes_of(const std::filesystem::path& path) {
        std::ostringstream bytes;
        bytes << std::ifstream(path, std::ios::binary).rdbuf();
        return bytes.str();
    }
    static Image counting(std::uint32_t width, std::uint32_t height, std::uint32_t channels, float first) {
        Image image(width, height, channels);
        std::iota(image.data.begin(), image.data.end(), first);
        return image;
    }
    template <class Body>
    static std::string error_of(Body&& body) {
        try {
            body();
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
};

}  // namespace sl
