// Refraction, absorption, and the media around the eye.
#include "common/povray/interiors.hpp"

#include "common/povray/optics.hpp"
#include "common/povray/placement.hpp"
#include "common/povray/refuse.hpp"

#include <algorithm>

namespace rt::povray {
namespace {

/// Its rays end at 1e7.
constexpr Real sky_radius = 1e6;

/// How many steps the index of refraction of a transparent object must differ from what the scene says, so
/// that it differs from that of nothing where the object may stand in nothing, and from that of bodies that
/// it may overlap.
int bending_steps(const Scene& scene, const Object& object) {
    const Real ior = material_of(scene, object).ior;
    bool is_within = false;  // a ball of other glass
    int steps = 0;
    bool is_earlier = true;
    for (const Object& other : scene.objects) {
        if (&other == &object) is_earlier = false;
        if (&other == &object || !is_glass(scene, other)) continue;
        if (material_of(scene, other).ior != ior)
            is_within = is_within || is_ball_within(object, other);
        else if (is_earlier && may_overlap(scene, object, other))
            ++steps;
    }
    return steps + (ior == 1 && !is_within ? 1 : 0);
}

/// Beer–Lambert as a medium: POV-Ray's fade_power 1001 has the same formula, but leaves out the ways
/// between inner reflections.
///
/// POV-Ray does not count a bounce where rays are not bent. So no body has quite the index of refraction of
/// what is around it: the differences are steps of its single precision.
std::string interior(const Scene& scene, const Object& object) {
    const Material& m = material_of(scene, object);
    const int steps = bending_steps(scene, object);
    // Nine digits are more than single precision has.
    const std::string ior = steps == 0 ? number(m.ior) : fmt::format("{:.9g}", m.ior * (1 + steps * 1e-6));
    std::string text = fmt::format(" interior {{ ior {}", ior);
    if (!is_black(m.absorption)) text += fmt::format(" media {{ absorption {} }}", rgb(m.absorption));
    return text + " }";
}

/// Media are only where every body around is hollow.
bool must_be_hollow(const Scene& scene, const Object& object) {
    return absorbs(scene) && (is_glass(scene, object) || may_surround_eye(scene, object));
}

/// POV-Ray takes any body around the eye for a medium, even if it is opaque. `inverse` turns its inside out
/// and changes nothing that is seen.
bool must_be_inverse(const Scene& scene, const Object& object) {
    return has_bounces(scene) && !is_glass(scene, object) && surrounds_eye(scene, object) &&
           std::ranges::any_of(scene.objects, [&](const Object& other) { return is_glass(scene, other); });
}

bool absorbs_without_end(const Scene& scene, const Object& object) {
    return is_glass(scene, object) && !is_black(material_of(scene, object).absorption) &&
           is_endless(scene, object);
}

}  // namespace

std::string inside(const Scene& scene, const Object& object) {
    std::string text;
    if (is_glass(scene, object)) text += interior(scene, object);
    if (must_be_hollow(scene, object)) text += " hollow";
    if (must_be_inverse(scene, object)) text += " inverse";
    return text;
}

void write_sky(Writer& out) {
    const Scene& scene = out.scene;
    if (!absorbs(scene)) return;
    const auto endless = std::ranges::find_if(
        scene.objects, [&](const Object& object) { return absorbs_without_end(scene, object); });
    if (endless == scene.objects.end()) return;
    const Vec3 a = material_of(scene, *endless).absorption;
    for (int i = 0; i < 3; ++i)
        if (a[i] > 0 && a[i] * sky_radius < 12)  // e^-12 is less than half a 16-bit step
            refuse(scene, *endless, "absorption so weak, in a body without an end");
    out.line(
        "sphere {{ {}, {} texture {{ pigment {{ {} }} finish {{ ambient 0 diffuse 0 emission 1 }} }} "
        "no_shadow hollow }}",
        triple(scene.camera.eye), number(sky_radius), rgb(scene.background));
}

}  // namespace rt::povray
