// The lessons as a book: which pages it has, and the static site that is written of them.
#pragma once

#include "common/workbook/catalogue.hpp"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace rt {

/// A page of the book and the Markdown that it is made of.
struct BookPage {
    std::filesystem::path source;  ///< from the repository's root, "chapters/02_spheres/README.md"
    std::string file;              ///< "02_spheres.html"
    std::string chapter;           ///< its number, "02"; empty for what belongs to none
    std::string title;             ///< its first line, "2 Spheres"
};

/// The lessons' pages in the order in which they are read, then the scene language. Throws InputError for a
/// page that does not begin with a line "# …".
std::vector<BookPage> book_pages(const Project& project, const std::vector<Chapter>& chapters);

/// Writes the site into a directory: `index.html`, a page a source, `whole.html` with all of them to be
/// printed, pictures, the files that lessons refer to, and what is needed to search. Nothing in it is loaded
/// from elsewhere. Files that are there already are replaced, others stay. `told` is called before each page.
/// In a handout links to what is hidden become plain text. Throws InputError if a lesson refers to a file or
/// page that is not there, outside of handouts, or if the directory cannot be written, std::runtime_error if
/// pandoc fails or warns.
void write_book(const Project& project, const std::vector<Chapter>& chapters,
                const std::vector<BookPage>& pages, const std::filesystem::path& output,
                const std::function<void(const BookPage&)>& told);

}  // namespace rt
