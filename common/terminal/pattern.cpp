// Texts that have a form.
#include "common/terminal/pattern.hpp"

#include <regex>

namespace rt {

std::optional<std::vector<std::string>> parts_of(const std::string& text, const char* form) {
    std::smatch parts;
    if (!std::regex_match(text, parts, std::regex(form))) return std::nullopt;
    std::vector<std::string> texts;
    for (const auto& part : parts) texts.push_back(part.str());
    return texts;
}

}  // namespace rt
