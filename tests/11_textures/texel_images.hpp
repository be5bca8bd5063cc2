// What the tests of images and of their pyramids share.
#pragma once

#include "common/image/image.hpp"
#include "common/scene/textures.hpp"
#include "tests/support.hpp"

#include <string>
#include <vector>

namespace rt::test {

inline constexpr Wrap all_wraps[] = {Wrap::Repeat, Wrap::Mirror, Wrap::Clamp};

inline std::string name_of(Wrap wrap) {
    return wrap == Wrap::Repeat ? "Repeat" : wrap == Wrap::Mirror ? "Mirror" : "Clamp";
}

/// Rows from the top, of grey texels.
inline Image grey(const std::vector<std::vector<Real>>& rows) {
    Image image = make_image(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()));
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            pixel(image, x, y) = Vec3(rows[static_cast<std::size_t>(y)][static_cast<std::size_t>(x)]);
    return image;
}

/// Each channel of each texel anything in [0, 1).
inline Image random_image(int width, int height, Random& random) {
    Image image = make_image(width, height);
    for (Vec3& p : image.pixels) p = Vec3(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
    return image;
}

}  // namespace rt::test
