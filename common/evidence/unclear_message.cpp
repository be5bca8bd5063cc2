// Whether a failed test's message is written for a student.
#include "common/evidence/unclear_message.hpp"

#include "common/workbook/exercise.hpp"

#include <regex>
#include <vector>

namespace rt {

namespace {

bool has(const std::string& text, const char* pattern) {
    return std::regex_search(text, std::regex(pattern));
}

}  // namespace

std::string unclear(const std::string& message) {
    // The test's name, what was asked, what came out, and the condition at its place.
    const std::vector<std::string> lines = split_lines(message);
    std::string asked, came_out;
    for (std::size_t i = 1; i + 1 < lines.size(); ++i)
        (lines[i].starts_with("came out: ") || !came_out.empty() ? came_out : asked) += lines[i] + "\n";
    if (has(asked + came_out, R"(\{\?\})")) return "shows a value as {?}";
    if (has(asked + came_out, R"(\b0x[0-9a-f])")) return "shows hexadecimal digits";
    if (has(asked, R"( := )")) return "names a variable of the test, not what it is";
    if (has(came_out, R"(\b(true|false)\b)")) return "says true or false, not what that means";
    if (asked.empty()) return "does not say what was asked";
    return "";
}

}  // namespace rt
