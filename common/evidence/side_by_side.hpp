// Independent jobs on all cores.
#pragma once

#include <cstddef>
#include <functional>

namespace rt {

/// Calls use(0) … use(count − 1), each once and begun in this order, as many at once as there are cores. What
/// they throw ends the program.
void side_by_side(std::size_t count, const std::function<void(std::size_t)>& use);

}  // namespace rt
