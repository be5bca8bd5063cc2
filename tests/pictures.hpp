// What becomes of two pictures that a test finds different.
#pragma once

#include "common/image/image.hpp"

namespace rt::test {

/// Called by a test that fails because `image` is not as `reference`, before it ends. It does nothing, but in
/// the autograder's judges, which draw the difference for the student.
extern void (*pictures_differ)(const Image& image, const Image& reference);

}  // namespace rt::test
