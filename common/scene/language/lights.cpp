// Commands of the lights.
#include "common/scene/language/arguments.hpp"
#include "common/scene/language/commands.hpp"

namespace rt::language {

namespace {

void add_directional(Parser& parser) {
    const Vec3 towards = direction(parser, 1, "the direction to the light");
    parser.scene.lights.push_back(DirectionalLight{towards, color(parser, 4)});
}

void add_point(Parser& parser) {
    const Vec3 position = place3(parser, 1);
    parser.scene.lights.push_back(PointLight{position, color(parser, 4), parser.attenuation});
}

void set_attenuation(Parser& parser) {
    parser.attenuation = not_negative3(parser, 1, "attenuation");
    for (std::size_t i = 1; i <= 3; ++i)
        if (number(parser, i) != 0) sized(parser, i, "an attenuation that is not 0");
    if (parser.attenuation == Vec3(0))
        fail(parser, parser.words[1], "attenuation 0 0 0 would divide light by zero");
}

const CommandRow rows[] = {
    {{"directional", "x y z r g b",
      "Light from infinitely far away; (x, y, z) points towards it. In world space, not attenuated.", "05"},
     add_directional},
    {{"point", "x y z r g b", "Light at (x, y, z) in world space, with the attenuation in force.", "05"},
     add_point},
    {{"attenuation", "c l q",
      "For the point lights that follow: light at distance d is divided by c + l·d + q·d²; default 1 0 0.",
      "05"},
     set_attenuation},
};

}  // namespace

std::span<const CommandRow> light_commands() { return rows; }

}  // namespace rt::language
