// SPDX-License-Identifier: MIT
/// \file
/// A process between the judge and the code it judges, to which every process that the code starts comes back.
///
/// A code may leave its process group and its session, and its children may outlive it: no signal to a group reaches them then. The kernel
/// hands whoever is orphaned to the nearest ancestor that has asked for them (PR_SET_CHILD_SUBREAPER), so that one that starts nothing but
/// the code may end all its children, whoever they are. The judge itself must not: it may have had children before, of its caller's or
/// from a shell that became it.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <functional>
#include <utility>

namespace touchstone::oracle {

/// An open file, closed when done with.
class Descriptor {
public:
    explicit Descriptor(int fd = -1) : fd_(fd) {}
    Descriptor(Descriptor&& o) noexcept : fd_(std::exchange(o.fd_, -1)) {}
    Descriptor& operator=(Descriptor&& o) noexcept { std::swap(fd_, o.fd_); return *this; }
    ~Descriptor() { close(); }
    int get() const { return fd_; }
    bool open() const { return fd_ >= 0; }
    void close();

private:
    int fd_;
};

struct Pipe {
    Descriptor read, write;
    Pipe(); ///< \throws std::runtime_error
};

/// A code that runs under a supervisor; it and all that it has started are gone when this is. When the judge is killed they are too.
class Supervised {
public:
    /// \param start called in the supervisor: the number of the process it has started, or less than 0: the error, negative
    explicit Supervised(const std::function<pid_t()>& start);
    Supervised(const Supervised&) = delete;
    Supervised& operator=(const Supervised&) = delete;
    ~Supervised() { end(); }

    int error() const { return error_; }            ///< for which it could not be started; 0: it was
    int word() const { return ended_ ? -1 : word_.get(); } ///< to be polled: something to read once the code has ended; -1 after that
    bool ended();                                   ///< the code itself; what it has started may live on
    bool watched() const { return ended_ || word_.open(); } ///< false: the supervisor is gone, and how the code ends will not be known
    int status() const { return status_; }          ///< as waitpid() has it, once it has ended
    std::size_t resident() const;                   ///< bytes of memory that the code and all that it has started hold
    bool end();                                     ///< kills them all; false: some could not be ended

private:
    bool hear();
    Descriptor word_;
    pid_t supervisor_ = -1, subject_ = 0;
    int error_ = 0, status_ = 0;
    bool ended_ = false, all_gone_ = true;
};

} // namespace touchstone::oracle
