// Moments as texts that mean the same everywhere: ISO 8601 with its distance from UTC (RFC 3339).
#pragma once

#include <chrono>
#include <optional>
#include <string>

namespace rt {

using Moment = std::chrono::sys_seconds;

/// "2027-03-01T22:59:00Z".
std::string text_of(Moment moment);

/// Reads "2027-03-01T23:59:00+01:00", "2027-03-01T22:59Z" and "2027-03-01T22:59:59.9Z", whose part of a
/// second is left out; years from 1970 to 9999. Nothing for any other text, also one without Z or a distance:
/// then it would depend on the machine's clock what it means.
std::optional<Moment> moment_of(const std::string& text);

/// This one.
Moment now();

}  // namespace rt
