// SPDX-License-Identifier: MIT
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "engine/core/error.h"
#include "engine/render/gl/context.h"
#include "engine/render/gl/gl.h"

namespace sl::gl {

/// A shader folder of its own for one test, gone afterwards.
class TempFolder {
  public:
    TempFolder() {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        std::string name = fmt::format("sl_{}_{}_{}", ::getpid(), test->test_suite_name(), test->name());
        for (char& c : name) c = c == '/' ? '_' : c;
        path_ = std::filesystem::temp_directory_path() / name;
        std::filesystem::create_directories(path_);
    }
    ~TempFolder() { std::filesystem::remove_all(path_); }
    TempFolder(const TempFolder&) = delete;
    TempFolder& operator=(const TempFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    void write(const std::string& file, const std::string& text) const {
        std::filesystem::create_directories((path_ / file).parent_path());
        std::ofstream(path_ / file) << text;
    }

  private:
    std::filesystem::path path_;
};

/// Runs each test in a context of its own, on EGL and on OSMesa, and requires that the driver found no error.
class GlTest : public testing::TestWithParam<ContextKind> {
  protected:
    void SetUp() override { context_ = create_context(GetParam()); }
    void TearDown() override {
        EXPECT_THAT(context_->errors(), testing::IsEmpty());
        context_.reset();
    }
    Context& context() { return *context_; }

  private:
    std::unique_ptr<Context> context_;
};

inline std::string kind_name(const testing::TestParamInfo<ContextKind>& info) {
    return std::string(context_kind_name(info.param));
}

/// The message of the Error that `body` throws, or "" when it throws none.
template <class Body>
std::string error_of(Body&& body) {
    try {
        body();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

}  // namespace sl::gl

#define SL_ON_BOTH_CONTEXTS(fixture) \
    INSTANTIATE_TEST_SUITE_P(On, fixture, testing::Values(ContextKind::egl, ContextKind::osmesa), kind_name)
