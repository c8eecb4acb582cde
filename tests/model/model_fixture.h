// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/model/gltf_model.h"

namespace sl {

using Json = nlohmann::json;

/// glTF files made by a test, in a folder of its own.
class ModelTest : public testing::Test {
  protected:
    std::filesystem::path folder;

    void SetUp() override {
        folder = std::filesystem::temp_directory_path() / fmt::format("sl_model_{}_{}", ::getpid(), testing::UnitTest::GetInstance()->current_test_info()->name());
        std::filesystem::create_directories(folder);
    }
    void TearDown() override { std::filesystem::remove_all(folder); }

    /// Appends numbers to the file's buffer and returns the accessor that reads them.
    template <class Number>
    int add_accessor(const std::vector<Number>& numbers, int component_type, const char* type, std::size_t count, Json more = Json::object()) {
        while (buffer_.size() % 4 != 0) buffer_.push_back('\0');
        Json view{{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", numbers.size() * sizeof(Number)}};
        const auto* bytes = reinterpret_cast<const char*>(numbers.data());
        buffer_.append(bytes, numbers.size() * sizeof(Number));
        json["bufferViews"].push_back(view);
        more.update({{"bufferView", json["bufferViews"].size() - 1}, {"componentType", component_type}, {"type", type}, {"count", count}});
        json["accessors"].push_back(more);
        return static_cast<int>(json["accessors"].size()) - 1;
    }
    int add_positions(const std::vector<float>& numbers) {
        Json low(std::vector<float>(3, 1e9f)), high(std::vector<float>(3, -1e9f));
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            low[i % 3] = std::min(low[i % 3].get<float>(), numbers[i]);
            high[i % 3] = std::max(high[i % 3].get<float>(), numbers[i]);
        }
        return add_accessor(numbers, 5126, "VEC3", numbers.size() / 3, {{"min", low}, {"max", high}});
    }
    /// A mesh of one primitive, at a node of its own in the scene.
    void show(const Json& primitive) {
        json["meshes"].push_back({{"primitives", {primitive}}});
        json["nodes"].push_back({{"mesh", json["meshes"].size() - 1}});
        json["scenes"][0]["nodes"].push_back(json["nodes"].size() - 1);
    }
    /// A square of two triangles, 1 m wide, that faces +z, with uv from its upper left corner.
    Json square(Json more = Json::object()) {
        more["attributes"] = {{"POSITION", add_positions({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})},
                              {"TEXCOORD_0", add_accessor<float>({0, 1, 1, 1, 1, 0, 0, 0}, 5126, "VEC2", 4)}};
        more["indices"] = add_accessor<std::uint16_t>({0, 1, 2, 0, 2, 3}, 5123, "SCALAR", 6);
        return more;
    }
    std::filesystem::path write(const char* name = "model.gltf") {
        if (!buffer_.empty()) {
            json["buffers"] = {{{"byteLength", buffer_.size()}, {"uri", "data.bin"}}};
            std::ofstream(folder / "data.bin", std::ios::binary) << buffer_;
        }
        std::ofstream(folder / name) << json.dump();
        return folder / name;
    }
    Model read() { return read_gltf(write()); }
    std::string fault() {
        try {
            (void)read();
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    Json json{{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", {{{"nodes", Json::array()}}}}};
    std::string buffer_;
};

}  // namespace sl
