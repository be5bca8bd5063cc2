// All lobes under one name, as light transport asks them.
#include "chapters/11_textures/lobes.hpp"

namespace rt {

Vec3 evaluate(const Lobe& lobe, const Vec3& to_light, const Vec3& to_viewer) {
    return std::visit([&](const auto& kind) { return evaluate(kind, to_light, to_viewer); }, lobe);
}

Real pdf(const Lobe& lobe, const Vec3& to_light, const Vec3& to_viewer) {
    return std::visit([&](const auto& kind) { return pdf(kind, to_light, to_viewer); }, lobe);
}

std::optional<LobeSample> sample(const Lobe& lobe, const Vec3& to_viewer, const Vec3& random) {
    return std::visit([&](const auto& kind) { return sample(kind, to_viewer, random); }, lobe);
}

}  // namespace rt
