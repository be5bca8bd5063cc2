// The ray tree of a pixel as JSON, and as text.
#pragma once

#include "common/scene/scene.hpp"
#include "common/terminal/console.hpp"
#include "common/world/world.hpp"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <string>

namespace rt {

/// A tree may have any number of rays: 2^depth between two panes of glass. So many are written down.
inline constexpr std::size_t most_rays = 10'000;

/// The rays through the middle of pixel (x, y) of a scene, which `course trace --json` prints:
/// {"scene","x","y", "color","tree_color","complete","rays":[…]}, where a ray says where it comes from, what
/// it hits, what light arrives there, and by which cells of which grids it goes. Where rays draw random
/// numbers each sample has a tree of its own: it is that of the pixel's first one. Throws InputError if the
/// picture has no such pixel.
nlohmann::ordered_json ray_tree(const Scene& scene, int x, int y);

/// The same of a scene that is compiled: for many pixels.
nlohmann::ordered_json ray_tree(const Scene& scene, const World& world, int x, int y);

/// Ray `index` of the list "rays" as lines, indented by its depth, what it is in this tone.
std::string ray_text(const nlohmann::ordered_json& rays, std::size_t index, Tone heading = Tone::Plain);

/// The whole tree as lines.
std::string tree_text(const nlohmann::ordered_json& tree, Tone heading = Tone::Plain);

/// Ray `index` of the list "rays" on standard output, indented by its depth.
void print_ray(const nlohmann::ordered_json& rays, std::size_t index);

/// The whole tree on standard output.
void print_tree(const nlohmann::ordered_json& tree);

/// A number of a tree, to six digits.
std::string number_of_tree(const nlohmann::ordered_json& number);

/// A vector or colour of a tree: "(1, 0, 0)".
std::string triple_of_tree(const nlohmann::ordered_json& triple);

}  // namespace rt
