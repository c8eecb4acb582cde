// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <iostream>
#include <map>
#include <numeric>
#include <set>

#include "engine/core/error.h"
#include "engine/core/model/read_model.h"
#include "tests/support/assets.h"
#include "tests/support/result_table.h"

namespace sl {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> columns{"tried", "refused", "loaded with a warning", "loaded without a word", "crashed"};

ResultTable& result_table() {
    static auto* table = static_cast<ResultTable*>(testing::AddGlobalTestEnvironment(
        new ResultTable("malformed models", SL_DOCS_FOLDER "/benchmarks.md", "files", columns)));
    return *table;
}
/// Before the tests run, or it would not be there when they end.
[[maybe_unused]] ResultTable& registered = result_table();

enum class End { silent, warned, refused, crashed };

/// What became of the files of one kind.
struct Outcome {
    std::map<End, std::size_t> ends;

    std::size_t tried() const {
        return std::accumulate(ends.begin(), ends.end(), std::size_t{0},
                               [](std::size_t sum, const auto& end) { return sum + end.second; });
    }
    void tell(const std::string& row) {
        const std::array counts{tried(), ends[End::refused], ends[End::warned], ends[End::silent], ends[End::crashed]};
        std::cout << row << ":";
        for (std::size_t i = 0; i < columns.size(); ++i) {
            std::cout << fmt::format("{} {} {}", i == 0 ? "" : ",", counts[i], columns[i]);
            result_table().say(row, columns[i], std::to_string(counts[i]));
        }
        std::cout << std::endl;
    }
};

/// More of memory and time than this is a crash: both end what reads the file.
void bound_this_process() {
    const rlimit seconds{20, 20};
    ::setrlimit(RLIMIT_CPU, &seconds);
#ifndef __SANITIZE_ADDRESS__
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlim_t most = pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + (rlim_t{512} << 20);
    const rlimit memory{most, most};
    ::setrlimit(RLIMIT_AS, &memory);
#endif
}

End read_to_the_end(const fs::path& path, std::string& message) {
    try {
        return read_model(path).warnings.empty() ? End::silent : End::warned;
    } catch (const Error& error) {
        message = error.what();
        return End::refused;
    }
}

class MalformedModelsTest : public AssetsTest {
  protected:
    /// Reads a model in a process of its own, which may crash.
    static End end_of(const fs::path& path, Outcome& outcome) {
        int ends[2];
        if (::pipe(ends) != 0) throw std::runtime_error("no pipe");
        const pid_t child = ::fork();
        if (child == 0) {
            bound_this_process();
            std::string message;
            const End end = read_to_the_end(path, message);
            const ssize_t written = ::write(ends[1], message.data(), message.size());
            ::_exit(written < 0 ? static_cast<int>(End::crashed) : static_cast<int>(end));
        }
        ::close(ends[1]);
        std::string message(std::size_t{1} << 16, '\0');
        const ssize_t size = ::read(ends[0], message.data(), message.size());
        message.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
        ::close(ends[0]);
        int status = 0;
        ::waitpid(child, &status, 0);
        const End end = WIFEXITED(status) ? static_cast<End>(WEXITSTATUS(status)) : End::crashed;
        EXPECT_NE(end, End::crashed) << path;
        if (end == End::refused) check_message(message, path);
        ++outcome.ends[end];
        return end;
    }

    static void check_message(const std::string& message, const fs::path& path) {
        ASSERT_TRUE(message.starts_with(path.string() + ": ")) << message;
        EXPECT_EQ(message.find('\n'), std::string::npos) << message;
        EXPECT_THAT(message.substr(path.string().size() + 2), testing::MatchesRegex("(/|byte [0-9]+:|the document ).*"));
    }
};

TEST_F(MalformedModelsTest, WhatTheValidatorFindsFaultWithIsRefusedOrTold) {
    std::set<fs::path> judged;
    Outcome outcome;
    for (const auto& entry : manifest()) {
        if (entry.value("errors", 0) == 0) continue;
        const fs::path path = folder / entry["file"].get<std::string>();
        judged.insert(path);
        EXPECT_NE(end_of(path, outcome), End::silent) << path << " should have " << entry["codes"];
    }
    outcome.tell("malformed, by the format's validator");
    Outcome others;
    for (const fs::path& path : models("malformed")) {
        if (!judged.contains(path)) end_of(path, others);
    }
    others.tell("made to break other loaders, without a verdict");
    EXPECT_GT(others.tried(), 0u);
}

TEST_F(MalformedModelsTest, ValidModelsAreNotRefused) {
    for (const auto& [part, row] :
         {std::pair{"valid", "valid, by the format's validator"}, std::pair{"public", "models of others"}}) {
        Outcome outcome;
        for (const fs::path& path : models(part)) EXPECT_NE(end_of(path, outcome), End::refused) << path;
        outcome.tell(row);
        EXPECT_GT(outcome.tried(), 0u);
    }
}

}  // namespace
}  // namespace sl
