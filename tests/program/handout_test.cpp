// Handouts: what is in them, what must not be, and what an update leaves alone.
#include "common/handout/handout.hpp"
#include "common/handout/handout_files.hpp"
#include "common/handout/solution_lines.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/git.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/results.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

#include <algorithm>
#include <functional>
#include <regex>
#include <set>
#include <sstream>

using namespace rt;

namespace {

namespace fs = std::filesystem;

using Names = std::vector<std::string>;

/// A text with every `from` as `to`.
std::string replaced(const std::string& text, const std::string& from, const std::string& to) {
    return std::regex_replace(text, std::regex(from), to);
}

/// A course of two chapters, with something of everything that a handout may have and must not have.
Project course(const std::string& name) {
    const Project project = test::sandbox(name);
    test::add_chapter(project, "02_spheres", test::good_chapter);
    test::add_chapter(project, "03_cubes", replaced(test::good_chapter, "02\\.", "03."));
    for (const char* file : {"chapters/03_cubes/x.cpp", "solutions/03_cubes/x.cpp"})
        test::write(project.root / file, replaced(read_file(project.root / file), "02\\.", "03."));
    for (const char* chapter : {"02_spheres", "03_cubes"}) {
        const std::string column = chapter;
        test::write(project.root / "chapters" / column / "README.md", "The lesson.\n");
        test::write(project.root / "chapters" / column / "x.hpp", "// " + column + "\nint f();\n");
        test::write(project.root / "tests" / column / "x_test.cpp", "// The tests.\n");
        test::write(project.root / "tests" / column / "mistakes/02.1_x.mistake", "why\n");
        test::write(project.root / "tests" / column / "variants/02.1_x.variant", "why\n");
        test::write(project.root / "references" / column / "figures.cpp", "// Draws.\n");
        test::write(project.root / "references" / column / "figures/a.svg", "<svg/>\n");
    }
    for (const char* file :
         {"README.md", "CONTRIBUTING.md", "LICENSE", ".ci/run", "notes.txt", "common/math/vec.hpp",
          "common/grading/README.md", "common/grading/REFERENCE.md", "common/grading/grade.hpp",
          "tests/CMakeLists.txt", "tests/changed_solutions.cmake", "tests/oracle/sum.cpp",
          "tests/program/a.sh", "tests/grading/attacks/a.cpp", "references/figures.hpp",
          "common/math/vec.hpp.001.backup", ".course/state.json", "build/bin/course"})
        test::write(project.root / file, std::string("// ") + file + "\n");
    test::write(project.root / "course", "#!/bin/sh\n");
    fs::permissions(project.root / "course", fs::perms::owner_exec, fs::perm_options::add);
    test::write(project.root / ".gitignore", read_file(fs::path(test::repository()) / ".gitignore"));
    return project;
}

/// A place for a handout, with nothing there.
fs::path place(const std::string& name) {
    const fs::path directory = fs::path(test::scratch_directory()) / name;
    fs::remove_all(directory);
    return directory;
}

/// A handout of such a course with its first chapter, and what to ask of it.
struct Handed {
    Project project;
    fs::path directory;

    explicit Handed(const std::string& name, const std::string& chapters = "2")
        : project(course(name)), directory(place(name + "_handout")) {
        make_handout(project, directory, {chapters, ""});
    }
    UpdatedHandout update(const std::string& chapters = "") const {
        return update_handout(project, directory, {chapters, ""});
    }
    std::string text(const std::string& file) const { return read_file(directory / file); }
    void write(const std::string& file, const std::string& text) const {
        test::write(directory / file, text);
    }
    /// Changes a file of the course.
    void change(const std::string& file, const std::string& text) const {
        test::write(project.root / file, text);
    }
};

/// All files but git's, as from the directory.
Names files_below(const fs::path& directory) {
    Names files;
    for (auto i = fs::recursive_directory_iterator(directory); i != fs::recursive_directory_iterator(); ++i) {
        if (i->path().filename() == ".git") i.disable_recursion_pending();
        if (i->is_regular_file()) files.push_back(i->path().lexically_relative(directory).string());
    }
    std::ranges::sort(files);
    return files;
}

std::string in(const fs::path& directory, Names arguments) {
    arguments.insert(arguments.begin(), {"-C", directory.string()});
    return git(arguments);
}

/// Whether a refusal says this.
void check_refused(const std::function<void()>& action, const std::string& what) {
    const std::string message = test::error_of(action);
    INFO("expected: " << what);
    CHECK_THAT(message, Catch::Contains(what));
    CHECK(message.find('\n') == std::string::npos);
}

const std::string exercise = "chapters/02_spheres/x.cpp", pristine = ".course/pristine/02_spheres/x.cpp";

/// A solution with another task, and hence another exercise.
std::string solution_with_task(const Handed& handed, const std::string& task) {
    return replaced(read_file(handed.project.root / "solutions/02_spheres/x.cpp"), "One\\.", task);
}

}  // namespace

TEST_CASE("a handout has what is given, the exercises, and nothing else", "[handout]") {
    const Handed handed("handout_files");
    CHECK(files_below(handed.directory) ==
          Names{".course/handout.json", ".course/pristine/02_spheres/x.cpp",
                ".course/pristine/03_cubes/x.cpp", ".gitignore", "LICENSE", "README.md",
                "chapters/02_spheres/README.md", "chapters/02_spheres/chapter.json",
                "chapters/02_spheres/x.cpp", "chapters/02_spheres/x.hpp", "chapters/03_cubes/x.hpp",
                "common/grading/grade.hpp", "common/math/vec.hpp", "course",
                "references/02_spheres/figures/a.svg", "references/02_spheres/one.scene",
                "tests/02_spheres/x_test.cpp", "tests/CMakeLists.txt", "tests/oracle/sum.cpp"});
    CHECK(handed.text(exercise) == read_file(handed.project.root / exercise));
    CHECK(handed.text(pristine) == handed.text(exercise));
    CHECK((fs::status(handed.directory / "course").permissions() & fs::perms::owner_exec) != fs::perms::none);
    const std::vector<Chapter> chapters = read_catalogue({handed.directory, handed.directory / "build"});
    REQUIRE(chapters.size() == 1);
    CHECK(is_untouched({handed.directory, handed.directory / "build"}, chapters[0]));
}

TEST_CASE("exercises of a handout come from the solutions, not from what somebody has written", "[handout]") {
    const Project project = course("handout_written");
    const std::string before = read_file(project.root / exercise);
    test::write(project.root / exercise, "int f() { return 1; }\n");
    const fs::path directory = place("handout_written_handout");
    make_handout(project, directory, {});
    CHECK(read_file(directory / exercise) == before);
}

TEST_CASE("a handout is a git repository with one commit that has all of it", "[handout]") {
    const Handed handed("handout_git");
    CHECK(in(handed.directory, {"rev-list", "--all", "--count"}) == "1\n");
    CHECK(in(handed.directory, {"status", "--porcelain"}).empty());
    std::string listed;
    for (const std::string& file : files_below(handed.directory)) listed += file + "\n";
    CHECK(in(handed.directory, {"ls-files"}) == listed);
    handed.write("common/math/vec.hpp", "spoilt");
    in(handed.directory, {"restore", "common"});
    CHECK(handed.text("common/math/vec.hpp") == "// common/math/vec.hpp\n");
}

TEST_CASE("the README names the class, its instructor and the dates of the chapters that are there",
          "[handout]") {
    const Project project = course("handout_readme");
    const fs::path directory = place("handout_readme_handout"), about = project.root / "class.json";
    test::write(about, R"({"course": "Rays 101", "instructor": "Ada Lovelace",
        "due": {"02": "2027-02-15 23:59", "03": "2027-03-01"}})");
    make_handout(project, directory, {"2", about});
    const std::string text = read_file(directory / "README.md");
    CHECK_THAT(text, Catch::StartsWith("# Rays 101\n"));
    CHECK_THAT(text, Catch::Contains("\nInstructor: Ada Lovelace\n"));
    CHECK_THAT(text, Catch::Contains("[2 Spheres](chapters/02_spheres/README.md) | Round things. | 3 | "
                                     "2027-02-15 23:59 |\n"));
    CHECK_THAT(text, !Catch::Contains("2027-03-01"));
    CHECK_THAT(text, Catch::Contains("\n./course check 02 "));
    CHECK_THAT(text, !Catch::Contains("{{"));
    CHECK(in(directory, {"log", "-1", "--format=%an: %s"}) ==
          "Ada Lovelace: Rays 101, as it was handed out\n");

    fs::remove_all(directory);
    make_handout(project, directory, {});
    CHECK_THAT(read_file(directory / "README.md"), !Catch::Contains("Instructor") && !Catch::Contains("due"));
}

TEST_CASE("what is wrong with a class's file is said in one line", "[handout]") {
    const Project project = course("handout_class");
    const fs::path about = project.root / "class.json", directory = place("handout_class_handout");
    const auto refused = [&](const std::string& text, const std::string& what) {
        INFO(text);
        test::write(about, text);
        check_refused([&] { make_handout(project, directory, {"", about}); }, about.string() + what);
        CHECK_FALSE(fs::exists(directory));
    };
    refused("{\n  \"course\": }", ":2:13: is not JSON");
    refused("[]", ":1:1: the file: expected an object");
    refused(R"({"teacher": "x"})", ":1:13: teacher: is not known; there are course, instructor, due");
    refused(R"({"course": ""})", ":1:12: course: expected a text of one line");
    refused(R"({"instructor": "a\nb"})", ":1:16: instructor: expected a text of one line");
    refused(R"({"due": {"02": "2027-02-30"}})", ":1:16: due/02: expected a day");
    refused(R"({"due": {"02": "2027-02-15 24:00"}})", ":1:16: due/02: expected a day");
    refused(R"({"due": {"2": "2027-02-15"}})", ":1:15: due/2: expected a chapter's number");
    refused(R"({"due": {"07": "2027-02-15"}})", ":1:16: due/07: there is no such chapter");
}

TEST_CASE("chapters are handed out from the first to another", "[handout]") {
    const Project project = course("handout_chapters");
    const auto numbers = [&](const std::string& chapters) {
        return make_handout(project, place("handout_chapters_handout"), {chapters, ""}).chapters;
    };
    CHECK(numbers("") == Names{"02", "03"});
    CHECK(numbers("2-3") == Names{"02", "03"});
    CHECK(numbers("02") == Names{"02"});
    check_refused([&] { numbers("3"); }, "--chapters: '3' must begin with 02");
    check_refused([&] { numbers("3-2"); }, "--chapters: '3-2' must begin with 02");
    check_refused([&] { numbers("2-9"); }, "there is no chapter '9'; there are 02, 03");
    check_refused([&] { numbers("2,3"); }, "--chapters: '2,3' is not from one chapter to another");
}

TEST_CASE("a line of a solution in a given file is found, and nothing is made", "[handout]") {
    const Project project = course("handout_leak");
    test::write(project.root / "solutions/03_cubes/x.cpp",
                "int f() {\n    // [exercise 03.1] One.\n    int secret  = 40 + 2;\n    int given = 1 + 1;\n"
                "    return 1;\n    // [/exercise]\n}\n\n"
                "int g() {\n    // [exercise 03.2] Two.\n    return 2;\n    // [/exercise]\n}\n");
    test::write(project.root / "common/math/vec.hpp", "// Given.\n\tint given = 1 +  1;\n");
    const SolutionLines lines = solution_lines(project);
    CHECK(lines.size() == 1);
    CHECK_FALSE(find_leak(lines, "int given = 1 + 1;\nreturn 1;\n").has_value());
    const auto leak = find_leak(lines, "// Mine.\n\n  int\tsecret = 40 + 2;   \n");
    REQUIRE(leak);
    CHECK(leak->line == 3);
    CHECK(leak->solution.line == 3);

    test::write(project.root / "tests/02_spheres/x_test.cpp",
                "// The tests.\n        int secret = 40 + 2;\n");
    const fs::path directory = place("handout_leak_handout");
    check_refused([&] { make_handout(project, directory, {}); },
                  "tests/02_spheres/x_test.cpp:2 is line 3 of solutions/03_cubes/x.cpp");
    CHECK_FALSE(fs::exists(directory));
}

TEST_CASE("what exists is not replaced", "[handout]") {
    const Handed handed("handout_exists");
    const fs::path other = place("handout_exists_other");
    fs::create_directories(other);
    check_refused([&] { make_handout(handed.project, other, {}); }, "exists, and is no handout");
    check_refused([&] { update_handout(handed.project, other, {}); }, "is no handout");
    check_refused([&] { update_handout(handed.project, other / "nothing", {}); }, "is no handout");
    CHECK(fs::is_empty(other));
    check_refused([&] { make_handout(handed.project, handed.directory, {}); },
                  "is a handout already; --update brings it up to date");
    check_refused([&] { make_handout(handed.project, other / "no/such", {}); }, "cannot be made");
    fs::create_directory_symlink(other / "nowhere", other / "link");
    check_refused([&] { make_handout(handed.project, other / "link", {}); }, "exists, and is no handout");
    check_refused(
        [&] {
            make_handout({handed.directory, handed.directory / "build"}, place("handout_of_it"), {});
        },
        "this is a handout, which has no solutions; ./course handout needs them");
}

TEST_CASE("an update brings what is given, and what nobody has touched", "[handout]") {
    const Handed handed("update_given");
    CHECK(handed.update().written.empty());
    handed.change("common/math/vec.hpp", "// New.\n");
    handed.change("chapters/02_spheres/README.md", "The new lesson.\n");
    handed.change("tests/02_spheres/y_test.cpp", "// More tests.\n");
    handed.change("solutions/02_spheres/x.cpp", solution_with_task(handed, "Another."));
    fs::remove(handed.project.root / "tests/oracle/sum.cpp");
    const UpdatedHandout updated = handed.update();
    CHECK(updated.kept.empty());
    CHECK(updated.removed == Names{"tests/oracle/sum.cpp"});
    CHECK(updated.written.size() == 5);
    CHECK(handed.text("common/math/vec.hpp") == "// New.\n");
    CHECK(handed.text("chapters/02_spheres/README.md") == "The new lesson.\n");
    CHECK(handed.text("tests/02_spheres/y_test.cpp") == "// More tests.\n");
    CHECK_THAT(handed.text(exercise), Catch::Contains("Another."));
    CHECK(handed.text(pristine) == handed.text(exercise));
    CHECK(handed.update().written.empty());
}

TEST_CASE("an update leaves alone what a student has written, also when both have changed", "[handout]") {
    const Handed handed("update_mine");
    handed.write(exercise, "int f() { return 1; }\n");
    handed.write("chapters/02_spheres/helper.cpp", "// Mine.\n");
    handed.write("notes.md", "Mine.\n");
    handed.write("build/bin/x", "built");
    handed.change("common/math/vec.hpp", "// New.\n");
    CHECK(handed.update().kept.empty());  // the exercise itself has not changed
    CHECK(handed.text(exercise) == "int f() { return 1; }\n");

    handed.change("solutions/02_spheres/x.cpp", solution_with_task(handed, "Another."));
    const UpdatedHandout updated = handed.update();
    REQUIRE(updated.kept.size() == 1);
    CHECK(updated.kept[0].path == exercise);
    CHECK(updated.kept[0].why ==
          "the exercise has changed; yours stays, and ./course reset 02 brings the new one");
    CHECK(handed.text(exercise) == "int f() { return 1; }\n");
    CHECK_THAT(handed.text(pristine), Catch::Contains("Another."));
    CHECK(handed.text("chapters/02_spheres/helper.cpp") == "// Mine.\n");
    CHECK(handed.text("notes.md") == "Mine.\n");
    CHECK(handed.text("build/bin/x") == "built");
    CHECK(handed.update().kept.empty());  // said once

    fs::remove(handed.directory / exercise);
    handed.change("common/math/vec.hpp", "// Newer.\n");
    CHECK(handed.update().kept.empty());
    CHECK_FALSE(fs::exists(handed.directory / exercise));  // `reset` brings it back
}

TEST_CASE("a given file that was changed is kept in a backup, if the course's has changed, too",
          "[handout]") {
    const Handed handed("update_changed");
    handed.write("common/math/vec.hpp", "// Changed there.\n");
    handed.write("tests/oracle/sum.cpp", "// Changed there.\n");
    CHECK(handed.update().kept.empty());
    CHECK(handed.text("common/math/vec.hpp") == "// Changed there.\n");

    handed.change("common/math/vec.hpp", "// New.\n");
    fs::remove(handed.project.root / "tests/oracle/sum.cpp");
    const UpdatedHandout updated = handed.update();
    REQUIRE(updated.kept.size() == 2);
    CHECK(updated.kept[0].path == "tests/oracle/sum.cpp");
    CHECK_THAT(updated.kept[0].why, Catch::Contains("no part of the course any more"));
    CHECK(updated.kept[1].path == "common/math/vec.hpp");
    CHECK_THAT(updated.kept[1].why, Catch::Contains("vec.hpp.001.backup"));
    CHECK(handed.text("common/math/vec.hpp") == "// New.\n");
    CHECK(handed.text("common/math/vec.hpp.001.backup") == "// Changed there.\n");
    CHECK(handed.text("tests/oracle/sum.cpp") == "// Changed there.\n");
}

TEST_CASE("an update shows more chapters, and hides none", "[handout]") {
    const Handed handed("update_chapters");
    handed.write("chapters/03_cubes/x.cpp", "// What a student has guessed.\n");
    const UpdatedHandout updated = handed.update("2-3");
    CHECK(updated.chapters == Names{"02", "03"});
    REQUIRE(updated.kept.size() == 1);
    CHECK(updated.kept[0].why ==
          "the exercise is new; yours stays, and ./course reset 03 brings the new one");
    CHECK(handed.text("chapters/03_cubes/README.md") == "The lesson.\n");
    CHECK(read_catalogue({handed.directory, handed.directory / "build"}).size() == 2);
    CHECK(handed.update().chapters == Names{"02", "03"});
    check_refused([&] { handed.update("2"); }, "has chapter 03, and an update hides none");
}

TEST_CASE("an update keeps the class's names and dates, or takes new ones", "[handout]") {
    const Project project = course("update_class");
    const fs::path directory = place("update_class_handout"), about = project.root / "class.json";
    test::write(about, R"({"instructor": "Ada Lovelace", "due": {"02": "2027-02-15"}})");
    make_handout(project, directory, {"", about});
    test::write(project.root / "common/math/vec.hpp", "// New.\n");
    CHECK(update_handout(project, directory, {}).written == Names{"common/math/vec.hpp"});
    CHECK_THAT(read_file(directory / "README.md"),
               Catch::Contains("Ada Lovelace") && Catch::Contains("2027-02-15"));
    test::write(about, R"({"instructor": "Ada Lovelace", "due": {"02": "2027-02-22"}})");
    CHECK(update_handout(project, directory, {"", about}).written == Names{"README.md"});
    CHECK_THAT(read_file(directory / "README.md"), Catch::Contains("2027-02-22"));
}

TEST_CASE("an update that was interrupted is finished by the next", "[handout]") {
    const Handed handed("update_interrupted");
    handed.change("common/math/vec.hpp", "// New.\n");
    handed.change("solutions/02_spheres/x.cpp", solution_with_task(handed, "Another."));
    const std::string record = handed.text(record_file);
    handed.update();
    const std::string after = handed.text(exercise);
    handed.write(record_file, record);  // which is written last
    fs::remove(handed.directory / "common/math/vec.hpp");
    const UpdatedHandout updated = handed.update();
    CHECK(updated.kept.empty());
    CHECK(updated.written == Names{"common/math/vec.hpp"});
    CHECK(handed.text(exercise) == after);
}

TEST_CASE("an update follows no link and no path that leads out of the handout", "[handout]") {
    const Handed handed("update_links");
    const fs::path outside = place("update_links_outside");
    fs::create_directories(outside);
    test::write(outside / "vec.hpp", "Precious.\n");
    test::write(outside / "lock", "Precious.\n");
    handed.change("common/math/vec.hpp", "// New.\n");
    handed.change("tests/oracle/sum.cpp", "// New.\n");

    fs::remove(handed.directory / "common/math/vec.hpp");
    fs::create_symlink(outside / "vec.hpp", handed.directory / "common/math/vec.hpp");
    check_refused([&] { handed.update(); }, "vec.hpp is a symbolic link");
    fs::remove_all(handed.directory / "common/math");
    fs::create_directory_symlink(outside, handed.directory / "common/math");
    check_refused([&] { handed.update(); }, "common/math is a symbolic link");
    fs::remove(handed.directory / "common/math");
    fs::create_symlink(outside / "lock", handed.directory / ".course/memory.lock");
    check_refused([&] { handed.update(); }, ".course/memory.lock is a symbolic link");
    fs::remove(handed.directory / ".course/memory.lock");
    fs::create_directories(handed.directory / "common/math/vec.hpp");
    check_refused([&] { handed.update(); }, "vec.hpp is no file");
    fs::remove_all(handed.directory / "common/math");

    HandoutRecord record = read_record(handed.text(record_file), "record");
    for (const char* path : {"../update_links_outside/vec.hpp", "/etc/passwd", "", ".", "common/../../x",
                             ".git/config", "common//math/vec.hpp"}) {
        CAPTURE(path);
        HandoutRecord bad = record;
        bad.files[path] = fingerprint("Precious.\n");
        handed.write(record_file, record_text(bad));
        check_refused([&] { handed.update(); }, "there is no such file in a handout");
    }
    for (const char* text : {"", "{}", "[1]", R"({"class": {}, "chapters": [1], "files": {}})",
                             R"({"class": {}, "chapters": [], "files": {}})",
                             R"({"class": {}, "chapters": ["77"], "files": {}})"}) {
        CAPTURE(text);
        handed.write(record_file, text);
        CHECK_THROWS_AS(handed.update(), InputError);
    }
    handed.write(record_file, record_text(record));
    CHECK(handed.text("tests/oracle/sum.cpp") == "// tests/oracle/sum.cpp\n");
    CHECK(read_file(outside / "vec.hpp") == "Precious.\n");
    CHECK(read_file(outside / "lock") == "Precious.\n");
    CHECK(handed.update().written == Names{"common/math/vec.hpp", "tests/oracle/sum.cpp"});
}

TEST_CASE("no line of a solution is in this course's handout, nor in its history", "[handout]") {
    const Project project = this_project();
    // Found here without the functions that the handout itself is looked through with.
    const auto fold = [](const std::string& line) {
        std::istringstream in(line);
        std::string text;
        for (std::string word; in >> word;) text += (text.empty() ? "" : " ") + word;
        return text;
    };
    const auto lines_of = [](const fs::path& room, const std::regex& name) {
        Names lines;
        for (const auto& entry : fs::recursive_directory_iterator(room))
            if (entry.is_regular_file() && std::regex_search(entry.path().string(), name))
                for (const std::string& line : split_lines(read_file(entry.path()))) lines.push_back(line);
        return lines;
    };
    std::set<std::string> secret;
    bool inside = false;
    for (const std::string& line : lines_of(project.root / "solutions", std::regex("\\.cpp$"))) {
        if (line.find("// [exercise ") != std::string::npos) inside = true;
        if (line.find("// [/exercise]") != std::string::npos) inside = false;
        if (inside && fold(line).size() >= 12) secret.insert(fold(line));
    }
    CHECK(secret.size() > 500);
    // What is given of the solutions' files is what stands outside of the marks there.
    for (const std::string& line : lines_of(project.root / "common", std::regex("\\.[ch]pp$")))
        secret.erase(fold(line));
    for (const std::string& line : lines_of(project.root / "chapters", std::regex("\\.hpp$")))
        secret.erase(fold(line));
    inside = false;
    for (const std::string& line : lines_of(project.root / "solutions", std::regex("\\.cpp$"))) {
        if (line.find("// [exercise ") != std::string::npos) inside = true;
        if (!inside) secret.erase(fold(line));
        if (line.find("// [/exercise]") != std::string::npos) inside = false;
    }
    std::erase_if(secret, [](const std::string& line) { return line.starts_with("//"); });  // tasks
    CHECK(secret.size() > 300);

    const fs::path directory = place("handout_of_this");
    make_handout(project, directory, {"1-5", ""});
    CHECK(in(directory, {"rev-list", "--all", "--count"}) == "1\n");
    Names leaks;
    const auto look_through = [&](const std::string& text) {
        for (const std::string& line : split_lines(text))
            if (secret.contains(fold(line))) leaks.push_back(line);
    };
    for (const std::string& file : files_below(directory)) look_through(read_file(directory / file));
    look_through(in(directory, {"cat-file", "--batch-all-objects", "--batch"}));
    look_through(in(directory, {"log", "--all", "--patch"}));
    CHECK(leaks == Names{});
    CHECK(files_below(directory).size() > 400);
    fs::remove_all(directory);
}
