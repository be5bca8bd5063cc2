// What a student may see of a grade, and how it is said.
#include "common/grading/shown.hpp"

#include "common/math/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace rt {
namespace {

/// A failing case may print pages; a person reads its beginning.
constexpr std::size_t most_bytes = 4000;

bool in_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || (c & 0x80) != 0 || c == '_' || c == '-' ||
           c == '.' || c == '+';
}

/// Stands for a private word.
constexpr std::string_view instead = "…";

/// Of paths from the machine's root, such as /home/somebody/x.cpp, and of what follows a private word as a
/// path, only the last name. A quotient, a relative path and the root's own files stay as they are.
std::string without_directories(const std::string& text) {
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool follows = text[i] == '/' && std::string_view(text).substr(0, i).ends_with(instead);
        const bool begins =
            follows || (text[i] == '/' &&
                        (i == 0 || (!in_name(text[i - 1]) && text[i - 1] != ')' && text[i - 1] != ']')));
        std::size_t end = i, last = i;  // of the path that may begin here, and of its last name
        for (; begins && end < text.size() && (in_name(text[end]) || text[end] == '/'); ++end)
            if (text[end] == '/' && end + 1 < text.size() && in_name(text[end + 1])) last = end + 1;
        if (last > i + 1) {
            if (follows) shown += '/';
            shown += text.substr(last, end - last);
            i = end - 1;
        } else {
            shown += text[i];
        }
    }
    return shown;
}

std::string without_words(std::string text, const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        if (word.empty()) continue;
        for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at)) {
            const std::size_t end = at + word.size();
            const auto letter = [](char c) {
                return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
            };
            const bool whole =
                (at == 0 || !letter(text[at - 1])) && (end == text.size() || !letter(text[end]));
            if (whole) text.replace(at, word.size(), instead);
            at += whole ? instead.size() : 1;
        }
    }
    return text;
}

/// The text, or its beginning where it is too long to be read.
std::string readable_part(const std::string& text) {
    const std::string_view part = beginning(text, most_bytes);
    return std::string(part) + (part.size() < text.size() ? " …" : "");
}

std::string indented(const std::string& text) {
    std::string lines = "  ";
    for (const char c : text) {
        lines += c;
        if (c == '\n') lines += "  ";
    }
    return lines;
}

std::string failure_lines(const FailedCheck& failure) {
    std::string lines;
    if (!failure.asked.empty()) lines += "\nasked: " + printable(failure.asked);
    if (!failure.said.empty()) lines += "\n" + indented(readable_part(printable(failure.said, Keep::Lines)));
    return lines;
}

}  // namespace

ShownGrade shown_to_student(const Grade& grade, const Rubric& rubric, Moment at,
                            const std::vector<std::string>& private_words) {
    ShownGrade shown{grade, std::nullopt};
    if (rubric.marks_from && at < *rubric.marks_from) shown.marks_from = rubric.marks_from;
    const auto clean = [&](std::string& text) {
        // The words first: one of them may be a directory with spaces in its name.
        text = without_directories(without_words(text, private_words));
    };
    clean(shown.grade.isolation);
    // With the seed a student could draw the next submission's random cases.
    shown.grade.seed = 0;
    shown.grade.rubric.clear();
    for (GradedStep& step : shown.grade.steps) {
        if (!rubric.hidden_from || at < *rubric.hidden_from) {
            const bool all_passed = step.hidden.passed == step.hidden.all;
            step.hidden = step.hidden.all == 0 ? CheckCount{} : CheckCount{all_passed ? 1 : 0, 1};
            step.hidden_failure.reset();
        }
        for (auto* failure : {&step.failure, &step.hidden_failure})
            if (*failure) {
                clean((*failure)->asked);
                clean((*failure)->said);
            }
    }
    return shown;
}

std::string verdict_line(const GradedStep& step) {
    const std::string verdict =
        step.verdict == Verdict::NeedsStep ? "needs step " + step.needs : std::string(name_of(step.verdict));
    if (step.checks.all == 0) return verdict;
    return fmt::format("{}: {} of {} {}", verdict, step.checks.passed, step.checks.all,
                       step.checks.all == 1 ? "check passes" : "checks pass");
}

std::string explained(const GradedStep& step) {
    std::string text = verdict_line(step);
    if (step.failure) text += failure_lines(*step.failure);
    if (step.hidden.passed < step.hidden.all)
        text += step.failure ? "\nSome hidden check does not pass, either."
                             : "\nSome hidden check does not pass.";
    if (step.hidden_failure) text += failure_lines(*step.hidden_failure);
    if (step.late_percent < 100) text += fmt::format("\nlate: {} % of the points count", step.late_percent);
    if (step.hint > 0) text += fmt::format("\nhint {}: ./course hint {}", step.hint, step.id);
    return text;
}

}  // namespace rt
