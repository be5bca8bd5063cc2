// PrairieLearn's results.json (its documentation, "External grading").
#include "common/grading/formats/formats.hpp"
#include "common/grading/formats/parts.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/json_text.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {

using Json = nlohmann::ordered_json;

namespace {

Json tests_of(const Grade& grade) {
    Json tests = Json::array();
    for (const GradedStep& step : grade.steps) {
        Json images = Json::array();
        if (!step.difference.empty())
            images.push_back({{"label", "difference"}, {"url", data_url(step.difference)}});
        tests.push_back({{"name", name_of(step)},
                         {"description", verdict_line(step)},
                         {"points", number_of(step.earned)},
                         {"max_points", number_of(counted_possible(step))},
                         {"message", points_line(step)},
                         {"output", explained(step)},
                         {"images", images}});
    }
    return tests;
}

/// What does not compile, or what kept the whole submission from being taken; each once.
std::vector<std::string> format_errors(const Grade& grade) {
    std::vector<std::string> errors;
    for (const GradedStep& step : grade.steps) {
        const bool whole = step.verdict == Verdict::NotTaken;
        if ((step.verdict != Verdict::NotCompiled && !whole) || !step.failure) continue;
        const std::string error =
            (whole ? "" : step.file + ": ") + printable(step.failure->said.substr(0, 1000), Keep::Lines);
        if (std::find(errors.begin(), errors.end(), error) == errors.end()) errors.push_back(error);
    }
    return errors;
}

/// The test where this is longest: the url of its picture, or its output.
Json* longest(Json& tests, bool picture) {
    Json* found = nullptr;
    for (Json& test : tests) {
        if (picture && test["images"].empty()) continue;
        Json& text = picture ? test["images"][0]["url"] : test["output"];
        const auto size = [](const Json& json) { return json.get_ref<const std::string&>().size(); };
        if (!found || size(text) > size(picture ? (*found)["images"][0]["url"] : (*found)["output"]))
            found = &test;
    }
    return found;
}

/// Makes it short enough; what is left out is said.
void shorten(Json& result) {
    while (json_text(result).size() >= most_prairielearn) {
        if (Json* test = longest(result["tests"], true)) {
            (*test)["images"] = Json::array();
            (*test)["message"] =
                (*test)["message"].get<std::string>() + "; the difference picture is left out";
        } else if (Json* longer = longest(result["tests"], false); longer && (*longer)["output"] != "") {
            (*longer)["output"] = "";
        } else {
            return;
        }
    }
}

}  // namespace

std::string prairielearn(const ShownGrade& shown) {
    require_shown(shown);
    const Grade& grade = shown.grade;
    const std::vector<std::string> errors = format_errors(grade);
    const Points most = possible(grade), own = earned(grade);
    const double score =
        most.hundredths == 0 ? 0 : static_cast<double>(own.hundredths) / static_cast<double>(most.hundredths);
    Json result = {{"gradable", errors.empty() || own.hundredths > 0},
                   {"score", std::min(score, 1.0)},
                   {"message", of_points(own, most)},
                   {"output", "isolation: " + printable(grade.isolation)},
                   {"format_errors", errors},
                   {"images", Json::array()},
                   {"tests", tests_of(grade)}};
    shorten(result);
    return json_text(result) + "\n";
}

}  // namespace rt
