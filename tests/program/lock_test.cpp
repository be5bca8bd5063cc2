// Several programs at once: who waits, what each has to itself, and what outlives a build.
#include "common/terminal/lock.hpp"
#include "common/image/whole_file.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/results.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>

using namespace rt;
namespace fs = std::filesystem;

namespace {

/// Whether another open file of the same name could be locked, as another process would.
bool is_free(const fs::path& file) {
    const int descriptor = open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    const bool free = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    close(descriptor);
    return free;
}

std::vector<fs::path> entries(const fs::path& directory) {
    std::vector<fs::path> all;
    for (const auto& entry : fs::directory_iterator(directory)) all.push_back(entry.path());
    return all;
}

}  // namespace

TEST_CASE("a lock keeps others out as long as it lives, and says who has it") {
    const Project project = test::sandbox("lock");
    {
        const Lock lock(build_lock(project), "Building chapter 02");
        CHECK_FALSE(is_free(build_lock(project)));
        CHECK(read_file(build_lock(project)) == std::to_string(getpid()) + ": Building chapter 02\n");
        CHECK(is_free(memory_lock(project)));
    }
    CHECK(is_free(build_lock(project)));
}

TEST_CASE("who was killed has no lock") {
    const Project project = test::sandbox("lock_killed");
    fs::create_directories(build_lock(project).parent_path());
    run_process({"sh", "-c", "exec 9>>'" + build_lock(project).string() + "'; kill -KILL $$"});
    CHECK(is_free(build_lock(project)));
}

TEST_CASE("a directory of one's own is empty, nobody else's, and those of the dead are removed") {
    const Project project = test::sandbox("own_directory");
    test::write(project.build / "runs/killed/alive", "");
    test::write(project.build / "runs/killed/check_02", "");
    test::write(project.build / "runs/living/alive", "");
    const int living = open((project.build / "runs/living/alive").c_str(), O_RDWR | O_CLOEXEC);
    REQUIRE(flock(living, LOCK_EX) == 0);

    const fs::path own = own_directory(project);
    CHECK(own == own_directory(project));
    CHECK_FALSE(fs::exists(project.build / "runs/killed"));
    CHECK(fs::exists(project.build / "runs/living"));
    CHECK(entries(project.build / "runs").size() == 2);
    CHECK_FALSE(is_free(own / "alive"));
    close(living);
}

TEST_CASE("a program that was kept stays as it was while the build makes it anew") {
    const Project project = test::sandbox("keep_program");
    const fs::path built = project.build / "bin/check_02";
    CHECK(program(project, "check_02") == built);
    test::write(built, "old");
    keep_program(project, "check_02");
    keep_program(project, "figures");  // no program: nothing to keep
    const fs::path kept = program(project, "check_02");
    CHECK(kept != built);
    // As a linker does.
    fs::remove(built);
    test::write(built, "new");
    CHECK(read_file(kept) == "old");
    keep_program(project, "check_02");
    CHECK(read_file(program(project, "check_02")) == "new");
    CHECK(program(project, "check_03") == project.build / "bin/check_03");
}

TEST_CASE("what is remembered outlives the build, also what an earlier version left there") {
    const Project project = test::sandbox("memory");
    test::write(project.build / "hints.json", "{\"02.1\":2}");
    CHECK(read_file(memory(project, "hints.json")) == "{\"02.1\":2}");
    fs::remove_all(project.build);
    CHECK(read_file(memory(project, "hints.json")) == "{\"02.1\":2}");
    // What is there already is newer than what is found in a build.
    test::write(project.build / "hints.json", "{}");
    CHECK(read_file(memory(project, "hints.json")) == "{\"02.1\":2}");
    CHECK(memory(project, "state.json") == project.root / ".course/state.json");
}

TEST_CASE("a file that was deleted is missing, and the message says how it comes back") {
    const Project project = test::sandbox("missing");
    test::add_chapter(project, "02_spheres", test::good_chapter);
    const std::vector<Chapter> chapters = read_catalogue(project);
    CHECK(missing_files(project, chapters[0]).empty());
    CHECK(missing_message(project, chapters[0]).empty());
    CHECK(is_untouched(project, chapters[0]));

    const fs::path exercise = project.root / "chapters/02_spheres/x.cpp";
    const std::string text = read_file(exercise);
    fs::remove(exercise);
    CHECK(missing_files(project, chapters[0]) == std::vector<std::string>{"x.cpp"});
    CHECK(missing_message(project, chapters[0])
              .find("chapters/02_spheres/x.cpp is missing; ./course reset 02") == 0);
    CHECK_FALSE(is_untouched(project, chapters[0]));
    CHECK_FALSE(known_result(project, chapters[0]).current);

    // In a handout the original is elsewhere; there, too, the catalogue can be read all the same.
    fs::remove_all(project.root / "solutions");
    test::write(project.root / ".course/pristine/02_spheres/x.cpp", text);
    CHECK(read_catalogue(project).size() == 1);
    CHECK(missing_files(project, chapters[0]) == std::vector<std::string>{"x.cpp"});
}
