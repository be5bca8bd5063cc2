// A table for spreadsheets: a row a submission, a column a step (RFC 4180).
#include "common/grading/formats/formats.hpp"
#include "common/grading/formats/parts.hpp"

#include <fmt/format.h>

namespace rt {
namespace {

/// "02.1 failed, 02.2 crashed".
std::string not_passed(const Grade& grade) {
    std::string list;
    for (const GradedStep& step : grade.steps)
        if (step.verdict != Verdict::Passed)
            list += fmt::format("{}{} {}", list.empty() ? "" : ", ", step.id, name_of(step.verdict));
    return list;
}

}  // namespace

std::string csv(const std::vector<Grade>& grades) {
    std::vector<std::string> head{"submission", "submitted", "earned", "possible"};
    if (!grades.empty())
        for (const GradedStep& step : grades.front().steps) head.push_back(step.id);
    for (const char* name : {"not passed", "seconds", "megabytes", "isolation", "seed", "graded", "digest"})
        head.push_back(name);

    std::string text = csv_row(head);
    for (const Grade& grade : grades) {
        std::vector<std::string> texts{grade.submission, grade.submitted ? text_of(*grade.submitted) : "",
                                       text_of(earned(grade)), text_of(possible(grade))};
        for (const GradedStep& step : grade.steps) texts.push_back(text_of(step.earned));
        for (const std::string& last :
             {not_passed(grade), fmt::format("{:.1f}", grade.seconds),
              fmt::format("{:.0f}", static_cast<double>(grade.peak_bytes) / 1e6), grade.isolation,
              std::to_string(grade.seed), text_of(grade.graded), grade.digest})
            texts.push_back(last);
        text += csv_row(texts);
    }
    return text;
}

}  // namespace rt
