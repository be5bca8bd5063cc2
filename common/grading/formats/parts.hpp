// What several formats share.
#pragma once

#include "common/grading/shown.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// Throws InputError if students may not see the marks yet.
void require_shown(const ShownGrade& shown);

/// "02.1 The roots of a quadratic".
std::string name_of(const GradedStep& step);

/// What is possible, not counting extra credit: 0 there.
Points counted_possible(const GradedStep& step);

/// "7.5 of 15 points", "0.5 of 1 point".
std::string of_points(Points earned, Points possible);
/// The same of a step: "5 of 10 points, extra credit".
std::string points_line(const GradedStep& step);

/// Whether the step's checks could not do their work: it crashed, did not compile, ….
bool is_error(Verdict verdict);
/// Whether there was nothing to check yet.
bool is_skipped(Verdict verdict);

/// A row of a table for spreadsheets (RFC 4180). Spreadsheets run what begins like a formula, also in quotes
/// (OWASP, "CSV Injection"), so such a field has an apostrophe in front.
std::string csv_row(const std::vector<std::string>& fields);

/// A picture as an URL that needs nothing else.
std::string data_url(const std::string& png);

/// The text with the five characters that mean something in HTML and XML as entities.
std::string escaped_markup(std::string_view text);

}  // namespace rt
