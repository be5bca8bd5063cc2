// A class's marks: those that are kept, and those that are given now.
#include "common/grading/class_marks.hpp"

#include "common/grading/run_judge.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/console.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace rt {

ClassMarks marks_of(const std::vector<Submission>& submissions, const KeptGrades& kept, const Marking& mark) {
    std::vector<std::optional<Grade>> grades;
    for (const Submission& submission : submissions) grades.push_back(kept.find(submission));

    // The time that remains is told from what is marked now.
    const auto to_do = std::count(grades.begin(), grades.end(), std::nullopt);
    std::ptrdiff_t done = 0;
    ClassMarks marks;
    Progress progress("Grading");
    for (std::size_t i = 0; i < grades.size(); ++i) {
        if (grades[i]) continue;
        try {
            grades[i] = mark(submissions[i], [&](double of_this_one) {
                progress.update((static_cast<double>(done) + of_this_one) / static_cast<double>(to_do),
                                fmt::format("Grading {} of {}", done + 1, to_do));
            });
            kept.keep(submissions[i], *grades[i]);
        } catch (const GraderFault& fault) {
            say("{}: not marked, which is the grader's fault: {}", printable(submissions[i].name),
                printable(fault.what()));
            marks.not_marked.push_back(submissions[i].name);
        }
        ++done;
    }
    for (std::optional<Grade>& grade : grades)
        if (grade) marks.grades.push_back(std::move(*grade));
    return marks;
}

}  // namespace rt
