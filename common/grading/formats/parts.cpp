// What several formats share.
#include "common/grading/formats/parts.hpp"

#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/base64.hpp"

#include <fmt/format.h>

namespace rt {
namespace {

std::string csv_field(const std::string& text) {
    std::string shown = printable(text);
    if (!shown.empty() && std::string_view("=+-@\t\r").find(shown.front()) != std::string_view::npos)
        shown.insert(0, "'");
    if (shown.find_first_of("\",\r\n;") == std::string::npos) return shown;
    std::string quoted = "\"";
    for (const char c : shown) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

}  // namespace

void require_shown(const ShownGrade& shown) {
    if (shown.marks_from)
        throw InputError(
            fmt::format("students may not see marks before {}; until then there are html and csv for you, "
                        "and gradescope, which keeps them back",
                        text_of(*shown.marks_from)));
}

std::string name_of(const GradedStep& step) { return step.id + " " + step.title; }

Points counted_possible(const GradedStep& step) { return step.extra ? Points{} : step.possible; }

std::string of_points(Points earned, Points possible) {
    return fmt::format("{} of {} {}", text_of(earned), text_of(possible),
                       possible == whole_points(1) ? "point" : "points");
}

std::string points_line(const GradedStep& step) {
    return of_points(step.earned, step.possible) + (step.extra ? ", extra credit" : "");
}

bool is_error(Verdict verdict) {
    return verdict == Verdict::Crashed || verdict == Verdict::TimedOut || verdict == Verdict::TooMuchMemory ||
           verdict == Verdict::NotCompiled || verdict == Verdict::NotTaken;
}

bool is_skipped(Verdict verdict) { return verdict == Verdict::Todo || verdict == Verdict::NeedsStep; }

std::string csv_row(const std::vector<std::string>& fields) {
    std::string line;
    for (std::size_t i = 0; i < fields.size(); ++i) line += (i == 0 ? "" : ",") + csv_field(fields[i]);
    return line + "\r\n";
}

std::string data_url(const std::string& png) { return "data:image/png;base64," + base64(png); }

std::string escaped_markup(std::string_view text) {
    std::string escaped;
    for (const char c : text) {
        switch (c) {
            case '&':
                escaped += "&amp;";
                break;
            case '<':
                escaped += "&lt;";
                break;
            case '>':
                escaped += "&gt;";
                break;
            case '"':
                escaped += "&quot;";
                break;
            case '\'':
                escaped += "&#39;";
                break;
            default:
                escaped += c;
        }
    }
    return escaped;
}

}  // namespace rt
