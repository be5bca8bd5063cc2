// The levels of isolation: their names, which of them this machine can do, and what each leaves open.
#pragma once

#include "common/sandbox/sandbox.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// "bwrap", "user", "none", from the most to the least.
std::string_view name_of(Isolation isolation);

/// The level of a name. Throws InputError that lists the names.
Isolation isolation_named(std::string_view name);

struct Level {
    Isolation isolation;
    bool possible;
    std::string reason;  ///< why it is not possible, one line; empty if it is
};

/// Tries every level with a program that does nothing, from the most to the least. Takes some 0.1 s.
std::vector<Level> probe();

/// Throws InputError, with the reason and with what would be possible, unless a box can be had at this level.
void require_possible(Isolation isolation);

/// What a box of this level leaves open on this machine, a phrase each: "see all processes".
std::vector<std::string> open_at(Isolation isolation);

}  // namespace rt
