// JSON as text that every reader accepts, whatever bytes a file's name or a compiler's message is made of.
#pragma once

#include "common/math/printable.hpp"

#include <nlohmann/json.hpp>

#include <string>

namespace rt {

/// In every string, bytes that are not UTF-8 become `\xNN`.
template <class Json>
void make_utf8(Json& value) {
    if (value.is_string()) {
        value = printable(value.template get_ref<const std::string&>(), Keep::Controls);
    } else if (value.is_structured()) {
        for (Json& part : value) make_utf8(part);
    }
}

/// The value as JSON, in one line or indented. Never throws because of what the strings hold.
template <class Json>
std::string json_text(const Json& value, int indent = -1) {
    try {
        return value.dump(indent);
    } catch (
        const nlohmann::detail::type_error&) {  // of all that it can be, only this: a string is not UTF-8
        Json shown = value;
        make_utf8(shown);
        return shown.dump(indent);
    }
}

}  // namespace rt
