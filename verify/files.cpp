// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/files.hpp"

#include "verify/exit_codes.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <sstream>

namespace touchstone::program {

void write_file(const std::filesystem::path& path, const std::string& bytes)
{
    const std::filesystem::path temporary = path.string() + fmt::format(".tmp{}", ::getpid());
    {
        std::ofstream out(temporary, std::ios::binary);
        out << bytes;
        out.close();
        if (!out) {
            std::error_code ignored;
            std::filesystem::remove(temporary, ignored);
            throw Failure(cannot_write, fmt::format("cannot write {}", path.string()));
        }
    }
    std::error_code error;
    std::filesystem::rename(temporary, path, error);
    if (error) {
        std::filesystem::remove(temporary, error);
        throw Failure(cannot_write, fmt::format("cannot write {}", path.string()));
    }
}

std::string read_file(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    if (!in) throw Failure(no_input_file, fmt::format("no such file: {}", path.string()));
    return std::move(bytes).str();
}

} // namespace touchstone::program
