// Whether a failed test's message is written for a student.
#include "common/evidence/unclear_message.hpp"

#include "common/workbook/exercise.hpp"

#include <regex>
#include <vector>

namespace rt {

namespace {

/// A message apart: the test's name comes first, and the condition at its place last.
struct Parts {
    std::string asked;
    std::string came_out;
};

Parts parts_of(const std::string& message) {
    const std::vector<std::string> lines = split_lines(message);
    Parts parts;
    for (std::size_t i = 1; i + 1 < lines.size(); ++i) {
        const bool is_result = lines[i].starts_with("came out: ") || !parts.came_out.empty();
        (is_result ? parts.came_out : parts.asked) += lines[i] + "\n";
    }
    return parts;
}

bool has(const std::string& text, const char* pattern) {
    return std::regex_search(text, std::regex(pattern));
}

/// Whether there is a word beside numbers, and beside what only says what was expected.
bool has_words(const std::string& asked) {
    static const std::regex no_words(R"(\b(expected|that|is|nan|inf|e[+-]?\d+)\b)");
    return has(std::regex_replace(asked, no_words, ""), "[a-z]{2}");
}

/// Numbers without noughts that mean nothing: 1.50 and 1.0 are 1.5 and 1.
std::string plain_numbers(const std::string& text) {
    static const std::regex noughts(R"((\.\d*?)0+(?!\d))"), point(R"(\.(?!\d))");
    return std::regex_replace(std::regex_replace(text, noughts, "$1"), point, "");
}

/// Whether what came out and what was expected read alike: "0, expected 0", "1.0, expected less than 1". That
/// 1 is not less than 1 needs no more digits.
bool look_alike(const std::string& came_out) {
    static const std::regex sides(
        "^came out: (.*), expected "
        "(anything but |less than |more than |at most |at least )?(.*?)( \\+- .*)?$");
    std::smatch found;
    const std::string line = came_out.substr(0, came_out.find('\n'));
    if (!std::regex_search(line, found, sides)) return false;
    const std::string actual = found[1], relation = found[2], expected = found[3];
    const bool equal_is_wrong = !relation.empty() && !relation.starts_with("at ");
    if (actual == expected) return !equal_is_wrong;
    return plain_numbers(actual) == plain_numbers(expected);
}

}  // namespace

std::string unclear(const std::string& message) {
    const auto [asked, came_out] = parts_of(message);
    if (has(asked + came_out, R"(\{\?\})")) return "shows a value as {?}";
    if (has(asked + came_out, R"(\b0x[0-9a-f])")) return "shows hexadecimal digits";
    if (has(asked, R"( := )")) return "names a variable of the test, not what it is";
    if (has(came_out, R"(\b(true|false)\b)")) return "says true or false, not what that means";
    if (has(came_out, R"(^came out: (yes|no), )")) return "answers yes or no, not what is wrong";
    if (look_alike(came_out)) return "shows two different values alike";
    if (!has_words(asked)) return "does not say what was asked";
    return "";
}

}  // namespace rt
