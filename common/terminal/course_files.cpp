// Which files are the course's.
#include "common/terminal/course_files.hpp"

#include "common/terminal/git.hpp"
#include "common/terminal/lock.hpp"

#include <algorithm>
#include <filesystem>

namespace rt {

std::vector<std::string> course_files(const Project& project) {
    // A repository without any file in it, so that also a tree without .git has a list.
    const std::filesystem::path index = own_directory(project) / "list.git";
    git({"init", "--quiet", "--bare", index.string()});
    const std::string listed =
        git({"--git-dir=" + index.string(), "--work-tree=" + project.root.string(), "-C",
             project.root.string(), "ls-files", "-z", "--others", "--exclude-standard"});
    std::vector<std::string> files;
    for (std::size_t begin = 0; begin < listed.size();) {
        const std::size_t end = std::min(listed.find('\0', begin), listed.size());
        files.push_back(listed.substr(begin, end - begin));
        begin = end + 1;
    }
    return files;
}

}  // namespace rt
