// Moments as texts that mean the same everywhere: ISO 8601 with its distance from UTC (RFC 3339).
#include "common/grading/time_stamp.hpp"

#include "common/terminal/pattern.hpp"

#include <fmt/format.h>

namespace rt {

using namespace std::chrono;

std::string text_of(Moment moment) {
    const auto day = floor<days>(moment);
    const year_month_day date(day);
    const hh_mm_ss time(moment - day);
    return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", static_cast<int>(date.year()),
                       static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
                       time.hours().count(), time.minutes().count(), time.seconds().count());
}

std::optional<Moment> moment_of(const std::string& text) {
    const auto parts = parts_of(
        text,
        "(\\d{4})-(\\d\\d)-(\\d\\d)T(\\d\\d):(\\d\\d)(?::(\\d\\d)(?:\\.\\d+)?)?(?:Z|([+-])(\\d\\d):(\\d\\d)"
        ")");
    if (!parts) return std::nullopt;
    const auto number = [&](std::size_t i) { return parts->at(i).empty() ? 0 : std::stoi(parts->at(i)); };
    const year_month_day date{year(number(1)), month(static_cast<unsigned>(number(2))),
                              day(static_cast<unsigned>(number(3)))};
    const bool good = date.ok() && number(1) >= 1970 && number(4) < 24 && number(5) < 60 && number(6) < 60 &&
                      number(8) < 24 && number(9) < 60;
    if (!good) return std::nullopt;
    const seconds from_utc = hours(number(8)) + minutes(number(9));
    const Moment local = sys_days(date) + hours(number(4)) + minutes(number(5)) + seconds(number(6));
    return parts->at(7) == "-" ? local + from_utc : local - from_utc;
}

Moment now() { return floor<seconds>(system_clock::now()); }

}  // namespace rt
