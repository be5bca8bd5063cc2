// A class's submissions beside each other and beside what is published: for the instructor to look at, never
// a mark.
#include "common/similarity/similarity_report.hpp"

#include "common/workbook/exercise.hpp"
#include "common/workbook/variants.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {
namespace {

using Files = std::map<std::string, std::string>;

/// The same files without marks and tasks.
CodeSample sample_of(std::string name, const Files& solution) {
    CodeSample sample{std::move(name), {}};
    for (const auto& [file, text] : solution) sample.files[file] = solution_text(text, file);
    return sample;
}

/// The solution, and what the k-th right variants of all steps make of it.
std::vector<CodeSample> known_answers(const Project& project, const Chapter& chapter, const Files& solution) {
    std::vector<CodeSample> answers{sample_of("our solution", solution)};
    for (const std::vector<Mistake>& variants : right_variants(project, chapter)) {
        Files changed = solution;
        for (const Mistake& variant : variants)
            changed[variant.file] = apply_mistake(variant, changed[variant.file], variant.file);
        answers.push_back(sample_of(fmt::format("our variants {}", answers.size()), changed));
    }
    return answers;
}

/// What a submission has of the chapter, by the names that its files have there.
Files files_of(const Submission& submission, const Chapter& chapter) {
    Files files;
    for (const std::string& file : files_of_steps(chapter))
        if (const auto found = submission.files.find(exercise_path(chapter, file));
            found != submission.files.end())
            files[file] = found->second;
    return files;
}

/// Of the first two: a third variant is there of some steps only.
double similarity_of_variants(const std::vector<CodeSample>& answers, const Files& given,
                              const SimilarityOptions& options) {
    SimilarityOptions one = options;
    one.least_similarity = 0;
    one.most_pairs = 1;
    if (answers.size() < 3) return 0;
    const Similarities found = similarities(std::span(answers).subspan(1, 2), given, 0, one);
    return found.pairs.empty() ? 0 : found.pairs.front().similarity;
}

ChapterSimilarity compare(const Project& project, const Chapter& chapter,
                          const std::vector<Submission>& submissions, const SimilarityOptions& options) {
    ChapterSimilarity result{chapter.name, chapter.title, {}, 0, {}, 0};
    for (const Submission& submission : submissions)
        if (Files files = files_of(submission, chapter); !files.empty())
            result.samples.push_back({submission.name, std::move(files)});

    // A file without a step is nobody's to write.
    const std::vector<std::string> files = files_of_steps(chapter);
    Files solution, given;
    for (const auto& [file, text] : solution_files(project, chapter)) {
        if (std::ranges::find(files, file) == files.end()) continue;
        solution[file] = text;
        given[file] = exercise_text(text, file);
    }
    const std::vector<CodeSample> answers = known_answers(project, chapter, solution);
    result.samples.insert(result.samples.end(), answers.begin(), answers.end());
    result.known = answers.size();
    result.found = similarities(result.samples, given, result.known, options);
    result.of_variants = similarity_of_variants(answers, given, options);
    return result;
}

}  // namespace

std::vector<ChapterSimilarity> similarity_report(const Project& project,
                                                 const std::vector<const Chapter*>& chapters,
                                                 const std::vector<Submission>& submissions,
                                                 const SimilarityOptions& options) {
    std::vector<ChapterSimilarity> report;
    for (const Chapter* chapter : chapters)
        report.push_back(compare(project, *chapter, submissions, options));
    return report;
}

bool is_known_answer(const ChapterSimilarity& chapter, const SimilarPair& pair) {
    return pair.second >= chapter.samples.size() - chapter.known;
}

}  // namespace rt
