// How POV-Ray makes a scene's picture.
#pragma once

#include "common/scene/scene.hpp"

#include <string>
#include <vector>

namespace rt {

/// Where one ray through each pixel's centre is not enough.
struct PovrayRun {
    int scale = 1;                     ///< the picture is made so many times as wide and high, then filtered
    std::vector<std::string> options;  ///< for antialiasing by POV-Ray itself
    bool filter = false;  ///< whether its pixels are samples, to be weighed by the scene's filter
    bool exact = true;    ///< whether its samples are the same as ours; else only the means are the same
    int frames = 1;       ///< so many pictures are made, each of one sample of every pixel
};

/// Regular samples are the pixels of a larger picture; POV-Ray's antialiasing methods 2 and 1, their
/// threshold 0, take the trapezoid rule's samples of 2^k cells a side, and centered samples. Random samples
/// it cannot repeat: then a picture 8 × 8 times as large, with 2 × 2 samples and one more in each of its
/// pixels, tells their mean. (8 × 8 alone were more wrong than the pictures that they judged.) Of a blurred
/// scene each snapshot is a picture (common/scene/snapshot.hpp).
PovrayRun povray_run(const Scene& scene);

}  // namespace rt
