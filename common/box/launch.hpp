// Starting a program in its box: everything that a child gives up before it becomes the program.
#pragma once

#include "common/box/capture.hpp"
#include "common/box/identity.hpp"
#include "common/box/stage.hpp"
#include "common/sandbox/message.hpp"

#include <sys/types.h>

namespace rt {

/// What the program's process is told, and where it reports.
struct Launch {
    const Request& request;
    const Identity& identity;
    const Stage& stage;
    const Capture &output, &errors;  ///< the program's
    const Capture& failure;          ///< why it could not be started; closed by the exec that succeeds
    const Capture& status;           ///< where bubblewrap says how it ended, if it was started
};

/// Returns the child: the program, or bubblewrap with the program in it. Throws std::system_error if there is
/// none.
pid_t launch(const Launch& launch);

}  // namespace rt
