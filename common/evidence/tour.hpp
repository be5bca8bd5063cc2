// The tour: every scene of the course rendered and compared with its reference.
#pragma once

#include "common/evidence/agreement.hpp"
#include "common/evidence/reference_scenes.hpp"
#include "common/math/vec.hpp"
#include "common/terminal/project.hpp"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// One scene of the tour, and what rendering it has shown.
struct TourStop {
    ReferenceScene scene;
    int width = 0;  ///< 0 before there is a picture
    int height = 0;
    double seconds = 0;
    std::uint64_t rays = 0;                   ///< of all kinds; 0 for scan conversion
    Real estimate = 0;                        ///< of the root mean square error; 0 for one sample a pixel
    std::optional<Agreement> agreement = {};  ///< nothing where there is no reference
    std::string problem = {};  ///< why there is no picture, or no agreement although there should be one
};

/// Whether nothing is wrong with it.
bool passed(const TourStop& stop);

/// A chapter's part of the tour, or that of the scenes in the base format.
struct TourPart {
    std::string name;  ///< of the directory of its pictures, "02_spheres"
    std::string title;
    std::string summary;
    std::vector<TourStop> stops;
};

/// The tour before it begins: the chapters in their order, then the scenes in the base format.
std::vector<TourPart> tour_of(const Project& project);

/// How many scenes there are, were compared and have failed.
struct TourCount {
    std::size_t stops = 0, compared = 0, failed = 0;
};
TourCount count(const std::vector<TourPart>& tour);

/// Files of a stop's pictures in the directory of its part.
std::string picture_of(const TourStop& stop);
std::string reference_of(const TourStop& stop);
std::string difference_of(const TourStop& stop);

/// By which differences are multiplied for the eye: two steps of 1/65535 become an eighth of full light.
inline constexpr Real difference_gain = 4096;

/// Renders one scene with the implementation that is linked in, writes its pictures into `directory`, which
/// exists, and compares. What goes wrong becomes the stop's problem. `progress` is told the fraction that is
/// done.
void visit(TourStop& stop, const std::filesystem::path& directory, const std::function<void(Real)>& progress);

/// A stop in words, as table and page show it; "–" where there is nothing to say.
struct StopText {
    std::string size;      ///< "320×240"
    std::string ms;        ///< milliseconds of rendering
    std::string rate;      ///< rays a second
    std::string greatest;  ///< difference, in steps of 1/65535
    std::string over;      ///< pixels that differ by more than gate_steps
    std::string inside;    ///< of them, not at silhouettes
    std::string error;     ///< the picture's own estimate of its error × what it really is of that
    std::string word;      ///< the outcome: "equal"
};
StopText text_of(const TourStop& stop);

/// What a scene file says of itself: the comment lines that it begins with, as one paragraph.
std::string opening_comment(std::string_view text);

/// The page, with links to the pictures that `visit` has written into the directories of the parts.
std::string tour_page(const std::vector<TourPart>& tour);

}  // namespace rt
