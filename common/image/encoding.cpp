// The sRGB transfer curve and its inverse.
#include "common/image/encoding.hpp"

#include <cmath>

namespace rt {

Real encode(Real linear, Encoding encoding) {
    linear = displayable(linear);
    if (encoding == Encoding::Linear) return linear;
    if (linear <= 0.0031308) return 12.92 * linear;
    return displayable(1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

Real decode(Real encoded, Encoding encoding) {
    encoded = displayable(encoded);
    if (encoding == Encoding::Linear) return encoded;
    if (encoded <= 0.04045) return encoded / 12.92;
    return displayable(std::pow((encoded + 0.055) / 1.055, 2.4));
}

std::uint8_t encode_byte(Real linear, Encoding encoding) {
    return static_cast<std::uint8_t>(std::lround(255 * encode(linear, encoding)));
}

}  // namespace rt
