// The lessons as a book: which pages it has, and the static site that is written of them.
#include "common/book/book.hpp"

#include "common/book/fragment.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/counted.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/page.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/lesson.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr const char* name_of_book = "Ray tracing, chapter by chapter";
constexpr const char* scene_language = "common/scene/README.md";

/// "2 Spheres" of "# 2 Spheres".
std::string title_of(const Project& project, const fs::path& source) {
    const std::vector<std::string> lines = split_lines(read_file(project.root / source));
    if (lines.empty() || !lines.front().starts_with("# "))
        throw InputError(source.string() + ":1: expected a title, '# …'");
    return lines.front().substr(2);
}

/// "02_spheres.html" of its README.md, "02_spheres_part_2.html" of its part_2.md.
std::string file_of(const Chapter& chapter, const fs::path& source) {
    const std::string stem = source.stem().string();
    return chapter.name + (stem == "README" ? "" : "_" + stem) + ".html";
}

/// What stands beside every page: the chapters and their pages, of which one may be this one.
PageView contents(const std::vector<Chapter>& chapters, const std::vector<BookPage>& pages,
                  const std::string& current) {
    PageView list = PageView::array();
    const auto entry = [&](const BookPage& page) {
        return PageView{{"href", page.file}, {"name", page.title}, {"current", page.file == current}};
    };
    for (const Chapter& chapter : chapters) {
        PageView parts = PageView::array();
        std::string whole;  // "3 Triangles, ", which stands once above its parts
        for (const BookPage& page : pages) {
            if (page.chapter != chapter.number) continue;
            parts.push_back(entry(page));
            if (!whole.empty() && page.title.starts_with(whole))
                parts.back()["name"] = page.title.substr(whole.size());
            if (whole.empty()) whole = page.title + ", ";
        }
        list.push_back({{"parts", parts}});
    }
    PageView others = PageView::array();
    for (const BookPage& page : pages)
        if (page.chapter.empty()) others.push_back(entry(page));
    list.push_back({{"parts", others}});
    return list;
}

/// The same where all pages are on one.
PageView contents_of_whole(const std::vector<BookPage>& pages) {
    PageView list = PageView::array();
    for (const BookPage& page : pages) {
        const std::string anchor = "#" + fs::path(page.file).stem().string();
        list.push_back({{"parts", {{{"href", anchor}, {"name", page.title}, {"current", false}}}}});
    }
    return list;
}

PageView neighbour(const std::vector<BookPage>& pages, std::size_t i) {
    if (i >= pages.size()) return false;
    return {{"href", pages[i].file}, {"name", pages[i].title}};
}

PageView base_view(const std::string& title, const std::string& way_up) {
    return {{"title", title}, {"site", name_of_book}, {"up", way_up}};
}

std::string page_html(const std::vector<Chapter>& chapters, const std::vector<BookPage>& pages, std::size_t i,
                      const Fragment& fragment) {
    PageView view = base_view(pages[i].title, "");
    view["chapters"] = contents(chapters, pages, pages[i].file);
    view["sections"] = PageView::array();
    for (const BookSection& section : fragment.sections)
        view["sections"].push_back({{"id", section.id}, {"name", section.title}});
    view["text"] = fragment.html;
    view["previous"] = neighbour(pages, i - 1);  // of the first there is none: the number is too large
    view["next"] = neighbour(pages, i + 1);
    return page_from("common/book/pages/book.mustache", view);
}

std::string whole_html(const std::vector<BookPage>& pages, const std::vector<Fragment>& fragments) {
    std::string text;
    for (std::size_t i = 0; i < pages.size(); ++i) text += among_others(fragments[i].html, pages[i], pages);
    PageView view = base_view(name_of_book, "");
    view["chapters"] = contents_of_whole(pages);
    view["text"] = text;
    return page_from("common/book/pages/book.mustache", view);
}

/// The picture of a chapter's first scene, from the root; empty if there is none.
fs::path cover_of(const Project& project, const Chapter& chapter) {
    if (chapter.scenes.empty()) return {};
    const fs::path scene = fs::path("references") / chapter.name / chapter.scenes.front();
    const fs::path picture = fs::path(scene).replace_extension(".png");
    return fs::exists(project.root / picture) ? picture : fs::path();
}

std::string index_html(const Project& project, const std::vector<Chapter>& chapters,
                       const std::vector<BookPage>& pages) {
    PageView view = base_view(name_of_book, "");
    view["chapters"] = contents(chapters, pages, "");
    view["cards_title"] = name_of_book;
    view["cards"] = PageView::array();
    for (const Chapter& chapter : chapters) {
        view["cards"].push_back({{"href", file_of(chapter, "README.md")},
                                 {"name", fmt::format("{} {}", std::stoi(chapter.number), chapter.title)},
                                 {"summary", chapter.summary},
                                 {"hours", counted(chapter.hours, "hour")},
                                 {"cover", cover_of(project, chapter).string()}});
    }
    return page_from("common/book/pages/book.mustache", view);
}

/// What can be searched, as a script: pages that are opened as files may load scripts, and nothing else.
std::string search_index(const std::vector<BookPage>& pages, const std::vector<Fragment>& fragments) {
    auto list = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < pages.size(); ++i)
        for (const BookSection& section : fragments[i].sections)
            list.push_back({{"page", pages[i].title},
                            {"title", searchable(section.title)},
                            {"href", pages[i].file + "#" + section.id},
                            {"text", searchable(section.body)}});
    return "const sections = " + json_text(list) + ";\n";
}

void copy_file_to(const fs::path& from, const fs::path& to) {
    make_directories(to.parent_path());
    write_file(to, read_file(from));
}

/// A file that a lesson refers to, as a page: a browser would not show it otherwise.
void write_source(const Project& project, const fs::path& file, const fs::path& output) {
    const fs::path page = output / "files" / (file.string() + ".html");
    std::string way_up;
    for (const fs::path& part : fs::path("files") / file.parent_path()) way_up += part.empty() ? "" : "../";
    PageView view = base_view(file.string(), way_up);
    view["code"] = read_file(project.root / file);
    make_directories(page.parent_path());
    write_file(page, page_from("common/book/pages/book.mustache", view));
}

/// Pictures, files, and what the search and the formulas need.
void write_parts(const Project& project, const std::vector<Chapter>& chapters,
                 const std::vector<Fragment>& fragments, const fs::path& output) {
    std::set<fs::path> pictures, files;
    for (const Fragment& fragment : fragments) {
        pictures.insert(fragment.pictures.begin(), fragment.pictures.end());
        files.insert(fragment.files.begin(), fragment.files.end());
    }
    for (const Chapter& chapter : chapters) {
        const fs::path cover = cover_of(project, chapter);
        if (!cover.empty()) pictures.insert(cover);
    }
    for (const fs::path& picture : pictures) copy_file_to(project.root / picture, output / picture);
    for (const fs::path& file : files) write_source(project, file, output);
    copy_file_to(project.root / "common/book/pages/search.js", output / "search.js");
    const std::pair<const char*, const char*> packaged[] = {
        {"/usr/share/javascript/lunr/lunr.min.js", "libjs-lunr"},
        {"/usr/share/fonts/opentype/stix-word/STIXMath-Regular.otf", "fonts-stix"}};
    for (const auto& [file, package] : packaged) {
        if (!fs::exists(file)) throw InputError(fmt::format("{} is missing; install {}", file, package));
        copy_file_to(file, output / fs::path(file).filename());
    }
}

}  // namespace

std::vector<BookPage> book_pages(const Project& project, const std::vector<Chapter>& chapters) {
    std::vector<BookPage> pages;
    for (const Chapter& chapter : chapters)
        for (const fs::path& page : pages_of(project.root / "chapters" / chapter.name)) {
            const fs::path source = fs::path("chapters") / chapter.name / page.filename();
            pages.push_back({source, file_of(chapter, source), chapter.number, title_of(project, source)});
        }
    pages.push_back({scene_language, "scene_language.html", "", title_of(project, scene_language)});
    return pages;
}

void write_book(const Project& project, const std::vector<Chapter>& chapters,
                const std::vector<BookPage>& pages, const fs::path& output,
                const std::function<void(const BookPage&)>& told) {
    make_directories(output);
    require_writable(output / "index.html");
    std::vector<Fragment> fragments;
    for (const BookPage& page : pages) {
        told(page);
        fragments.push_back(fragment_of(project, page, pages));
    }
    write_parts(project, chapters, fragments, output);
    for (std::size_t i = 0; i < pages.size(); ++i)
        write_file(output / pages[i].file, page_html(chapters, pages, i, fragments[i]));
    write_file(output / "whole.html", whole_html(pages, fragments));
    write_file(output / "search_index.js", search_index(pages, fragments));
    write_file(output / "index.html", index_html(project, chapters, pages));
}

}  // namespace rt
