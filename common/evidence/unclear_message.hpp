// Whether a failed test's message is written for a student.
#pragma once

#include <string>

namespace rt {

/// What keeps the message of a failed test (tests/main.cpp) from saying in words what is wrong, such as "says
/// true or false, not what that means"; empty if nothing does.
std::string unclear(const std::string& message);

}  // namespace rt
