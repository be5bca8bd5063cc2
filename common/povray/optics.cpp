// Which objects send rays on, and which take light from them.
#include "common/povray/optics.hpp"

#include <algorithm>

namespace rt::povray {

bool may_bounce(const Scene& scene) { return row_of(scene.integrator).tree && scene.max_depth > 0; }

bool has_bounces(const Scene& scene) {
    return may_bounce(scene) && std::ranges::any_of(scene.objects, [&](const Object& object) {
               const Material& m = material_of(scene, object);
               return is_transparent(m) || !is_black(m.specular) || m.fresnel != Fresnel::None;
           });
}

bool is_glass(const Scene& scene, const Object& object) {
    return row_of(scene.integrator).tree && is_transparent(material_of(scene, object));
}

bool absorbs(const Scene& scene) {
    return may_bounce(scene) && std::ranges::any_of(scene.objects, [&](const Object& object) {
               return is_glass(scene, object) && !is_black(material_of(scene, object).absorption);
           });
}

}  // namespace rt::povray
