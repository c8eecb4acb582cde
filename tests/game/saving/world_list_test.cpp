// SPDX-License-Identifier: MIT
#include "game/saving/world_list.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "engine/core/error.h"
#include "engine/core/text_file.h"

namespace sl {
namespace {

using testing::HasSubstr;

class WorldListTest : public testing::Test {
  protected:
    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / fmt::format("secondlight_worlds_{}", ::getpid());

    WorldListTest() { std::filesystem::create_directories(folder_); }
    ~WorldListTest() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path path(const std::string& name) const { return world_path(folder_, name); }
    void make(const std::string& name, int hours_ago) const {
        (void)WorldFile::create(path(name), "scene of " + name);
        std::filesystem::last_write_time(path(name), std::filesystem::file_time_type::clock::now() - std::chrono::hours(hours_ago));
    }
    std::string bytes(const std::string& name) const { return read_text_file(path(name), 1 << 24); }
    std::size_t files() const { return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder_), {})); }
    std::vector<std::string> names(const WorldFile* open = nullptr) const {
        std::vector<std::string> result;
        for (const WorldEntry& entry : list_worlds(folder_, open)) result.push_back(entry.name);
        return result;
    }
};

TEST_F(WorldListTest, TheLastPlayedComesFirst) {
    make("old", 3);
    make("new", 1);
    make("older", 5);
    write_text_file(folder_ / "notes.txt", "no world");
    EXPECT_THAT(names(), testing::ElementsAre("new", "old", "older"));
    const WorldEntry first = list_worlds(folder_, nullptr).front();
    EXPECT_EQ(first.scene, "scene of new");
    EXPECT_EQ(first.fault, "");
    EXPECT_EQ(first.bytes, std::filesystem::file_size(path("new")));
}

TEST_F(WorldListTest, WhatIsDamagedIsListedWithItsFaultAndStaysAsItIs) {
    make("good", 1);
    write_text_file(path("foreign"), std::string(5000, 'x'));
    write_text_file(path("empty"), "");
    std::filesystem::create_directory(path("folder"));
    std::filesystem::create_symlink("nowhere", path("dangling"));
    make("half", 2);
    std::filesystem::resize_file(path("half"), std::filesystem::file_size(path("half")) / 2);
    const std::string foreign = bytes("foreign"), half = bytes("half");
    const std::size_t before = files();
    const auto worlds = list_worlds(folder_, nullptr);
    EXPECT_EQ(worlds.size(), 6u);
    for (const WorldEntry& entry : worlds) {
        EXPECT_EQ(entry.fault.empty(), entry.name == "good") << entry.name << ": " << entry.fault;
        if (entry.name == "good") continue;
        EXPECT_THROW(delete_world(entry.path), Error) << entry.name;
    }
    EXPECT_EQ(files(), before);
    EXPECT_EQ(bytes("foreign"), foreign);
    EXPECT_EQ(bytes("half"), half);
}

TEST_F(WorldListTest, TheWorldThatIsPlayedComesFirstAndGoesOnBeingSaved) {
    make("other", 0);
    make("mine", 5);
    {
        const auto mine = WorldFile::open(path("mine"));
        mine->save({0, {1, 2, 3}, Block::gold});
        ASSERT_TRUE(mine->wait(5.0));
        const auto worlds = list_worlds(folder_, mine.get());
        EXPECT_EQ(worlds.front().name, "mine");
        EXPECT_TRUE(worlds.front().open);
        EXPECT_EQ(worlds.front().scene, "scene of mine");
        EXPECT_THROW(delete_world(path("mine")), Error) << "nobody deletes what is played";
        EXPECT_EQ(list_worlds(folder_, nullptr).size(), 2u) << "nor does looking at it from elsewhere disturb";
        mine->save({0, {4, 5, 6}, Block::gold});
        ASSERT_TRUE(mine->wait(5.0));
    }
    EXPECT_EQ(WorldFile::open(path("mine"))->edits().size(), 2u);
}

TEST_F(WorldListTest, ADeletedWorldIsGoneWithAllThatLayBesideIt) {
    make("a", 0);
    make("b", 0);
    delete_world(path("a"));
    EXPECT_THAT(names(), testing::ElementsAre("b"));
    EXPECT_EQ(files(), 1u);
    EXPECT_THROW(delete_world(path("a")), Error);
}

TEST_F(WorldListTest, WithoutAFolderThereAreNoWorlds) {
    EXPECT_TRUE(list_worlds(folder_ / "none", nullptr).empty());
    EXPECT_TRUE(list_worlds("/dev/null", nullptr).empty());
}

TEST_F(WorldListTest, NamesThatNoFileCanHaveAreRefused) {
    make("taken", 0);
    for (const std::string name : {"", "a/b", "..", ".hidden", " a", "a ", "a\nb", "a\tb", "con:", "what?", "a*", "back\\slash", "taken"}) {
        EXPECT_NE(fault_of_name(folder_, name), "") << name;
    }
    EXPECT_THAT(fault_of_name(folder_, std::string(300, 'a')), HasSubstr("too long"));
    EXPECT_THAT(fault_of_name(folder_, "a/b"), HasSubstr("/"));
    for (const std::string name : {"World 1", "Grüße", "a.b", "x-y_z"}) EXPECT_EQ(fault_of_name(folder_, name), "") << name;
}

}  // namespace
}  // namespace sl
