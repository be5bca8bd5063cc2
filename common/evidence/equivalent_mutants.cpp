// Mutants that are right, too: no test can notice them, and nobody has to look at them again.
#include "common/evidence/equivalent_mutants.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/workbook/exercise.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

namespace {

/// A line `key value`, the blanks between them dropped.
struct KeyedLine {
    std::string key, value;
};

KeyedLine keyed(const std::string& line) {
    const auto end = line.find(' ');
    if (end == std::string::npos) return {line, ""};
    const auto begin = line.find_first_not_of(' ', end);
    return {line.substr(0, end), begin == std::string::npos ? "" : line.substr(begin)};
}

}  // namespace

std::vector<EquivalentMutant> parse_equivalent(std::string_view text, const std::string& name) {
    std::vector<EquivalentMutant> entries, open;  // open: those that have no reason yet
    EquivalentMutant next;
    const std::vector<std::string> lines = split_lines(text);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const int number = static_cast<int>(i) + 1;
        const auto [key, value] = keyed(lines[i]);
        if (key.empty() || key == "#") continue;
        if (value.empty()) fail_at(name, number, "expected 'step', 'from', 'to' or 'why', and a text");
        if (key == "step") {
            if (!is_step_id(value)) fail_at(name, number, "expected 'step NN.S', such as 'step 02.1'");
            next.step = value;
        } else if (key == "from") {
            if (!open.empty()) fail_at(name, number, "the entry before has no 'why'");
            next.from = value;
        } else if (key == "to") {
            if (next.step.empty() || next.from.empty())
                fail_at(name, number, "'to' without a 'step' and a 'from' before it");
            open.push_back({next.step, next.from, value, "", number});
        } else if (key == "why") {
            if (open.empty()) fail_at(name, number, "'why' without a 'to' before it");
            for (EquivalentMutant& entry : open) entry.why = value;
            entries.insert(entries.end(), open.begin(), open.end());
            open.clear();
        } else {
            fail_at(name, number, "expected 'step', 'from', 'to' or 'why', not '" + key + "'");
        }
    }
    if (!open.empty()) fail_at(name, open.back().line, "the last entry has no 'why'");
    return entries;
}

std::string equivalent_list(const Chapter& chapter) {
    return "tests/" + chapter.name + "/variants/equivalent.mutants";
}

std::vector<EquivalentMutant> equivalent_mutants(const Project& project, const Chapter& chapter) {
    const std::string name = equivalent_list(chapter);
    if (!std::filesystem::exists(project.root / name)) return {};
    return parse_equivalent(read_file(project.root / name), name);
}

bool is_about(const EquivalentMutant& entry, const Mutant& mutant) {
    return entry.step == mutant.step && entry.from == mutant.from && entry.to == mutant.to;
}

std::vector<std::string> stale_entries(const std::vector<EquivalentMutant>& entries,
                                       const std::vector<Mutant>& mutants, const std::string& name) {
    std::vector<std::string> stale;
    for (const EquivalentMutant& entry : entries)
        if (std::none_of(mutants.begin(), mutants.end(),
                         [&](const Mutant& mutant) { return is_about(entry, mutant); }))
            stale.push_back(fmt::format("{}:{}: step {} has no mutant '{}' of '{}'", name, entry.line,
                                        entry.step, entry.to, entry.from));
    return stale;
}

}  // namespace rt
