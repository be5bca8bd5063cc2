// Functions in a source file, found without compiling it: enough for files of free functions.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// A function's definition in a text.
struct FunctionText {
    std::size_t begin = 0;  ///< of the first line of its signature
    std::size_t end = 0;    ///< after the line of its closing brace
    int line = 0;           ///< its first, counted from 1
    std::string signature;  ///< up to its opening brace
};

/// The number of the line in which place `at` of the text is, counted from 1.
int line_at(std::string_view text, std::size_t at);

/// The text with each run of blanks and line ends as one blank, and without those at its ends.
std::string in_one_line(std::string_view text);

/// The functions of a well-formatted file (as clang-format leaves it) that contain a line with `part`, in
/// order.
std::vector<FunctionText> functions_with(std::string_view text, std::string_view part);

/// The function with this signature, blanks and line ends aside, in a file formatted in any way; nothing if
/// there is none, or if its braces do not match.
std::optional<FunctionText> find_function(std::string_view text, std::string_view signature);

/// The text with a function of `original` that it does not have put in its place: after the function that is
/// before it there, before the next one, or at the end of the namespace. Nothing if none of these is found,
/// or the text has a function of the same name that `original` does not have: which may be the same with
/// other parameters.
std::optional<std::string> with_function(std::string_view text, std::string_view original,
                                         const FunctionText& function);

}  // namespace rt
