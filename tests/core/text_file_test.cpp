// SPDX-License-Identifier: MIT
#include "engine/core/text_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/core/every_field.h"

namespace sl {
namespace {

namespace fs = std::filesystem;

class TextFile : public testing::Test {
  protected:
    void SetUp() override {
        folder = fs::temp_directory_path() / ("sl_text_file_" + std::to_string(::getpid()));
        fs::create_directories(folder);
    }
    void TearDown() override { fs::remove_all(folder); }
    std::size_t files() const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
    }
    fs::path folder;
};

TEST_F(TextFile, ReadsWhatWasWritten) {
    const std::string text("a\n\0b", 4);
    write_text_file(folder / "a", text);
    EXPECT_EQ(read_text_file(folder / "a", 100), text);
    write_text_file(folder / "a", "");
    EXPECT_EQ(read_text_file(folder / "a", 100), "");
    EXPECT_EQ(files(), 1u);
}

TEST_F(TextFile, KeepsModeAndFollowsLinks) {
    write_text_file(folder / "real", "old");
    ::chmod((folder / "real").c_str(), 0640);
    fs::create_symlink("real", folder / "link");
    write_text_file(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(read_text_file(folder / "real", 100), "new");
    EXPECT_EQ(fs::status(folder / "real").permissions(), fs::perms(0640));
}

TEST_F(TextFile, ErrorsNameTheFile) {
    const std::string name = (folder / "a").string();
    EXPECT_EQ(error_of([&] { read_text_file(name, 1); }), name + ": there is no such file");
    EXPECT_EQ(error_of([&] { read_text_file(folder, 1); }), folder.string() + ": is no regular file");
    EXPECT_EQ(error_of([&] { read_text_file("/dev/zero", 1); }), "/dev/zero: is no regular file");
    write_text_file(name, "four");
    EXPECT_EQ(error_of([&] { read_text_file(name, 3); }), name + ": has 4 bytes, at most 3 are read");
    EXPECT_EQ(error_of([&] { write_text_file(folder / "no" / "b", "x"); }),
              (folder / "no" / "b").string() + ": cannot be written: No such file or directory");
}

TEST_F(TextFile, AFailureLeavesTheOldFileAndNothingBeside) {
    fs::create_directory(folder / "taken");
    EXPECT_NE(error_of([&] { write_text_file(folder / "taken", "x"); }), "");
    EXPECT_TRUE(fs::is_directory(folder / "taken"));
    EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace sl
