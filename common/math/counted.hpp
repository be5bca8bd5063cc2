// Numbers of things, as a person says them.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace rt {

/// So many things in words: "1 test", "3 tests"; `many` where the plural is not `one` with an s.
template <std::integral Count>
std::string counted(Count count, std::string_view one, std::string_view many = {}) {
    std::string text = std::to_string(count) + ' ';
    text += count == 1 || many.empty() ? one : many;
    return count != 1 && many.empty() ? text + 's' : text;
}

}  // namespace rt
