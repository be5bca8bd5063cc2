// Commands that say how rays become colours, and what is built to find what they hit.
#include "common/scene/accelerators.hpp"
#include "common/scene/language/arguments.hpp"
#include "common/scene/language/commands.hpp"

#include <limits>

namespace rt::language {

namespace {

constexpr Word<Integrator> integrators[] = {
    {"raytrace", Integrator::Raytrace}, {"flat", Integrator::Flat}, {"directions", Integrator::Directions},
    {"normals", Integrator::Normals},   {"uv", Integrator::Uv},     {"rasterize", Integrator::Rasterize}};

void set_maxdepth(Parser& parser) {
    parser.scene.max_depth =
        static_cast<int>(whole_setting(parser, "the number of bounces", 0, std::numeric_limits<int>::max()));
}

/// `word` meaning; `word` meaning
std::string accelerator_meanings() {
    std::string text;
    for (const AcceleratorWord& word : accelerator_words)
        text.append(text.empty() ? "`" : "; `").append(word.name).append("` ").append(word.meaning);
    return text;
}

const CommandRow rows[] = {
    {{"integrator", alternatives(integrators),
      "How rays become colours: `raytrace` (default) is the whole sum of light; `flat` is ambient + "
      "emission; `directions` and `normals` show (x + 1)/2 of unit vectors, `uv` the texture coordinates; "
      "`rasterize` is the z-buffer's `normals`.",
      "01"},
     [](Parser& p) { p.scene.integrator = choice(p, integrators); }},
    {{"shadows", alternatives(on_or_off), "Whether things stand in each other's light; default on.", "06"},
     [](Parser& p) { p.scene.shadows = choice(p, on_or_off); }},
    {{"maxdepth", "n", "Greatest number of bounces; default 5.", "07"}, set_maxdepth},
    {{"mincontribution", "c",
      "Rays whose weight is not greater than c in any channel are not followed; default 0.", "07"},
     [](Parser& p) { p.scene.min_contribution = not_negative(p, 1, "the least contribution"); }},
    {{"accelerator", alternatives(accelerator_words),
      "What is built so that a ray need not ask every shape: " + accelerator_meanings() +
          ". The picture is the same to the bit.",
      "09"},
     [](Parser& p) { p.scene.accelerator = choice(p, accelerator_words); }},
};

}  // namespace

std::span<const CommandRow> tracing_commands() { return rows; }

}  // namespace rt::language
