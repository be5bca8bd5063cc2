// `course exercises`: whether generated files, exercises above all, are what they are generated from.
#include "common/commands/changed_files.hpp"
#include "common/commands/commands.hpp"
#include "common/evidence/drifted_files.hpp"
#include "common/image/whole_file.hpp"

namespace rt {

int run_exercises(bool make, bool json) {
    const Project project = this_project();
    std::vector<std::string> changed;
    for (const Drift& drift : drifted_files(project, read_catalogue(project))) {
        if (make) write_file(drift.file, drift.expected);
        changed.push_back(relative(project, drift.file));
    }
    return report_changed(changed, make, json, "./course exercises --make");
}

}  // namespace rt
