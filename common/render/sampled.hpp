// Pictures of many samples a pixel, and how wrong they probably are.
#pragma once

#include "common/render/render.hpp"

namespace rt {

/// Fills result's image, rays, samples_per_pixel and rms_error; for worlds with needs.samples, or where the
/// options ask for seconds or an error. Runs in the current arena.
///
/// The samples of a pixel are a function of the pixel, the pass and the seed. A picture of a given number of
/// samples is one pass. Its error comes from second, independent patterns in some of the pixels: half the
/// mean square difference of two independent estimates is the variance of one. Patterns that are not random
/// are compared with coarser ones of their kind. A picture for a given time or error is the mean of many
/// passes, each with a whole pattern a pixel; its error comes from the variance between them. (s/√n of single
/// samples would not do: those of a pattern are not independent.)
void render_sampled(const World& world, const RenderOptions& options, RenderResult& result);

}  // namespace rt
