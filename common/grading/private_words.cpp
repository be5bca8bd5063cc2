// What of the instructor's machine no student may read.
#include "common/grading/private_words.hpp"

#include <pwd.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <string_view>

namespace rt {

namespace fs = std::filesystem;

namespace {

std::string variable(const char* name) {
    const char* const value = std::getenv(name);
    return value ? value : "";
}

void add_directory(std::set<std::string>& words, const fs::path& directory) {
    std::error_code ignored;
    for (std::string path : {directory.string(), fs::weakly_canonical(directory, ignored).string()}) {
        while (path.ends_with('/')) path.pop_back();
        if (!path.empty()) words.insert(path);
    }
}

void add_name(std::set<std::string>& words, const std::string& name) {
    constexpr std::array<std::string_view, 3> everybodys{"root", "localhost", "nobody"};
    const bool tells =
        name.size() > 1 && std::find(everybodys.begin(), everybodys.end(), name) == everybodys.end();
    if (tells) words.insert(name);
}

/// With and without its domain.
void add_machine(std::set<std::string>& words) {
    std::array<char, 256> name{};
    if (::gethostname(name.data(), name.size() - 1) != 0) return;
    const std::string whole = name.data();
    add_name(words, whole);
    add_name(words, whole.substr(0, whole.find('.')));
}

void add_user(std::set<std::string>& words) {
    for (const char* name : {"USER", "LOGNAME", "SUDO_USER"}) add_name(words, variable(name));
    const passwd* const user = ::getpwuid(::getuid());
    if (!user) return;
    add_name(words, user->pw_name);
    const std::string about = user->pw_gecos ? user->pw_gecos : "";
    add_name(words, about.substr(0, about.find(',')));  // the real name; rooms and telephones follow
    if (user->pw_dir) add_directory(words, user->pw_dir);
}

}  // namespace

std::vector<std::string> private_words(const Project& project) {
    std::set<std::string> words;
    std::error_code ignored;
    for (const fs::path& directory :
         {project.root, project.build, fs::path(variable("HOME")), fs::temp_directory_path(ignored)})
        if (!directory.empty()) add_directory(words, directory);
    add_machine(words);
    add_user(words);
    std::vector<std::string> sorted(words.begin(), words.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const std::string& a, const std::string& b) { return a.size() > b.size(); });
    return sorted;
}

}  // namespace rt
