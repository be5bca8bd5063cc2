// A class as a command names it: directories and archives, one a student, and what they have handed in.
#include "common/grading/class_list.hpp"

#include "common/grading/archive.hpp"
#include "common/grading/workshop.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/console.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace rt {

namespace fs = std::filesystem;

ClassList class_list(const std::vector<fs::path>& paths) {
    if (paths.empty()) throw InputError("there are no submissions: name their directories and archives");
    std::map<std::string, fs::path> by_name;
    for (const fs::path& path : paths) {
        const auto [other, is_new] = by_name.try_emplace(name_of_submission(path), path);
        if (!is_new)
            throw InputError(fmt::format("{} and {}: two submissions of the same name",
                                         printable(other->second.string()), printable(path.string())));
    }
    ClassList list;
    for (const auto& [name, path] : by_name) {
        list.names.push_back(name);
        list.paths.push_back(path);
    }
    return list;
}

std::vector<Submission> read_submissions(const Project& project, const std::vector<fs::path>& paths,
                                         const std::vector<const Chapter*>& chapters, Isolation isolation) {
    if (std::ranges::any_of(paths, [](const fs::path& path) { return fs::is_regular_file(path); }))
        prepare_boxes(project, isolation);  // archives are opened in them
    std::vector<Submission> submissions;
    std::vector<std::string> refusals;
    for (const fs::path& path : paths) {
        try {
            submissions.push_back(read_handed_in(path, chapters, isolation));
        } catch (const InputError& refusal) {
            refusals.emplace_back(refusal.what());
            continue;
        }
        for (const std::string& remark : submissions.back().remarks)
            say("{}: not taken: {}", printable(submissions.back().name), printable(remark));
    }
    if (refusals.size() == 1) throw InputError(refusals.front());
    for (const std::string& refusal : refusals) say("{}", refusal);
    if (!refusals.empty())
        throw InputError(
            fmt::format("{} of {} submissions cannot be read, so nothing was done: move them away",
                        refusals.size(), paths.size()));
    return submissions;
}

}  // namespace rt
