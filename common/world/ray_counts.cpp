// How many rays each thread has traced.
#include "common/world/ray_counts.hpp"

namespace rt {

RayCounts& ray_counts() {
    thread_local RayCounts counts;
    return counts;
}

}  // namespace rt
