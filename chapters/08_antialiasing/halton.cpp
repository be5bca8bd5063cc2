// Points that fill the square evenly, however many there are: Halton's sequence.
#include "chapters/08_antialiasing/samples.hpp"

#include "common/math/todo.hpp"

#include <glm/common.hpp>

#include <cmath>

namespace rt {

Real radical_inverse(int index, int base) {
    // 08.12  The digits of the index in this base, mirrored at the point: the last digit of the
    // index becomes the first one after the point.
    return todo("08.12");
}

std::vector<PixelSample> halton_samples(int count, Random random) {
    // 08.12  `count` samples of equal weight at Halton's points, whose coordinates are the radical
    // inverses of 0, 1, 2 … in the bases 2 and 3. All are moved by one random_point(random), and those that
    // leave the pixel come in again on the other side.
    return todo("08.12");
}

}  // namespace rt
