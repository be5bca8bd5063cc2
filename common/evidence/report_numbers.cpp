// Numbers of the report as people write them.
#include "common/evidence/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt {
namespace {

/// Groups of three digits, a thin space between them.
std::string in_groups(double x) {
    std::string text = fmt::format("{:.0f}", std::abs(x));
    for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, "\u2009");
    return (x < 0 ? "−" : "") + text;
}

std::string power_of_ten(double x, int exponent) {
    std::string raised;
    constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    for (const char c : fmt::format("{}", exponent)) raised += c == '-' ? "⁻" : digits[c - '0'];
    return fmt::format("{:.1f}\u2009·\u200910{}", x / std::pow(10, exponent), raised);
}

}  // namespace

std::string number_text(const ReportData& number) {
    if (!number.is_number()) return "–";
    const double x = number;
    if (x == 0) return "0";
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(x))));
    if (number.is_number_integer() || (exponent >= 3 && exponent < 9)) return in_groups(x);
    if (exponent >= 3 || exponent < -3) return power_of_ten(x, exponent);
    const std::string text = fmt::format("{:.{}f}", x, std::max(0, 2 - exponent));
    return text.starts_with('-') ? "−" + text.substr(1) : text;
}

ReportData numbers_as_text(ReportData data) {
    if (data.is_number() || data.is_null()) return number_text(data);
    if (data.is_structured())
        for (ReportData& part : data) part = numbers_as_text(part);
    return data;
}

}  // namespace rt
