// As whom the program in a box runs: under a uid that nobody else has, with no privilege.
#pragma once

#include "common/image/descriptor.hpp"

#include <sys/types.h>

#include <utility>

namespace rt {

/// A uid that no user, no process and no other box on this machine has, for as long as this lives: a uid is
/// what the kernel counts processes by, and what it asks before one process may touch another. Where this
/// process is not root it is its own.
class Identity {
public:
    /// Throws InputError where there is none.
    Identity();

    uid_t number() const { return number_; }
    bool own() const { return own_; }  ///< whether the box has it to itself

    /// For a child before its exec: gives up all privileges for good. False, with errno, if that failed.
    bool assume() const;

    /// Ends all processes of this uid at once, so that a fork bomb cannot get away. Only if it is the box's
    /// own.
    void kill_all() const;

private:
    explicit Identity(std::pair<uid_t, int> number_and_lock);

    uid_t number_;
    bool own_;
    Descriptor lock_;
};

}  // namespace rt
