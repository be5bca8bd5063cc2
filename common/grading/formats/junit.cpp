// JUnit's XML, as Ant's reports began it and Jenkins and GitLab read it.
#include "common/grading/formats/formats.hpp"
#include "common/grading/formats/parts.hpp"
#include "common/math/printable.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {
namespace {

/// `printable` has escaped control characters and what is not UTF-8; XML 1.0 also has no place for these two.
std::string xml(const std::string& text, Keep keep = Keep::Nothing) {
    std::string legal = printable(text, keep);
    for (const auto& [forbidden, escape] :
         {std::pair{"\xEF\xBF\xBE", "\\ufffe"}, {"\xEF\xBF\xBF", "\\uffff"}})
        for (auto at = legal.find(forbidden); at != std::string::npos; at = legal.find(forbidden))
            legal.replace(at, 3, escape);
    return escaped_markup(legal);
}

struct Counts {
    int tests = 0, failures = 0, errors = 0, skipped = 0;
};

Counts count(const Grade& grade) {
    Counts counts;
    for (const GradedStep& step : grade.steps) {
        ++counts.tests;
        if (is_error(step.verdict)) ++counts.errors;
        if (is_skipped(step.verdict)) ++counts.skipped;
        if (step.verdict == Verdict::Failed) ++counts.failures;
    }
    return counts;
}

std::string test_case(const GradedStep& step) {
    std::string text = fmt::format("    <testcase classname=\"chapter {}\" name=\"{}\">\n",
                                   xml(chapter_of(step)), xml(name_of(step)));
    const char* tag = is_error(step.verdict) ? "error" : is_skipped(step.verdict) ? "skipped" : "failure";
    if (step.verdict != Verdict::Passed)
        text += fmt::format("      <{0} type=\"{1}\" message=\"{2}\">{3}</{0}>\n", tag, name_of(step.verdict),
                            xml(verdict_line(step)), xml(explained(step), Keep::Lines));
    return text + fmt::format("      <system-out>{}</system-out>\n    </testcase>\n", xml(points_line(step)));
}

std::string suite(const Grade& grade) {
    const Counts counts = count(grade);
    std::string text = fmt::format(
        "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" errors=\"{}\" skipped=\"{}\" time=\"{:.3f}\" "
        "timestamp=\"{}\">\n    <properties>\n",
        xml(grade.submission), counts.tests, counts.failures, counts.errors, counts.skipped, grade.seconds,
        text_of(grade.graded));
    for (const auto& [name, value] : {std::pair<const char*, std::string>{"earned", text_of(earned(grade))},
                                      {"possible", text_of(possible(grade))},
                                      {"isolation", grade.isolation}})
        text += fmt::format("      <property name=\"{}\" value=\"{}\"/>\n", name, xml(value));
    text += "    </properties>\n";
    for (const GradedStep& step : grade.steps) text += test_case(step);
    return text + "  </testsuite>\n";
}

}  // namespace

std::string junit_xml(const std::vector<ShownGrade>& shown) {
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n";
    for (const ShownGrade& one : shown) {
        require_shown(one);
        text += suite(one.grade);
    }
    return text + "</testsuites>\n";
}

}  // namespace rt
