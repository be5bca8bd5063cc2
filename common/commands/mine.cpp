// The program that is linked with the student's chapters in place of solutions, and when commands go on as
// it.
#include "common/commands/mine.hpp"

#include "common/math/input_error.hpp"
#include "common/terminal/lock.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/check.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <stdexcept>

namespace rt {

const char* linked_chapters() { return std::getenv(mine_variable); }

void become_mine(const Project& project, const OwnCode& own, const std::vector<std::string>& arguments) {
    if (is_empty(own)) return;
    const BuildResult build = build_mine(project, own);
    if (!build.ok) throw InputError("your chapters do not build: " + build.message);
    std::vector<std::string> line{program(project, "course_mine").string()};
    line.insert(line.end(), arguments.begin(), arguments.end());
    replace_process(line, {{mine_variable, in_words(own)}});
    throw std::runtime_error(line.front() + " cannot be started");
}

void become_mine_in_handout(const std::vector<std::string>& arguments) {
    const Project project = this_project();
    if (linked_chapters() || has_solutions(project)) return;
    const std::vector<Chapter> chapters = read_catalogue(project);
    become_mine(project, own_code(project, chapters), arguments);
}

std::string whose_code() {
    const char* linked = linked_chapters();
    if (!linked) return "solutions for all chapters";
    return has_solutions(this_project()) ? fmt::format("your code for {}, solutions for the rest", linked)
                                         : "your code";
}

std::vector<const Chapter*> pointers_to(const std::vector<Chapter>& chapters) {
    std::vector<const Chapter*> pointers;
    for (const Chapter& chapter : chapters) pointers.push_back(&chapter);
    return pointers;
}

}  // namespace rt
