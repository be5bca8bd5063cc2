// From an annotated solution to the exercise that a student starts with.
#include "common/workbook/exercise.hpp"

#include "common/math/input_error.hpp"

#include <algorithm>
#include <cctype>

namespace rt {

namespace {

constexpr std::string_view opening = "[exercise";
constexpr std::string_view closing = "[/exercise]";
constexpr std::string_view todo_header = "#include \"common/math/todo.hpp\"";

std::string_view trimmed(std::string_view line) {
    const auto first = line.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return line.substr(first, line.find_last_not_of(" \t\r") - first + 1);
}

bool is_comment(std::string_view line) { return trimmed(line).starts_with("//"); }

/// What a comment line says, without the slashes and the blanks after them.
std::string_view comment_text(std::string_view line) { return trimmed(trimmed(line).substr(2)); }

std::string indentation(std::string_view line) {
    return std::string(line.substr(0, line.find_first_not_of(" \t")));
}

/// The step and the first line of the task in `[exercise 02.1] task`.
struct Opening {
    std::string step;
    std::string task;
};

Opening parse_opening(std::string_view text, const std::string& file, int line) {
    const auto end = text.find(']');
    if (end == std::string_view::npos) fail_at(file, line, "the marker '[exercise' has no ']'");
    const std::string_view step = trimmed(text.substr(opening.size(), end - opening.size()));
    if (!is_step_id(step))
        fail_at(file, line,
                "'" + std::string(step) + "' is not a step; expected '[exercise NN.S]', such as 02.1");
    return {std::string(step), std::string(trimmed(text.substr(end + 1)))};
}

/// Index of the first line of code of a region: after its opening marker and the comment lines that follow.
std::size_t code_start(const std::vector<std::string>& lines, const ExerciseRegion& region) {
    auto i = static_cast<std::size_t>(region.first_line);
    while (is_comment(lines[i]) && comment_text(lines[i]) != closing) ++i;
    return i;
}

/// Puts the header of `todo` among the includes from common/, in their order.
void include_todo(std::vector<std::string>& lines) {
    if (std::find(lines.begin(), lines.end(), todo_header) != lines.end()) return;
    auto last_quoted = lines.end(), place = lines.end();
    for (auto line = lines.begin(); line != lines.end(); ++line) {
        if (!line->starts_with("#include \"")) continue;
        last_quoted = line;
        if (!line->starts_with("#include \"common/")) continue;
        if (*line > todo_header) {
            lines.insert(line, std::string(todo_header));
            return;
        }
        place = line;
    }
    if (place != lines.end()) {
        lines.insert(place + 1, std::string(todo_header));
    } else if (last_quoted != lines.end()) {
        const auto blank = lines.insert(last_quoted + 1, "");
        lines.insert(blank + 1, std::string(todo_header));
    } else {
        const auto first = std::find_if_not(lines.begin(), lines.end(), is_comment);
        lines.insert(first, std::string(todo_header));
    }
}

std::string joined(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

}  // namespace

void replace_all(std::string& text, const std::string& from, const std::string& to) {
    for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

std::vector<std::string> split_lines(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const auto end = text.find('\n');
        lines.emplace_back(text.substr(0, end));
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + 1);
    }
    return lines;
}

bool is_step_id(std::string_view text) {
    const auto digit = [&](std::size_t i) { return std::isdigit(static_cast<unsigned char>(text[i])) != 0; };
    if (text.size() < 4 || text.size() > 5 || text[2] != '.') return false;
    return digit(0) && digit(1) && digit(3) && (text.size() == 4 || digit(4));
}

std::vector<ExerciseRegion> exercise_regions(std::string_view solution, const std::string& file) {
    std::vector<ExerciseRegion> regions;
    bool open = false;
    const std::vector<std::string> lines = split_lines(solution);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!is_comment(lines[i])) continue;
        const int number = static_cast<int>(i) + 1;
        const std::string_view text = comment_text(lines[i]);
        if (text.starts_with(opening)) {
            if (open)
                fail_at(file, number,
                        "a marker inside the exercise that line " +
                            std::to_string(regions.back().first_line) +
                            " opened; expected '// [/exercise]' before it");
            const Opening marker = parse_opening(text, file, number);
            if (marker.task.empty())
                fail_at(file, number, "the exercise has no task; expected text after the ']'");
            regions.push_back({marker.step, number, 0});
            open = true;
        } else if (text.starts_with("[/")) {
            if (text != closing)
                fail_at(file, number, "'" + std::string(text) + "' is not a marker; expected '[/exercise]'");
            if (!open) fail_at(file, number, "'[/exercise]' closes an exercise that was not opened");
            ExerciseRegion& region = regions.back();
            region.last_line = number;
            open = false;
            if (code_start(lines, region) == i) fail_at(file, number, "the exercise has no code");
        }
    }
    if (open)
        fail_at(file, regions.back().first_line,
                "the exercise is not closed; expected '// [/exercise]' below");
    return regions;
}

std::string exercise_text(std::string_view solution, const std::string& file) {
    const std::vector<ExerciseRegion> regions = exercise_regions(solution, file);
    if (regions.empty()) return std::string(solution);

    const std::vector<std::string> lines = split_lines(solution);
    std::vector<std::string> exercise;
    std::size_t next = 0;
    for (const ExerciseRegion& region : regions) {
        const auto first = static_cast<std::size_t>(region.first_line) - 1;
        const auto code = code_start(lines, region);
        const std::string indent = indentation(lines[first]);
        const Opening marker = parse_opening(comment_text(lines[first]), file, region.first_line);

        exercise.insert(exercise.end(), lines.begin() + static_cast<std::ptrdiff_t>(next),
                        lines.begin() + static_cast<std::ptrdiff_t>(first));
        exercise.push_back(indent + "// " + marker.step + "  " + marker.task);
        exercise.insert(exercise.end(), lines.begin() + static_cast<std::ptrdiff_t>(first) + 1,
                        lines.begin() + static_cast<std::ptrdiff_t>(code));
        exercise.push_back(indent + "return todo(\"" + marker.step + "\");");
        next = static_cast<std::size_t>(region.last_line);
    }
    exercise.insert(exercise.end(), lines.begin() + static_cast<std::ptrdiff_t>(next), lines.end());
    include_todo(exercise);
    return joined(exercise);
}

std::string solution_text(std::string_view solution, const std::string& file) {
    const std::vector<ExerciseRegion> regions = exercise_regions(solution, file);
    const std::vector<std::string> lines = split_lines(solution);
    std::vector<std::string> plain;
    std::size_t next = 0;
    for (const ExerciseRegion& region : regions) {
        plain.insert(plain.end(), lines.begin() + static_cast<std::ptrdiff_t>(next),
                     lines.begin() + region.first_line - 1);
        plain.insert(plain.end(), lines.begin() + static_cast<std::ptrdiff_t>(code_start(lines, region)),
                     lines.begin() + region.last_line - 1);
        next = static_cast<std::size_t>(region.last_line);
    }
    plain.insert(plain.end(), lines.begin() + static_cast<std::ptrdiff_t>(next), lines.end());
    return joined(plain);
}

}  // namespace rt
