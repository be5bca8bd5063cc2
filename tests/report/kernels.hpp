// Intersections of rays with surfaces: how wrong each method is, and how long it takes.
#pragma once

#include "common/math/vec.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace rt::report {

/// Told the part of the work that is done, in [0, 1].
using Told = std::function<void(double)>;

/// How a method's points are shown in the plot of a shape. Methods of one colour have one name.
struct Look {
    int color;  ///< 1 red, 2 orange, 3 blue, 4 green, 5 violet
    const char* name;
};
inline constexpr Look textbook_look{1, "textbook"};
inline constexpr Look constants_look{2, "textbook with its constants"};
inline constexpr Look course_look{3, "stable"};
inline constexpr Look interval_look{4, "intervals"};
inline constexpr Look exact_look{5, "exact"};

/// One method on one family of cases. Errors are those of t, in units of κu|t|, over the cases that the
/// method calls a hit and that surely are one; κ as in tests/stability/spheres.hpp and triangles.hpp. For a
/// torus it is (|f| + |t||d| + R + r) / (|t| |n·d|), and for a surface f = 0 in a box (|o| + |t||d| + size of
/// the box) / (|t| |n·d|) and what moving each term of f by a relative 1 adds.
struct KernelRow {
    std::string shape;   ///< such as "sphere"
    std::string method;  ///< such as "textbook"
    std::string number;  ///< what it computes with, such as "float"
    double ns = 0;       ///< CPU time of a call: the median of repeats in one run
    double error_max = 0;
    double error_9999 = 0;    ///< exceeded in one case of 10 000
    double error_median = 0;  ///< exceeded in every other
    std::size_t cases = 0;
    std::size_t wrong = 0;  ///< hits called misses, and the other way round, where 4 ulp of the data can't
                            ///< excuse it
    std::size_t undecided = 0;  ///< neither answer given: what intervals do
    bool course = false;        ///< the method that the course teaches
    Look look{};
};

/// What the cases of a shape are.
struct KernelFamily {
    std::string shape;
    std::string words;
    std::size_t cases = 0;
};

/// Correct decimal digits of t, the worst of some rays a cell.
struct DigitsMap {
    std::string method;
    std::vector<double> distance;  ///< log10 of distance over radius, for each column
    std::vector<double> tangency;  ///< log10 of the ray's depth in the sphere over the radius, for each row
    std::vector<double> digits;    ///< row by row; NaN where no ray of the cell meets the sphere
};

struct Kernels {
    std::vector<KernelFamily> families;  ///< one a shape, in the order in which they are shown
    std::vector<KernelRow> rows;
    std::vector<DigitsMap> maps;  ///< naive, stable, and what the data allow
};

struct KernelOptions {
    std::size_t cases = 200'000;
    int repeats = 15;      ///< of each timing; 0: no timing
    double repeat_ms = 8;  ///< length of one
    int map_columns = 40;
    int map_rows = 34;
    int map_samples = 24;  ///< rays a cell
};

/// What `course report --quick` and the regression test measure.
inline constexpr KernelOptions quick_kernels{10'000, 7, 2, 20, 17, 8};

Kernels measure_kernels(const KernelOptions& options = {}, const Told& told = {});

}  // namespace rt::report
