// Commands of the current material.
#include "common/scene/language/arguments.hpp"
#include "common/scene/language/commands.hpp"

namespace rt::language {

namespace {

constexpr Word<Highlight> highlights[] = {{"blinn", Highlight::Blinn}, {"phong", Highlight::Phong}};
constexpr Word<Fresnel> fresnels[] = {
    {"none", Fresnel::None}, {"exact", Fresnel::Exact}, {"schlick", Fresnel::Schlick}};

void set_checker(Parser& parser) {
    const Vec3 even = color(parser, 1), odd = color(parser, 4);
    parser.material.checker = {even, odd, sized(parser, 7, "the size of the checker's cubes")};
}

void set_transmission(Parser& parser) {
    parser.material.transmission = not_negative3(parser, 1, "transmission");
    color(parser, 1);  // whether it is in range
}

const CommandRow rows[] = {
    {{"ambient", "r g b",
      "For the objects that follow: light that they give off whatever the lights; default .2 .2 .2.", "01"},
     [](Parser& p) { p.material.ambient = color(p, 1); }},
    {{"emission", "r g b", "For the objects that follow: light that they give off besides; default 0 0 0.",
      "01"},
     [](Parser& p) { p.material.emission = color(p, 1); }},
    {{"checker", "r g b r g b size",
      "For the objects that follow: two colours that multiply ambient, diffuse and emission, in solid cubes "
      "of the given size in world space. The first where the sum of the floors of x/size, y/size and z/size "
      "is even. `checker 1 1 1 1 1 1 1` is none.",
      "01"},
     set_checker},
    {{"diffuse", "r g b",
      "For the objects that follow: weight of light that is scattered evenly; default 0 0 0.", "05"},
     [](Parser& p) { p.material.diffuse = color(p, 1); }},
    {{"specular", "r g b",
      "For the objects that follow: weight of the highlight and of the mirror direction; default 0 0 0.",
      "05"},
     [](Parser& p) { p.material.specular = color(p, 1); }},
    {{"shininess", "s", "For the objects that follow: exponent of the highlight, at least 0; default 0.",
      "05"},
     [](Parser& p) { p.material.shininess = not_negative(p, 1, "the shininess"); }},
    {{"highlight", alternatives(highlights),
      "For the objects that follow: highlight from the half vector (default) or from the reflection vector.",
      "05"},
     [](Parser& p) { p.material.highlight = choice(p, highlights); }},
    {{"transmission", "r g b",
      "For the objects that follow: weight of the refracted ray; default 0 0 0, opaque.", "07"},
     set_transmission},
    {{"ior", "n", "For the objects that follow: index of refraction inside, greater than 0; default 1.",
      "07"},
     [](Parser& p) { p.material.ior = sized(p, 1, "the index of refraction"); }},
    {{"fresnel", alternatives(fresnels),
      "For the objects that follow: how much light a transparent surface mirrors; default none.", "07"},
     [](Parser& p) { p.material.fresnel = choice(p, fresnels); }},
    {{"absorption", "r g b",
      "For the objects that follow: light inside is multiplied by exp(−absorption · distance); default none.",
      "07"},
     [](Parser& p) { p.material.absorption = not_negative3(p, 1, "absorption"); }},
};

}  // namespace

std::span<const CommandRow> material_commands() { return rows; }

}  // namespace rt::language
