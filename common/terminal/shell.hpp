// Words for a shell.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// The text as one word of a POSIX shell's command line, whatever bytes but zero it has: as it is where that
/// is safe, else in single quotes.
std::string shell_word(std::string_view text);

/// Several words, with `between` them.
std::string shell_words(const std::vector<std::string>& texts, std::string_view between = " ");

}  // namespace rt
