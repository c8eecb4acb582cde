// SPDX-License-Identifier: MIT
#include "engine/core/text_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>

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

TEST_F(TextFile, KeepsModeAndOwnerAndFollowsLinks) {
    constexpr uid_t nobody = 65534;
    write_text_file(folder / "real", "old");
    const uid_t owner = ::geteuid() == 0 ? nobody : ::geteuid();  // only root can give a file away
    ASSERT_EQ(::chown((folder / "real").c_str(), owner, static_cast<gid_t>(-1)), 0);
    ::chmod((folder / "real").c_str(), 0640);
    fs::create_symlink("real", folder / "link");
    write_text_file(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(read_text_file(folder / "real", 100), "new");
    EXPECT_EQ(fs::status(folder / "real").permissions(), fs::perms(0640));
    struct stat now {};
    ASSERT_EQ(::stat((folder / "real").c_str(), &now), 0);
    EXPECT_EQ(now.st_uid, owner);
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

TEST_F(TextFile, ALinkToAFileThatIsNotThereYetIsFollowed) {
    fs::create_directory(folder / "in");
    fs::create_symlink("in/link", folder / "first");
    fs::create_symlink("../real", folder / "in" / "link");
    write_text_file(folder / "first", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "first"));
    EXPECT_TRUE(fs::is_symlink(folder / "in" / "link"));
    EXPECT_EQ(read_text_file(folder / "real", 100), "new");
    fs::create_symlink("circle", folder / "circle");
    EXPECT_EQ(error_of([&] { write_text_file(folder / "circle", "x"); }),
              (folder / "circle").string() + ": cannot be written: Too many levels of symbolic links");
}

TEST_F(TextFile, AFullDiskLeavesTheOldFile) {
    write_text_file(folder / "a", "old");
    // A limit on the size of files stops a write half way, as a full disk does.
    rlimit usual{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &usual), 0);
    const auto no_signal = std::signal(SIGXFSZ, SIG_IGN);
    rlimit small = usual;
    small.rlim_cur = 4096;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
    const std::string error = error_of([&] { write_text_file(folder / "a", std::string(100'000, 'x')); });
    ::setrlimit(RLIMIT_FSIZE, &usual);
    std::signal(SIGXFSZ, no_signal);
    EXPECT_EQ(error, (folder / "a").string() + ": cannot be written: File too large");
    EXPECT_EQ(read_text_file(folder / "a", 100), "old");
    EXPECT_EQ(files(), 1u);
}

/// What a user without special rights is told who writes the file; the answer comes as the message of a process that ends.
[[noreturn]] void write_as_a_user(const fs::path& file) {
    constexpr uid_t nobody = 65534;
    if (::geteuid() == 0 && ::setuid(nobody) != 0) std::_Exit(1);
    fmt::print(stderr, "{}", error_of([&] { write_text_file(file, "new"); }));
    std::_Exit(0);
}

TEST_F(TextFile, WhatIsProtectedStaysAsItIs) {
    write_text_file(folder / "a", "older");
    ::chmod((folder / "a").c_str(), 0666);
    ::chmod(folder.c_str(), 0777);
    EXPECT_EXIT(write_as_a_user(folder / "a"), testing::ExitedWithCode(0), "");
    EXPECT_EQ(read_text_file(folder / "a", 100), "new");
    write_text_file(folder / "a", "old");
    ::chmod(folder.c_str(), 0555);
    EXPECT_EXIT(write_as_a_user(folder / "a"), testing::ExitedWithCode(0), "/a: cannot be written: Permission denied");
    EXPECT_EXIT(write_as_a_user(folder / "b"), testing::ExitedWithCode(0), "/b: cannot be written: Permission denied");
    ::chmod(folder.c_str(), 0777);
    ::chmod((folder / "a").c_str(), 0444);
    EXPECT_EXIT(write_as_a_user(folder / "a"), testing::ExitedWithCode(0), "/a: cannot be written: Permission denied");
    EXPECT_EQ(read_text_file(folder / "a", 100), "old");
    EXPECT_EQ(files(), 1u);
}

}  // namespace
}  // namespace sl
