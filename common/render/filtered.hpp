// Pictures on surfaces, averaged over what a pixel sees of them: rays carry their differentials.
#pragma once

#include "common/world/query.hpp"

namespace rt {

/// As `radiance` of chapter 7, for a world whose needs say `footprints`: each ray of the tree knows how it
/// changes from pixel to pixel (Igehy 1999), and textures are averaged over the pixel's footprint.
Vec3 filtered_radiance(const World& world, const Ray& ray, Stream& stream);

/// What the nearest hit of a camera ray shows in such a world: ambient + emission, ...
Vec3 filtered_own_light(const World& world, const Ray& ray, const Hit& hit);

/// ... or its unit shading normal n by the averaged normal map, turned to the viewer, as the colour (n +
/// 1)/2.
Vec3 filtered_normal(const World& world, const Ray& ray, const Hit& hit);

}  // namespace rt
