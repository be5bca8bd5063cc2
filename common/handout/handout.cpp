// Handouts: made once, in a repository of their own.
#include "common/handout/handout.hpp"

#include "common/handout/handout_files.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/git.hpp"
#include "common/terminal/staged_directory.hpp"
#include "common/workbook/chosen_chapters.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>

namespace rt {

namespace fs = std::filesystem;

namespace {

void require_free(const fs::path& directory) {
    if (!fs::exists(fs::symlink_status(directory))) return;
    throw InputError(fs::exists(directory / record_file)
                         ? directory.string() + " is a handout already; --update brings it up to date"
                         : directory.string() + " exists, and is no handout; nothing was changed");
}

void write_all(const fs::path& directory, const std::vector<HandoutFile>& files) {
    for (const HandoutFile& file : files) {
        const fs::path path = directory / file.path;
        make_directories(path.parent_path());
        write_file(path, file.text);
        if (file.executable)
            fs::permissions(path, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                            fs::perm_options::add);
    }
}

/// All files in one commit, whose author is nobody on this machine.
void commit_all(const fs::path& directory, const ClassFacts& about) {
    const std::string place = "--git-dir=" + (directory / ".git").string();
    const std::string tree = "--work-tree=" + directory.string();
    git({"init", "--quiet", "--initial-branch=main", "--template=", directory.string()});
    git({place, tree, "add", "--all"});
    git({place, tree, "-c", "user.name=" + (about.instructor.empty() ? "The course" : about.instructor), "-c",
         "user.email=course@localhost", "commit", "--quiet", "--no-gpg-sign", "-m",
         about.course.empty() ? "The course as it was handed out" : about.course + ", as it was handed out"});
}

}  // namespace

MadeHandout make_handout(const Project& project, const fs::path& directory, const HandoutOptions& options) {
    require_solutions(project, "./course handout");
    // "../handout/" is the directory, not something in it.
    const fs::path target = directory.has_filename() ? directory : directory.parent_path();
    require_free(target);
    const std::vector<Chapter> all = read_catalogue(project),
                               chapters = chosen_chapters(all, options.chapters);
    const ClassFacts about = options.about.empty() ? ClassFacts() : read_class_facts(options.about, all);
    const std::vector<HandoutFile> files = handout_files(project, chapters, about);

    StagedDirectory staged(target);
    write_all(staged.path, files);
    commit_all(staged.path, about);
    staged.rename(target);

    MadeHandout made{{}, files.size()};
    for (const Chapter& chapter : chapters) made.chapters.push_back(chapter.number);
    return made;
}

}  // namespace rt
