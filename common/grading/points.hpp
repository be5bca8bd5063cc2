// Points, counted in whole hundredths: sums are exact, in whatever order, and the same on every machine.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <compare>
#include <cstdint>
#include <string>

namespace rt {

struct Points {
    std::int64_t hundredths = 0;

    friend auto operator<=>(const Points&, const Points&) = default;
    Points& operator+=(const Points& other) {
        hundredths += other.hundredths;
        return *this;
    }
};

/// No step is worth more.
inline constexpr std::int64_t most_points = 1000;

inline Points whole_points(std::int64_t points) { return {points * 100}; }

/// "15", "7.5" or "0.25".
std::string text_of(const Points& points);

/// The same as a number in JSON.
nlohmann::ordered_json number_of(const Points& points);

}  // namespace rt
