// Words that other programs use for what this language calls otherwise, and words of chapters to come.
#pragma once

#include <string>
#include <string_view>

namespace rt {

/// What a command that this language does not have may mean, as the end of a message:
/// `; did you mean 'tri'?`, `; did you mean 'point' or 'directional'?`, `; it comes with chapter 12` or why
/// it is not to be had. Upper and lower case are the same. Empty where the word is in no table.
std::string meaning_elsewhere(std::string_view command);

/// The same for a word that is no known choice of `command`.
std::string meaning_elsewhere(std::string_view command, std::string_view choice);

}  // namespace rt
