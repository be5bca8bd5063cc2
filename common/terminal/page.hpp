// HTML pages from mustache templates: one style, light and dark, nothing loaded from elsewhere.
#pragma once

#include "common/terminal/template.hpp"

#include <string>
#include <string_view>

namespace rt {

/// What a page shows; see TemplateView. Texts are shown as they are, also those with < and &.
using PageView = TemplateView;

/// The page that a template makes of `view`; `file` is its path from the repository's root, such as
/// "common/evidence/pages/tour.mustache". The templates beside it and those of common/terminal/pages are its
/// partials. The page's style is page.css and, if there is one, the .css file beside the template with its
/// name. Throws as `filled`.
std::string page_from(std::string_view file, const PageView& view);

}  // namespace rt
