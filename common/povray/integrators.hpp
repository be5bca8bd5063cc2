// How POV-Ray expresses an integrator: what the light of a scene becomes.
#pragma once

#include "common/povray/writer.hpp"

namespace rt::povray {

/// A row of the table in integrators.cpp.
struct Expression {
    Integrator integrator;
    Vec3 (*background)(const Writer&);
    void (*write_lights)(Writer&);
    void (*write_textures)(Writer&);
    std::string (*object)(const Scene&, const Object&);  ///< its statement; null where none is shown
    /// What makes a statement of an area light's shape; null where POV-Ray cannot say it.
    std::string (*area_light)(const Scene&, const AreaLight&);
};

/// Refuses the scene where its integrator has no row here; common/scene/integrators.hpp says why not.
const Expression& expression_of(const Scene& scene);

}  // namespace rt::povray
