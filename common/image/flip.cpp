// How different two pictures look to somebody who flips between them (Andersson et al. 2020).
#include "common/image/flip.hpp"

#include "common/image/encoding.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace rt {
namespace {

/// Linear sRGB to CIE XYZ over that of white (D65), which is (1, 1, 1) then; columns, as GLM has them.
const glm::dmat3 xyz_of_rgb = [] {
    const glm::dmat3 rows(10135552. / 24577794, 8788810. / 24577794, 4435075. / 24577794,  //
                          2613072. / 12288897, 8788810. / 12288897, 887015. / 12288897,    //
                          1425312. / 73733382, 8788810. / 73733382, 70074185. / 73733382);
    const glm::dmat3 xyz = glm::transpose(rows);
    const Vec3 white = xyz * Vec3(1);
    return glm::dmat3(xyz[0] / white, xyz[1] / white, xyz[2] / white);
}();
const glm::dmat3 rgb_of_xyz = glm::inverse(xyz_of_rgb);

/// What L*a*b* does with three numbers, and YCxCz, its linear relative, with their linear ones.
Vec3 opponent(const Vec3& f) { return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)}; }
Vec3 not_opponent(const Vec3& c) {
    const Real y = (c.x + 16) / 116;
    return {y + c.y / 500, y, y - c.z / 200};
}

/// L*a*b* with less colour in the dark: Hunt's effect.
Vec3 hunt_lab(const Vec3& rgb) {
    constexpr Real delta = Real(6) / 29;
    Vec3 f = xyz_of_rgb * rgb;
    for (int i = 0; i < 3; ++i)
        f[i] = f[i] > delta * delta * delta ? std::cbrt(f[i]) : f[i] / (3 * delta * delta) + Real(4) / 29;
    const Vec3 lab = opponent(f);
    return {lab.x, 0.01 * lab.x * lab.y, 0.01 * lab.x * lab.z};
}

/// The distance of colours that are far apart (Abasi et al. 2020), to the power 0.7.
Real color_distance(const Vec3& a, const Vec3& b) {
    const Vec3 d = a - b;
    return std::pow(std::abs(d.x) + std::hypot(d.y, d.z), 0.7);
}

/// A distance as a number from 0 to 1, of which small distances get nearly all.
Real spread_out(Real distance) {
    constexpr Real share_of_range = 0.4, share_of_result = 0.95;
    static const Real most = color_distance(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1}));
    const Real bend = share_of_range * most;
    return distance < bend ? distance * share_of_result / bend
                           : share_of_result + (distance - bend) / (most - bend) * (1 - share_of_result);
}

using Channels = std::array<Channel, 3>;

/// YCxCz of what a display shows.
Channels opponent_channels(const Image& image, const Display& display) {
    const auto light = [&](Real v) {
        if (display.eight_bits) return decode(encode_byte(v, display.encoding) / Real(255), Encoding::Srgb);
        return display.encoding == Encoding::Srgb ? displayable(v) : decode(displayable(v), Encoding::Srgb);
    };
    Channels channels;
    for (Channel& channel : channels) channel = {image.width, image.height, {}};
    for (const Vec3& p : image.pixels) {
        const Vec3 c = opponent(xyz_of_rgb * Vec3(light(p.x), light(p.y), light(p.z)));
        for (std::size_t i = 0; i < 3; ++i) channels[i].values.push_back(c[static_cast<int>(i)]);
    }
    return channels;
}

/// One Gaussian of a contrast sensitivity function: a √(π/b) exp(−π² z²/b), z in degrees.
struct Sensitivity {
    Real a, b;
};

/// As an eye sees a channel that has the sum of these sensitivities.
Channel seen(const Channel& channel, const std::vector<Sensitivity>& parts, Real pixels_per_degree) {
    constexpr Real widest = 0.04;  // of all channels' b; they are cut off at one radius
    const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest / 2) / pi * pixels_per_degree));
    Channel sum{channel.width, channel.height, std::vector<Real>(channel.values.size(), 0)};
    Real total = 0;
    for (const Sensitivity& part : parts) {
        const Weights weights = gaussian(std::sqrt(part.b / 2) / pi * pixels_per_degree, radius);
        const Real along = std::accumulate(weights.begin(), weights.end(), Real(0));
        const Real scale = part.a * std::sqrt(pi / part.b);
        total += scale * along * along;
        const Channel one = convolved(channel, weights, weights);
        for (std::size_t i = 0; i < sum.values.size(); ++i) sum.values[i] += scale * one.values[i];
    }
    for (Real& value : sum.values) value /= total;
    return sum;
}

/// The three channels as an eye sees them, as colours.
std::vector<Vec3> seen_colors(const Channels& channels, Real pixels_per_degree) {
    const Channel y = seen(channels[0], {{1, 0.0047}}, pixels_per_degree);
    const Channel red_green = seen(channels[1], {{1, 0.0053}}, pixels_per_degree);
    const Channel blue_yellow = seen(channels[2], {{34.1, 0.04}, {13.5, 0.025}}, pixels_per_degree);
    std::vector<Vec3> colors;
    for (std::size_t i = 0; i < y.values.size(); ++i) {
        const Vec3 rgb = rgb_of_xyz * not_opponent({y.values[i], red_green.values[i], blue_yellow.values[i]});
        colors.push_back(hunt_lab(glm::clamp(rgb, Vec3(0), Vec3(1))));
    }
    return colors;
}

/// Positive weights that sum to 1, negative ones that sum to −1.
Weights balanced(Weights weights) {
    Real positive = 0, negative = 0;
    for (const Real w : weights) (w > 0 ? positive : negative) += std::abs(w);
    for (Real& w : weights) w /= w > 0 ? positive : negative;
    return weights;
}

/// How much of an edge and of a point there is at each pixel, whatever its direction.
struct Features {
    std::vector<Real> edges, points;
};

Features features_of(const Channel& y, Real pixels_per_degree) {
    const Real deviation = 0.5 * 0.082 * pixels_per_degree;
    const int radius = static_cast<int>(std::ceil(3 * deviation));
    const Weights smooth = gaussian(deviation, radius);
    Weights first = smooth, second = smooth;
    for (int x = -radius; x <= radius; ++x) {
        const auto i = static_cast<std::size_t>(x + radius);
        first[i] *= -x;
        second[i] *= x * x / (deviation * deviation) - 1;
    }
    Channel brightness = y;
    for (Real& value : brightness.values) value = (value + 16) / 116;
    const auto strength = [&](const Weights& derivative) {
        const Weights along = balanced(derivative), beside = normalized(smooth);
        const Channel across = convolved(brightness, along, beside),
                      down = convolved(brightness, beside, along);
        std::vector<Real> lengths;
        for (std::size_t i = 0; i < across.values.size(); ++i)
            lengths.push_back(std::hypot(across.values[i], down.values[i]));
        return lengths;
    };
    return {strength(first), strength(second)};
}

}  // namespace

Channel flip(const Image& image, const Image& reference, const Display& display, Real pixels_per_degree) {
    require_same_size(image, reference);
    const Channels ours = opponent_channels(image, display), theirs = opponent_channels(reference, display);
    const std::vector<Vec3> our_colors = seen_colors(ours, pixels_per_degree),
                            their_colors = seen_colors(theirs, pixels_per_degree);
    const Features our_features = features_of(ours[0], pixels_per_degree),
                   their_features = features_of(theirs[0], pixels_per_degree);
    Channel result{image.width, image.height, {}};
    for (std::size_t i = 0; i < our_colors.size(); ++i) {
        const Real color = spread_out(color_distance(our_colors[i], their_colors[i]));
        const Real feature = std::max(std::abs(our_features.edges[i] - their_features.edges[i]),
                                      std::abs(our_features.points[i] - their_features.points[i]));
        result.values.push_back(std::pow(color, 1 - std::sqrt(feature / std::sqrt(Real(2)))));
    }
    return result;
}

Real mean(const Channel& channel) {
    return std::accumulate(channel.values.begin(), channel.values.end(), Real(0)) /
           static_cast<Real>(channel.values.size());
}

}  // namespace rt
