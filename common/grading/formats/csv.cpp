// A table for spreadsheets: a row a submission, a column a step (RFC 4180).
#include "common/grading/formats/formats.hpp"
#include "common/math/printable.hpp"

#include <fmt/format.h>

namespace rt {
namespace {

/// One field. Spreadsheets run what begins like a formula, also in quotes (OWASP, "CSV Injection").
std::string field(const std::string& text) {
    std::string shown = printable(text);
    if (!shown.empty() && std::string_view("=+-@\t\r").find(shown.front()) != std::string_view::npos)
        shown.insert(0, "'");
    if (shown.find_first_of("\",\r\n;") == std::string::npos) return shown;
    std::string quoted = "\"";
    for (const char c : shown) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

std::string row(const std::vector<std::string>& texts) {
    std::string line;
    for (std::size_t i = 0; i < texts.size(); ++i) line += (i == 0 ? "" : ",") + field(texts[i]);
    return line + "\r\n";
}

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

    std::string text = row(head);
    for (const Grade& grade : grades) {
        std::vector<std::string> texts{grade.submission, grade.submitted ? text_of(*grade.submitted) : "",
                                       text_of(earned(grade)), text_of(possible(grade))};
        for (const GradedStep& step : grade.steps) texts.push_back(text_of(step.earned));
        for (const std::string& last :
             {not_passed(grade), fmt::format("{:.1f}", grade.seconds),
              fmt::format("{:.0f}", static_cast<double>(grade.peak_bytes) / 1e6), grade.isolation,
              std::to_string(grade.seed), text_of(grade.graded), grade.digest})
            texts.push_back(last);
        text += row(texts);
    }
    return text;
}

}  // namespace rt
