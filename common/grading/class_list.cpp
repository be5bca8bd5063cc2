// A class as it was handed in: its directories and archives, listed and read.
#include "common/grading/class_list.hpp"

#include "common/grading/archive.hpp"
#include "common/grading/workshop.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/console.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace rt {

namespace fs = std::filesystem;

ClassList class_list(const std::vector<fs::path>& paths) {
    if (paths.empty()) throw InputError("there are no submissions: name their directories or archives");
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

std::vector<Submission> read_class(const ClassList& list, const std::optional<ClassPart>& part,
                                   const Project& project, const std::vector<const Chapter*>& chapters,
                                   Isolation isolation) {
    if (std::ranges::any_of(list.paths, [](const fs::path& path) { return fs::is_regular_file(path); }))
        prepare_boxes(project, isolation);
    std::vector<Submission> submissions;
    for (std::size_t i = 0; i < list.paths.size(); ++i) {
        if (part && !is_in(*part, i)) continue;
        submissions.push_back(read_handed_in(list.paths[i], chapters, isolation));
        const Submission& submission = submissions.back();
        if (!submission.refused.empty())
            say("{}: not taken: it {}", printable(list.paths[i].string()), submission.refused);
        for (const std::string& remark : submission.remarks)
            say("{}: not taken: {}", printable(submission.name), printable(remark));
    }
    return submissions;
}

}  // namespace rt
