// SPDX-License-Identifier: GPL-3.0-or-later
/// \file
/// Files read and written whole.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace touchstone::program {

/// What is read whole is no longer than this: an endless file is refused, not read until the memory is full.
inline constexpr std::size_t longest_file = std::size_t{256} << 20;

/// A plain file is the old one or the new one, never half (a temporary file beside it, then a rename), and keeps its mode and
/// owner; one with several names becomes a file of its own, and the other names keep what they had. Devices and pipes are written
/// through; a symbolic link stays one, and what it leads to is written; /dev/stdout and /dev/fd/N continue where they are.
/// A plain file that cannot be replaced (another's, in a folder that is not ours, or mounted by itself) is written in place, once there is
/// room for all of it: a full disk leaves the old one, a kill in that moment may leave a part of the new one.
/// \throws Failure (cannot_write) with the system's reason
void write_file(const std::filesystem::path&, const std::string& bytes);

/// Whoever names a folder has not named what lies in it, which may have come from anywhere.
/// \throws Failure (cannot_write) where folder/name is a link that leads out of the folder, or no plain file (a pipe, a device)
void require_plain_inside(const std::filesystem::path& folder, const std::string& name);

/// write_file for what has require_plain_inside
void write_into_folder(const std::filesystem::path& folder, const std::string& name, const std::string& bytes);

/// While it lives, no other one of that folder does, in this process or another. Where the file system has no locks, it has no effect.
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock();

private:
    int descriptor_;
};

/// To standard error, for a reader who may not be there: where it cannot be written, the work goes on all the same.
void remark(const std::string& text);

/// What is printed so far goes out. Why it cannot is kept, since work that goes on would be lost with it: output_error() says it at the end
/// (0: all is out).
void flush_output();
int output_error();

/// \throws Failure: no_input_file if there is none, bad_input with the system's reason if it cannot be read or has no end
std::string read_file(const std::filesystem::path&);

/// The stored tables that belong to this program; empty: there are none.
std::string reference_folder();

} // namespace touchstone::program
