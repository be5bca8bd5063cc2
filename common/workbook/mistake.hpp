// Changes to the solution: known mistakes, which the tests must catch, and right variants, which they must
// accept.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rt {

/// One `--- replace … --- with …` group of a mistake file.
struct Replacement {
    std::string from;  ///< whole lines, as they stand in the solution
    std::string to;
    int line = 0;  ///< of its `--- replace` in the mistake file
};

/// A file of tests/NN_name/mistakes/ or of tests/NN_name/variants/.
struct Mistake {
    std::string step;   ///< whose tests must fail; of a variant, which it writes in another way
    std::string file;   ///< of the solution
    std::string why;    ///< it is wrong; of a variant, why it is right
    std::string shows;  ///< what the failure that is shown must say, such as its test's name; may be empty
    std::vector<Replacement> replacements;
};

/// Reads a mistake; `name` is its file's name for messages. Throws InputError, with file and line, for a
/// missing step, file or reason, an unknown line, and a group that is not complete.
Mistake parse_mistake(std::string_view text, const std::string& name);

/// The solution with the change in it. Throws InputError, with the change's file and line, if a text to
/// replace does not stand in the solution exactly once.
std::string apply_mistake(const Mistake& mistake, const std::string& solution, const std::string& name);

}  // namespace rt
