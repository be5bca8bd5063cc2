// Gradescope's results.json (gradescope-autograders.readthedocs.io, "Autograder Specifications").
#include "common/grading/formats/formats.hpp"
#include "common/grading/formats/parts.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rt {

using Json = nlohmann::ordered_json;

namespace {

/// As text; with a picture it takes HTML.
void add_output(Json& test, const GradedStep& step) {
    const std::string text = points_line(step) + "\n" + explained(step);
    if (step.difference.empty()) {
        test["output"] = text;
        test["output_format"] = "text";
        return;
    }
    test["output"] = fmt::format("<pre>{}</pre><img src=\"{}\" alt=\"the difference between both pictures\">",
                                 escaped_markup(text), data_url(step.difference));
    test["output_format"] = "html";
}

}  // namespace

std::string gradescope(const ShownGrade& shown) {
    const std::string visibility = shown.marks_from ? "after_published" : "visible";
    Json tests = Json::array();
    for (const GradedStep& step : shown.grade.steps) {
        Json test = {{"score", number_of(step.earned)},
                     {"max_score", number_of(counted_possible(step))},
                     {"status", step.verdict == Verdict::Passed ? "passed" : "failed"},
                     {"name", step.title},
                     {"number", step.id}};
        add_output(test, step);
        test["tags"] = {"chapter " + chapter_of(step)};
        test["visibility"] = visibility;
        tests.push_back(test);
    }
    // Without a score of its own the sum of the tests' counts, which is the points earned.
    const Json result = {{"execution_time", shown.grade.seconds},
                         {"output", "isolation: " + printable(shown.grade.isolation)},
                         {"output_format", "text"},
                         {"visibility", visibility},
                         {"stdout_visibility", "hidden"},
                         {"extra_data", {{"digest", shown.grade.digest}}},
                         {"tests", tests}};
    return json_text(result, 1) + "\n";
}

}  // namespace rt
