// What a class keeps in its tree: the seed of its random cases, and the marks that were given.
#pragma once

#include "common/grading/grader.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace rt {

/// Drawn once and kept, so that a whole class has the same cases, which nobody knows before. Graders that run
/// at once get the same.
std::uint64_t seed_of_class(const Project& project);

/// Marks that are there already: a grader that was stopped goes on where it was. One file a submission,
/// written whole or not at all.
class KeptGrades {
public:
    /// Those that were given by these options and by the judges as they are built now.
    KeptGrades(const Project& project, const GraderOptions& options);

    /// Nothing also where its file is damaged: then it is marked again.
    std::optional<Grade> find(const Submission& submission) const;

    void keep(const Submission& submission, const Grade& grade) const;

private:
    std::filesystem::path file_of(const Submission& submission) const;

    std::filesystem::path directory_;
    std::string about_;
};

}  // namespace rt
