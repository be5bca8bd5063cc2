// Small chapters and grades that tests of the autograder share.
#pragma once

#include "common/grading/grade.hpp"
#include "common/grading/marks.hpp"
#include "common/workbook/catalogue.hpp"

#include <string>
#include <vector>

namespace rt::test {

/// Two chapters with three steps of 10, 15 and 20 points.
inline std::vector<Chapter> two_chapters() {
    const std::vector<std::string> hints{"a", "b", "c"};
    return {
        {"01_rays", "01", "Rays", "Lines.", {{"01.1", "The axes", "ray.cpp", 10, hints}}, {}},
        {"02_spheres",
         "02",
         "Spheres",
         "Round things.",
         {{"02.1", "The roots", "sphere.cpp", 15, hints}, {"02.2", "The normal", "sphere.cpp", 20, hints}},
         {}}};
}

inline Moment moment(const std::string& text) { return *moment_of(text); }

/// Bytes that no format may trip over: no UTF-8, control characters, markup, a formula, what XML forbids.
inline const std::string nasty =
    std::string("=1+1 \xFF\xC3( \x1B[31m\x01 </script><b>&amp; ]]> \"q\", \xEF\xBF\xBE") +
    std::string("\0zero", 5);

/// A perfect submission.
inline Grade perfect(const std::string& name) {
    Grade grade;
    grade.submission = name;
    grade.digest = "0123456789abcdef";
    grade.rubric = "fedcba9876543210";
    grade.seed = 18446744073709551615u;
    grade.isolation = "bwrap: a namespace of its own";
    grade.seconds = 12.25;
    grade.peak_bytes = 300000000;
    grade.submitted = moment("2027-03-01T10:00:00Z");
    grade.graded = moment("2027-03-02T10:00:00Z");
    for (const Chapter& chapter : two_chapters())
        for (const Step& step : chapter.steps) {
            GradedStep graded;
            graded.id = step.id;
            graded.title = step.title;
            graded.file = "chapters/" + chapter.name + "/" + step.file;
            graded.possible = graded.earned = whole_points(step.points);
            graded.verdict = Verdict::Passed;
            graded.checks = {7, 7};
            grade.steps.push_back(graded);
        }
    return grade;
}

/// One with something of everything: a failing case of nasty bytes in 02.1, a crash in a hidden check of
/// 02.2.
inline Grade troubled(const std::string& name) {
    Grade grade = perfect(name);
    GradedStep &roots = grade.steps[1], &normal = grade.steps[2];
    roots.verdict = Verdict::Failed;
    roots.earned = {750};
    roots.checks = {3, 7};
    roots.failure = FailedCheck{"two roots of a far sphere", "sphere_test.cpp:5: 1.5 == 2\n" + nasty};
    roots.hint = 1;
    roots.difference = "\x89PNG\r\n\x1A\n bytes";
    normal.verdict = Verdict::Crashed;
    normal.earned = {};
    normal.hidden = {1, 4};
    normal.hidden_failure = FailedCheck{"the secret check", "the secret case 42.5"};
    normal.late_percent = 50;
    normal.extra = true;
    return grade;
}

}  // namespace rt::test
