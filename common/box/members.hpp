// The processes of a box as /proc tells of them, and what they use together.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <set>
#include <vector>

namespace rt {

/// All that descend from the supervisor: it is a subreaper, so none can leave its family. Who they are is
/// asked of their parents and not of their uid, because a process can make its files in /proc root's.
class Members {
public:
    struct Use {
        std::uint64_t memory = 0;  ///< bytes resident; pages that two share count twice
        double cpu_seconds = 0;    ///< of those alive and of the children that these have waited for
        std::vector<pid_t> alive;
    };

    /// What they use now. Takes some 0.2 ms: processes that are known as others' are not looked at for a
    /// second.
    Use look();

private:
    std::set<pid_t> others_;
    std::chrono::steady_clock::time_point forget_others_{};
};

}  // namespace rt
