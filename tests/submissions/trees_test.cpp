// Submissions whose directories are the attack: only the exercises' regular files are taken, whatever else
// lies there, and nobody waits for what has no end.
#include "common/image/whole_file.hpp"
#include "tests/catch.hpp"
#include "tests/submissions/submissions.hpp"
#include "tests/support.hpp"

#include <fmt/format.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <functional>

namespace fs = std::filesystem;
using namespace rt;

namespace {

const char* const plane = "chapters/01_ray_casting/plane.cpp";

/// The directory of a submission that is perfect, but for what is done to it.
fs::path tree(const Submission& perfect, const std::string& name) {
    const fs::path root = fs::path(test::scratch_directory()) / "hostile trees" / name;
    fs::remove_all(root);
    for (const auto& [file, text] : perfect.files) {
        fs::create_directories((root / file).parent_path());
        write_file(root / file, text);
    }
    return root;
}

bool make_socket(const fs::path& path) {
    const fs::path was = fs::current_path();
    fs::current_path(path.parent_path());  // a socket's name may have 107 bytes
    const int end = ::socket(AF_UNIX, SOCK_STREAM, 0);
    sockaddr_un name{};
    name.sun_family = AF_UNIX;
    std::strncpy(name.sun_path, path.filename().c_str(), sizeof name.sun_path - 1);
    const bool made = ::bind(end, reinterpret_cast<sockaddr*>(&name), sizeof name) == 0;
    ::close(end);
    fs::current_path(was);
    return made;
}

/// What stands where plane.cpp should, and what is said of it.
struct Instead {
    std::string name, said;
    std::function<bool(const fs::path& file)> put;  ///< false where this machine or user cannot
};

Instead link_to(const std::string& name, const fs::path& target) {
    return {name, "is a symbolic link, or in one", [target](const fs::path& file) {
                fs::create_symlink(target, file);
                return true;
            }};
}

std::vector<Instead> all_instead() {
    const fs::path solution = fs::path(test::repository()) / "solutions/01_ray_casting/plane.cpp";
    return {
        link_to("link to passwords", "/etc/shadow"),
        link_to("link to the solution", solution),
        link_to("link up and down again", "../../../../../../../../../../etc/passwd"),
        link_to("link to itself", "plane.cpp"),
        link_to("link to the grader's memory", "/proc/self/mem"),
        link_to("link to a descriptor", "/proc/self/fd/0"),
        link_to("link to a neighbour", "camera.cpp"),
        {"pipe", "is no regular file",
         [](const fs::path& file) { return ::mkfifo(file.c_str(), 0666) == 0; }},
        {"device", "is no regular file",
         [](const fs::path& file) { return ::mknod(file.c_str(), S_IFCHR | 0666, makedev(1, 5)) == 0; }},
        {"directory", "is no regular file", [](const fs::path& file) { return fs::create_directory(file); }},
        {"socket", "No such device or address", make_socket},
        {"file of a terabyte", "is larger than 1 MiB", [](const fs::path& file) {
             write_file(file, "");
             return ::truncate(file.c_str(), off_t{1} << 40) == 0;
         }}};
}

}  // namespace

TEST_CASE("of a submission only regular files are taken, and no link is followed", "[trees]") {
    const Project project = this_project();
    const std::vector<Chapter> chapters = read_catalogue(project);
    const std::vector<const Chapter*> first{&chapters.front()};
    const Submission perfect = test::perfect(first);
    int tried = 0;
    for (const Instead& instead : all_instead()) {
        const fs::path root = tree(perfect, instead.name);
        fs::remove(root / plane);
        if (!instead.put(root / plane)) continue;
        const Submission taken = read_submission(root, first);
        INFO(instead.name);
        CHECK(taken.files.size() == perfect.files.size() - 1);
        CHECK_FALSE(taken.files.contains(plane));
        CHECK(taken.remarks == std::vector<std::string>{fmt::format("{} {}", plane, instead.said)});
        ++tried;
    }
    CHECK(tried >= 10);
}

TEST_CASE("directories of a submission that are links are not entered", "[trees]") {
    const std::vector<Chapter> chapters = read_catalogue(this_project());
    const std::vector<const Chapter*> first{&chapters.front()};
    const Submission perfect = test::perfect(first);
    for (const char* directory : {"chapters", "chapters/01_ray_casting"}) {
        const fs::path root = tree(perfect, "linked directory"), elsewhere = tree(perfect, "elsewhere");
        fs::remove_all(root / directory);
        fs::create_directory_symlink(elsewhere / directory, root / directory);
        const Submission taken = read_submission(root, first);
        CHECK(taken.files.empty());
        CHECK(taken.remarks.size() == perfect.files.size());
    }
}

TEST_CASE("what else lies in a submission changes nothing", "[trees]") {
    const std::vector<Chapter> chapters = read_catalogue(this_project());
    const std::vector<const Chapter*> first{&chapters.front()};
    const Submission perfect = test::perfect(first);
    const fs::path root = tree(perfect, "more than was asked for");
    const fs::path chapter = root / "chapters/01_ray_casting";
    write_file(root / "CMakeLists.txt", "execute_process(COMMAND touch /tmp/course_attack)\n");
    write_file(root / "Makefile", "all:\n\ttouch /tmp/course_attack\n");
    write_file(root / "common.hpp", "#error this is mine\n");
    write_file(chapter / "plane.hpp", "#error this is mine\n");
    write_file(chapter / "grading.json", "{\"points\": 1000}\n");
    write_file(chapter / "zz.cpp", "#error this is mine\n");
    for (const char* name :
         {"a\nb.cpp", "-o", "$(touch course_attack)", "caf\xe9.cpp", "\x1b[2J", "\"};<b>.cpp"})
        write_file(chapter / name, "#error this is mine\n");
    fs::create_directories(root / "tests/01_ray_casting");
    write_file(root / "tests/01_ray_casting/plane_test.cpp", "int main() {}\n");
    fs::create_symlink("/", root / "everything");
    fs::create_symlink(".", chapter / "again");
    // Deeper than a path may be long.
    const fs::path was = fs::current_path();
    fs::current_path(root);
    for (int i = 0; i < 100; ++i) {
        const std::string name(200, 'd');
        REQUIRE(::mkdir(name.c_str(), 0777) == 0);
        REQUIRE(::chdir(name.c_str()) == 0);
    }
    fs::current_path(was);

    const Submission taken = read_submission(root, first);
    CHECK(taken.files == perfect.files);
    CHECK(taken.remarks.empty());
    CHECK(digest_of(taken) == digest_of(perfect));
    fs::remove_all(root);
}
