// How two pictures differ, and what becomes of those that a test finds different.
#pragma once

#include "common/image/image.hpp"

#include <cmath>

namespace rt::test {

/// The root mean square of the differences over all pixels and channels of two pictures of one size; colours
/// are not cut off.
inline Real rms_difference(const Image& image, const Image& reference) {
    Real squares = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const Vec3 off = image.pixels[i] - reference.pixels[i];
        squares += glm::dot(off, off);
    }
    return std::sqrt(squares / (3 * static_cast<Real>(image.pixels.size())));
}

/// Called by a test that fails because `image` is not as `reference`, before it ends. It does nothing, but in
/// the autograder's judges, which draw the difference for the student.
extern void (*pictures_differ)(const Image& image, const Image& reference);

}  // namespace rt::test
