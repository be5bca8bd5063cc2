// How alike the structure of two pictures is (Wang et al. 2004).
#include "common/image/ssim.hpp"

#include "common/image/convolution.hpp"
#include "common/image/encoding.hpp"

namespace rt {
namespace {

constexpr int radius = 5;

/// Luma by Rec. 601 of the numbers that a display gets.
Channel luma(const Image& image, const Display& display) {
    Channel channel{image.width, image.height, {}};
    const auto shown = [&](Real v) {
        return display.eight_bits ? encode_byte(v, display.encoding) / Real(255)
                                  : encode(v, display.encoding);
    };
    for (const Vec3& p : image.pixels)
        channel.values.push_back(0.299 * shown(p.x) + 0.587 * shown(p.y) + 0.114 * shown(p.z));
    return channel;
}

/// The mean of a product around each pixel.
Channel mean_product(const Channel& a, const Channel& b) {
    static const Weights window = normalized(gaussian(1.5, radius));
    Channel product = a;
    for (std::size_t i = 0; i < product.values.size(); ++i) product.values[i] *= b.values[i];
    return convolved(product, window, window);
}

}  // namespace

std::optional<Real> ssim(const Image& image, const Image& reference, const Display& display) {
    require_same_size(image, reference);
    if (image.width <= 2 * radius || image.height <= 2 * radius) return std::nullopt;
    const Channel a = luma(image, display), b = luma(reference, display);
    const Channel one{a.width, a.height, std::vector<Real>(a.values.size(), 1)};
    const Channel mean_a = mean_product(a, one), mean_b = mean_product(b, one);
    const Channel aa = mean_product(a, a), bb = mean_product(b, b), ab = mean_product(a, b);
    constexpr Real c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    Real sum = 0;
    for (int y = radius; y < a.height - radius; ++y)
        for (int x = radius; x < a.width - radius; ++x) {
            const auto i = static_cast<std::size_t>(y * a.width + x);
            const Real ma = mean_a.values[i], mb = mean_b.values[i];
            sum += (2 * ma * mb + c1) * (2 * (ab.values[i] - ma * mb) + c2) /
                   ((ma * ma + mb * mb + c1) * (aa.values[i] - ma * ma + bb.values[i] - mb * mb + c2));
        }
    return sum / ((a.width - 2 * radius) * (a.height - 2 * radius));
}

}  // namespace rt
