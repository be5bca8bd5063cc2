// `course references --random`: random scenes, by POV-Ray and by us.
#include "common/evidence/random_references.hpp"
#include "common/commands/commands.hpp"
#include "common/math/counted.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

namespace {

struct Counts {
    long long equal = 0, refused = 0, differ = 0;
};

Counts count(const std::vector<RandomFinding>& findings) {
    Counts counts;
    for (const RandomFinding& finding : findings)
        ++(finding.state == RandomFinding::Equal     ? counts.equal
           : finding.state == RandomFinding::Refused ? counts.refused
                                                     : counts.differ);
    return counts;
}

void print_json(const std::vector<RandomFinding>& findings, const Counts& counts, std::uint64_t first) {
    ordered_json json = {{"equal", counts.equal}, {"refused", counts.refused}, {"differ", counts.differ}};
    json["scenes"] = ordered_json::array();
    for (std::size_t i = 0; i < findings.size(); ++i)
        if (findings[i].state != RandomFinding::Equal)
            json["scenes"].push_back({{"number", first + i},
                                      {"refused", findings[i].state == RandomFinding::Refused},
                                      {"why", findings[i].why}});
    fmt::print("{}\n", json_text(json, 2));
}

}  // namespace

int run_random_references(const RandomReferencesCommand& command, const Project& project) {
    const fs::path directory = project.build / "references" / "random";
    fs::create_directories(directory);
    std::vector<RandomFinding> findings;
    {
        Progress progress("random scenes", !command.json);
        findings = check_random_scenes(command.first, command.count, directory,
                                       [&](double fraction) { progress.update(fraction); });
    }
    const Counts counts = count(findings);
    if (command.json) {
        print_json(findings, counts, command.first);
    } else {
        for (std::size_t i = 0; i < findings.size(); ++i)
            if (findings[i].state == RandomFinding::Differs)
                fmt::print("{} {}\n",
                           relative(project, directory / fmt::format("{}.scene", command.first + i)),
                           paint("differs: " + findings[i].why, Tone::Bad));
        fmt::print("{}: {} equal, {} refused, {} differ\n", counted(findings.size(), "random scene"),
                   counts.equal, counts.refused, counts.differ);
    }
    return counts.differ > 0 || counts.refused > counts.equal ? 1 : 0;
}

}  // namespace rt
