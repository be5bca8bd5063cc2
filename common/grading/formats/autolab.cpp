// The last two lines of an Autolab autograder's output (its documentation, "Formatted Feedback").
#include "common/grading/formats/formats.hpp"
#include "common/grading/formats/parts.hpp"
#include "common/terminal/json_text.hpp"

#include <nlohmann/json.hpp>

namespace rt {

using Json = nlohmann::ordered_json;

std::string autolab(const ShownGrade& shown) {
    require_shown(shown);
    Json feedback = {{"_presentation", "semantic"}, {"stages", Json::array()}};
    Json scores = Json::object();
    for (const GradedStep& step : shown.grade.steps) {
        const std::string stage = "Chapter " + chapter_of(step);
        if (!feedback.contains(stage)) {
            feedback["stages"].push_back(stage);
            feedback[stage] = Json::object();
        }
        Json& test = feedback[stage][name_of(step)];
        test["passed"] = step.verdict == Verdict::Passed;
        if (step.verdict != Verdict::Passed) test["hint"] = points_line(step) + "\n" + explained(step);
        scores[step.id] = number_of(step.earned);
    }
    return json_text(feedback) + "\n" + json_text(Json{{"scores", scores}}) + "\n";
}

}  // namespace rt
