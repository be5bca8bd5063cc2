// A class beyond one machine: the script that marks it in parts on an engine that is there already.
#include "common/grading/class_script.hpp"

#include "common/math/counted.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/project.hpp"
#include "common/terminal/shell.hpp"
#include "common/terminal/template.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

const std::vector<std::string>& engines() {
    static const std::vector<std::string> names{"parallel", "slurm"};
    return names;
}

void require_engine(std::string_view name) {
    if (std::find(engines().begin(), engines().end(), name) == engines().end())
        throw InputError(fmt::format("a class can be marked on {}, not on '{}'", fmt::join(engines(), " or "),
                                     printable(name)));
}

int usual_parts(std::size_t submissions) { return static_cast<int>((submissions + 9) / 10); }

std::string class_script(const ClassScript& script) {
    require_engine(script.engine);
    std::vector<std::string> submissions;
    for (const fs::path& path : script.submissions) submissions.push_back(path.string());
    const TemplateView view = {
        {"course", shell_word(script.course.string())},
        {"directory", shell_word(script.directory.string())},
        {"options", shell_words(script.options)},
        {"parts", script.parts},
        {"in_parts", counted(script.parts, "part")},
        {"submissions", shell_words(submissions, " \\\n        ")},
        {"format", script.format},
        {"rubric", script.rubric.empty() ? "" : " --rubric " + shell_word(script.rubric)},
        {"marks", "marks." + script.format}};
    const fs::path templates = this_project().root / "common/grading/engines";
    return filled(templates / (script.engine + ".mustache"), view, Escape::None, {templates});
}

}  // namespace rt
