// Files of the course that nobody has to touch - headers, tests, lessons, scenes -, and which of them were
// changed.
#include "common/workbook/given_files.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/git.hpp"
#include "common/terminal/json_text.hpp"
#include "common/workbook/catalogue.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_named = 3;

// Which files a handout has, with their fingerprints (common/handout/handout_files.hpp).
constexpr const char* handout_record = ".course/handout.json";

/// Git in the repository, which may be another user's, as where directories are shared.
std::string git_there(const Project& project, std::vector<std::string> arguments) {
    const std::vector<std::string> place{"-c", "safe.directory=*", "-C", project.root.string()};
    arguments.insert(arguments.begin(), place.begin(), place.end());
    std::string said = git(arguments);
    while (said.ends_with('\n')) said.pop_back();
    return said;
}

/// The same, or nothing where git fails.
std::string git_or_nothing(const Project& project, const std::vector<std::string>& arguments) {
    try {
        return git_there(project, arguments);
    } catch (const InputError&) {
        return "";
    }
}

/// The commit that has the given files as the course has them.
std::string commit_of_course(const Project& project) {
    if (fs::exists(project.root / handout_record))
        return git_or_nothing(project, {"log", "-1", "--format=%H", "--", handout_record});
    return git_or_nothing(project, {"merge-base", "HEAD", "@{upstream}"});
}

/// Whether the course needs the file as it is, or it is missing.
bool is_given(const fs::path& path, bool missing) {
    const std::vector<std::string> parts(path.begin(), path.end());
    if (parts.size() == 1) return path == "CMakeLists.txt" || path == "course";
    if (parts[0] == "chapters" && parts.size() == 3 && is_chapter_name(parts[1]) &&
        path.extension() == ".cpp")
        return false;
    const bool room = parts[0] == "common" || parts[0] == "chapters" || parts[0] == "solutions" ||
                      parts[0] == "references" || parts[0] == "tests";
    return room && (missing || path.extension() != ".md");
}

/// An update of a handout changes files before anybody commits them: what is as its record says is as it
/// should be.
void take_out_updated(const Project& project, std::vector<ChangedGiven>& changed) {
    const fs::path record = project.root / handout_record;
    if (changed.empty() || !fs::exists(record)) return;
    const nlohmann::json read = read_json(read_file(record));
    const nlohmann::json files = read.is_object() ? read.value("files", nlohmann::json::object()) : read;
    std::erase_if(changed, [&](const ChangedGiven& file) {
        const auto known = files.find(file.path);
        if (known == files.end()) return true;
        return !file.missing && *known == fingerprint(read_file(project.root / file.path));
    });
}

/// The given files that differ from the commit that these words of git's diff name; nothing if there is none.
std::optional<std::vector<ChangedGiven>> differing(const Project& project,
                                                   const std::vector<std::string>& commit) {
    // Files that only were touched are no difference; whether they are, git reads.
    std::vector<std::string> command{"diff", "--relative",   "--name-status",
                                     "-z",   "--no-renames", "--no-ext-diff"};
    command.insert(command.end(), commit.begin(), commit.end());
    command.insert(command.end(), {"--", "."});
    try {
        std::vector<ChangedGiven> changed = changed_given(git_there(project, command));
        take_out_updated(project, changed);
        return changed;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

/// The given files that are not as in commit_of_course. Every command asks this, so where nothing is wrong it
/// starts git only once.
std::vector<ChangedGiven> changed_since_course(const Project& project) {
    std::optional<std::vector<ChangedGiven>> changed;
    if (!fs::exists(project.root / handout_record))
        changed = differing(project, {"--merge-base", "@{upstream}"});
    else if (const std::string course = commit_of_course(project); !course.empty())
        changed = differing(project, {course});
    if (!changed) changed = differing(project, {"HEAD"});
    return changed.value_or(std::vector<ChangedGiven>());
}

}  // namespace

std::vector<ChangedGiven> changed_given(std::string_view status) {
    // A letter, a zero, a path, a zero, and so on.
    std::vector<ChangedGiven> changed;
    while (!status.empty()) {
        const std::size_t letter_end = status.find('\0');
        if (letter_end == std::string_view::npos) break;
        const bool missing = status.starts_with('D'), added = status.starts_with('A');  // theirs
        status.remove_prefix(letter_end + 1);
        const std::size_t path_end = std::min(status.find('\0'), status.size());
        const std::string path(status.substr(0, path_end));
        status.remove_prefix(std::min(path_end + 1, status.size()));
        if (!added && is_given(path, missing)) changed.push_back({path, missing});
    }
    return changed;
}

GivenChanges given_changes(const Project& project) {
    GivenChanges changes;
    changes.files = changed_since_course(project);
    changes.commit = "HEAD";
    if (changes.files.empty()) return changes;
    if (git_or_nothing(project, {"config", "--type=bool", "course.maintainer"}) == "true") return {};
    const std::string course = commit_of_course(project);
    changes.committed =
        !course.empty() && differing(project, {"HEAD"}).value_or(changes.files).size() < changes.files.size();
    if (changes.committed) changes.commit = course;
    changes.staged = !git_or_nothing(project, {"diff", "--cached", "--name-only", "--", "."}).empty();
    return changes;
}

std::string restore_command(const GivenChanges& changes) {
    std::string command = "git restore";
    // Without a source git takes what is staged.
    if (changes.committed || changes.staged) command += " --source=" + changes.commit.substr(0, 10);
    if (changes.staged) command += " --staged --worktree";
    for (std::size_t i = 0; i < std::min(changes.files.size(), most_named); ++i)
        command += " " + changes.files[i].path;
    return command;
}

std::string given_in_words(const GivenChanges& changes) {
    const std::size_t count = changes.files.size();
    if (count == 0) return "";
    std::string names;
    for (std::size_t i = 0; i < std::min(count, most_named); ++i)
        names +=
            (i == 0 ? "" : ", ") + changes.files[i].path + (changes.files[i].missing ? " (deleted)" : "");
    if (count > most_named) names += fmt::format(" and {} more", count - most_named);
    return fmt::format("{} {} not as the course has {}; {} brings {} back", names, count == 1 ? "is" : "are",
                       count == 1 ? "it" : "them", restore_command(changes),
                       count > most_named ? "the first"
                       : count == 1       ? "it"
                                          : "them");
}

std::vector<std::string> restore_missing(const Project& project, std::string_view number) {
    std::string digits(number.substr(0, number.find_first_of("._")));
    if (digits.size() == 1) digits = "0" + digits;
    const GivenChanges changes = given_changes(project);
    std::vector<std::string> restored, command{"restore", "--source=" + changes.commit, "--worktree", "--"};
    for (const ChangedGiven& file : changes.files) {
        const auto slash = file.path.find('/');
        if (!file.missing || slash == std::string::npos || file.path.substr(slash + 1, 3) != digits + "_")
            continue;
        restored.push_back(file.path);
        command.push_back(file.path);
    }
    if (!restored.empty()) git_there(project, command);
    return restored;
}

}  // namespace rt
