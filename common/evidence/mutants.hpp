// Mutants of a solution: each differs from it at one place, as a slip of the pen would. Tests that do not
// notice one do not test that place (Richard A. DeMillo, Richard J. Lipton, Frederick G. Sayward,
// 'Hints on Test Data Selection: Help for the Practicing Programmer', Computer 11 (1978), 34–41).
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace rt {

struct Mutant {
    std::string step;         ///< whose exercise is changed
    std::size_t begin = 0;    ///< of what is replaced in the solution
    std::size_t length = 0;   ///< of that
    std::string replacement;  ///< what stands there in the mutant
    int line = 0;             ///< of the solution, counted from 1
    std::string from;         ///< the changed line, or lines as one, without the blanks around
    std::string to;           ///< what it is changed to, likewise
};

/// All mutants of a solution's exercises, in the order of their places. `file` is its name for messages.
///
/// Changed are operators (`<` to `<=` and `>=`, `+` to `-`, `&&` to `||` …), numbers (one more, one less; a
/// fraction is doubled), the conditions of `if`, `while`, `for` and `?:` (always true, always false),
/// neighbours in lists of arguments, names that have an opposite (min and max, sin and cos, x and y), calls
/// (`sqrt(x)` to `(x)`) and statements (left out; `v.reserve(n)` only saves time and stays as it is). Not all
/// that are made compile. Relies on the layout of clang-format: only operators between two operands have
/// blanks on both sides.
std::vector<Mutant> mutants_of(std::string_view solution, const std::string& file);

/// The whole file as the mutant has it.
std::string mutated(std::string_view solution, const Mutant& mutant);

}  // namespace rt
