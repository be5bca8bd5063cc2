// A class's submissions beside each other and beside what is published: for the instructor to look at, never
// a mark.
#pragma once

#include "common/grading/submission.hpp"
#include "common/similarity/similarity.hpp"
#include "common/terminal/project.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace rt {

struct ChapterSimilarity {
    std::string chapter;  ///< "02_spheres"
    std::string title;
    /// The submissions that have a file of the chapter; then the known answers: the solution, and the
    /// programs of right variants.
    std::vector<CodeSample> samples;
    std::size_t known = 0;  ///< how many of them are known answers
    Similarities found;
    /// Of two programs of ours that write every step in another way: what right code has in common anyway, or
    /// more, as they share lines of the solution. 0 if there are no two.
    double of_variants = 0;
};

/// Compares the submissions in each of these chapters. Throws InputError where a variant is not one.
std::vector<ChapterSimilarity> similarity_report(const Project& project,
                                                 const std::vector<const Chapter*>& chapters,
                                                 const std::vector<Submission>& submissions,
                                                 const SimilarityOptions& options);

/// Whether the pair's second is a known answer; its first never is.
bool is_known_answer(const ChapterSimilarity& chapter, const SimilarPair& pair);

}  // namespace rt
