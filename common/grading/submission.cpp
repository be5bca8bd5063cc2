// What somebody handed in: the files of the exercises, and nothing else of what lies beside them.
#include "common/grading/submission.hpp"

#include "common/image/descriptor.hpp"
#include "common/math/printable.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <linux/openat2.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// Opens a file below a directory; nothing on the way may be a symbolic link.
int open_below(int directory, const std::string& path) {
    open_how how{};
    how.flags = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY;  // a pipe must not make us wait
    how.resolve = RESOLVE_BENEATH | RESOLVE_NO_SYMLINKS | RESOLVE_NO_MAGICLINKS;
    return static_cast<int>(::syscall(SYS_openat2, directory, path.c_str(), &how, sizeof how));
}

struct Taken {
    bool exists = false;
    std::optional<std::string> text;
    std::string why_not;
};

std::string read_all(int file) {
    std::string text(largest_submitted_file + 1, '\0');
    std::size_t size = 0;
    while (size < text.size()) {
        const ssize_t count = ::read(file, text.data() + size, text.size() - size);
        if (count <= 0) break;
        size += static_cast<std::size_t>(count);
    }
    text.resize(size);
    return text;
}

Taken take(int directory, const std::string& path) {
    const Descriptor file(open_below(directory, path));
    if (file.number < 0) {
        if (errno == ENOENT || errno == ENOTDIR) return {};
        return {true, {}, errno == ELOOP ? "is a symbolic link, or in one" : std::strerror(errno)};
    }
    struct stat what {};
    if (::fstat(file.number, &what) != 0 || !S_ISREG(what.st_mode)) return {true, {}, "is no regular file"};
    std::string text = read_all(file.number);
    if (text.size() > largest_submitted_file) return {true, {}, "is larger than 1 MiB"};
    return {true, std::move(text), ""};
}

bool is_empty(const Submission& submission) { return submission.files.empty() && submission.remarks.empty(); }

/// Takes what there is of these chapters' exercises at the top of a directory.
void take_all(int directory, const std::vector<const Chapter*>& chapters, Submission& submission) {
    for (const Chapter* chapter : chapters)
        for (const std::string& file : files_of_steps(*chapter))
            for (const std::string& place : places_of(*chapter, file)) {
                Taken taken = take(directory, place);
                if (!taken.exists) continue;
                if (taken.text)
                    submission.files[exercise_path(*chapter, file)] = std::move(*taken.text);
                else
                    submission.remarks.push_back(fmt::format("{} {}", place, taken.why_not));
                break;
            }
}

/// The same from the only directory below that has exercises: archives often have one in which all is.
void take_below(const fs::path& directory, int root, const std::vector<const Chapter*>& chapters,
                Submission& submission) {
    std::string found;
    for (const auto& entry : fs::directory_iterator(directory)) {
        const std::string name = entry.path().filename().string();
        const Descriptor below(::openat(root, name.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC));
        if (below.number < 0) continue;
        Submission there;
        take_all(below.number, chapters, there);
        if (is_empty(there)) continue;
        if (!found.empty())
            throw BadSubmission(
                directory, fmt::format("has exercises in both {} and {}", printable(std::min(found, name)),
                                       printable(std::max(found, name))));
        found = name;
        submission.files = std::move(there.files);
        submission.remarks = std::move(there.remarks);
    }
}

}  // namespace

BadSubmission::BadSubmission(const fs::path& path, const std::string& what_it_is)
    : InputError(fmt::format("{}: {}", printable(path.string()), what_it_is)), why(what_it_is) {}

std::string exercise_path(const Chapter& chapter, std::string_view file) {
    return fmt::format("chapters/{}/{}", chapter.name, file);
}

std::vector<std::string> files_of_steps(const Chapter& chapter) {
    std::vector<std::string> files;
    for (const Step& step : chapter.steps)
        if (std::find(files.begin(), files.end(), step.file) == files.end()) files.push_back(step.file);
    return files;
}

std::string name_of_submission(const fs::path& path) {
    const fs::path whole = fs::absolute(path).lexically_normal();
    fs::path name = (whole.has_filename() ? whole : whole.parent_path()).filename();
    if (!fs::is_regular_file(path)) return name.string();
    name = name.stem();
    return (name.extension() == ".tar" ? name.stem() : name).string();
}

std::vector<std::string> places_of(const Chapter& chapter, std::string_view file) {
    return {exercise_path(chapter, file), fmt::format("{}/{}", chapter.name, file), std::string(file)};
}

Submission read_submission(const fs::path& directory, const std::vector<const Chapter*>& chapters) {
    const Descriptor root(::open(directory.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (root.number < 0)
        throw InputError(fmt::format("{}: {}", printable(directory.string()), std::strerror(errno)));

    Submission submission{name_of_submission(directory), {}, {}};
    take_all(root.number, chapters, submission);
    if (is_empty(submission)) take_below(directory, root.number, chapters, submission);
    if (is_empty(submission)) throw without_exercises(directory, chapters);
    return submission;
}

BadSubmission without_exercises(const fs::path& path, const std::vector<const Chapter*>& chapters) {
    return {path, "has no file of an exercise, such as " +
                      exercise_path(*chapters.front(), chapters.front()->steps.front().file)};
}

std::string digest_of(const Submission& submission) {
    std::string all = submission.refused;
    for (const auto& [file, text] : submission.files)
        all += fmt::format("{} {}\n{}\n", file, text.size(), text);
    return fingerprint(all);
}

}  // namespace rt
