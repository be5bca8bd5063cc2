// JSON as text that every reader accepts, and read from text.
#include "common/terminal/json_text.hpp"

#include "common/math/printable.hpp"

namespace rt {
namespace {

/// In every string, bytes that are not UTF-8 become `\xNN`.
template <class Json>
void make_utf8(Json& value) {
    if (value.is_string()) {
        value = printable(value.template get_ref<const std::string&>(), Keep::Controls);
    } else if (value.is_structured()) {
        for (Json& part : value) make_utf8(part);
    }
}

template <class Json>
std::string text_of(const Json& value, int indent) {
    try {
        return value.dump(indent);
    } catch (
        const nlohmann::detail::type_error&) {  // of all that it can be, only this: a string is not UTF-8
        Json shown = value;
        make_utf8(shown);
        return shown.dump(indent);
    }
}

}  // namespace

std::string json_text(const nlohmann::json& value, int indent) { return text_of(value, indent); }
std::string json_text(const nlohmann::ordered_json& value, int indent) { return text_of(value, indent); }

nlohmann::json read_json(std::string_view text) { return nlohmann::json::parse(text, nullptr, false); }
nlohmann::ordered_json read_ordered_json(std::string_view text) {
    return nlohmann::ordered_json::parse(text, nullptr, false);
}

}  // namespace rt
