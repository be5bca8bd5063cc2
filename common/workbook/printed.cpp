// What a student's code prints while its tests run.
#include "common/workbook/printed.hpp"

#include "common/math/counted.hpp"
#include "common/math/printable.hpp"
#include "common/workbook/back_trace.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

namespace {

constexpr char mark = '\x1e';
constexpr std::size_t most_lines = 10;

/// What a test printed: the lines with something in them, but for what the standard library says before it
/// ends a program, which is told with the place. Of millions of lines those that nobody reads are only
/// counted.
Printed printed_in(const std::string& test, std::string_view text) {
    Printed printed{test, {}};
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty()) continue;
        if (printed.lines.size() == most_lines)
            ++printed.more;
        else if (broken_rule(line).empty())
            printed.lines.push_back(printable(line));
    }
    return printed;
}

std::size_t count(const Printed& printed) { return printed.lines.size() + printed.more; }

}  // namespace

std::vector<Printed> read_printed(std::string_view output) {
    std::vector<Printed> printed;
    std::string test;
    for (bool more = true; more;) {
        const std::size_t end = output.find(mark);
        Printed part = printed_in(test, output.substr(0, end));
        if (!part.lines.empty()) printed.push_back(std::move(part));
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
    for (const std::string& line : shown->lines) text += "      " + line + "\n";
    if (shown->more > 0) text += fmt::format("      … and {}\n", counted(shown->more, "more line"));
    std::size_t others = 0;
    for (const Printed& part : printed)
        if (&part != &*shown) others += count(part);
    if (others > 0)
        text += fmt::format("      ({} in {})\n", counted(others, "line"),
                            counted(printed.size() - 1, "other test"));
    return text;
}

}  // namespace rt
