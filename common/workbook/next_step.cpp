// Which step comes next.
#include "common/workbook/next_step.hpp"

#include <algorithm>

namespace rt {
namespace {

/// The first from step number `first` on, round to the one before it.
std::optional<Target> next_in(const Chapter& chapter, const KnownResult& known, std::size_t first) {
    const std::size_t count = chapter.steps.size();
    for (std::size_t i = 0; i < count; ++i) {
        const Step& step = chapter.steps[(first + i) % count];
        if (step.optional && i > 0) continue;
        const auto result = std::ranges::find(known.result.steps, step.id, &StepResult::id);
        if (!known.current || result == known.result.steps.end() || result->state != State::Passed)
            return Target{&chapter, &step};
    }
    return std::nullopt;
}

}  // namespace

std::optional<Target> next_step(const std::vector<Chapter>& chapters, const std::vector<KnownResult>& known,
                                const Target& from) {
    const auto start = static_cast<std::size_t>(from.chapter - chapters.data());
    for (std::size_t i = 0; i < chapters.size(); ++i) {
        const std::size_t number = (start + i) % chapters.size();
        const bool here = i == 0 && from.step;
        const auto first = here ? static_cast<std::size_t>(from.step - from.chapter->steps.data()) : 0;
        if (const auto next = next_in(chapters[number], known[number], first)) return next;
    }
    return std::nullopt;
}

}  // namespace rt
