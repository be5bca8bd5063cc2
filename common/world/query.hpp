// What a chapter may ask of a whole World. Implemented in common/render by dispatch over the shapes that
// occur, because every chapter adds to the answers.
#pragma once

#include "common/world/ray_counts.hpp"
#include "common/world/stream.hpp"
#include "common/world/world.hpp"

#include <optional>
#include <span>
#include <vector>

namespace rt {

/// Nearest hit in (range.min, range.max], or nothing. Of equal distances the first in the file wins.
std::optional<Hit> closest_hit(const World& world, const Ray& ray, Interval range);

/// The hit that comes after `last`, a hit of the same ray, up to and including range.max, or nothing.
///
/// Hits are ordered by distance; of equal distances, as where several sheets lie in one place, each object
/// has its turn in the order of the file. An object that is met twice at one distance, on an edge between
/// two of its triangles, is met once.
std::optional<Hit> next_hit(const World& world, const Ray& ray, const Hit& last, Interval range);

/// Whether anything at all is hit in (range.min, range.max]; stops at the first that is.
bool occluded(const World& world, const Ray& ray, Interval range);

/// Nearest hit with the mesh's triangles in (range.min, range.max], for a ray in the mesh's own space;
/// `Hit::primitive` is the triangle's index. Of equal distances the lowest wins.
std::optional<Hit> closest_hit(const SharedMesh& mesh, const Ray& local, Interval range);

/// Whether any triangle of the mesh is hit in the range, for a ray in the mesh's own space.
bool occluded(const SharedMesh& mesh, const Ray& local, Interval range);

/// A hit for each of the mesh's triangles that the line of the ray meets, in no order; also those with t ≤ 0.
/// `Hit::primitive` is the triangle's index.
std::vector<Hit> all_hits(const SharedMesh& mesh, const Ray& local);

/// The surface at a hit that `closest_hit` returned for the same world and ray.
Surface surface_at(const World& world, const Ray& ray, const Hit& hit);

/// The material at a hit, its checker decided: index into world.materials.
std::uint32_t material_index(const World& world, const Hit& hit, const Surface& surface);

/// The material at a hit, its checker decided, its textures applied. A value, because its numbers may be this
/// hit's own.
Material material_at(const World& world, const Hit& hit, const Surface& surface);

/// The material of what is around a ray that is inside of these, outermost first: of the last that is not a
/// sheet. Null where there is none: nothing is around it.
const Material* material_around(const World& world, std::span<const Medium> inside);

/// Radiance that the surface sends towards the viewer by itself and by reflecting the lights directly:
/// ambient + emission + diffuse · skylight + Σ visible · L/(c + l·d + q·d²) · (diffuse · max(n·l, 0) +
/// specular · highlight). `normal` is the unit shading normal, turned to the viewer; `to_viewer` is a unit
/// vector.
Vec3 local_light(const World& world, const Surface& surface, const Material& material, const Vec3& normal,
                 const Vec3& to_viewer);

/// The same at a time, in a world that has area lights or motion: with the light of area lights, each by as
/// many random points as the scene says, and not more than one point of one light if it chooses one.
Vec3 local_light(const World& world, const Surface& surface, const Material& material, const Vec3& normal,
                 const Vec3& to_viewer, Real time, Stream& stream);

/// What a hit of an area light shows to the ray: its radiance on the bright side, black on the dark one;
/// nothing if the hit is of something else.
std::optional<Vec3> light_at(const World& world, const Ray& ray, const Hit& hit);

/// The exponent of the lobe in which a material spreads mirrored rays, or refracted ones; 0 if it does not.
Real gloss_of(const World& world, const Material& material, bool refracted);

/// What the sky shows in a direction, of any length but 0, in a world whose needs say that it has one.
Vec3 sky_color(const World& world, const Vec3& direction);

/// What is seen in a direction, of any length but 0, where nothing is hit.
inline Vec3 background(const World& world, const Vec3& direction) {
    return world.needs.sky ? sky_color(world, direction) : world.background;
}

/// What a camera ray is a function of.
struct CameraSample {
    Vec2 place{0};   ///< of the picture, in pixels: as for pixel_ray
    Vec2 lens{0.5};  ///< of the unit square, mapped to the lens
    Real time = 0;   ///< in the shutter interval [0, 1]
};

/// The ray of a sample, in world space; its direction is a unit vector.
Ray camera_ray(const World& world, const CameraSample& sample);

/// The sample of a place of the picture. What the camera needs besides is drawn from the stream: a point of
/// the lens, if there is one, and then the time, if anything moves.
CameraSample camera_sample(const World& world, const Vec2& place, Stream& stream);

/// The ray of that sample.
Ray camera_ray(const World& world, const Vec2& place, Stream& stream);

}  // namespace rt
