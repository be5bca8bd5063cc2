// HTML pages from mustache templates: one style, light and dark, nothing loaded from elsewhere.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>

namespace rt {

/// What the names in a template stand for. Texts are data: whatever characters they have, the page shows
/// them. A section is left out for "", false, null and an empty list. Numbers are written with all their
/// digits, so callers make texts of those that people read.
using PageView = nlohmann::ordered_json;

/// The page that a template makes of `view`; `file` is its path from the repository's root, such as
/// "common/evidence/pages/tour.mustache". The templates beside it and those of common/pictures/pages are its
/// partials. The page's style is page.css and, if there is one, the .css file beside the template with its
/// name. Throws InputError where a file cannot be read, std::logic_error for a template that is not one.
std::string page_from(std::string_view file, const PageView& view);

}  // namespace rt
