// Text in POV-Ray's language: numbers, vectors and colours, and the lines that are made of them.
#pragma once

#include "common/scene/scene.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

namespace rt::povray {

/// The shortest number that reads back as the same double; −0 is 0.
std::string number(Real x);

/// The unit vector along v, which may have any length but 0. Its digits stand in the references' files, so it
/// is not `unit`, which rounds otherwise.
Vec3 unit_along(const Vec3& v);

/// `<x, y, z>`
std::string triple(const Vec3& v);

/// `rgb <r, g, b>`, or `rgb x` of a grey.
std::string rgb(const Vec3& c);

/// The text so far, and the scene that it is about.
struct Writer {
    const Scene& scene;
    Real factor;  ///< of all its lengths to what the author wrote
    std::string text{};

    template <class... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        text += fmt::format(format, std::forward<Args>(args)...) + '\n';
    }
};

}  // namespace rt::povray
