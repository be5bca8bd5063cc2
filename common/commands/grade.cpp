// `course grade`: marks submissions, in boxes, by the chapters' own tests.
#include "common/commands/commands.hpp"
#include "common/grading/formats/formats.hpp"
#include "common/grading/grade_json.hpp"
#include "common/grading/grader.hpp"
#include "common/grading/isolation.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/console.hpp"

#include <fmt/format.h>

#include <map>
#include <random>

namespace rt {

namespace fs = std::filesystem;

namespace {

std::vector<const Chapter*> asked_chapters(const std::vector<Chapter>& chapters,
                                           const std::vector<std::string>& numbers) {
    std::vector<const Chapter*> asked;
    if (numbers.empty())
        for (const Chapter& chapter : chapters) asked.push_back(&chapter);
    for (const std::string& number : numbers) asked.push_back(&find_chapter(chapters, number));
    return asked;
}

/// Drawn once and kept, so that a whole class has the same cases, which nobody knows before.
std::uint64_t seed_of_class(const Project& project) {
    const fs::path file = memory(project, "grading_seed");
    if (!fs::exists(file)) {
        fs::create_directories(file.parent_path());
        std::random_device device;
        write_file(file, fmt::format("{}\n", (std::uint64_t{device()} << 21) ^ device()));
    }
    return std::stoull(read_file(file));
}

/// Marks that are there already: a grader that was stopped goes on where it was. One file a submission.
class KeptGrades {
public:
    KeptGrades(const Project& project, std::string about)
        : directory_(memory(project, "grades")), about_(std::move(about)) {
        fs::create_directories(directory_);
    }

    std::optional<Grade> find(const Submission& submission) const {
        const fs::path file = file_of(submission);
        if (!fs::exists(file)) return {};
        try {
            std::vector<Grade> grades = read_grades(file.string(), read_file(file));
            if (grades.size() == 1) return std::move(grades.front());
        } catch (const InputError&) {
        }
        return {};  // damaged: marked again
    }

    void keep(const Submission& submission, const Grade& grade) const {
        write_file(file_of(submission), grades_text({grade}));
    }

private:
    fs::path file_of(const Submission& submission) const {
        return directory_ /
               (fingerprint(about_ + "\n" + submission.name + "\n" + digest_of(submission)) + ".json");
    }

    fs::path directory_;
    std::string about_;
};

/// What else a mark depends on: the tests, and all that is asked of the grader.
std::string what_counts(const Project& project, const GraderOptions& options) {
    std::string all =
        fmt::format("{} {} {}", digest_of(options.rubric), options.seed, name_of(options.isolation));
    for (const Chapter* chapter : options.chapters)
        all += " " + fingerprint(read_file(program(project, "judge_" + chapter->number)));
    return all;
}

std::vector<Submission> read_all(const std::vector<fs::path>& paths,
                                 const std::vector<const Chapter*>& chapters) {
    std::map<std::string, fs::path> names;
    std::vector<Submission> submissions;
    for (const fs::path& path : paths) {
        submissions.push_back(read_submission(path, chapters));
        const auto [other, is_new] = names.try_emplace(submissions.back().name, path);
        if (!is_new)
            throw InputError(fmt::format("{} and {}: two submissions of the same name",
                                         printable(other->second.string()), printable(path.string())));
        for (const std::string& remark : submissions.back().remarks)
            say("{}: not taken: {}", printable(submissions.back().name), printable(remark));
    }
    return submissions;
}

}  // namespace

int run_grade(const GradeCommand& command) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const Format& format = find_format(command.format);
    GraderOptions options{.chapters = asked_chapters(chapters, command.chapters),
                          .rubric = command.rubric.empty() ? default_rubric(chapters)
                                                           : read_rubric(command.rubric.string(),
                                                                         read_file(command.rubric), chapters),
                          .seed = command.seed.value_or(0),
                          .isolation = isolation_named(command.isolation)};
    if (!command.seed) options.seed = seed_of_class(project);
    if (!command.output.empty()) require_writable(command.output);
    const std::vector<Submission> submissions = read_all(command.submissions, options.chapters);

    Grader grader(project, options);
    const KeptGrades kept(project, what_counts(project, options));
    std::vector<Grade> grades;
    {
        Progress progress("Grading");
        for (const Submission& submission : submissions) {
            std::optional<Grade> grade = kept.find(submission);
            if (!grade) {
                grade = grader.grade(submission);
                kept.keep(submission, *grade);
            }
            grades.push_back(std::move(*grade));
            progress.update(static_cast<double>(grades.size()) / static_cast<double>(submissions.size()));
        }
    }
    const std::string text = format.text(
        {.grades = grades, .rubric = options.rubric, .at = now(), .private_words = {}, .classroom50 = {}});
    if (command.output.empty())
        fmt::print("{}", text);
    else
        write_file(command.output, text);
    return 0;
}

}  // namespace rt
