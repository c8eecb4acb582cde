// SPDX-License-Identifier: MIT
#include "game/saving/world_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <random>
#include <set>

#include "engine/core/error.h"

namespace sl {
namespace {

using testing::HasSubstr;

class WorldFileTest : public testing::Test {
  protected:
    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / fmt::format("secondlight_world_{}", ::getpid());
    std::filesystem::path path_ = folder_ / "test.world";

    WorldFileTest() { std::filesystem::create_directories(folder_); }
    ~WorldFileTest() override {
        std::filesystem::permissions(folder_, std::filesystem::perms::owner_all);
        std::filesystem::remove_all(folder_);
    }
    std::string bytes() const {
        std::ifstream file(path_, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    std::string refusal() const {
        try {
            (void)WorldFile::open(path_);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }
    static BlockEdit edit(int number) { return {static_cast<std::uint32_t>(number % 3), {number, -number, 2 * number}, static_cast<Block>(1 + number % 20)}; }
};

TEST_F(WorldFileTest, KeepsEditsAndTexts) {
    {
        auto world = WorldFile::create(path_, "outdoor");
        for (int i = 0; i < 1000; ++i) world->save(edit(i));
        world->save({0, {0, 0, 0}, Block::gold});
        world->save_text("player", "here");
        world->save_text("player", "there; drop table 'block'");
    }
    const auto world = WorldFile::open(path_);
    EXPECT_EQ(world->scene(), "outdoor");
    EXPECT_EQ(world->text("player"), "there; drop table 'block'");
    EXPECT_EQ(world->text("nothing"), "");
    ASSERT_EQ(world->edits().size(), 1000u) << "the last of a place counts";
    EXPECT_EQ(std::ranges::count(world->edits(), edit(17)), 1);
    EXPECT_EQ(std::ranges::count(world->edits(), BlockEdit{0, {0, 0, 0}, Block::gold}), 1);
}

TEST_F(WorldFileTest, NothingThatWasAcknowledgedIsLostWhenTheProcessIsKilled) {
    (void)WorldFile::create(path_, "outdoor");
    std::mt19937 random(3);
    int first = 0, most = 0;
    for (int round = 0; round < 200; ++round) {
        int ends[2];
        ASSERT_EQ(::pipe(ends), 0);
        const pid_t child = ::fork();
        if (child == 0) {
            ::close(ends[0]);
            const auto world = WorldFile::open(path_);
            for (int i = first;; ++i) {
                world->save(edit(i));
                if (i % 3 == 0 && world->wait(5.0) && ::write(ends[1], &i, sizeof i) != sizeof i) ::_exit(1);
            }
        }
        ::close(ends[1]);
        int acknowledged = -1, number = 0;
        // At least one of this round, and then at any moment.
        if (::read(ends[0], &number, sizeof number) == sizeof number) acknowledged = number;
        ::usleep(std::uniform_int_distribution<useconds_t>(0, 3000)(random));
        ::kill(child, SIGKILL);
        while (::read(ends[0], &number, sizeof number) == sizeof number) acknowledged = number;
        ::close(ends[0]);
        ::waitpid(child, nullptr, 0);
        ASSERT_GE(acknowledged, first) << "round " << round;
        const auto world = WorldFile::open(path_);
        std::set<int> there;
        for (const BlockEdit& one : world->edits()) there.insert(one.cell.x);
        for (int i = 0; i <= acknowledged; ++i) ASSERT_TRUE(there.contains(i)) << "edit " << i << " of " << acknowledged << " in round " << round;
        first = acknowledged + 1;
        most = acknowledged;
    }
    EXPECT_GT(most, 400);
}

TEST_F(WorldFileTest, ASecondProcessIsRefused) {
    const auto world = WorldFile::create(path_, "outdoor");
    EXPECT_THAT(refusal(), HasSubstr("open in another process"));
    world->save(edit(1));
    EXPECT_TRUE(world->wait(5.0)) << "and does no harm";
}

TEST_F(WorldFileTest, WhatIsNoWorldIsRefusedAndStaysAsItIs) {
    EXPECT_THAT(refusal(), HasSubstr("no such file"));
    const std::vector<std::string> others{"", "this is a text, and a long one, longer than the head of a database, which has a hundred bytes, so that all of it is looked at", std::string(5000, '\0')};
    for (const std::string& content : others) {
        std::ofstream(path_, std::ios::binary) << content;
        EXPECT_NE(refusal(), "") << content.substr(0, 20);
        EXPECT_EQ(bytes(), content);
        EXPECT_THROW((void)WorldFile::create(path_, "outdoor"), Error);
        EXPECT_EQ(bytes(), content);
    }
    std::filesystem::remove(path_);
    Database(path_, Database::Access::create).run("CREATE TABLE text (key, value)");
    EXPECT_THAT(refusal(), HasSubstr("no world"));
    std::filesystem::remove(path_);
    (void)WorldFile::create(path_, "outdoor");
    Database(path_, Database::Access::write).run("PRAGMA user_version=99");
    EXPECT_THAT(refusal(), HasSubstr("newer version"));
}

TEST_F(WorldFileTest, TablesOfAStrangerAreRefused) {
    const char* endless = "DROP TABLE text; CREATE VIEW text AS WITH RECURSIVE n(i) AS (SELECT 0 UNION ALL SELECT i + 1 FROM n) SELECT 'k' || i AS key, 'v' AS value FROM n";
    for (const char* more : {endless, "CREATE TRIGGER t AFTER INSERT ON block BEGIN DELETE FROM block; END", "CREATE TABLE other (x)", "ALTER TABLE text ADD COLUMN c AS (hex(zeroblob(1000000)))"}) {
        std::filesystem::remove(path_);
        (void)WorldFile::create(path_, "outdoor");
        Database(path_, Database::Access::write).run(more);
        EXPECT_THAT(refusal(), HasSubstr("its tables are not those of a world")) << more;
        EXPECT_THROW((void)WorldFile::scene_of(path_), Error);
    }
}

TEST_F(WorldFileTest, DamagedFilesAreRefusedOrRead) {
    {
        auto world = WorldFile::create(path_, "outdoor");
        for (int i = 0; i < 3000; ++i) world->save(edit(i));
    }
    const std::string whole = bytes();
    ASSERT_GT(whole.size(), 20000u);
    std::mt19937 random(5);
    int refused = 0;
    for (int round = 0; round < 100; ++round) {
        std::string damaged = whole;
        if (round % 2 == 0) damaged.resize(random() % whole.size());
        for (int i = 0; i < 200 && !damaged.empty(); ++i) damaged[random() % damaged.size()] = static_cast<char>(random());
        std::filesystem::remove(path_);
        std::ofstream(path_, std::ios::binary) << damaged;
        const std::string why = refusal();
        if (why.empty()) continue;
        ++refused;
        EXPECT_THAT(why, HasSubstr("test.world"));
        EXPECT_EQ(bytes(), damaged) << "it stays as it is";
    }
    EXPECT_GT(refused, 90);
}

TEST_F(WorldFileTest, AFolderThatIsReadOnlyIsToldAndPlayGoesOn) {
    {
        const auto world = WorldFile::create(path_, "outdoor");
        world->save(edit(7));
    }
    using std::filesystem::perms;
    std::filesystem::permissions(folder_, perms::owner_read | perms::owner_exec | perms::others_read | perms::others_exec);
    // Root may write everywhere, so somebody else looks, in a process of its own.
    const pid_t child = ::fork();
    if (child == 0) {
        if (::geteuid() == 0 && (::setgid(65534) != 0 || ::setuid(65534) != 0)) ::_exit(2);
        const auto world = WorldFile::open(path_);
        world->save(edit(1));
        const bool kept = world->scene() == "outdoor" && world->edits() == std::vector{edit(7)};
        const WorldFile::Status status = world->status();
        ::_exit(!kept ? 3 : status.problem.find("read-only") == std::string::npos ? 4 : status.waiting != 1 ? 5 : 0);
    }
    int result = 0;
    ASSERT_EQ(::waitpid(child, &result, 0), child);
    EXPECT_TRUE(WIFEXITED(result));
    EXPECT_EQ(WEXITSTATUS(result), 0) << "2: cannot become another user; 3: not read; 4: not told; 5: not kept in memory";
}

TEST_F(WorldFileTest, AFullDiskIsToldAndSavingGoesOnWhenThereIsRoom) {
    (void)WorldFile::create(path_, "outdoor");
    const auto world = WorldFile::open(path_);
    // No file may grow past 64 KiB: as good as a full disk, and needs none.
    ::signal(SIGXFSZ, SIG_IGN);
    rlimit before{};
    ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
    rlimit little = before;
    little.rlim_cur = 64 << 10;
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &little), 0);
    for (int i = 0; i < 20000; ++i) world->save(edit(i));
    EXPECT_FALSE(world->wait(2.0));
    EXPECT_THAT(world->status().problem, HasSubstr("test.world"));
    EXPECT_GT(world->status().waiting, 0u);
    ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
    EXPECT_TRUE(world->wait(10.0));
    EXPECT_EQ(world->status().problem, "");
}

}  // namespace
}  // namespace sl
