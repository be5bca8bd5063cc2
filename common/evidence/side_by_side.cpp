// Independent jobs on all cores.
#include "common/evidence/side_by_side.hpp"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace rt {

void side_by_side(std::size_t count, const std::function<void(std::size_t)>& use) {
    std::atomic<std::size_t> next = 0;
    std::vector<std::jthread> threads;
    for (unsigned i = 0; i < std::max(1u, std::thread::hardware_concurrency()); ++i)
        threads.emplace_back([&] {
            for (std::size_t mine; (mine = next++) < count;) use(mine);
        });
}

}  // namespace rt
