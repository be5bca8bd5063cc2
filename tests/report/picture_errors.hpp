// How wrong a picture is: what it should be, and the distance from that.
#pragma once

#include "common/image/image.hpp"
#include "common/render/render.hpp"
#include "common/scene/scene.hpp"
#include "tests/report/kernels.hpp"

namespace rt::report {

/// What a picture should be, and how sure that is.
struct Truth {
    Image image;
    bool analytic = true;
    double error = 0;    ///< its own standard error; of an analytic one its rounding
    double samples = 0;  ///< a pixel
};

/// Without the further samples that estimate the error.
RenderOptions drawn_only(int threads);

RenderResult render_with(Scene& scene, const Sampling& sampling, const RenderOptions& options);

/// The mean of `renders` pictures of `count` jittered samples a pixel, and the standard error of that mean.
Truth converged(Scene& scene, int count, int renders, const Told& told);

}  // namespace rt::report
