// One box from its start to its end.
#pragma once

#include "common/sandbox/message.hpp"

namespace rt {

/// Starts the program, watches it, ends all its processes and says how it was. It is stopped when the other
/// side of the socket `control` is closed. Whatever keeps it from starting is an exception. Once a process.
Ending supervise(const Request& request, int control);

}  // namespace rt
