// course-tool: what the build itself needs, small so that nothing waits for the whole program.
//   course-tool exercise IN OUT            the exercise of a solution
//   course-tool mistake FILE DIR OUT       the solution in DIR with a known mistake
#include "common/app/exercise.hpp"
#include "common/app/mistake.hpp"
#include "common/math/input_error.hpp"

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
    if (arguments.size() == 4 && arguments[0] == "mistake") {
        const rt::Mistake mistake = rt::parse_mistake(read(arguments[1]), arguments[1]);
        const std::string solution = read(fs::path(arguments[2]) / mistake.file);
        write(arguments[3], rt::apply_mistake(mistake, solution, arguments[1]));
        return 0;
    }
    std::fprintf(stderr, "usage: course-tool exercise IN OUT | course-tool mistake FILE DIR OUT\n");
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
