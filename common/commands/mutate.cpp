// `course mutate`: how well the tests notice small changes of the solutions.
#include "common/commands/commands.hpp"
#include "common/evidence/mutation.hpp"
#include "common/math/counted.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <system_error>

namespace rt {

using nlohmann::ordered_json;

namespace {

/// The chapters to try in the course's order, each with its steps or none for all.
struct Choice {
    const Chapter* chapter = nullptr;
    std::vector<std::string> steps;
};

std::vector<Choice> chosen(const std::vector<Chapter>& chapters, const std::vector<std::string>& targets) {
    std::map<const Chapter*, std::vector<std::string>> steps;
    std::map<const Chapter*, bool> whole;
    for (const std::string& text : targets) {
        const Target target = find_target(chapters, text);
        std::vector<std::string>& of_chapter = steps[target.chapter];
        if (target.step)
            of_chapter.push_back(target.step->id);
        else
            whole[target.chapter] = true;
    }
    std::vector<Choice> choices;
    for (const Chapter& chapter : chapters)
        if (targets.empty() || whole[&chapter])
            choices.push_back({&chapter, {}});
        else if (steps.contains(&chapter))
            choices.push_back({&chapter, steps[&chapter]});
    return choices;
}

std::string place_of(const Chapter& chapter, const TriedMutant& one) {
    return fmt::format("solutions/{}/{}:{}", chapter.name, one.file, one.mutant.line);
}

/// Whether it could be written, the end of the program tells.
void print_survivor(const Chapter& chapter, const TriedMutant& one) {
    try {
        fmt::print("{}  step {}\n  {} {}\n  {} {}\n", place_of(chapter, one), one.mutant.step,
                   paint("-", Tone::Good), one.mutant.from, paint("+", Tone::Bad), one.mutant.to);
        flush_output();
    } catch (const std::system_error&) {
    }
}

void print_table(const std::vector<Mutation>& mutations) {
    fmt::print("\n{:24} {:>7} {:>13} {:>10} {:>8} {:>7}\n", "chapter", "caught", "by other step",
               "equivalent", "survived", "score");
    for (const Mutation& mutation : mutations)
        fmt::print("{:24} {:7} {:13} {:10} {:8} {:5.1f} %\n", mutation.chapter->name,
                   mutation.count(Fate::Caught), mutation.count(Fate::CaughtLater), mutation.equivalent(),
                   mutation.count(Fate::Survived), 100 * mutation.score());
}

ordered_json to_json(const Mutation& mutation) {
    auto survived = ordered_json::array();
    for (const TriedMutant* one : mutation.survivors())
        survived.push_back({{"step", one->mutant.step},
                            {"place", place_of(*mutation.chapter, *one)},
                            {"from", one->mutant.from},
                            {"to", one->mutant.to}});
    return {{"id", mutation.chapter->name},
            {"caught", mutation.count(Fate::Caught)},
            {"caught_by_other_step", mutation.count(Fate::CaughtLater)},
            {"not_compiled", mutation.count(Fate::NotCompiled)},
            {"equivalent", mutation.equivalent()},
            {"score", mutation.score()},
            {"survived", survived},
            {"stale", mutation.stale}};
}

}  // namespace

int run_mutate(const MutateCommand& command) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    std::vector<Mutation> mutations;
    for (const Choice& choice : chosen(chapters, command.targets)) {
        mutations.push_back(
            try_mutants(project, *choice.chapter, choice.steps, command.sample, [&](const TriedMutant& one) {
                if (!command.json) print_survivor(*choice.chapter, one);
            }));
        if (command.json) continue;
        for (const std::string& line : mutations.back().stale) fmt::print("{}\n", line);
    }
    if (command.json) {
        auto list = ordered_json::array();
        for (const Mutation& mutation : mutations) list.push_back(to_json(mutation));
        fmt::print("{}\n", json_text(ordered_json{{"chapters", list}}));
    } else {
        print_table(mutations);
    }
    const bool good = std::all_of(mutations.begin(), mutations.end(), [](const Mutation& mutation) {
        return mutation.survivors().empty() && mutation.stale.empty();
    });
    return good ? 0 : 1;
}

}  // namespace rt
