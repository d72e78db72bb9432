// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/files.hpp"

#include "verify/exit_codes.hpp"

#include <fmt/format.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <optional>
#include <utility>

namespace touchstone::program {
namespace {

namespace fs = std::filesystem;

constexpr int most_links = 40; ///< as the kernel has it
constexpr mode_t permissions = 07777;
constexpr int most_leftovers = 1000; ///< temporary files of dead writers that are passed by

Failure not_written(const fs::path& path, int error)
{
    return {cannot_write, fmt::format("cannot write {}: {}", path.string(), std::strerror(error))};
}

/// An open file, closed when done with.
class File {
public:
    explicit File(int descriptor) : descriptor_(descriptor) {}
    File(const File&) = delete;
    File& operator=(const File&) = delete;
    ~File() { close(); }
    bool open() const { return descriptor_ >= 0; }
    int get() const { return descriptor_; }
    /// 0, or the error that writing behind our back has led to
    int close() { return descriptor_ >= 0 && ::close(std::exchange(descriptor_, -1)) != 0 ? errno : 0; }
    /// 0, or the error
    int write(std::string_view bytes)
    {
        while (!bytes.empty()) {
            const ssize_t n = ::write(descriptor_, bytes.data(), bytes.size());
            if (n < 0 && errno != EINTR) return errno;
            if (n > 0) bytes.remove_prefix(static_cast<std::size_t>(n));
        }
        return 0;
    }

private:
    int descriptor_;
};

/// While a pipe is written to, a reader that went away is an error like any other and not our death.
class NoBrokenPipe {
public:
    NoBrokenPipe() : before_(std::signal(SIGPIPE, SIG_IGN)) {}
    NoBrokenPipe(const NoBrokenPipe&) = delete;
    NoBrokenPipe& operator=(const NoBrokenPipe&) = delete;
    ~NoBrokenPipe() { std::signal(SIGPIPE, before_); }

private:
    void (*before_)(int);
};

/// The descriptor that /dev/stdout, /dev/fd/N and their like stand for: what it holds already is not to be cut off.
std::optional<int> inherited_descriptor(const fs::path& path)
{
    const std::string folder = path.parent_path().string(), name = path.filename().string();
    if (folder != "/proc/self/fd" && folder != "/dev/fd" && folder != fmt::format("/proc/{}/fd", ::getpid())) return std::nullopt;
    int number = -1;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), number);
    return error == std::errc() && end == name.data() + name.size() ? std::optional(number) : std::nullopt;
}

/// Where the links of a path lead in the end, whether or not that is there.
fs::path target_of(fs::path path)
{
    std::error_code error;
    for (int k = 0; k < most_links && !inherited_descriptor(path) && fs::is_symlink(path, error); ++k) {
        const fs::path to = fs::read_symlink(path, error);
        if (error) break;
        path = to.is_absolute() ? to : path.parent_path() / to;
    }
    return path;
}

/// A device or a pipe.
void write_through(const fs::path& path, const fs::path& named, const std::string& bytes)
{
    const NoBrokenPipe quiet;
    File file(::open(path.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
    if (!file.open()) throw not_written(named, errno);
    if (const int error = file.write(bytes)) throw not_written(named, error);
    if (const int error = file.close()) throw not_written(named, error);
}

/// A plain file that no other can replace.
void write_in_place(const fs::path& path, const fs::path& named, const std::string& bytes, const struct stat& before)
{
    File file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (!file.open()) throw not_written(named, errno);
    const auto size = static_cast<off_t>(bytes.size());
    const int no_room = size > before.st_size ? ::posix_fallocate(file.get(), 0, size) : 0;
    if (no_room == ENOSPC || no_room == EDQUOT || no_room == EFBIG) {
        (void)!::ftruncate(file.get(), before.st_size); // of what was asked for, a part may be there
        throw not_written(named, no_room);
    }
    if (const int error = file.write(bytes)) throw not_written(named, error);
    if (::ftruncate(file.get(), size) != 0) throw not_written(named, errno);
    if (const int error = file.close()) throw not_written(named, error);
}

void write_to_descriptor(int descriptor, const fs::path& named, const std::string& bytes)
{
    const NoBrokenPipe quiet;
    flush_output(); // what was printed before comes before
    File file(::dup(descriptor));
    if (!file.open()) throw not_written(named, errno);
    if (const int error = file.write(bytes)) throw not_written(named, error);
}

/// A file that was not there, beside `path`; or -1. In containers every run may have the same process number, and so a name that a dead or
/// a distant writer has taken is passed by: to remove it would take it from under one that lives.
int open_temporary(const fs::path& path, mode_t mode, fs::path& temporary)
{
    for (int k = 0;; ++k) {
        temporary = path.string() + fmt::format(".tmp{}-{}", ::getpid(), k);
        const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
        if (descriptor >= 0 || errno != EEXIST || k == most_leftovers) return descriptor;
    }
}

/// A new file in place of the old, with the old one's mode and owner: false if the folder does not let us.
bool replace(const fs::path& path, const fs::path& named, const std::string& bytes, const struct stat* before)
{
    const mode_t mode = before != nullptr ? before->st_mode & permissions : 0666;
    fs::path temporary;
    File file(open_temporary(path, mode, temporary));
    if (!file.open()) {
        if (before != nullptr && (errno == EACCES || errno == EPERM || errno == EROFS)) return false;
        throw not_written(named, errno);
    }
    const auto give_up = [&](int error) {
        ::unlink(temporary.c_str());
        return not_written(named, error);
    };
    if (before != nullptr) {
        const bool ours = before->st_uid == ::geteuid() && before->st_gid == ::getegid();
        if (!ours && ::fchown(file.get(), before->st_uid, before->st_gid) != 0) { // somebody else's: only its contents are ours to change
            ::unlink(temporary.c_str());
            return false;
        }
        if (::fchmod(file.get(), mode) != 0) throw give_up(errno); // the umask has no say in a mode that was there before
    }
    if (const int error = file.write(bytes)) throw give_up(error);
    if (const int error = file.close()) throw give_up(error);
    if (::rename(temporary.c_str(), path.c_str()) == 0) return true;
    const int error = errno;
    if (before == nullptr || error != EBUSY) throw give_up(error);
    ::unlink(temporary.c_str()); // a file mounted by itself, as containers have them
    return false;
}

int first_output_error = 0;

} // namespace

void remark(const std::string& text) { (void)std::fwrite(text.data(), 1, text.size(), stderr); }

void flush_output()
{
    if (std::fflush(stdout) != 0 && first_output_error == 0) first_output_error = errno;
}

int output_error() { return first_output_error != 0 ? first_output_error : std::ferror(stdout) != 0 ? EIO : 0; }

void write_file(const fs::path& named, const std::string& bytes)
{
    const fs::path path = target_of(named);
    if (const auto descriptor = inherited_descriptor(path)) return write_to_descriptor(*descriptor, named, bytes);
    struct stat before{};
    const bool exists = ::stat(path.c_str(), &before) == 0;
    if (!exists && errno != ENOENT) throw not_written(named, errno);
    if (exists && S_ISDIR(before.st_mode)) throw not_written(named, EISDIR);
    if (exists && ::access(path.c_str(), W_OK) != 0) throw not_written(named, errno);
    if (exists && !S_ISREG(before.st_mode)) return write_through(path, named, bytes);
    if (!replace(path, named, bytes, exists ? &before : nullptr)) write_in_place(path, named, bytes, before);
}

void require_plain_inside(const fs::path& folder, const std::string& name)
{
    std::error_code error;
    const fs::path path = folder / name;
    if (fs::is_symlink(path, error)) {
        const fs::path here = fs::canonical(folder.empty() ? "." : folder, error);
        const fs::path there = fs::canonical(path, error); // an error: there is nothing yet where it leads
        if (error || there.parent_path() != here)
            throw Failure(cannot_write, fmt::format("cannot write {}: it is a link that leads out of the folder", path.string()));
    }
    const fs::file_status status = fs::status(path, error);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Failure(cannot_write, fmt::format("cannot write {}: it is no plain file", path.string()));
}

void write_into_folder(const fs::path& folder, const std::string& name, const std::string& bytes)
{
    require_plain_inside(folder, name);
    write_file(folder / name, bytes);
}

FolderLock::FolderLock(const fs::path& folder) : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
    while (descriptor_ >= 0 && ::flock(descriptor_, LOCK_EX) != 0 && errno == EINTR) {}
}

FolderLock::~FolderLock()
{
    if (descriptor_ >= 0) ::close(descriptor_);
}

std::string read_file(const fs::path& path)
{
    const auto unreadable = [&](int error) {
        const bool missing = error == ENOENT || error == ENOTDIR;
        return Failure(missing ? no_input_file : bad_input, missing
                                                                ? fmt::format("no such file: {}", path.string())
                                                                : fmt::format("cannot read {}: {}", path.string(), std::strerror(error)));
    };
    const File file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (!file.open()) throw unreadable(errno);
    std::string bytes;
    for (std::string buffer(std::size_t{1} << 16, '\0');;) {
        const ssize_t n = ::read(file.get(), buffer.data(), buffer.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) throw unreadable(errno);
        if (n == 0) return bytes;
        bytes.append(buffer, 0, static_cast<std::size_t>(n));
        if (bytes.size() > longest_file)
            throw Failure(bad_input, fmt::format("{}: longer than {} bytes, which no file of ours is", path.string(), longest_file));
    }
}

std::string reference_folder()
{
    std::error_code error;
    const fs::path program = fs::read_symlink("/proc/self/exe", error).parent_path();
    for (const fs::path& folder : {program / "../share/touchstone/reference", program / "data/reference", program / "../data/reference",
                                   program / "../../data/reference"})
        if (fs::is_directory(folder, error)) return folder.string();
    return "";
}

} // namespace touchstone::program
