// What GitHub Classroom's reporter reads: an output a runner, JSON in base64 (its README, "Autograding
// Reporter").
#include "common/grading/formats/formats.hpp"
#include "common/grading/formats/parts.hpp"
#include "common/terminal/base64.hpp"
#include "common/terminal/json_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>

namespace rt {

using Json = nlohmann::ordered_json;

namespace {

std::string status_of(Verdict verdict) {
    return verdict == Verdict::Passed ? "pass" : is_error(verdict) ? "error" : "fail";
}

Json runner(const std::vector<const GradedStep*>& steps) {
    Json tests = Json::array();
    Points possible;
    std::string status = "pass";
    for (const GradedStep* step : steps) {
        possible += counted_possible(*step);
        const std::string own = status_of(step->verdict);
        if (own == "error" || status == "pass") status = own;
        tests.push_back({{"name", name_of(*step)},
                         {"status", own},
                         {"score", number_of(step->earned)},
                         {"message", explained(*step)},
                         {"test_code", "./course check " + step->id},
                         {"filename", step->file},
                         {"line_no", 0},
                         {"execution_time", 0}});
    }
    return {{"version", 1}, {"status", status}, {"max_score", number_of(possible)}, {"tests", tests}};
}

}  // namespace

std::string github_classroom(const ShownGrade& shown) {
    require_shown(shown);
    std::map<std::string, std::vector<const GradedStep*>> chapters;
    for (const GradedStep& step : shown.grade.steps) chapters["chapter-" + chapter_of(step)].push_back(&step);
    std::string names, lines;
    for (const auto& [name, steps] : chapters) {
        names += (names.empty() ? "" : ",") + name;
        lines += name + "=" + base64(json_text(runner(steps))) + "\n";
    }
    return "runners=" + names + "\n" + lines;
}

}  // namespace rt
