// course-tool: what the build itself needs, small so that nothing waits for the whole program.
//   course-tool exercise IN OUT            the exercise of a solution
//   course-tool change FILE... DIR OUT     the solution in DIR with known mistakes or right variants of one
//   file
#include "common/math/input_error.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/mistake.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    if (!in || !text) throw rt::InputError(path.string() + ": cannot be read");
    return text.str();
}

void write(const fs::path& path, const std::string& text) {
    if (path.has_parent_path()) fs::create_directories(path.parent_path());
    const fs::path temporary = path.string() + ".part";
    std::ofstream out(temporary, std::ios::binary);
    out << text;
    out.close();
    if (!out) throw rt::InputError(path.string() + ": cannot be written");
    fs::rename(temporary, path);
}

int run(const std::vector<std::string>& arguments) {
    if (arguments.size() == 3 && arguments[0] == "exercise") {
        write(arguments[2], rt::exercise_text(read(arguments[1]), arguments[1]));
        return 0;
    }
    if (arguments.size() >= 4 && arguments[0] == "change") {
        const fs::path directory = arguments[arguments.size() - 2];
        std::string text;
        for (std::size_t i = 1; i + 2 < arguments.size(); ++i) {
            const rt::Mistake change = rt::parse_mistake(read(arguments[i]), arguments[i]);
            if (i == 1) text = read(directory / change.file);
            text = rt::apply_mistake(change, text, arguments[i]);
        }
        write(arguments.back(), text);
        return 0;
    }
    std::fprintf(stderr, "usage: course-tool exercise IN OUT | course-tool change FILE... DIR OUT\n");
    return 2;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
