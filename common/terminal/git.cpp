// Git, without what the person who runs it has set.
#include "common/terminal/git.hpp"

#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/process.hpp"

namespace rt {

namespace {

/// They would lead git to another repository, or name another author.
constexpr const char* variables[] = {"GIT_DIR",
                                     "GIT_WORK_TREE",
                                     "GIT_INDEX_FILE",
                                     "GIT_OBJECT_DIRECTORY",
                                     "GIT_ALTERNATE_OBJECT_DIRECTORIES",
                                     "GIT_AUTHOR_NAME",
                                     "GIT_AUTHOR_EMAIL",
                                     "GIT_AUTHOR_DATE",
                                     "GIT_COMMITTER_NAME",
                                     "GIT_COMMITTER_EMAIL",
                                     "GIT_COMMITTER_DATE"};

/// Its last line that is not empty.
std::string last_line(std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    return text.substr(text.rfind('\n') + 1);  // npos + 1 is 0
}

}  // namespace

std::string git(const std::vector<std::string>& arguments) {
    std::vector<std::string> command{"env"};
    for (const char* variable : variables) command.insert(command.end(), {"-u", variable});
    command.insert(command.end(),
                   {"GIT_CONFIG_GLOBAL=/dev/null", "GIT_CONFIG_SYSTEM=/dev/null", "LC_ALL=C", "git"});
    for (const char* setting : {"core.hooksPath", "core.excludesFile", "core.attributesFile"})
        command.insert(command.end(), {"-c", std::string(setting) + "=/dev/null"});
    command.insert(command.end(), arguments.begin(), arguments.end());
    ProcessOptions options;
    options.output_limit = std::size_t{64} << 20;
    const ProcessResult result = run_process(command, options);
    if (succeeded(result)) return result.output;
    if (result.exit_code == 127) throw InputError("git is not installed, and this needs it");
    throw InputError("git: " + printable(last_line(result.output)));
}

}  // namespace rt
