// A whole scene, statement by statement: settings, camera, lights, textures, objects.
#include "common/povray/export.hpp"

#include "common/povray/camera.hpp"
#include "common/povray/integrators.hpp"
#include "common/povray/interiors.hpp"
#include "common/povray/mesh.hpp"
#include "common/povray/optics.hpp"
#include "common/povray/refuse.hpp"
#include "common/povray/run.hpp"
#include "common/povray/scaling.hpp"
#include "common/povray/sky.hpp"
#include "common/povray/writer.hpp"

#include <filesystem>
#include <utility>

namespace rt {

using namespace povray;

namespace {

/// POV-Ray's own limit of max_trace_level.
constexpr int most_trace_levels = 256;

void write_comments(Writer& out) {
    const Scene& scene = out.scene;
    const std::filesystem::path file(scene.file);
    const PovrayRun run = povray_run(scene);
    out.line("// {}, written by `course export`.", file.filename().string());
    out.line("// povray +I{0}.pov +O{0}.png +W{1} +H{2} +FN16 -D {3} File_Gamma=1.0", file.stem().string(),
             scene.width * run.scale, scene.height * run.scale,
             run.options.empty() ? "-A" : fmt::format("{}", fmt::join(run.options, " ")));
    if (run.scale > 1)
        out.line("// then {0} × {0} of its pixels are one of ours, weighed by our filter", run.scale);
    else if (run.filter)
        out.line("// then its pixels are weighed by our filter");
    if (out.factor != 1)
        out.line("// All lengths are {} times those of the scene: POV-Ray's tolerances are lengths.",
                 number(out.factor));
}

void write_settings(Writer& out) {
    const Scene& scene = out.scene;
    int levels = 1;
    if (has_bounces(scene)) {
        levels = scene.max_depth + 1;
        if (levels > most_trace_levels)
            refuse(scene, fmt::format("maxdepth {} is over its limit of {}", scene.max_depth,
                                      most_trace_levels - 1));
    }
    out.line("#version 3.7;");
    out.line("global_settings {{ assumed_gamma 1 max_trace_level {} adc_bailout {} }}", levels,
             number(scene.min_contribution));
    out.line("background {{ {} }}", rgb(expression_of(scene).background(scene)));
    out.line("");
}

void write_objects(Writer& out) {
    const Scene& scene = out.scene;
    const Expression& expression = expression_of(scene);
    if (!expression.object) return;
    std::vector<bool> written(scene.meshes.size(), false);
    for (const std::vector<Object>* objects : {&scene.objects, &scene.parts})
        for (const Object& object : *objects) {
            const auto* shown = std::get_if<MeshObject>(&object.shape);
            if (!shown || written[shown->mesh]) continue;
            written[shown->mesh] = true;
            write_mesh(out, shown->mesh);
        }
    write_sky(out);
    for (const Object& object : scene.objects) out.line("{}", expression.object(scene, object));
}

}  // namespace

std::string export_povray(const Scene& scene) {
    const Expression& expression = expression_of(scene);
    refuse_other_optics(scene);
    const Real factor = factor_for(scene);
    const Scene here = scaled(scene, factor);
    Writer out{.scene = here, .factor = factor};
    write_comments(out);
    write_settings(out);
    write_camera(out);
    expression.write_lights(out);
    out.line("");
    write_sky_sphere(out);
    expression.write_textures(out);
    write_objects(out);
    return std::move(out.text);
}

}  // namespace rt
