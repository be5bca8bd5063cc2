// System calls that no program in a box needs, and that would let it out of a limit or at another process.
#pragma once

namespace rt {

/// Refuses them to this process and to all that it becomes. Needs no_new_privs. False, with errno, if that
/// failed.
bool refuse_system_calls();

/// The same filter as a program for `bwrap --seccomp`, in a file without a name; negative, with errno, if it
/// could not be made.
int system_call_filter();

}  // namespace rt
