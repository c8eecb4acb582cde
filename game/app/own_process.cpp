// SPDX-License-Identifier: MIT
#include "game/app/own_process.h"

#include <malloc.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <fstream>
#include <optional>
#include <thread>

namespace sl {

namespace {

constexpr double least_memory_share = 0.08;  // of the machine's, below which work is ended
constexpr char good = '+', bad = '-';        // first letter of what the copy sends

/// Of the machine's memory, what can still be had.
double free_memory_share() {
    std::ifstream info("/proc/meminfo");
    double total = 0.0, available = 0.0;
    std::string name, unit;
    for (double value = 0.0; info >> name >> value && std::getline(info, unit);) {
        if (name == "MemTotal:") total = value;
        if (name == "MemAvailable:") available = value;
    }
    return total > 0.0 ? available / total : 1.0;
}

[[noreturn]] void work_and_send(const std::function<std::string()>& work, int pipe) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);  // nobody would read what an orphan sends
    std::string text;
    try {
        text = good + work();
    } catch (const std::exception& error) {
        text = bad + std::string(error.what());
    }
    std::fflush(nullptr);
    for (std::size_t sent = 0; sent < text.size();) {
        const ssize_t written = write(pipe, text.data() + sent, text.size() - sent);
        if (written <= 0) break;
        sent += static_cast<std::size_t>(written);
    }
    // No destructors of what belongs to the process that was copied.
    _exit(0);
}

/// Reads until the copy ends; none where it was ended, with why in `reason`.
std::optional<std::string> receive(pid_t child, int pipe, double seconds, std::string& reason) {
    const auto start = std::chrono::steady_clock::now();
    std::string text;
    std::array<char, 4096> buffer{};
    for (;;) {
        pollfd ready{.fd = pipe, .events = POLLIN, .revents = 0};
        if (poll(&ready, 1, 100) > 0) {
            const ssize_t count = read(pipe, buffer.data(), buffer.size());
            if (count <= 0) return text;
            text.append(buffer.data(), static_cast<std::size_t>(count));
            continue;
        }
        const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
        if (passed.count() > seconds) reason = fmt::format("took longer than {:.3g} minutes", seconds / 60.0);
        if (free_memory_share() < least_memory_share) reason = fmt::format("left less than {:.0f} % of the memory free", 100.0 * least_memory_share);
        if (reason.empty()) continue;
        kill(child, SIGKILL);
        return std::nullopt;
    }
}

}  // namespace

std::string in_own_process(const std::function<std::string()>& work, double seconds) {
    std::fflush(nullptr);  // or both would print what waits
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) fail("no pipe to a process of its own can be made; close some files");
    const pid_t child = fork();
    if (child < 0) fail("no process of its own can be started; there may be too many");
    if (child == 0) {
        close(ends[0]);
        work_and_send(work, ends[1]);
    }
    close(ends[1]);
    std::string reason;
    const auto text = receive(child, ends[0], seconds, reason);
    close(ends[0]);
    int status = 0;
    waitpid(child, &status, 0);
    if (!text) throw LimitReached(reason);
    if (text->empty()) fail("ended by signal {}", WIFSIGNALED(status) ? WTERMSIG(status) : 0);
    if (text->front() == bad) fail("{}", text->substr(1));
    return text->substr(1);
}

void keep_little_memory() {
    constexpr int large_block = 1 << 20;
    mallopt(M_MMAP_THRESHOLD, large_block);  // which stops it from rising by itself
    mallopt(M_ARENA_MAX, static_cast<int>(std::max(2u, std::thread::hardware_concurrency())));
}

double resident_megabytes() {
    std::ifstream file("/proc/self/statm");
    double total = 0.0, resident = 0.0;
    file >> total >> resident;
    return 1e-6 * resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

double peak_megabytes() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
        if (line.starts_with("VmHWM:")) return 1.024e-3 * std::stod(line.substr(line.find(':') + 1));
    }
    return resident_megabytes();
}

ProcessUse process_use() {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    const auto seconds = [](const timeval& time) { return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec); };
    return {.seconds = seconds(use.ru_utime) + seconds(use.ru_stime), .in_system = seconds(use.ru_stime), .pages = use.ru_minflt + use.ru_majflt, .from_disk = use.ru_majflt};
}

double allocated_megabytes() {
    const struct mallinfo2 info = mallinfo2();
    return 1e-6 * static_cast<double>(info.uordblks + info.hblkhd);
}

}  // namespace sl
