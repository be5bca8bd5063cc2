// Options of a test program of its own, beside those that all of them have (tests/main.cpp), and what else it
// may be used for.
#pragma once

#include <string>
#include <vector>

namespace rt::test {

/// Such as `--scene FILE`, as often as one likes. A variable at namespace scope: it is known to the command
/// line from its construction on, and has its values before the first test starts.
struct OwnOption {
    OwnOption(std::string option, std::string value, std::string about);
    OwnOption(const OwnOption&) = delete;
    OwnOption& operator=(const OwnOption&) = delete;

    std::string name, value_name, help;
    std::vector<std::string> values;
};

/// All of this program.
std::vector<OwnOption*>& own_options();

/// What a program does instead of testing where its first argument is `name`: `use` gets the others, and its
/// answer is the exit status. A variable at namespace scope.
struct OtherUse {
    OtherUse(std::string name, int (*use)(const std::vector<std::string>& arguments));
    OtherUse(const OtherUse&) = delete;
    OtherUse& operator=(const OtherUse&) = delete;

    std::string name;
    int (*use)(const std::vector<std::string>&);
};

/// All of this program.
std::vector<OtherUse*>& other_uses();

}  // namespace rt::test
