// Chapter 12 measured: each blur by several samplers, ways to ask lights, and what blurs cost alone and
// together.
#pragma once

#include "tests/report/pictures.hpp"

namespace rt::report {

struct BlursOptions {
    int height = 20;                          ///< of the pictures
    std::vector<int> counts{4, 16, 64, 256};  ///< samples a pixel
    int repeats = 4;                          ///< renders a point, each of another seed
    int truth_count = 2048;                   ///< samples a pixel of one render of the truth
    int truth_renders = 8;
};

/// What `course report --quick` measures.
BlursOptions quick_blurs();

/// A lens, motion, a lamp, gloss, and all of them together: a scene each, a curve a sampler.
std::vector<PictureScene> measure_blurs(const std::string& repository, const BlursOptions& options = {},
                                        const Told& told = {});

/// Two ways or more to one picture, a curve each, measured in turns: a near lamp by its area and by its
/// angle, many lights all and one at random, and camera rays with one shadow ray or with many. The last scene
/// is the billiard table without a blur, with each alone, and with all: a truth each.
std::vector<PictureScene> compare_blurs(const std::string& repository, const BlursOptions& options = {},
                                        const Told& told = {});

}  // namespace rt::report
