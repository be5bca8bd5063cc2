// Whether a picture agrees with its reference: the gate of tour and references.
#pragma once

#include "common/image/image.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace rt {

/// Greatest difference from a reference that rounding explains, in steps of 1/65535.
inline constexpr Real gate_steps = 2;

/// Share of a picture's pixels that may differ by more, if they are at silhouettes.
inline constexpr Real gate_share = 0.001;

/// Greatest factor between a picture's true error and its own estimate of it.
inline constexpr Real gate_ratio = 1.5;

/// How a picture stands against its reference.
struct Agreement {
    Real greatest = 0;            ///< difference of a channel, clamped to [0, 1], in steps of 1/65535
    std::size_t over = 0;         ///< pixels with a channel that differs by more than gate_steps
    std::size_t unexplained = 0;  ///< of these, pixels not at silhouettes
    /// Root mean square of the differences over the estimated error; of pictures with samples at random only.
    std::optional<Real> ratio;
    bool passed = false;
};

/// Judges a picture: at most gate_steps everywhere, save at most gate_share of the pixels, all of these at
/// silhouettes, that is where the pixel's decision differs from one of its eight neighbours'.
/// `decisions` is asked for one number a pixel, as `decisions(World)` gives them, only where some pixel is
/// over. Throws InputError if the sizes of the pictures differ.
Agreement judge(const Image& image, const Image& reference,
                const std::function<std::vector<std::uint64_t>()>& decisions);

/// Judges a picture with samples at random by a reference with other samples: the root mean square of the
/// differences must be what the picture says of itself, within gate_ratio both ways. Throws as `judge` does.
Agreement judge_samples(const Image& image, const Image& reference, Real rms_error);

}  // namespace rt
