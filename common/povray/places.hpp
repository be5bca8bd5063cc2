// Where a point of an object is on a picture, and which way is out, as functions of the world's x, y and z.
#pragma once

#include "common/povray/writer.hpp"

namespace rt::povray {

/// Coordinates of a picture as the inside of functions.
struct Coordinates {
    bool mapped = false;  ///< they are POV-Ray's own, and x and y stand for them under `uv_mapping`
    std::string u, v;
};

/// Declares what the coordinates are made of, under names that end with the number of the object.
Coordinates write_coordinates(Writer& out, const Object& object, std::size_t number);

/// Declares `OutX7(x, y, z)`, `OutY7`, `OutZ7`: the unit normal, outwards. False, and nothing is declared,
/// where the point does not tell it.
bool write_outward(Writer& out, const Object& object, std::size_t number);

}  // namespace rt::povray
