// Classroom 50's result.json (its wiki, "Advanced Autograding").
#include "common/grading/formats/formats.hpp"
#include "common/grading/formats/parts.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/json_text.hpp"

#include <nlohmann/json.hpp>

namespace rt {

using Json = nlohmann::ordered_json;

namespace {

std::int64_t rounded(const Points& points) { return (points.hundredths + 50) / 100; }

}  // namespace

std::string classroom50(const ShownGrade& shown, const Classroom50Names& names) {
    require_shown(shown);
    std::int64_t score = 0, possible = 0;
    Json tests = Json::array();
    for (const GradedStep& step : shown.grade.steps) {
        const std::int64_t most = rounded(counted_possible(step));
        score += rounded(step.earned);
        possible += most;
        tests.push_back({{"test-name", name_of(step)},
                         {"passed", step.verdict == Verdict::Passed},
                         {"score", rounded(step.earned)},
                         {"max-score", most}});
    }
    const Json result = {{"schema", "classroom50/result/v1"},
                         {"classroom", printable(names.classroom)},
                         {"assignment", printable(names.assignment)},
                         {"submission", printable(shown.grade.submission)},
                         {"commit", printable(names.commit)},
                         {"release", printable(names.release)},
                         {"review", printable(names.review)},
                         {"datetime", text_of(shown.grade.graded)},
                         {"score", score},
                         {"max-score", possible},
                         {"tests", tests}};
    return json_text(result, 1) + "\n";
}

}  // namespace rt
