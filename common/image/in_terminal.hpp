// A picture in a true-colour terminal, two pixels a character.
#pragma once

#include "common/image/image.hpp"

#include <string>

namespace rt {

/// The image as `rows` lines at most of `columns` characters at most, for a terminal with 24-bit colour: each
/// character is an upper half block whose foreground is the upper pixel and whose background is the lower one
/// (the terminal's own background below an odd last row). Larger images are shrunk, keeping their aspect, by
/// a box filter in linear light over values limited to [0, 1]; smaller ones are shown as they are. Each line
/// ends with a colour reset and a newline. `columns` and `rows` under 1 count as 1.
std::string preview(const Image& image, Encoding encoding, int columns, int rows);

}  // namespace rt
