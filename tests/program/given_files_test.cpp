// Given files that were changed or deleted: which they are, and how they come back.
#include "common/workbook/given_files.hpp"
#include "common/image/whole_file.hpp"
#include "common/terminal/git.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

using namespace rt;
namespace fs = std::filesystem;

namespace {

/// A repository of one chapter, as a student has cloned it.
struct Clone {
    Project project = test::sandbox("given_files");
    fs::path header = project.root / "chapters/02_spheres/x.hpp",
             shared = project.root / "common/math/ray.hpp",
             exercise = project.root / "chapters/02_spheres/x.cpp";
    Clone() {
        test::add_chapter(project, "02_spheres", test::good_chapter);
        test::write(header, "int f();\n");
        test::write(shared, "struct Ray {};\n");
        test::write(project.root / "chapters/02_spheres/README.md", "The lesson.\n");
        in_git({"init", "--quiet", "--initial-branch=main"});
        commit();
    }
    std::string in_git(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), {"-C", project.root.string()});
        return git(arguments);
    }
    void commit() const {
        in_git({"add", "--all"});
        in_git({"-c", "user.name=Ada", "-c", "user.email=ada@localhost", "commit", "--quiet", "-m", "x"});
    }
    std::string words() const { return given_in_words(given_changes(project)); }
};

}  // namespace

TEST_CASE("what a student may change is no change of the course") {
    const Clone clone;
    CHECK(clone.words().empty());
    test::write(clone.exercise, "int f() { return 1; }\n");
    test::write(clone.project.root / "chapters/02_spheres/README.md", "The lesson, and my notes.\n");
    test::write(clone.project.root / "chapters/02_spheres/mine.hpp", "int mine();\n");
    CHECK(clone.words().empty());
    clone.in_git({"add", "--all"});
    CHECK(clone.words().empty());
    // Nor is a file that was only written again.
    test::write(clone.shared, "struct Ray {};\n");
    CHECK(clone.words().empty());
}

TEST_CASE("a given file that was changed is named, and how it comes back") {
    const Clone clone;
    test::write(clone.shared, "struct Ray {}\n");
    CHECK(clone.words() ==
          "common/math/ray.hpp is not as the course has it; git restore common/math/ray.hpp brings it back");
    fs::remove(clone.header);
    CHECK(clone.words() ==
          "chapters/02_spheres/x.hpp (deleted), common/math/ray.hpp are not as the course has them; git "
          "restore "
          "chapters/02_spheres/x.hpp common/math/ray.hpp brings them back");
    clone.in_git({"restore", "chapters/02_spheres/x.hpp", "common/math/ray.hpp"});
    CHECK(clone.words().empty());
}

TEST_CASE("one that was staged comes back, too") {
    const Clone clone;
    test::write(clone.shared, "struct Ray {}\n");
    clone.in_git({"add", "--all"});
    CHECK(restore_command(given_changes(clone.project)) ==
          "git restore --source=HEAD --staged --worktree common/math/ray.hpp");
    clone.in_git({"restore", "--source=HEAD", "--staged", "--worktree", "common/math/ray.hpp"});
    CHECK(clone.words().empty());
    CHECK(clone.in_git({"diff", "--cached", "--name-only"}).empty());
}

TEST_CASE("one that was committed by accident comes back, too") {
    const Clone clone;
    clone.in_git({"branch", "theirs"});
    clone.in_git({"branch", "--set-upstream-to=theirs", "main"});
    test::write(clone.shared, "struct Ray {}\n");
    clone.commit();
    const GivenChanges changes = given_changes(clone.project);
    REQUIRE(changes.files.size() == 1);
    const std::string command = restore_command(changes);
    CHECK(command == "git restore --source=" + clone.in_git({"rev-parse", "theirs"}).substr(0, 10) +
                         " common/math/ray.hpp");
    clone.in_git({"restore", "--source=theirs", "common/math/ray.hpp"});
    CHECK(clone.words().empty());
}

TEST_CASE("deleted files of a chapter come back by its number, and no others") {
    const Clone clone;
    const fs::path description = clone.project.root / "chapters/02_spheres/chapter.json";
    for (const fs::path& file : {clone.header, description, clone.shared}) fs::remove(file);
    CHECK(restore_missing(clone.project, "03").empty());
    const std::vector<std::string> both{"chapters/02_spheres/chapter.json", "chapters/02_spheres/x.hpp"};
    CHECK(restore_missing(clone.project, "2.1") == both);
    CHECK(read_file(clone.header) == "int f();\n");
    CHECK(fs::exists(description));
    CHECK_FALSE(fs::exists(clone.shared));
    CHECK(restore_missing(clone.project, "02_spheres").empty());
}

TEST_CASE("a handout is compared with what was handed out, also after an update that nobody has committed") {
    const Clone clone;
    const auto record = [&](const std::string& ray) {
        test::write(clone.project.root / ".course/handout.json",
                    "{\"files\": {\"common/math/ray.hpp\": \"" + fingerprint(ray) + "\"}}");
    };
    record("struct Ray {};\n");
    clone.commit();
    test::write(clone.shared, "struct Ray {}\n");
    clone.commit();
    CHECK(clone.words().find("git restore --source=") != std::string::npos);
    record("struct Ray {}\n");
    CHECK(clone.words().empty());
}

TEST_CASE("who works on the course is not told what they changed") {
    const Clone clone;
    test::write(clone.shared, "struct Ray {}\n");
    clone.in_git({"config", "course.maintainer", "true"});
    CHECK(clone.words().empty());
}

TEST_CASE("without git nothing is known") {
    const Project project = test::sandbox("given_without_git");
    test::write(project.root / "common/math/ray.hpp", "struct Ray {};\n");
    CHECK(given_changes(project).files.empty());
    CHECK(restore_missing(project, "02").empty());
}

TEST_CASE("of many changed files the first are named") {
    GivenChanges changes{{{"a"}, {"b", true}, {"c"}, {"d"}, {"e"}}, "HEAD"};
    CHECK(given_in_words(changes) ==
          "a, b (deleted), c and 2 more are not as the course has them; git restore a b c brings the first "
          "back");
}
