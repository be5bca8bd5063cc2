// Time to equal error against POV-Ray: soft shadows and depth of field, by ours and by what it has for them.
#pragma once

#include "tests/report/pictures.hpp"

namespace rt::report {

struct PovrayOptions {
    int height = 90;                          ///< of the pictures
    std::vector<int> counts{4, 16, 64, 256};  ///< our samples, and those of POV-Ray that are set
    int repeats = 3;                          ///< in turns; times are their medians
    int truth_count = 4096;                   ///< samples a pixel of one render of the truth
    int truth_renders = 4;
};

/// What `course report --quick` measures.
PovrayOptions quick_povray();

/// Whether there is a program `povray`.
bool has_povray();

/// `repository` is where tests/report/povray is; `directory` exists, and POV-Ray may write there. Both
/// programs run on one thread, and their times are CPU seconds; POV-Ray's without those of its start. A curve
/// of ours, then those of POV-Ray. Throws std::runtime_error if POV-Ray fails.
std::vector<PictureScene> measure_povray(const std::string& repository, const std::string& directory,
                                         const PovrayOptions& options = {}, const Told& told = {});

}  // namespace rt::report
