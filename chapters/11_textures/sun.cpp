// The sun of a sky's picture as a lamp: a challenge, which nothing else needs.
#include "chapters/11_textures/sun.hpp"

#include "common/math/todo.hpp"

#include <cmath>

namespace rt {

SkyAndSun without_sun(const Image& picture, Real most) {
    // 11.23  Cut off what is too bright, and gather it: how much light is it, and from where?
    return todo("11.23");
}

}  // namespace rt
