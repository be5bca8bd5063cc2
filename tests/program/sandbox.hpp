// A repository of one small chapter, made for a test.
#pragma once

#include "common/terminal/project.hpp"
#include "tests/support.hpp"

#include <filesystem>
#include <fstream>
#include <string>

namespace rt::test {

inline constexpr auto good_chapter = R"({
  "title": "Spheres",
  "summary": "Round things.",
  "hours": 3,
  "steps": [
    {"id": "02.1", "title": "First", "file": "x.cpp", "points": 10, "hints": ["a", "b", "c"]},
    {"id": "02.2", "title": "Second", "file": "x.cpp", "points": 5, "hints": ["a", "b", "c"]}
  ],
  "scenes": ["one.scene"]
})";

/// Writes a file and the directories above it.
inline void write(const std::filesystem::path& path, const std::string& text) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
}

/// An empty repository and build directory in the scratch directory.
inline Project sandbox(const std::string& name) {
    const std::filesystem::path directory = std::filesystem::path(scratch_directory()) / name;
    std::filesystem::remove_all(directory);
    std::filesystem::create_directories(directory / "chapters");
    std::filesystem::create_directories(directory / "build");
    return {directory, directory / "build"};
}

/// A chapter with this chapter.json, an exercise x.cpp with steps 02.1 and 02.2, its solution, and a scene.
inline void add_chapter(const Project& project, const std::string& name, const std::string& description) {
    const std::string head = "#include \"common/math/todo.hpp\"\n\n";
    write(project.root / "chapters" / name / "chapter.json", description);
    write(project.root / "chapters" / name / "x.cpp",
          head +
              "int f() {\n    // 02.1  One.\n    return todo(\"02.1\");\n}\n\n"
              "int g() {\n    // 02.2  Two.\n    return todo(\"02.2\");\n}\n");
    write(project.root / "solutions" / name / "x.cpp",
          head +
              "int f() {\n    // [exercise 02.1] One.\n    return 1;\n    // [/exercise]\n}\n\n"
              "int g() {\n    // [exercise 02.2] Two.\n    return 2;\n    // [/exercise]\n}\n");
    write(project.root / "references" / name / "one.scene", "");
}

}  // namespace rt::test
