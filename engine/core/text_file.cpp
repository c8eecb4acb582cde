// SPDX-License-Identifier: MIT
#include "engine/core/text_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "engine/core/error.h"

namespace sl {

namespace {

class FileDescriptor {
  public:
    explicit FileDescriptor(int number) : number_(number) {}
    ~FileDescriptor() { close(); }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
    int number() const { return number_; }
    bool close() {
        const int closed = number_ < 0 ? 0 : ::close(number_);
        number_ = -1;
        return closed == 0;
    }

  private:
    int number_;
};

bool write_all(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(file, text.data(), text.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
}

[[noreturn]] void fail_to_write(const std::filesystem::path& path, const std::filesystem::path& beside) {
    const int why = errno;
    ::unlink(beside.c_str());
    fail("{}: cannot be written: {}", path.string(), std::strerror(why));
}

/// Through symbolic links, also to a file that is not there yet.
std::filesystem::path linked_file(const std::filesystem::path& path) {
    constexpr int most_links = 40;  // as many as the kernel follows
    std::filesystem::path file = path;
    std::error_code error;
    for (int links = 0; std::filesystem::is_symlink(file, error); ++links) {
        if (links == most_links) fail("{}: cannot be written: {}", path.string(), std::strerror(ELOOP));
        file = file.parent_path() / std::filesystem::read_symlink(file, error);
    }
    return file;
}

}  // namespace

std::string read_text_file(const std::filesystem::path& path, std::uint64_t most_bytes) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) fail("{}: there is no such file", path.string());
    if (!std::filesystem::is_regular_file(status)) fail("{}: is no regular file", path.string());
    std::ifstream file(path, std::ios::binary | std::ios::ate);
    if (!file) fail("{}: cannot be opened: {}", path.string(), std::strerror(errno));
    const auto bytes = static_cast<std::uint64_t>(file.tellg());
    if (bytes > most_bytes) fail("{}: has {} bytes, at most {} are read", path.string(), bytes, most_bytes);
    std::string text(bytes, '\0');
    file.seekg(0);
    if (!file.read(text.data(), static_cast<std::streamsize>(bytes)))
        fail("{}: cannot be read", path.string());
    return text;
}

void write_text_file(const std::filesystem::path& path, std::string_view text) {
    std::error_code error;
    const std::filesystem::path target = linked_file(path);
    const bool exists = std::filesystem::exists(target, error);
    if (exists && !std::filesystem::is_regular_file(target, error)) {
        fail("{}: cannot be written: it is no regular file, and would be replaced", path.string());
    }
    // The folder would let a file be replaced that is protected itself.
    if (exists && ::access(target.c_str(), W_OK) != 0) fail("{}: cannot be written: {}", path.string(), std::strerror(errno));
    std::filesystem::path beside = target;
    beside += fmt::format(".{}.tmp", ::getpid());
    struct stat old {};
    const bool has_mode = exists && ::stat(target.c_str(), &old) == 0;

    FileDescriptor file(::open(beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
    if (file.number() < 0) fail_to_write(path, beside);
    if (!write_all(file.number(), text)) fail_to_write(path, beside);
    // Whoever has no right to give files away writes one of their own. Before the mode, of which this may clear bits.
    [[maybe_unused]] const int is_given = has_mode ? ::fchown(file.number(), old.st_uid, old.st_gid) : 0;
    if (has_mode && ::fchmod(file.number(), old.st_mode & 07777) != 0) fail_to_write(path, beside);
    if (::fsync(file.number()) != 0 || !file.close()) fail_to_write(path, beside);
    if (::rename(beside.c_str(), target.c_str()) != 0) fail_to_write(path, beside);

    // The rename itself is on the disk once the folder is; without that the old file may come back, which is
    // whole too.
    const std::filesystem::path folder = target.has_parent_path() ? target.parent_path() : ".";
    const FileDescriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (opened.number() >= 0) ::fsync(opened.number());
}

}  // namespace sl
