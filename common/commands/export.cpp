// `course export`: a scene in POV-Ray's language.
#include "common/povray/export.hpp"
#include "common/commands/commands.hpp"
#include "common/image/whole_file.hpp"
#include "common/pictures/scene_file.hpp"
#include "common/render/snapshots.hpp"
#include "common/scene/parse.hpp"
#include "common/terminal/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rt {

int run_export(const ExportCommand& command) {
    const Scene scene = read_scene(command.scene, command.lenient);
    require_no_input(command.output, files_of(command.scene, scene));
    require_writable(command.output);
    write_file(command.output, export_povray(scene, snapshots_of(scene)));
    if (command.json) fmt::print("{}\n", json_text(nlohmann::json{{"output", command.output.string()}}));
    return 0;
}

}  // namespace rt
