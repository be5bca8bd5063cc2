// g++ in a box: it compiles what is right, and what would take the machine down is stopped.
#include "common/image/whole_file.hpp"
#include "common/sandbox/system_files.hpp"
#include "tests/catch.hpp"
#include "tests/grading/sandbox/boxes.hpp"

#include <filesystem>

using namespace rt;
using namespace rt::test;
namespace fs = std::filesystem;

namespace {

struct Compilation {
    Ending verdict;
    std::string program;  ///< its path, if there is one
};

Sandbox compiler_box(const Way& way, const std::string& source, const std::string& out) {
    Sandbox box;
    box.isolation = way.isolation;
    box.may_mount = way.may_mount;
    box.limits = compiler_limits();
    // Less than a submission gets: a bomb reaches it sooner.
    box.limits.process_memory = std::uint64_t{256} << 20;
    box.limits.cpu_seconds = 1;
    box.limits.file_size = std::uint64_t{8} << 20;
    box.mounts = compiler_mounts();
    box.mounts.push_back({source, "/src"});
    box.products = {{"program", out}};
    return box;
}

Compilation compiled(const Way& way, const std::string& text) {
    const std::string source = fresh_directory("src"), out = fresh_directory("out");
    fs::permissions(out, fs::perms(0777));
    write_file(source + "/main.cpp", text);
    const Sandbox box = compiler_box(way, source, out + "/program");
    std::vector<std::string> command{"/usr/bin/g++", "-std=c++20"};
    for (const std::string& option : short_diagnostics()) command.push_back(option);
    for (const std::string& word :
         {seen_from(box, source + "/main.cpp"), std::string("-o"), std::string("program")})
        command.push_back(word);
    Compilation compilation{run(way, box, command), out + "/program"};
    if (!fs::exists(compilation.program)) compilation.program.clear();
    return compilation;
}

/// A compiler takes long: without mounts it is as with them.
template <class Check>
void in_most_ways(Check check) {
    for (const Way& way : ways()) {
        if (!way.may_mount) continue;
        INFO("level := " << way.name);
        check(way);
    }
}

/// Neither a program nor more than the limit of diagnostics.
bool stopped(const Compilation& compilation) {
    return compilation.program.empty() && compilation.verdict.errors.size() <= compiler_limits().output &&
           !(compilation.verdict.end == End::Exited && compilation.verdict.number == 0);
}

}  // namespace

TEST_CASE("g++ compiles and links in a box, and the program runs in another", "[box][compile]") {
    in_most_ways([](const Way& way) {
        const Compilation compilation = compiled(way,
                                                 "#include <cmath>\n#include <cstdio>\nint main(int n, "
                                                 "char**) { std::printf(\"%.3f\", std::sqrt(n)); }");
        INFO(compilation.verdict.errors);
        REQUIRE(compilation.verdict.end == End::Exited);
        REQUIRE(compilation.verdict.number == 0);
        REQUIRE_FALSE(compilation.program.empty());
        Sandbox box = attack_box(way);
        box.mounts = library_mounts();
        box.mounts.push_back({compilation.program, "/program"});
        CHECK(run(way, box, {seen_from(box, compilation.program), "2"}).output == "1.414");
    });
}

TEST_CASE("a compiler that is attacked is stopped", "[box][compile]") {
    in_most_ways([](const Way& way) {
        if (!way.apart()) return;
        const Compilation templates = compiled(way,
                                               "template <int n, int m> struct C { enum { v = C<n - 1, 2 * "
                                               "m>::v + C<n - 1, 2 * m + 1>::v }; };\n"
                                               "template <int m> struct C<0, m> { enum { v = 1 }; };\n"
                                               "int main() { return C<24, 0>::v; }");
        CHECK(stopped(templates));
        CHECK(templates.verdict.end != End::Exited);
        CHECK(stopped(compiled(way, "#include \"/dev/zero\"\nint main() {}")));
        CHECK(stopped(compiled(way, "int a[1 << 28] = {1};\nint main() { return a[0]; }")));
        CHECK(stopped(compiled(way, "#include __FILE__\n#include __FILE__\n")));
    });
}

TEST_CASE("a compiler in a box reads nothing that it was not given", "[box][compile]") {
    in_most_ways([](const Way& way) {
        const std::string secret = fresh_directory("secret") + "/answers";
        write_file(secret, "42");
        const Compilation included = compiled(way, "int main() { return\n#include \"" + secret + "\"\n; }");
        const Compilation assembled =
            compiled(way, "asm(\".incbin \\\"" + secret + "\\\"\");\nint main() {}");
        CHECK(stopped(included) == way.apart());
        CHECK(stopped(assembled) == way.apart());
    });
}
