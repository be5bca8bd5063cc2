// A curve of error against samples and seconds: pictures of one scene by one way of sampling.
#pragma once

#include "tests/report/picture_errors.hpp"
#include "tests/report/pictures.hpp"

#include <vector>

namespace rt::report {

/// A way of taking a pixel's samples.
struct Way {
    const char* name;
    Sampler sampler;
    bool adaptive = false;
    double theory = 0;  ///< exponent of samples; 0 where none is printed
};

/// `repeats` pictures of `count` samples a pixel, each of another seed. Without `estimated` they are not
/// asked how wrong they are, which takes as long as they do.
PicturePoint measure_point(Scene& scene, const Way& way, int count, const Image& truth, int repeats,
                           bool estimated = true);

/// The curve of these points: its exponents, and what stops it.
PictureCurve curve_of(const Way& way, std::vector<PicturePoint> points, const Truth& truth);

}  // namespace rt::report
