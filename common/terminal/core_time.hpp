// What a process gets of the machine, so that limits on time do not depend on what else runs there.
#pragma once

#include <sys/types.h>

namespace rt {

struct CoreTime {
    double running = 0;  ///< seconds for which it ran
    double waiting = 0;  ///< seconds for which it could have run, and others did
};

/// Of a process since it was started; of one with several threads, its first one's. All 0 where that is not
/// known.
CoreTime core_time(pid_t process);

}  // namespace rt
