// Families of extreme cases for chapter 10's boxes, discs and cones, and their judge.
//
// Demands. Boxes: exact, but for 4u|t| in t, and where entry and exit differ by no more than that. Discs and
// cones: the answer is the exact one of a shape whose surface has been moved by no more than η, but for 8u|t|
// in t. Where some of these shapes are hit and others missed, either answer is right. With f = origin − a
// place of the shape, η is 8u(|f| + radius) for a disc, and 8u|f| + 40u(|b − a| + the greater radius) for a
// cone, along its axis; across the axis it is more by the slope of the side.
//
// Why 40: the way to the point near a is rounded 3 times, in units of u|f|. What follows is in units of u
// times the cone's size: the axis 1, e 3 and m 3, the length of the axis in α and β 3 each, the place along
// the axis and its step 7 each, times the slope, and the radius 3; the coefficients, the discriminant and the
// roots 7. Few of them reach the same number.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"
#include "common/world/hit.hpp"
#include "tests/stability/verdict.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace rt::stability {

template <class Shape>
struct SolidCase {
    Shape shape;
    Ray ray;
};

template <class Shape>
struct SolidFamily {
    const char* name;
    std::vector<SolidCase<Shape>> (*make)(std::size_t count, std::uint64_t seed);
    bool breaks_textbook = true;  ///< one on which that is right, too, only looks after the course's method
};

/// All the families; any prefix of a family's cases is the same for every count.
std::span<const SolidFamily<Box>> box_families();
std::span<const SolidFamily<Disc>> disc_families();
std::span<const SolidFamily<Cone>> cone_families();

/// Judges the nearest hit for the range (0, infinity].
Verdict judge(std::span<const SolidCase<Box>> cases, std::span<const std::optional<Hit>> answers);
Verdict judge(std::span<const SolidCase<Disc>> cases, std::span<const std::optional<Hit>> answers);
Verdict judge(std::span<const SolidCase<Cone>> cases, std::span<const std::optional<Hit>> answers);

}  // namespace rt::stability

namespace rt::naive {

/// Slabs by the inverse of the direction, with std::min and std::max (as in most programs).
std::optional<Hit> intersect(const Box& box, const Ray& ray, Interval range);

/// The point of the plane in the world, and its distance from the centre.
std::optional<Hit> intersect(const Disc& disc, const Ray& ray, Interval range);

/// The quadratic from its coefficients, in the frame of a unit axis, both caps as discs, and the nearest of
/// the four that counts (Glassner 1989, chapter 2).
std::optional<Hit> intersect(const Cone& cone, const Ray& ray, Interval range);

}  // namespace rt::naive
