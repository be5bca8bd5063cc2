// JSON as text that every reader accepts, whatever bytes a file's name or a compiler's message is made of;
// and read from text. Only json_text.cpp compiles the library's reader and writer, which take seconds.
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <string_view>

namespace rt {

/// The value as JSON, in one line or indented. Bytes of strings that are not UTF-8 become `\xNN`; never
/// throws because of what the strings hold.
std::string json_text(const nlohmann::json& value, int indent = -1);
std::string json_text(const nlohmann::ordered_json& value, int indent = -1);

/// What the text says, with keys in alphabetical order or in the text's; `is_discarded()` where it is no
/// JSON.
nlohmann::json read_json(std::string_view text);
nlohmann::ordered_json read_ordered_json(std::string_view text);

}  // namespace rt
