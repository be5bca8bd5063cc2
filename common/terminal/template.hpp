// Texts from mustache templates.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace rt {

/// What the names in a template stand for. Texts are data, whatever characters they have. A section is left
/// out for "", false, null and an empty list. Numbers are written with all their digits, so callers make
/// texts of those that people read.
using TemplateView = nlohmann::ordered_json;

/// What becomes of characters that mean something in the text that is made.
enum class Escape { None, Html };

/// The text that the template in `file` makes of `view`. Templates NAME.mustache in these directories are its
/// partials; no name in the view may be that of one. Throws InputError where a file cannot be read,
/// std::logic_error for a template that is not one.
std::string filled(const std::filesystem::path& file, const TemplateView& view, Escape escape,
                   const std::vector<std::filesystem::path>& partials = {});

}  // namespace rt
