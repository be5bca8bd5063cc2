// Failures that may only follow from others: of steps that use a step that is wrong.
#include "common/workbook/causes.hpp"

#include "common/workbook/solutions.hpp"

namespace rt {

namespace {

const Step* find(const std::vector<Chapter>& chapters, const std::string& id) {
    for (const Chapter& chapter : chapters)
        for (const Step& step : chapter.steps)
            if (step.id == id) return &step;
    return nullptr;
}

/// All that the step uses, also through others.
std::set<std::string> all_used(const std::vector<Chapter>& chapters, const std::string& id) {
    std::set<std::string> used;
    std::vector<std::string> open{id};
    while (!open.empty()) {
        const Step* step = find(chapters, open.back());
        open.pop_back();
        if (!step) continue;  // of a chapter that was not handed out
        for (const std::string& other : step->uses)
            if (used.insert(other).second) open.push_back(other);
    }
    return used;
}

void add_failed(const ChapterResult& result, std::set<std::string>& failed) {
    for (const StepResult& step : result.steps)
        if (step.state == State::Failed) failed.insert(step.id);
}

}  // namespace

void find_causes(const std::vector<Chapter>& chapters, const std::set<std::string>& failed_before,
                 ChapterResult& result) {
    if (!result.build_error.empty()) return;  // that is the cause of all
    std::set<std::string> failed = failed_before;
    add_failed(result, failed);
    for (StepResult& step : result.steps) {
        if (step.state != State::Failed) continue;
        const std::set<std::string> used = all_used(chapters, step.id);
        for (const Chapter& chapter : chapters)
            for (const Step& cause : chapter.steps)
                if (step.because.empty() && used.contains(cause.id) && failed.contains(cause.id))
                    step.because = cause.id;
    }
}

std::set<std::string> failed_before(const Project& project, const std::vector<Chapter>& chapters,
                                    const Chapter& chapter) {
    std::set<std::string> failed;
    if (has_solutions(project)) return failed;
    for (const Chapter& earlier : chapters) {
        if (earlier.number >= chapter.number) continue;
        const KnownResult known = known_result(project, earlier);
        if (known.current) add_failed(known.result, failed);
    }
    return failed;
}

}  // namespace rt
