// HTML pages from mustache templates: one style, light and dark, nothing loaded from elsewhere.
#include "common/pictures/page.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/project.hpp"

#include <fmt/format.h>
#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <stdexcept>

namespace rt {

namespace fs = std::filesystem;
namespace mustache = kainjow::mustache;

namespace {

constexpr const char* shared_pages = "common/pictures/pages";

mustache::data to_data(const PageView& view) {
    switch (view.type()) {
        case PageView::value_t::object: {
            mustache::data object;
            for (const auto& [key, value] : view.items()) object.set(key, to_data(value));
            return object;
        }
        case PageView::value_t::array: {
            mustache::data list(mustache::data::type::list);
            for (const PageView& value : view) list.push_back(to_data(value));
            return list;
        }
        case PageView::value_t::string: {
            const auto& text = view.get_ref<const std::string&>();
            return text.empty() ? mustache::data(false) : mustache::data(text);
        }
        case PageView::value_t::boolean:
            return view.get<bool>();
        case PageView::value_t::null:
            return false;
        default:
            return view.dump();
    }
}

/// Adds the templates of a directory by their names. The end of a file's last line is not part of it, so that
/// a partial can stand inside a line.
void add_partials(mustache::data& data, const fs::path& directory) {
    for (const auto& entry : fs::directory_iterator(directory)) {
        if (entry.path().extension() != ".mustache") continue;
        std::string text = read_file(entry.path());
        if (text.ends_with('\n')) text.pop_back();
        data.set(entry.path().stem().string(), mustache::partial([text] { return text; }));
    }
}

std::string style_of(const fs::path& root, const fs::path& file) {
    std::string style = read_file(root / shared_pages / "page.css");
    const fs::path own = fs::path(root / file).replace_extension(".css");
    if (fs::exists(own)) style += read_file(own);
    return style;
}

}  // namespace

std::string page_from(std::string_view file, const PageView& view) {
    const fs::path root = this_project().root;
    mustache::data data = to_data(view);
    add_partials(data, root / shared_pages);
    add_partials(data, (root / file).parent_path());
    data.set("style", style_of(root, file));
    mustache::mustache page(read_file(root / file));
    page.set_custom_escape(
        [](const std::string& text) { return mustache::html_escape(printable(text, Keep::Lines)); });
    std::string text = page.render(data);
    if (!page.is_valid()) throw std::logic_error(fmt::format("{}: {}", file, page.error_message()));
    return text;
}

}  // namespace rt
