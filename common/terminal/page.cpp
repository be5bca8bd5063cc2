// HTML pages from mustache templates: one style, light and dark, nothing loaded from elsewhere.
#include "common/terminal/page.hpp"

#include "common/image/whole_file.hpp"
#include "common/terminal/project.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace rt {

namespace fs = std::filesystem;

std::string page_from(std::string_view file, const PageView& view) {
    const fs::path root = this_project().root, shared = root / "common/terminal/pages", page = root / file;
    std::string style = read_file(shared / "page.css");
    if (const fs::path own = fs::path(page).replace_extension(".css"); fs::exists(own))
        style += read_file(own);
    PageView complete = view;
    complete["style"] = style;
    return filled(page, complete, Escape::Html, {shared, page.parent_path()});
}

}  // namespace rt
