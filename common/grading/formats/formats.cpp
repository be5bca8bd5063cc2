// The forms in which results leave the house, by their names.
#include "common/grading/formats/formats.hpp"

#include "common/grading/grade_json.hpp"
#include "common/math/input_error.hpp"

#include <fmt/format.h>

namespace rt {
namespace {

std::vector<ShownGrade> all_shown(const FormatRequest& request) {
    std::vector<ShownGrade> shown;
    for (const Grade& grade : request.grades)
        shown.push_back(shown_to_student(grade, request.rubric, request.at, request.private_words));
    return shown;
}

ShownGrade only_one(const FormatRequest& request) {
    if (request.grades.size() != 1)
        throw InputError(
            fmt::format("this format is for one submission, and there are {}; csv, html and junit are "
                        "for a class",
                        request.grades.size()));
    return all_shown(request).front();
}

}  // namespace

const std::vector<Format>& formats() {
    using Request = const FormatRequest&;
    static const std::vector<Format> all{
        {"html", "one page for the instructor: the class at a glance, a page a student",
         [](Request r) { return class_page(r.grades, r.not_marked); }},
        {"csv", "a row a submission, a column a step", [](Request r) { return csv(r.grades); }},
        {"json", "all that is known, for the grader itself: what --part writes and --merge reads",
         [](Request r) { return grades_text(r.grades, r.part, r.not_marked); }},
        {"junit", "JUnit's XML: a suite a submission, a case a step",
         [](Request r) { return junit_xml(all_shown(r)); }},
        {"gradescope", "Gradescope's results.json", [](Request r) { return gradescope(only_one(r)); }},
        {"github-classroom", "outputs for the reporter of GitHub Classroom, a runner a chapter",
         [](Request r) { return github_classroom(only_one(r)); }},
        {"classroom50", "Classroom 50's result.json",
         [](Request r) { return classroom50(only_one(r), r.classroom50); }},
        {"prairielearn", "PrairieLearn's results.json", [](Request r) { return prairielearn(only_one(r)); }},
        {"autolab", "the last lines of an Autolab autograder's output",
         [](Request r) { return autolab(only_one(r)); }},
    };
    return all;
}

const Format& find_format(std::string_view name) {
    std::string names;
    for (const Format& format : formats()) {
        if (format.name == name) return format;
        names += (names.empty() ? "" : ", ") + std::string(format.name);
    }
    throw InputError(fmt::format("there is no format '{}'; there are {}", name, names));
}

}  // namespace rt
