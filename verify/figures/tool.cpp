// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/figures/tool.hpp"

#include "verify/exit_codes.hpp"
#include "verify/files.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>

extern char** environ;

namespace touchstone::figures {
namespace {

namespace fs = std::filesystem;
using program::Failure;

/// A folder of our own that goes when we do.
class Scratch {
public:
    Scratch()
    {
        std::string name = (fs::temp_directory_path() / "touchstone-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr)
            throw Failure(program::cannot_write, fmt::format("cannot make a folder in {}", fs::temp_directory_path().string()));
        path_ = name;
    }
    ~Scratch()
    {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    Scratch(const Scratch&) = delete;
    Scratch& operator=(const Scratch&) = delete;
    fs::path file(const char* name) const { return path_ / name; }

private:
    fs::path path_;
};

} // namespace

std::optional<ToolAnswer> run_tool(const std::vector<std::string>& command, const std::string& input)
{
    const Scratch scratch; // files, not pipes: neither side can wait for the other
    const fs::path in = scratch.file("in"), out = scratch.file("out"), err = scratch.file("err");
    program::write_file(in, input);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, in.c_str(), O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    std::vector<std::string> words = command;
    std::vector<char*> arguments;
    for (std::string& w : words) arguments.push_back(w.data());
    arguments.push_back(nullptr);
    pid_t child = 0;
    const int refused = ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    if (refused != 0) return std::nullopt;
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    if (WIFEXITED(status) && WEXITSTATUS(status) == 127) return std::nullopt;
    return ToolAnswer{WIFEXITED(status) && WEXITSTATUS(status) == 0, program::read_file(out), program::read_file(err)};
}

} // namespace touchstone::figures
