// Which step comes next.
#pragma once

#include "common/workbook/results.hpp"

#include <optional>

namespace rt {

/// The first step from `from` on that has not passed: of its own chapter, then of the later ones, then from
/// the beginning. Optional steps are passed over, but for `from` itself. Of a chapter that changed since it
/// was checked nothing is known. Nothing if all have passed. `known` is all chapters', in their order.
std::optional<Target> next_step(const std::vector<Chapter>& chapters, const std::vector<KnownResult>& known,
                                const Target& from);

}  // namespace rt
