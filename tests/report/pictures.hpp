// Pictures of several scenes by several ways of sampling: how wrong they are, and how long they take.
#pragma once

#include "tests/report/kernels.hpp"
#include "tests/report/statistics.hpp"

namespace rt::report {

/// A way of sampling with so many samples a pixel. Errors are root mean squares over the pixels and channels
/// of all the repeats, linear.
struct PicturePoint {
    int asked = 1;       ///< what `spp` says
    double samples = 1;  ///< a pixel, as the render counts them
    double seconds = 0;  ///< CPU time of one render: the median of the repeats
    double error = 0;
    double estimate = 0;                   ///< what the renders themselves say; 0 for one sample
    double ratio_low = 0, ratio_high = 0;  ///< of error to estimate, over the single renders
    double rays = 0;                       ///< of all kinds, a pixel
};

struct PictureCurve {
    std::string method;
    std::vector<PicturePoint> points;
    PowerLaw by_samples, by_seconds;
    double theory = 0;    ///< exponent of samples; 0 where none is printed
    std::string stopped;  ///< what made the curve flat at its end, or "the samples ended"
};

struct PictureScene {
    std::string name, title;
    std::string chapter;  ///< "05"
    int width = 0, height = 0;
    bool analytic = false;             ///< the truth is a formula; else it is a much longer render
    double truth_error = 0;            ///< the truth's own standard error; of an analytic one its rounding
    double truth_samples = 0;          ///< a pixel
    double best = 0;                   ///< the smallest error of all points
    std::vector<PictureCurve> curves;  ///< the first is a single point, one sample at the pixel's centre
};

struct PictureOptions {
    int height = 32;                                      ///< of the pictures
    std::vector<int> counts{4, 9, 16, 36, 64, 144, 256};  ///< samples a pixel
    int repeats = 4;                                      ///< renders a point, each of another seed
    int truth_count = 4096;                               ///< samples a pixel of one render of the truth
    int truth_renders = 8;
    bool chapters = true;  ///< scenes of chapters 5 to 7 too, not only those with a formula
};

/// What `course report --quick` measures.
PictureOptions quick_pictures();

/// `repository` is where references/ is.
std::vector<PictureScene> measure_pictures(const std::string& repository, const PictureOptions& options = {},
                                           const Told& told = {});

}  // namespace rt::report
