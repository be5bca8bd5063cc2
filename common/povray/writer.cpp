// Numbers, vectors and colours as POV-Ray reads them.
#include "common/povray/writer.hpp"

#include "common/povray/optics.hpp"

namespace rt::povray {

// Adding 0 makes -0 a 0.
std::string number(Real x) { return fmt::format("{}", x + 0); }

Vec3 unit_along(const Vec3& v) { return glm::normalize(near_one(v)); }

std::string triple(const Vec3& v) {
    return fmt::format("<{}, {}, {}>", number(v.x), number(v.y), number(v.z));
}

std::string rgb(const Vec3& c) { return "rgb " + (is_grey(c) ? number(c.x) : triple(c)); }

}  // namespace rt::povray
