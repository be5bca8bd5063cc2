// `course book`: the lessons as one static site.
#include "common/book/book.hpp"

#include "common/commands/commands.hpp"
#include "common/math/counted.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rt {

namespace fs = std::filesystem;

int run_book(const fs::path& directory, bool json) {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    if (chapters.empty()) throw InputError("there are no chapters yet");
    const std::vector<BookPage> pages = book_pages(project, chapters);
    const fs::path output = directory.empty() ? project.build / "book" : directory;
    {
        Progress progress("book", !json);
        double done = 0;
        write_book(project, chapters, pages, output, [&](const BookPage& page) {
            progress.update(done++ / static_cast<double>(pages.size()), page.file);
        });
    }
    const fs::path index = output / "index.html";
    if (json)
        fmt::print("{}\n",
                   json_text(nlohmann::ordered_json{{"pages", pages.size()}, {"page", index.string()}}));
    else
        fmt::print("{}; the book begins at {}\n", counted(pages.size(), "page"),
                   printable(relative(project, index)));
    return 0;
}

}  // namespace rt
