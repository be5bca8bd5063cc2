// The random scenes that POV-Ray is asked about: that they are scenes, and of everything that the language
// says.
#include "common/evidence/random_scenes.hpp"

#include "common/render/compile.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

#include <filesystem>
#include <set>
#include <sstream>
#include <string>

using namespace rt;

TEST_CASE("random scenes can be rendered, and together they say every command", "[random_scenes]") {
    const std::filesystem::path directory =
        std::filesystem::path(test::scratch_directory()) / "random_scenes";
    std::filesystem::create_directories(directory);
    write_random_files(directory);
    std::set<std::string> said;
    for (std::uint64_t number = 0; number < 200; ++number) {
        const std::string text = random_scene(number);
        INFO(text);
        REQUIRE_NOTHROW(compile(parse_scene_text(text, "random", directory)));
        std::istringstream in(text);
        for (std::string line; std::getline(in, line);) said.insert(line.substr(0, line.find(' ')));
    }
    for (const SceneCommand& command : scene_commands()) {
        INFO(command.name);
        CHECK(said.contains(std::string(command.name)));
    }
    CHECK(random_scene(7) == random_scene(7));
    CHECK(random_scene(7) != random_scene(8));
}
