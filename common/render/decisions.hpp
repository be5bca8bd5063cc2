// The discrete decisions behind each pixel: where two ray tracers may rightly differ.
#pragma once

#include "common/render/trace.hpp"

#include <cstdint>
#include <vector>

namespace rt {

/// The discrete decisions of a ray tree as one number: what was hit, which material of a pattern, what each
/// light's shadow ray met, which rays went on. Equal trees have equal numbers; different ones almost surely
/// have not.
std::uint64_t decision(const World& world, const std::vector<TraceRecord>& tree);

/// The decision of the ray through each pixel's centre, row by row. Where two neighbours differ runs a
/// silhouette, a shadow's edge or the like: only there may another ray tracer see something else. In a
/// picture of several samples a pixel, pixels within which decisions differ have a number of their own.
std::vector<std::uint64_t> decisions(const World& world);

}  // namespace rt
