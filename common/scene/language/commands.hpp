// The table of commands, a file a subject. To add a command, add one row to its subject's table.
// What the new row needs besides is said at the end of common/scene/README.md.
#pragma once

#include "common/scene/language/parser.hpp"

#include <span>

namespace rt::language {

/// A row of the table: what the reference says, and what the parser does with a line of the right number of
/// words.
struct CommandRow {
    SceneCommand reference;
    void (*handle)(Parser&);
};

std::span<const CommandRow> picture_commands();    ///< size, camera, background, ...
std::span<const CommandRow> tracing_commands();    ///< integrator, maxdepth, accelerator, ...
std::span<const CommandRow> shape_commands();      ///< sphere, vertex, mesh, ...
std::span<const CommandRow> transform_commands();  ///< translate, pushTransform, ...
std::span<const CommandRow> light_commands();      ///< point, attenuation, ...
std::span<const CommandRow> material_commands();   ///< ambient, ior, ...
std::span<const CommandRow> sampling_commands();   ///< spp, filter, ...
std::span<const CommandRow> texture_commands();    ///< texture, marble, environment, ...
std::span<const CommandRow> blur_commands();       ///< quadLight, lens, motion, ...

/// All of them by chapter, those of one chapter in the order above.
std::span<const CommandRow> all_commands();

// What can be told only at the end of the file.

void require_camera(const Parser& parser);
void require_closed_combinations(const Parser& parser);
void require_adaptable_sampler(const Parser& parser);

}  // namespace rt::language
