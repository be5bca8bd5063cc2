// Bytes as text of 64 letters, for data URLs and JSON (RFC 4648).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rt {

/// With the letters + and /, filled up with = to a multiple of four.
std::string base64(std::string_view bytes);

/// The bytes that `base64` makes this text of, or nothing if it makes it of none.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace rt
