// When submissions were handed in, as an instructor says it.
#include "common/grading/submission_times.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

namespace rt {

namespace {

/// Where something is wrong; columns count bytes.
[[noreturn]] void refuse(const std::string& file, int line, std::size_t column, const std::string& what) {
    throw InputError(at_place(printable(file), line, column, what));
}

/// `"Lovelace, Ada"` as `Lovelace, Ada`.
std::string unquoted(const std::string& text) {
    if (text.size() < 2 || !text.starts_with('"') || !text.ends_with('"')) return text;
    std::string name;
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        name += text[i];
        if (text[i] == '"' && text[i + 1] == '"') ++i;
    }
    return name;
}

}  // namespace

std::map<std::string, Moment> read_submission_times(const std::string& file, const std::string& text) {
    std::map<std::string, Moment> times;
    std::istringstream in(text);
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (line.ends_with('\r')) line.pop_back();
        if (line.empty()) continue;
        const auto comma = line.rfind(',');
        if (comma == std::string::npos || comma == 0)
            refuse(file, number, 1, "expected a submission's name, a comma, and when it was handed in");
        const std::optional<Moment> moment = moment_of(line.substr(comma + 1));
        if (!moment)
            refuse(file, number, comma + 2,
                   "expected a time with its distance from UTC, such as 2027-03-01T23:59:00+01:00");
        const std::string name = unquoted(line.substr(0, comma));
        if (!times.emplace(name, *moment).second)
            refuse(file, number, 1, fmt::format("{} is there twice", printable(name)));
    }
    return times;
}

void tell_times(std::vector<Submission>& submissions, const std::filesystem::path& file) {
    const auto times = read_submission_times(file.string(), read_file(file));
    for (Submission& submission : submissions) {
        const auto found = times.find(submission.name);
        if (found == times.end())
            throw InputError(fmt::format("{}: it does not say when {} was handed in",
                                         printable(file.string()), printable(submission.name)));
        submission.submitted = found->second;
    }
}

}  // namespace rt
