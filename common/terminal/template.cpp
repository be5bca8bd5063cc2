// Texts from mustache templates.
#include "common/terminal/template.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/project.hpp"

#include <kainjow/mustache.hpp>
#include <nlohmann/json.hpp>

#include <stdexcept>

namespace rt {

namespace fs = std::filesystem;
namespace mustache = kainjow::mustache;

namespace {

mustache::data to_data(const TemplateView& view) {
    switch (view.type()) {
        case TemplateView::value_t::object: {
            mustache::data object;
            for (const auto& [key, value] : view.items()) object.set(key, to_data(value));
            return object;
        }
        case TemplateView::value_t::array: {
            mustache::data list(mustache::data::type::list);
            for (const TemplateView& value : view) list.push_back(to_data(value));
            return list;
        }
        case TemplateView::value_t::string: {
            const auto& text = view.get_ref<const std::string&>();
            return text.empty() ? mustache::data(false) : mustache::data(text);
        }
        case TemplateView::value_t::boolean:
            return view.get<bool>();
        case TemplateView::value_t::null:
            return false;
        default:
            return json_text(view);
    }
}

/// Adds the templates of a directory by their names. The end of a file's last line is not part of it, so that
/// a partial can stand inside a line.
void add_partials(mustache::data& data, const fs::path& directory) {
    for (const fs::path& file : files_in(directory, {".mustache"})) {
        std::string text = read_file(file);
        if (text.ends_with('\n')) text.pop_back();
        data.set(file.stem().string(), mustache::partial([text] { return text; }));
    }
}

std::string escaped(const std::string& text, Escape escape) {
    return escape == Escape::Html ? mustache::html_escape(printable(text, Keep::Lines)) : text;
}

}  // namespace

std::string filled(const fs::path& file, const TemplateView& view, Escape escape,
                   const std::vector<fs::path>& partials) {
    mustache::data data = to_data(view);
    for (const fs::path& directory : partials) add_partials(data, directory);
    mustache::mustache form(read_file(file));
    form.set_custom_escape([escape](const std::string& text) { return escaped(text, escape); });
    std::string text = form.render(data);
    if (!form.is_valid()) throw std::logic_error(file.string() + ": " + form.error_message());
    return text;
}

}  // namespace rt
