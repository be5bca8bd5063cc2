// Grades as JSON, the class's kept results: what is written is read back the same, whatever bytes it holds.
#include "common/grading/grade_json.hpp"

#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/base64.hpp"
#include "common/terminal/json_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt {

using Json = nlohmann::ordered_json;

namespace {

constexpr int version = 1;
constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();

// --------------------------------------------------------------------------------------- parts of a grade

Json bytes_json(const std::string& bytes) {
    return is_utf8(bytes) ? Json(bytes) : Json{{"base64", base64(bytes)}};
}

std::string base64_from(const JsonValue& value) {
    const std::optional<std::string> bytes = from_base64(value.text());
    if (!bytes) value.fail("expected base64");
    return *bytes;
}

std::string bytes_from(const JsonValue& value) {
    if (!value.value->is_object()) return value.text();
    value.only({"base64"});
    return base64_from(value.at("base64"));
}

Points points_from(const JsonValue& value) {
    const double points = value.number(0, most_points);
    return {std::llround(points * 100)};
}

Json count_json(const CheckCount& count) { return {{"passed", count.passed}, {"all", count.all}}; }

CheckCount count_from(const JsonValue& value) {
    value.only({"passed", "all"});
    CheckCount count;
    count.all = static_cast<int>(value.at("all").whole(0, most));
    count.passed = static_cast<int>(value.at("passed").whole(0, count.all));
    return count;
}

Json failure_json(const FailedCheck& failure) {
    return {{"asked", bytes_json(failure.asked)}, {"said", bytes_json(failure.said)}};
}

FailedCheck failure_from(const JsonValue& value) {
    value.only({"asked", "said"});
    return {bytes_from(value.at("asked")), bytes_from(value.at("said"))};
}

Moment moment_from(const JsonValue& value) {
    const std::optional<Moment> moment = moment_of(value.text());
    if (!moment) value.fail("expected a time such as \"2027-03-01T23:59:00Z\"");
    return *moment;
}

// ------------------------------------------------------------------------------------------------- a step

Json step_json(const GradedStep& step) {
    Json json = {{"id", step.id},
                 {"title", step.title},
                 {"file", step.file},
                 {"possible", number_of(step.possible)},
                 {"earned", number_of(step.earned)},
                 {"extra", step.extra},
                 {"late_percent", step.late_percent},
                 {"verdict", name_of(step.verdict)},
                 {"checks", count_json(step.checks)},
                 {"hidden", count_json(step.hidden)},
                 {"hint", step.hint}};
    if (!step.needs.empty()) json["needs"] = step.needs;
    if (step.failure) json["failure"] = failure_json(*step.failure);
    if (step.hidden_failure) json["hidden_failure"] = failure_json(*step.hidden_failure);
    if (!step.difference.empty()) json["difference"] = base64(step.difference);
    return json;
}

GradedStep step_from(const JsonValue& value) {
    value.only({"id", "title", "file", "possible", "earned", "extra", "late_percent", "verdict", "checks",
                "hidden", "hint", "needs", "failure", "hidden_failure", "difference"});
    GradedStep step;
    step.id = value.at("id").text();
    step.title = value.at("title").text();
    step.file = value.at("file").text();
    step.possible = points_from(value.at("possible"));
    step.earned = points_from(value.at("earned"));
    if (step.earned > step.possible) value.at("earned").fail("is more than what is possible");
    step.extra = value.at("extra").boolean();
    step.late_percent = static_cast<int>(value.at("late_percent").whole(0, 100));
    const JsonValue verdict = value.at("verdict");
    const std::optional<Verdict> named = verdict_named(verdict.text());
    if (!named) verdict.fail("is no verdict");
    step.verdict = *named;
    step.checks = count_from(value.at("checks"));
    step.hidden = count_from(value.at("hidden"));
    step.hint = static_cast<int>(value.at("hint").whole(0, most));
    if (value.has("needs")) step.needs = value.at("needs").text();
    if (value.has("failure")) step.failure = failure_from(value.at("failure"));
    if (value.has("hidden_failure")) step.hidden_failure = failure_from(value.at("hidden_failure"));
    if (value.has("difference")) step.difference = base64_from(value.at("difference"));
    return step;
}

Json part_json(const ClassPart& part) {
    return {{"number", part.number}, {"of", part.count}, {"list", part.list}};
}

ClassPart part_from(const JsonValue& value) {
    value.only({"number", "of", "list"});
    ClassPart part;
    part.count = static_cast<int>(value.at("of").whole(1, most));
    part.number = static_cast<int>(value.at("number").whole(1, part.count));
    part.list = value.at("list").text();
    return part;
}

Json names_json(std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    Json json = Json::array();
    for (const std::string& name : names) json.push_back(bytes_json(name));
    return json;
}

bool by_name(const Grade& a, const Grade& b) { return a.submission < b.submission; }

}  // namespace

Json to_json(const Grade& grade) {
    Json steps = Json::array();
    for (const GradedStep& step : grade.steps) steps.push_back(step_json(step));
    Json json = {{"submission", bytes_json(grade.submission)},
                 {"digest", grade.digest},
                 {"rubric", grade.rubric},
                 {"seed", grade.seed},
                 {"isolation", grade.isolation},
                 {"seconds", grade.seconds},
                 {"peak_bytes", grade.peak_bytes},
                 {"graded", text_of(grade.graded)}};
    if (grade.submitted) json["submitted"] = text_of(*grade.submitted);
    json["steps"] = steps;
    return json;
}

Grade grade_from(const JsonValue& value) {
    value.only({"submission", "digest", "rubric", "seed", "isolation", "seconds", "peak_bytes", "submitted",
                "graded", "steps"});
    Grade grade;
    grade.submission = bytes_from(value.at("submission"));
    if (grade.submission.empty()) value.at("submission").fail("expected a name");
    grade.digest = value.at("digest").text();
    grade.rubric = value.at("rubric").text();
    grade.seed = value.at("seed").unsigned_whole();
    grade.isolation = value.at("isolation").text();
    grade.seconds = value.at("seconds").number(0, 1e9);
    grade.peak_bytes = value.at("peak_bytes").whole(0, std::int64_t{1} << 60);
    grade.graded = moment_from(value.at("graded"));
    if (value.has("submitted")) grade.submitted = moment_from(value.at("submitted"));
    for (const JsonValue& step : value.at("steps").items()) {
        grade.steps.push_back(step_from(step));
        for (std::size_t i = 0; i + 1 < grade.steps.size(); ++i)
            if (grade.steps[i].id == grade.steps.back().id) step.at("id").fail("is there twice");
    }
    return grade;
}

std::string grades_text(std::vector<Grade> grades, const std::optional<ClassPart>& part,
                        const std::vector<std::string>& not_marked) {
    std::sort(grades.begin(), grades.end(), by_name);
    std::string text = fmt::format("{{\"version\":{},", version);
    if (part) text += fmt::format("\"part\":{},", json_text(part_json(*part)));
    if (!not_marked.empty()) text += fmt::format("\"not_marked\":{},", json_text(names_json(not_marked)));
    text += "\"grades\":[";
    for (std::size_t i = 0; i < grades.size(); ++i)
        text += (i == 0 ? "\n" : ",\n") + json_text(to_json(grades[i]));
    return text + "\n]}\n";
}

GradesFile read_grades_file(const std::string& file, const std::string& text) {
    const JsonSource source = parse_json(file, text);
    const JsonValue root = root_of(source);
    root.only({"version", "part", "not_marked", "grades"});
    root.at("version").whole(version, version);
    GradesFile read{file, {}, {}, {}};
    for (const JsonValue& value : root.at("grades").items()) read.grades.push_back(grade_from(value));
    read.grades = merged({read});
    if (root.has("part")) read.part = part_from(root.at("part"));
    if (root.has("not_marked"))
        for (const JsonValue& name : root.at("not_marked").items())
            read.not_marked.push_back(bytes_from(name));
    return read;
}

std::vector<Grade> read_grades(const std::string& file, const std::string& text) {
    return read_grades_file(file, text).grades;
}

}  // namespace rt
