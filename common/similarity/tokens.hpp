// What remains of C++ when names, values and layout are forgotten.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace rt {

struct Token {
    std::uint16_t kind = 0;  ///< the same for what is alike; never 0
    int line = 0;            ///< where it begins, counted from 1
};

/// The tokens of a source, whatever bytes it has.
///
/// All names are of one kind, also those of built-in types and `auto`; so are all literals. Each other
/// keyword and each operator is of its own. What a copy can put in, take out or move without another thought
/// is dropped: comments, white space, braces, lines of #include and #pragma, qualifiers (`std::`), and the
/// keywords that say something of a thing and compute nothing, such as `const`.
std::vector<Token> tokens_of(std::string_view source);

}  // namespace rt
