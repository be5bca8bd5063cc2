// Submissions for tests of the grader, and what came of them.
#pragma once

#include "common/grading/grade.hpp"
#include "common/grading/grader.hpp"
#include "common/grading/submission.hpp"
#include "common/sandbox/isolation.hpp"
#include "common/workbook/mistake.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt::test {

/// The best level that this machine can do; nothing where it can have no boxes, which is said once.
std::optional<Isolation> best_level();

/// A chapter that is cheap to mark.
struct Course {
    Project project = this_project();
    std::vector<Chapter> all = read_catalogue(project);
    const Chapter& planes = find_chapter(all, "01");
    std::vector<const Chapter*> marked{&planes};
};

/// What everybody who solved these chapters would hand in.
Submission perfect(const std::vector<const Chapter*>& chapters);

/// Puts other texts in the place of some that stand once in an exercise's file.
void change(Submission& submission, const Chapter& chapter, const std::string& file,
            const std::vector<Replacement>& replacements);

/// The same as a file of tests/NN_name says it, such as "mistakes/02.1_unsorted_roots.mistake".
void change_as(Submission& submission, const Chapter& chapter, const std::string& file);

/// A line a step: its points, its verdict, and what it says.
std::string told(const Grade& grade);

/// Whether the failure of some step contains this text.
bool somebody_said(const Grade& grade, std::string_view text);

}  // namespace rt::test
