// course-tool: what the build itself needs, small so that nothing waits for the whole program.
//   course-tool exercise IN OUT            the exercise of a solution
//   course-tool change FILE... DIR OUT     the solution in DIR with known mistakes or right variants of one
//   file
//   course-tool quotes FILE ROOT STAMP     whether all that a lesson quotes exists; STAMP depends on that
#include "common/image/whole_file.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/lesson.hpp"
#include "common/workbook/mistake.hpp"

#include <cstdio>
#include <filesystem>

namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
    if (path.has_parent_path()) rt::make_directories(path.parent_path());
    rt::write_file(path, text);
}

int run(const std::vector<std::string>& arguments) {
    if (arguments.size() == 3 && arguments[0] == "exercise") {
        write(arguments[2], rt::exercise_text(rt::read_file(arguments[1]), arguments[1]));
        return 0;
    }
    if (arguments.size() >= 4 && arguments[0] == "change") {
        const fs::path directory = arguments[arguments.size() - 2];
        std::string text;
        for (std::size_t i = 1; i + 2 < arguments.size(); ++i) {
            const rt::Mistake change = rt::parse_mistake(rt::read_file(arguments[i]), arguments[i]);
            if (i == 1) text = rt::read_file(directory / change.file);
            text = rt::apply_mistake(change, text, arguments[i]);
        }
        write(arguments.back(), text);
        return 0;
    }
    if (arguments.size() == 4 && arguments[0] == "quotes") {
        const fs::path stamp = arguments[3];
        const std::string text = rt::read_file(arguments[1]);
        std::string rule = stamp.string() + ":";
        for (const fs::path& file : rt::woven_lesson(text, arguments[1], arguments[2]).sources)
            rule += " " + file.string();
        write(stamp.string() + ".d", rule + "\n");
        write(stamp, "");
        return 0;
    }
    std::fprintf(stderr,
                 "usage: course-tool exercise IN OUT | course-tool change FILE... DIR OUT | course-tool "
                 "quotes FILE ROOT STAMP\n");
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
