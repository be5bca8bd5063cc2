// The words of `accelerator`: what may be built so that a ray need not ask every shape.
#pragma once

#include <string_view>

namespace rt {

/// What a scene asks for.
enum class AcceleratorChoice { Auto, None, Grid, Nested, Bvh, Spheres, OrientedBoxes, Ellipsoids };

/// A word of the language, what it asks for, and how the reference describes that.
struct AcceleratorWord {
    std::string_view name;
    AcceleratorChoice value;
    std::string_view meaning;
    std::string_view chapter;  ///< whose code it runs; empty where it may do without
};

inline constexpr AcceleratorWord accelerator_words[] = {
    {"auto", AcceleratorChoice::Auto,
     "(default) whichever of `none`, `grid` and `nested` is found cheapest by samples and counts, around all "
     "shapes of a kind but at most 64 that are far out or huge",
     ""},
    {"none", AcceleratorChoice::None, "nothing", ""},
    {"grid", AcceleratorChoice::Grid, "one uniform grid over each kind of shape and each shared mesh", "09"},
    {"nested", AcceleratorChoice::Nested, "the same, and crowded cells have grids of their own", "09"},
    {"bvh", AcceleratorChoice::Bvh, "a hierarchy of boxes over each of them; `auto` does not try it", "13"},
    {"spheres", AcceleratorChoice::Spheres, "the same hierarchy with spheres for boxes", "13"},
    {"obb", AcceleratorChoice::OrientedBoxes, "the same with boxes that have axes of their own", "13"},
    {"ellipsoids", AcceleratorChoice::Ellipsoids, "the same with ellipsoids", "13"},
};

}  // namespace rt
