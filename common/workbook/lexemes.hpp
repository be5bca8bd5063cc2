// A C++ source cut into words, numbers, quoted texts and signs, without compiling it.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace rt {

/// A piece of a source: a view into its text.
struct Lexeme {
    enum class Kind { Word, Number, Quoted, Sign };
    Kind kind = Kind::Sign;
    std::string_view text;
    std::size_t begin = 0;  ///< of `text` in the source
    int line = 0;           ///< where it begins, counted from 1

    std::size_t end() const { return begin + text.size(); }
    bool is(std::string_view what) const { return text == what; }
};

/// The pieces of a source, whatever bytes it has, in order. Comments, white space, and lines of #include and
/// #pragma are left out; of other directives the sign `#`. A sign that is no operator is a byte.
std::vector<Lexeme> lexemes_of(std::string_view source);

}  // namespace rt
