// When submissions were handed in, as an instructor says it.
#pragma once

#include "common/grading/submission.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rt {

/// Reads lines of a submission's name, a comma, and a moment, "ada,2027-03-01T23:59:00+01:00"; empty lines
/// mean nothing. A name may have commas, and quotes around it as in RFC 4180. Throws InputError, with file,
/// line and column, for lines of another form and for a name that stands there twice.
std::map<std::string, Moment> read_submission_times(const std::string& file, const std::string& text);

/// Says of each submission when it was handed in. Throws InputError if the file does not say it of one: that
/// one would count as never late.
void tell_times(std::vector<Submission>& submissions, const std::filesystem::path& file);

}  // namespace rt
