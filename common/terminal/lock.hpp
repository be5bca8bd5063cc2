// Several of this program at once: who has to wait for whom, and what each one has to itself.
#pragma once

#include "common/terminal/project.hpp"

#include <filesystem>
#include <string>

namespace rt {

/// Keeps other processes of the course out while it lives. They are kept out of what `file` stands for, an
/// empty file that is made for this; the system lets go of it when the process ends, in whichever way.
struct Lock {
    /// Waits until nobody else has the lock, and says once on standard error what is waited for. `doing` is
    /// what others are told that wait for this one, such as "Building chapter 02". Where the file system
    /// knows no locks there is none.
    Lock(const std::filesystem::path& file, const std::string& doing);
    ~Lock();
    Lock(const Lock&) = delete;
    Lock& operator=(const Lock&) = delete;

private:
    int descriptor = -1;
};

/// What must be locked to build: ninja takes two builds of one directory at once for one, and both fail. The
/// script `course` locks the same file while it builds this program.
std::filesystem::path build_lock(const Project& project);

/// What must be locked to change what is remembered in .course/.
std::filesystem::path memory_lock(const Project& project);

/// Closes the build's lock, which the script `course` hands on so that no other build replaces the program at
/// the very moment when it starts.
void close_inherited_lock();

/// A directory of the build for this process alone: for reports, and for the programs that it has built,
/// which another process may build anew while they run. It is made when it is first asked for and removed at
/// the end of the process; what a killed one left is removed by the next.
std::filesystem::path own_directory(const Project& project);

/// Keeps a program that was just built as it is, for this process: from now on program() finds that one. The
/// build's lock must be held.
void keep_program(const Project& project, const std::string& name);

}  // namespace rt
