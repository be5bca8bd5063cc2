// Whether the solutions are here: the course's own tree has them, a handout has not.
#include "common/workbook/solutions.hpp"

#include "common/math/input_error.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace rt {

bool has_solutions(const Project& project) {
    return std::filesystem::is_directory(project.root / "solutions");
}

void require_solutions(const Project& project, std::string_view what) {
    if (!has_solutions(project))
        throw InputError(fmt::format("this is a handout, which has no solutions; {} needs them", what));
}

}  // namespace rt
