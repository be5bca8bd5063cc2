// A textured floor to the horizon by each way of looking a texture up: how wrong the picture is, and how long
// it takes.
#pragma once

#include "tests/report/pictures.hpp"

namespace rt::report {

struct FilterOptions {
    int height = 60;                                    ///< of the picture
    std::vector<int> counts{1, 4, 9, 16, 36, 64, 144};  ///< samples a pixel; one is at the centre
    int repeats = 4;                                    ///< renders a point, each of another seed
    int truth_count = 4096;                             ///< samples a pixel of one render of the truth
    int truth_renders = 8;
};

/// What `course report --quick` measures.
FilterOptions quick_filters();

/// The floor of chapter 11's horizon.scene, alone; a curve a filter, each with all the counts. The truth
/// looks up the nearest texel, in many more samples: what a pixel sees of the texels is then their mean,
/// without any filter of textures.
/// `repository` is where references/ is.
std::vector<PictureScene> measure_filters(const std::string& repository, const FilterOptions& options = {},
                                          const Told& told = {});

}  // namespace rt::report
