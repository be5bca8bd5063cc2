// What may include what: the table of rooms in CONTRIBUTING.md, and every `#include "…"` held against it.
#include "common/image/whole_file.hpp"
#include "common/terminal/project.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace rt;
namespace fs = std::filesystem;

namespace {

using Names = std::vector<std::string>;

/// Each room with all that its files may include: itself, the rooms that it stands on, and theirs.
using Law = std::map<std::string, std::set<std::string>>;

/// The files of the repository, each with those that it includes, all as written from its root.
using Includes = std::map<std::string, Names>;

/// "02" for a file in the column of chapter 2, else "".
std::string chapter_of(const fs::path& file) {
    static const std::regex column("[a-z]+/([0-9][0-9])_.*");
    const std::string name = file.string();
    std::smatch match;
    return std::regex_match(name, match, column) ? match[1].str() : "";
}

/// The room of a file as the table names it: the two directories that it is in, with all that is inside of
/// them. Mistakes and variants are changes to a solution and stand there; a file that the build makes of all
/// contracts stands with them.
std::string room_of(const fs::path& file) {
    const std::string ending = file.extension().string();
    if (ending == ".mistake" || ending == ".variant") return "solutions/NN_name";
    const Names parts(file.begin(), file.end());
    if (parts.size() < 2) return "";
    if (parts.size() == 2) return parts[0] == "chapters" ? "chapters/NN_name" : parts[0];
    return parts[0] + "/" + (chapter_of(file).empty() ? parts[1] : "NN_name");
}

/// What stands between backquotes.
Names quoted(const std::string& text) {
    static const std::regex quotes("`([^`]+)`");
    Names names;
    for (std::sregex_iterator i(text.begin(), text.end(), quotes), end; i != end; ++i)
        names.push_back((*i)[1]);
    return names;
}

/// Reads the rows `| room | what it stands on | ...`; a room must stand below those that it stands on.
Law law_in(const std::string& text, Names& problems) {
    const std::string head = "| room | stands on |";
    std::istringstream in(text.substr(std::min(text.find(head), text.size())));
    std::string line;
    std::getline(in, line);
    std::getline(in, line);  // the rule below the head
    Law law;
    while (std::getline(in, line) && line.starts_with("|")) {
        const std::size_t second = line.find('|', 1), third = line.find('|', second + 1);
        const Names rooms = quoted(line.substr(0, second));
        if (rooms.size() != 1) problems.push_back("not one room: " + line);
        for (const std::string& room : rooms) {
            std::set<std::string> allowed{room};
            for (const std::string& below : quoted(line.substr(second, third - second))) {
                if (!law.contains(below)) problems.push_back(room + " stands above " + below);
                allowed.insert(law[below].begin(), law[below].end());
            }
            law[room] = allowed;
        }
    }
    return law;
}

/// What is wrong with the includes of each file, a line each.
Names against(const Law& law, const Includes& includes) {
    Names problems;
    for (const auto& [file, names] : includes) {
        const auto row = law.find(room_of(file));
        if (row == law.end()) problems.push_back(file + ": no row for " + room_of(file));
        for (const std::string& name : names) {
            if (row != law.end() && !row->second.contains(room_of(name)))
                problems.push_back(file + " includes " + name);
            if (!chapter_of(file).empty() && chapter_of(file) < chapter_of(name))
                problems.push_back(file + " includes " + name + ", of a later chapter");
        }
    }
    return problems;
}

/// Follows the includes from `file`; a circle is what of the way so far begins with a file that comes again.
void find_circles(const Includes& includes, const std::string& file, Names& way,
                  std::set<std::string>& finished, Names& circles) {
    const auto begin = std::ranges::find(way, file);
    if (begin != way.end()) {
        std::string circle;
        for (auto i = begin; i != way.end(); ++i) circle += *i + " → ";
        circles.push_back(circle + file);
        return;
    }
    const auto found = includes.find(file);
    if (found == includes.end() || finished.contains(file)) return;
    way.push_back(file);
    for (const std::string& name : found->second) find_circles(includes, name, way, finished, circles);
    way.pop_back();
    finished.insert(file);
}

Names circles_in(const Includes& includes) {
    Names circles, way;
    std::set<std::string> finished;
    for (const auto& [file, names] : includes) find_circles(includes, file, way, finished, circles);
    return circles;
}

Names includes_of(const std::string& text) {
    static const std::string word = "#include \"";
    Names names;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        if (line.starts_with(word)) names.push_back(line.substr(word.size(), line.rfind('"') - word.size()));
    return names;
}

Includes includes_of_repository() {
    const Project project = this_project();
    Includes includes;
    for (const char* room : {"chapters", "common", "references", "solutions", "tests"})
        for (const auto& entry : fs::recursive_directory_iterator(project.root / room)) {
            const std::string ending = entry.path().extension().string();
            if (std::ranges::count(Names{".cpp", ".hpp", ".mistake", ".variant"}, ending) > 0)
                includes[relative(project, entry.path())] = includes_of(read_file(entry.path()));
        }
    return includes;
}

std::string contributing() { return read_file(fs::path(test::repository()) / "CONTRIBUTING.md"); }

}  // namespace

TEST_CASE("every file includes what CONTRIBUTING.md allows its room", "[includes]") {
    Names problems;
    const Law law = law_in(contributing(), problems);
    const Includes includes = includes_of_repository();
    CHECK(problems == Names{});
    CHECK(against(law, includes) == Names{});
    CHECK(circles_in(includes) == Names{});

    std::set<std::string> rooms;
    for (const auto& [file, names] : includes) rooms.insert(room_of(file));
    for (const auto& [room, allowed] : law) {
        INFO("a row for a room without files: " << room);
        CHECK(rooms.contains(room));
    }
    CHECK(includes.size() > 100);
}

TEST_CASE("an include against the law is found", "[includes]") {
    Names problems;
    const Law law = law_in(
        "| room | stands on | what lives there |\n|---|---|---|\n"
        "| `common/math` | | |\n"
        "| `common/scene` | `common/math` | `text` |\n"
        "| `chapters/NN_name` | `common/scene` | |\n"
        "| `solutions/NN_name` | `chapters/NN_name` | |\n\n"
        "| `elsewhere` | `nothing` | |\n",
        problems);
    REQUIRE(problems == Names{});
    REQUIRE(law.size() == 4);
    const auto problem = [&](const std::string& file, const std::string& included) {
        return against(law, {{file, {included}}}) != Names{};
    };
    CHECK_FALSE(problem("common/scene/a.cpp", "common/scene/a.hpp"));
    CHECK_FALSE(problem("common/scene/part/a.cpp", "common/scene/part/a.hpp"));
    CHECK_FALSE(problem("chapters/02_b/b.hpp", "common/math/vec.hpp"));
    CHECK_FALSE(problem("solutions/02_b/b.cpp", "chapters/01_a/a.hpp"));
    CHECK_FALSE(problem("tests/02_b/variants/02.1_x.variant", "chapters/02_b/b.hpp"));
    CHECK(problem("common/math/a.cpp", "common/scene/a.hpp"));
    CHECK(problem("common/scene/a.cpp", "a.hpp"));
    CHECK(problem("common/new/a.cpp", "common/new/a.hpp"));
    CHECK(problem("common/scene/a.cpp", "chapters/01_a/a.hpp"));
    CHECK(problem("solutions/02_b/b.cpp", "chapters/03_c/c.hpp"));
    CHECK(problem("chapters/02_b/b.cpp", "solutions/02_b/b.hpp"));

    law_in("| room | stands on |\n|---|---|\n| `a` | `b` |\n| `b` | |\n", problems);
    CHECK(problems == Names{"a stands above b"});
}

TEST_CASE("a circle of includes is found", "[includes]") {
    CHECK(circles_in({{"a", {"b", "c"}}, {"b", {"c"}}, {"c", {}}}) == Names{});
    CHECK(circles_in({{"a", {"b"}}, {"b", {"c"}}, {"c", {"b"}}}) == Names{"b → c → b"});
    CHECK(circles_in({{"a", {"a"}}}) == Names{"a → a"});
}
