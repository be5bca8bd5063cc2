// What the commands say that keep generated files true to their sources.
#include "common/commands/changed_files.hpp"

#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rt {

int report_changed(const std::vector<std::string>& files, bool make, bool json, const char* repair) {
    if (json) {
        const nlohmann::ordered_json object = {{"changed", files}, {"written", make}};
        fmt::print("{}\n", json_text(object));
    } else {
        for (const std::string& file : files) fmt::print("{} {}\n", make ? "wrote" : "differs:", file);
        if (files.empty()) fmt::print("nothing has changed\n");
        if (!files.empty() && !make) say("{} writes what differs", repair);
    }
    return files.empty() || make ? 0 : 1;
}

}  // namespace rt
