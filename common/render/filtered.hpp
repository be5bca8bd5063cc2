// Pictures on surfaces, averaged over what a pixel sees of them: rays carry their differentials.
#pragma once

#include "common/world/query.hpp"

namespace rt {

/// As `radiance` of chapter 7, for a world whose needs say `footprints`: each ray of the tree knows how it
/// changes from pixel to pixel (Igehy 1999), and textures are averaged over the pixel's footprint.
Vec3 filtered_radiance(const World& world, const Ray& ray, Stream& stream);

/// As `cast_ray` of chapter 1, likewise: ambient + emission.
Vec3 filtered_own_light(const World& world, const Ray& ray, Stream& stream);

}  // namespace rt
