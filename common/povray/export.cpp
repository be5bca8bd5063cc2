// A whole scene, statement by statement: settings, camera, lights, textures, objects.
#include "common/povray/export.hpp"

#include "common/povray/area_lights.hpp"
#include "common/povray/camera.hpp"
#include "common/povray/exposure.hpp"
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
#include <stdexcept>
#include <utility>

namespace rt {

using namespace povray;

namespace {

/// POV-Ray's own limit of max_trace_level.
constexpr int most_trace_levels = 256;

std::string brightened(const Scene& scene) {
    const Real exposure = exposure_of(scene);
    return exposure == 1 ? "" : fmt::format(", times {}", 1 / exposure);
}

std::string comments_of(const Scene& scene) {
    const std::filesystem::path file(scene.file);
    const PovrayRun run = povray_run(scene);
    const std::string options = run.options.empty() ? "-A" : fmt::format("{}", fmt::join(run.options, " "));
    const std::string frames = run.frames > 1 ? fmt::format(" +KFI0 +KFF{}", run.frames - 1) : "";
    std::string text = fmt::format("// {}, written by `course export`.\n", file.filename().string());
    text +=
        fmt::format("// povray +I{0}.pov +O{0}.png +W{1} +H{2} +FN16 -D {3} File_Gamma=1.0{4}\n",
                    file.stem().string(), scene.width * run.scale, scene.height * run.scale, options, frames);
    if (run.scale > 1)
        text += fmt::format("// then {0} × {0} of its pixels are one of ours, weighed by our filter\n",
                            run.scale);
    else if (run.frames > 1)
        text += fmt::format("// then a pixel's samples are those of {} pictures, weighed by our filter{}\n",
                            run.frames, brightened(scene));
    else if (run.filter)
        text += "// then its pixels are weighed by our filter\n";
    return text;
}

void write_factor(Writer& out) {
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
    out.line("background {{ {} }}", rgb(expression_of(scene).background(out)));
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
    for (const AreaLightObject& object : scene.area_lights) {
        if (!expression.area_light)
            refuse(scene, object,
                   fmt::format("what the integrator {} shows of it", row_of(scene.integrator).name));
        out.line("{}{} }}", open_statement(object.light), expression.area_light(scene, object.light));
    }
}

/// All that the snapshot shows.
std::string text_of(const Scene& scene, Real exposure, Snapshot snapshot) {
    const Expression& expression = expression_of(scene);
    const Scene still = still_of(scene, snapshot);
    refuse_other_optics(still);
    if (may_bounce(scene)) refuse_other_eye(scene, still);
    const Real factor = factor_for(still);
    const Scene here = scaled(exposed(still, exposure), factor);
    for (FacingLight& light : snapshot.lights) light.color *= exposure;
    Writer out{.scene = here, .snapshot = snapshot, .factor = factor};
    write_factor(out);
    write_settings(out);
    write_camera(out);
    expression.write_lights(out);
    out.line("");
    write_sky_sphere(out);
    expression.write_textures(out);
    write_objects(out);
    return std::move(out.text);
}

}  // namespace

std::string export_povray(const Scene& scene, std::span<const Snapshot> snapshots) {
    expression_of(scene);  // or there is no use in asking further
    if (const int count = snapshot_count(scene);
        count > 0 && snapshots.size() != static_cast<std::size_t>(count))
        throw std::invalid_argument("export_povray: these are not the snapshots of the scene");
    const Real exposure = exposure_of(scene);
    std::string text = comments_of(scene);
    if (snapshots.size() <= 1)
        return text + text_of(scene, exposure, snapshots.empty() ? Snapshot() : snapshots.front());
    text += "#version 3.7;\n#switch (frame_number)\n";  // it wants the version before all else
    for (std::size_t k = 0; k < snapshots.size(); ++k)
        text += fmt::format("#case ({})\n{}#break\n", k, text_of(scene, exposure, snapshots[k]));
    return text + "#end\n";
}

}  // namespace rt
