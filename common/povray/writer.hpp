// Text in POV-Ray's language: numbers, vectors and colours, and the lines that are made of them.
#pragma once

#include "common/scene/snapshot.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

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

/// The text so far, and the still scene that it is about. The eye is where the snapshot has it, at its time
/// and on the lens.
struct Writer {
    const Scene& scene;
    const Snapshot& snapshot;
    Real factor;  ///< of all the scene's lengths to what the author wrote, and so to the snapshot's
    std::string text{};
    std::vector<std::size_t> frames{};  ///< objects whose own coordinates have been declared

    template <class... Args>
    void line(fmt::format_string<Args...> format, Args&&... args) {
        text += fmt::format(format, std::forward<Args>(args)...) + '\n';
    }
};

}  // namespace rt::povray
