// What a student's code prints while its tests run.
#include "common/workbook/printed.hpp"

#include "common/math/counted.hpp"
#include "common/math/printable.hpp"
#include "common/workbook/back_trace.hpp"
#include "common/workbook/exercise.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

namespace {

constexpr char mark = '\x1e';
constexpr std::size_t most_lines = 10;

/// The lines with something in them, but for what the standard library says before it ends a program: that is
/// told with the place.
std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    for (const std::string& line : split_lines(text))
        if (!line.empty() && broken_rule(line).empty()) lines.push_back(printable(line));
    return lines;
}

}  // namespace

std::vector<Printed> read_printed(std::string_view output) {
    std::vector<Printed> printed;
    std::string test;
    for (bool more = true; more;) {
        const std::size_t end = output.find(mark);
        std::vector<std::string> lines = lines_of(output.substr(0, end));
        if (!lines.empty()) printed.push_back({test, std::move(lines)});
        more = end != std::string_view::npos;
        if (!more) break;
        output.remove_prefix(end + 1);
        const std::size_t name_end = std::min(output.find('\n'), output.size());
        test = output.substr(0, name_end);
        output.remove_prefix(std::min(name_end + 1, output.size()));
        more = !test.empty();
    }
    return printed;
}

std::string printed_in_words(const std::vector<Printed>& printed, std::string_view first) {
    if (printed.empty()) return "";
    auto shown = std::ranges::find(printed, first, &Printed::test);
    if (shown == printed.end()) shown = printed.begin();
    std::string text = shown->test.empty() ? "  Printed before the first test:\n"
                                           : fmt::format("  Printed in the test \"{}\":\n", shown->test);
    for (std::size_t i = 0; i < std::min(shown->lines.size(), most_lines); ++i)
        text += "      " + shown->lines[i] + "\n";
    if (shown->lines.size() > most_lines)
        text += fmt::format("      … and {}\n", counted(shown->lines.size() - most_lines, "more line"));
    std::size_t others = 0;
    for (const Printed& part : printed)
        if (&part != &*shown) others += part.lines.size();
    if (others > 0)
        text += fmt::format("      ({} in {})\n", counted(others, "line"),
                            counted(printed.size() - 1, "other test"));
    return text;
}

}  // namespace rt
