// A scene in POV-Ray's language: every statement means the same there as here, to rounding.
// The mappings were measured with POV-Ray 3.7.0; the first lines of what this writes say how to render it.
#pragma once

#include "common/scene/scene.hpp"

#include <string>
#include <vector>

namespace rt {

/// The scene for POV-Ray 3.7, complete, and the same text for the same scene.
///
/// Numbers are written so that reading them gives back the same double. Where things are smaller than 0.01 or
/// farther than 1e4, all lengths are multiplied by a power of two, because POV-Ray's tolerances are lengths.
/// Throws InputError with the object's `file:line:column` and the reason for what POV-Ray cannot express.
std::string export_povray(const Scene& scene);

/// How POV-Ray makes a scene's picture, where one ray through each pixel's centre is not enough.
struct PovrayRun {
    int scale = 1;                     ///< the picture is made so many times as wide and high, then filtered
    std::vector<std::string> options;  ///< for antialiasing by POV-Ray itself
    bool filter = false;  ///< whether its pixels are samples, to be weighed by the scene's filter
    bool exact = true;    ///< whether its samples are the same as ours; else only the means are the same
};

/// Regular samples are the pixels of a larger picture; POV-Ray's antialiasing methods 2 and 1, their
/// threshold 0, take the trapezoid rule's samples of 2^k cells a side, and centered samples. Random samples
/// it cannot repeat: then a picture 8 × 8 times as large, with 2 × 2 samples and one more in each of its
/// pixels, tells their mean. (8 × 8 alone were more wrong than the pictures that they judged.)
PovrayRun povray_run(const Scene& scene);

}  // namespace rt
