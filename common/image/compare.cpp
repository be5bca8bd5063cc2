// How far apart two images are: one pass over the pixels, one histogram a measure.

#include "common/image/compare.hpp"

#include "common/image/file.hpp"
#include "common/math/input_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace rt {
namespace {

Real channel_difference(Real a, Real b) {
    if (std::isnan(a) != std::isnan(b)) return 1;
    return std::abs(displayable(a) - displayable(b));
}

Real encoded_difference(Real a, Real b, const Display& display) {
    if (a == b) return 0;  // most are, and need no power
    if (std::isnan(a) != std::isnan(b)) return 1;
    if (display.eight_bits)
        return std::abs(encode_byte(a, display.encoding) - encode_byte(b, display.encoding)) / Real(255);
    return std::abs(encode(a, display.encoding) - encode(b, display.encoding));
}

/// The smallest n with difference <= n/steps. Rounding (about 1e-11 steps, from decoding a file and from the
/// subtraction) must not lift a difference of exactly n steps to n + 1, hence the millionth of a step.
std::size_t steps_up(Real difference, Real steps) {
    return static_cast<std::size_t>(std::max(Real(0), std::ceil(difference * steps - 0x1p-20)));
}

/// How many pixels lie exactly n steps apart, n = 0 … 255; farther ones are not counted.
using Histogram = std::array<Real, 256>;

void count(Histogram& histogram, std::size_t n) {
    if (n < histogram.size()) ++histogram[n];
}

/// Fraction of all pixels that lie at most n steps apart.
Histogram cumulative(const Histogram& histogram, Real pixels) {
    Histogram within{};
    Real sum = 0;
    for (std::size_t n = 0; n < within.size(); ++n) within[n] = (sum += histogram[n]) / pixels;
    return within;
}

}  // namespace

std::string percent(Real share) {
    return share >= 1 ? "100 %" : fmt::format("{:.2f} %", std::floor(share * 1e4) / 1e2);
}

void require_same_size(const Image& image, const Image& reference) {
    if (image.width == reference.width && image.height == reference.height) return;
    const auto size = [](const Image& i) {
        return std::to_string(i.width) + " x " + std::to_string(i.height);
    };
    throw InputError("the image has " + size(image) + " pixels and the reference " + size(reference) +
                     "; only images of one size can be compared");
}

Comparison compare(const Image& image, const Image& reference, const Display& display) {
    require_same_size(image, reference);
    Comparison result{.width = image.width, .height = image.height};
    Histogram shown{}, linear{};
    Real sum = 0, squares = 0;
    for (int y = 0; y < image.height; ++y) {
        Real row_sum = 0, row_squares = 0;
        for (int x = 0; x < image.width; ++x) {
            const Vec3 &a = pixel(image, x, y), &b = pixel(reference, x, y);
            Vec3 difference, encoded;
            for (int i = 0; i < 3; ++i) {
                difference[i] = channel_difference(a[i], b[i]);
                encoded[i] = encoded_difference(a[i], b[i], display);
            }
            row_sum += difference.x + difference.y + difference.z;
            row_squares += glm::dot(difference, difference);
            result.shown_max = std::max(result.shown_max, max_component(encoded));
            count(shown, steps_up(max_component(encoded), 255));
            count(linear, steps_up(max_component(difference), 65535));
            if (max_component(difference) > result.max) {
                result.max = max_component(difference);
                result.worst_x = x;
                result.worst_y = y;
            }
        }
        sum += row_sum;
        squares += row_squares;
    }
    const Real pixels = static_cast<Real>(image.pixels.size());
    result.mean = sum / (3 * pixels);
    result.rmse = std::sqrt(squares / (3 * pixels));
    if (result.rmse > 0) result.psnr = -20 * std::log10(result.rmse);
    result.within = cumulative(shown, pixels);
    result.within16 = cumulative(linear, pixels);
    return result;
}

Image difference(const Image& image, const Image& reference, Real gain) {
    require_same_size(image, reference);
    Image result = make_image(image.width, image.height);
    for (std::size_t p = 0; p < result.pixels.size(); ++p)
        for (int i = 0; i < 3; ++i)
            result.pixels[p][i] = gain * channel_difference(image.pixels[p][i], reference.pixels[p][i]);
    return result;
}

Real visible_gain(const Comparison& comparison) {
    // A typical difference then becomes a middle grey, and a few large ones do not hide it.
    if (comparison.rmse <= 0) return 1;
    return std::clamp(std::exp2(std::floor(std::log2(0.25 / comparison.rmse))), Real(1), Real(4096));
}

}  // namespace rt
