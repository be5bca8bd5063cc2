// The ray trees of a scene's pixels, as the student's code makes them.
#include "common/commands/student_trees.hpp"

#include "common/math/input_error.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/check.hpp"

#include <fmt/format.h>

namespace rt {

using nlohmann::ordered_json;

std::vector<ordered_json> student_trees(const Project& project, const std::vector<const Chapter*>& mine,
                                        const std::filesystem::path& scene, bool lenient,
                                        const std::vector<std::pair<int, int>>& pixels) {
    const BuildResult build = build_mine(project, mine);
    if (!build.ok) throw InputError("your chapters do not build: " + build.message);
    ProcessOptions options;
    options.time_limit = 60;
    options.merge_errors = false;
    options.environment = {{mine_variable, numbers_of(mine)}};
    options.output_limit = std::size_t{256} << 20;
    std::string also;
    for (std::size_t i = 1; i < pixels.size(); ++i)
        also += fmt::format("{}{},{}", i > 1 ? " " : "", pixels[i].first, pixels[i].second);
    std::vector<std::string> line{program(project, "course_mine").string(),
                                  "trace",
                                  scene.string(),
                                  std::to_string(pixels.front().first),
                                  std::to_string(pixels.front().second),
                                  "--json"};
    if (lenient) line.push_back("--lenient");
    if (!also.empty()) line.insert(line.end(), {"--also", also});
    const ProcessResult result = run_process(line, options);
    const std::string what = pixels.size() == 1 ? "this pixel" : "these pixels";
    if (!succeeded(result))
        throw InputError(result.timed_out     ? "your code takes more than a minute for " + what
                         : result.signal != 0 ? "your code crashed: " + signal_name(result.signal)
                                              : "your code made no tree of " + what);
    const ordered_json told = read_ordered_json(result.output);
    if (told.is_discarded())
        throw InputError(fmt::format("the tree that your code makes of {} is too large to compare", what));
    if (also.empty()) return {told};
    return told["trees"].get<std::vector<ordered_json>>();
}

}  // namespace rt
