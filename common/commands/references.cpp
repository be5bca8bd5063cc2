// `course references`: what POV-Ray makes of the reference scenes now, and what of it has changed.
#include "common/evidence/references.hpp"
#include "common/commands/commands.hpp"
#include "common/math/counted.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rt {

using nlohmann::ordered_json;

namespace {

struct Findings {
    std::vector<ReferenceFinding> scenes;
    std::vector<ThumbnailFinding> thumbnails;
    long long changed = 0, problems = 0;  ///< how many
};

Findings findings_of(const ReferencesCommand& command, const Project& project) {
    std::vector<Chapter> chapters = read_catalogue(project);
    if (!command.chapter.empty()) chapters = {find_chapter(chapters, command.chapter)};
    Findings findings;
    {
        Progress progress("references", !command.json && !command.quiet);
        findings.scenes = check_references(
            project, chapters, command.make,
            [&](double fraction, const std::string& scene) { progress.update(fraction, scene); });
    }
    for (const Chapter& chapter : chapters)
        if (const auto found = check_thumbnail(project, chapter, command.make))
            findings.thumbnails.push_back(*found);
    findings.problems = std::ranges::count_if(
        findings.scenes, [](const ReferenceFinding& scene) { return !scene.problem.empty(); });
    findings.changed = std::ranges::count_if(findings.scenes,
                                             [](const ReferenceFinding& scene) { return !is_same(scene); }) -
                       findings.problems +
                       std::ranges::count_if(findings.thumbnails, [](const ThumbnailFinding& thumbnail) {
                           return thumbnail.state != Kept::Same;
                       });
    return findings;
}

std::string describe(const ReferenceFinding& finding) {
    if (!finding.scene.why_none.empty()) return "no reference: " + finding.scene.why_none;
    if (!finding.problem.empty()) return finding.problem;
    if (is_same(finding)) return "same";
    std::vector<std::string> parts;
    if (finding.pov != Kept::Same) parts.push_back(fmt::format("scene for POV-Ray {}", name_of(finding.pov)));
    if (finding.picture == Kept::Missing) parts.push_back("picture missing");
    if (finding.picture == Kept::Changed)
        parts.push_back(fmt::format("picture changed in {} by up to {:.0f}/65535",
                                    counted(finding.changed_pixels, "pixel"), finding.greatest));
    return fmt::format("{}", fmt::join(parts, ", "));
}

void print_row(std::string_view chapter, std::string_view name, double seconds, double ours,
               std::string_view what, Tone tone) {
    const auto time = [](double s) { return s > 0 ? fmt::format("{:8.2f}", s) : std::string(8, ' '); };
    fmt::print("{:<16} {:<24} {} {}  {}\n", chapter, name, time(seconds), time(ours), paint(what, tone));
}

void print_table(const Findings& findings, bool make) {
    fmt::print("{}\n", paint(fmt::format("{:<41} {:>8} {:>8}  the picture by POV-Ray is",
                                         "seconds for the same pixels", "POV-Ray", "ours"),
                             Tone::Dim));
    const Tone tone = make ? Tone::Accent : Tone::Bad;
    for (const ReferenceFinding& f : findings.scenes)
        print_row(f.scene.chapter, f.scene.name, f.seconds, f.our_seconds, describe(f),
                  is_same(f)          ? Tone::Good
                  : f.problem.empty() ? tone
                                      : Tone::Bad);
    for (const ThumbnailFinding& t : findings.thumbnails)
        print_row(t.chapter, "thumbnail", 0, 0, name_of(t.state), t.state == Kept::Same ? Tone::Good : tone);
    if (findings.problems > 0) fmt::print("{} could not be checked\n", counted(findings.problems, "scene"));
    if (findings.changed == 0 && findings.problems == 0)
        fmt::print("all references are as POV-Ray makes them now\n");
    if (findings.changed > 0)
        fmt::print("{} {}\n", counted(findings.changed, "reference"),
                   make ? "written"
                        : "changed or missing; `course references --make` writes what POV-Ray makes now");
}

ordered_json to_json(const ReferenceFinding& finding) {
    ordered_json json = {{"chapter", finding.scene.chapter}, {"scene", finding.scene.name}};
    if (!finding.scene.why_none.empty()) {
        json["why_none"] = finding.scene.why_none;
    } else if (!finding.problem.empty()) {
        json["problem"] = finding.problem;
    } else {
        json["pov"] = name_of(finding.pov);
        json["picture"] = name_of(finding.picture);
        json["changed_pixels"] = finding.changed_pixels;
        json["greatest16"] = std::lround(finding.greatest);
        json["seconds"] = finding.seconds;
        json["our_seconds"] = finding.our_seconds;
    }
    return json;
}

void print_json(const Findings& findings, bool make) {
    ordered_json json = {{"scenes", ordered_json::array()}, {"thumbnails", ordered_json::object()}};
    for (const ReferenceFinding& finding : findings.scenes) json["scenes"].push_back(to_json(finding));
    for (const ThumbnailFinding& t : findings.thumbnails) json["thumbnails"][t.chapter] = name_of(t.state);
    json["changed"] = findings.changed;
    json["problems"] = findings.problems;
    json["written"] = make && findings.changed > 0;
    fmt::print("{}\n", json_text(json, 2));
}

}  // namespace

int run_references(const ReferencesCommand& command, const Project& project) {
    const Findings findings = findings_of(command, project);
    if (command.json)
        print_json(findings, command.make);
    else if (!command.quiet)
        print_table(findings, command.make);
    return findings.problems > 0 || (findings.changed > 0 && !command.make) ? 1 : 0;
}

}  // namespace rt
