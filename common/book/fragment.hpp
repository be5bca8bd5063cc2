// A page of Markdown as HTML, by pandoc.
#pragma once

#include "common/book/book.hpp"

#include <set>
#include <string>
#include <vector>

namespace rt {

/// A heading below the page's title.
struct BookSection {
    std::string id;
    std::string title;  ///< HTML
    std::string body;   ///< HTML of what follows, up to the next heading of this kind
};

/// What stands between a page's head and foot.
struct Fragment {
    std::string html;
    std::vector<BookSection> sections;
    std::set<std::filesystem::path> pictures, files;  ///< that it shows and refers to, from the root
};

/// Converts a page. Links to other pages lead to them, and those to files to `files/NAME.html`. Throws as
/// `write_book`.
Fragment fragment_of(const Project& project, const BookPage& page, const std::vector<BookPage>& pages);

/// The same without tags, references and needless blanks, to be searched.
std::string searchable(const std::string& html);

/// The fragment as one of several on a page: its anchors begin with the page's name, and links to `pages`
/// lead to anchors.
std::string among_others(const std::string& html, const BookPage& page, const std::vector<BookPage>& pages);

}  // namespace rt
