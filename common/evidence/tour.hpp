// The tour: every scene of the course rendered, compared with its reference and shown on a page.
#pragma once

#include "common/terminal/project.hpp"
#include "common/image/image.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// Greatest difference from a reference that rounding explains, in steps of 1/65535.
inline constexpr Real gate_steps = 2;

/// Share of a picture's pixels that may differ by more, if they are at silhouettes.
inline constexpr Real gate_share = 0.001;

/// How a picture stands against its reference.
struct Verdict {
    Real greatest = 0;            ///< difference of a channel, clamped to [0, 1], in steps of 1/65535
    std::size_t over = 0;         ///< pixels with a channel that differs by more than gate_steps
    std::size_t unexplained = 0;  ///< of these, pixels not at silhouettes
    /// Root mean square of the differences over the estimated error; of pictures with samples at random only.
    std::optional<Real> ratio;
    bool passed = false;
};

/// Greatest factor between a picture's true error and its own estimate of it.
inline constexpr Real gate_ratio = 1.5;

/// Judges a picture with samples at random by a reference with other samples: the root mean square of the
/// differences must be what the picture says of itself, within gate_ratio both ways. Throws as `judge` does.
Verdict judge_samples(const Image& image, const Image& reference, Real rms_error);

/// Judges a picture: at most gate_steps everywhere, save at most gate_share of the pixels, all of these at
/// silhouettes, that is where the pixel's decision differs from one of its eight neighbours'.
/// `decisions` is asked for one number a pixel, as `decisions(World)` gives them, only where some pixel is
/// over. Throws InputError if the sizes of the pictures differ.
Verdict judge(const Image& image, const Image& reference,
              const std::function<std::vector<std::uint64_t>()>& decisions);

struct TourOptions {
    std::filesystem::path output;  ///< directory of the page; empty: `tour` in the build directory
    bool json = false;             ///< one JSON object on standard output instead of the table
    bool quiet = false;            ///< nothing on standard output, no progress
};

/// What a scene file says of itself: the comment lines that it begins with, as one paragraph.
std::string opening_comment(std::string_view text);

/// Renders the scenes of all chapters with the implementation that is linked in, compares each with its
/// reference, writes the page and prints a table. Returns the exit status: 1 if a comparison fails.
int run_tour(const TourOptions& options, const Project& project = this_project());

}  // namespace rt
