// Points, counted in whole hundredths: sums are exact, in whatever order, and the same on every machine.
#include "common/grading/points.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rt {

std::string text_of(const Points& points) {
    std::string text = fmt::format("{}.{:02}", points.hundredths / 100, points.hundredths % 100);
    while (text.ends_with('0')) text.pop_back();
    if (text.ends_with('.')) text.pop_back();
    return text;
}

nlohmann::ordered_json number_of(const Points& points) {
    if (points.hundredths % 100 == 0) return points.hundredths / 100;
    return static_cast<double>(points.hundredths) / 100;
}

}  // namespace rt
