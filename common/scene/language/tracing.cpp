// Commands that say how rays become colours, and what is built to find what they hit.
#include "common/scene/accelerators.hpp"
#include "common/scene/language/arguments.hpp"
#include "common/scene/language/commands.hpp"

#include <limits>

namespace rt::language {

namespace {

constexpr Word<Visibility> visibilities[] = {{"rays", Visibility::Rays},
                                             {"rasterize", Visibility::Rasterize}};

void set_integrator(Parser& parser) {
    const std::optional<IntegratorChoice> chosen = integrator_named(parser.words[1]);
    if (!chosen) fail_choice(parser, 1, integrator_names());
    parser.scene.integrator = chosen->integrator;
    parser.integrator_rasterizes = chosen->visibility == Visibility::Rasterize;
}

void set_visibility(Parser& parser) {
    parser.scene.visibility = choice(parser, visibilities);
    parser.scene.visibility_place = place_of(parser, parser.words[0]);
}

void set_maxdepth(Parser& parser) {
    parser.scene.max_depth =
        static_cast<int>(whole_setting(parser, "the number of bounces", 0, std::numeric_limits<int>::max()));
}

/// `name` meaning; `name` meaning
template <class Row, std::size_t N>
std::string meanings(const Row (&rows)[N]) {
    std::string text;
    for (const Row& row : rows)
        text.append(text.empty() ? "`" : "; `").append(row.name).append("` ").append(row.meaning);
    return text;
}

const CommandRow rows[] = {
    {{"integrator", alternatives(integrators) + "|" + std::string(rasterize_word),
      "How rays become colours: " + meanings(integrators) +
          "; `rasterize` is an older word for `normals` with `visibility rasterize`.",
      "01"},
     set_integrator},
    {{"visibility", alternatives(visibilities),
      "How a picture finds what its pixels see: `rays` (default), or `rasterize`: scan conversion of "
      "triangles with a z-buffer, at the pixels' centres, for the integrators " +
          integrators_with(&IntegratorRow::hit_alone) + ", which ask for nothing but the nearest hit.",
      "03"},
     set_visibility},
    {{"shadows", alternatives(on_or_off), "Whether things stand in each other's light; default on.", "06"},
     [](Parser& p) { p.scene.shadows = choice(p, on_or_off); }},
    {{"maxdepth", "n", "Greatest number of bounces; default 5.", "07"}, set_maxdepth},
    {{"mincontribution", "c",
      "Rays whose weight is not greater than c in any channel are not followed; default 0.", "07"},
     [](Parser& p) { p.scene.min_contribution = not_negative(p, 1, "the least contribution"); }},
    {{"accelerator", alternatives(accelerator_words),
      "What is built so that a ray need not ask every shape: " + meanings(accelerator_words) +
          ". The picture is the same to the bit.",
      "09"},
     [](Parser& p) { p.scene.accelerator = choice(p, accelerator_words); }},
};

}  // namespace

std::span<const CommandRow> tracing_commands() { return rows; }

}  // namespace rt::language
