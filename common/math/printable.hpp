// Text from outside (a file's name, a compiler's message, bytes of a file) as a person and JSON can be shown
// it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace rt {

/// Whether the byte goes on with a UTF-8 character that an earlier one began.
inline bool continues_utf8(char c) { return (static_cast<std::uint8_t>(c) & 0xC0) == 0x80; }

/// The length of the UTF-8 character at the front of `text`, which is not empty; 0 where there is none: a
/// byte out of place, a form longer than needed, half of a surrogate pair, or beyond U+10FFFF (RFC 3629).
inline std::size_t utf8_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(text[i]); };
    const std::uint8_t first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if (!continues_utf8(text[i])) return 0;
    const std::uint8_t second = byte(1);
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F)) return 0;
    if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F)) return 0;
    return length;
}

inline bool is_utf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        if (length == 0) return false;
        text.remove_prefix(length);
    }
    return true;
}

/// As much of the text's beginning as `most` bytes hold, whole characters of it.
inline std::string_view beginning(std::string_view text, std::size_t most) {
    if (text.size() <= most) return text;
    while (most > 0 && continues_utf8(text[most])) --most;
    return text.substr(0, most);
}

/// What may stand in a text as it is, beside characters that are no control characters.
enum class Keep { Nothing, Lines, Controls };

/// `text` as UTF-8 in which nothing steers a terminal: bytes that are not UTF-8 and control characters (C0,
/// DEL and C1) become `\xNN`, newlines and tabs `\n` and `\t`. `Keep::Lines` leaves newlines and tabs as they
/// are, `Keep::Controls` (for JSON, which has escapes of its own) all control characters.
inline std::string printable(std::string_view text, Keep keep = Keep::Nothing) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string shown;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const char first = text[0];
        const auto code = static_cast<std::uint8_t>(first);
        const bool c1 = length == 2 && code == 0xC2 && static_cast<std::uint8_t>(text[1]) < 0xA0;
        const bool control = (length == 1 && (code < 0x20 || code == 0x7F)) || c1;
        const bool line = first == '\n' || first == '\t';
        const std::size_t taken = length == 0 ? 1 : length;
        if (length > 0 && (!control || keep == Keep::Controls || (line && keep == Keep::Lines))) {
            shown += text.substr(0, taken);
        } else if (line) {
            shown += first == '\n' ? "\\n" : "\\t";
        } else {
            for (const char c : text.substr(0, taken)) {
                const auto bits = static_cast<std::uint8_t>(c);
                shown += {'\\', 'x', digits[bits >> 4], digits[bits & 15]};
            }
        }
        text.remove_prefix(taken);
    }
    return shown;
}

}  // namespace rt
