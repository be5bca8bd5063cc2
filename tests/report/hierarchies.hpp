// Hierarchies beside grids and beside asking every triangle, over the same triangles and the same rays: what
// building costs, what a ray costs, and what a ray was predicted to cost.
#pragma once

#include "tests/report/kernels.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace rt::report {

/// One way to find the nearest triangle of a scene.
struct SearchPoint {
    std::string scene;
    std::string way;
    double triangles = 0;
    double build_seconds = 0;  ///< CPU time, median of repeats
    double ns = 0;             ///< a ray; median of repeats, the ways in turn
    double nodes = 0;          ///< or cells, that a ray looks into
    double asked = 0;          ///< triangles that a ray asks
    double bytes = 0;          ///< of the accelerator, a triangle
    double break_even =
        0;  ///< rays from which on building and searching is faster than asking every triangle
    /// Of a hierarchy what a ray is expected to pay (13.6, 1 for a node and 1 for a triangle), and what lines
    /// that come from everywhere alike, and that nothing stops, paid; else 0.
    double predicted = 0, paid = 0;
    std::size_t different = 0;  ///< answers that are not the bits that asking every triangle gives
    std::size_t compared = 0;   ///< with so many
};

struct SearchesOptions {
    double size = 1e5;          ///< triangles of a scene, about
    std::size_t rays = 20'000;  ///< of which the first are compared with asking every triangle
    double brute_tests = 1e8;   ///< triangles that are asked without an accelerator, in each scene
    int repeats = 5;
};

/// What `course report --quick` measures.
SearchesOptions quick_searches();

/// The ways in each scene after one another; the first asks every triangle.
std::vector<SearchPoint> measure_searches(const SearchesOptions& options = {}, const Told& told = {});

}  // namespace rt::report
