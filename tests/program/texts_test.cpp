// What the texts say can be done: every command that they show is run, and does what they promise.
#include "common/image/whole_file.hpp"
#include "common/terminal/process.hpp"
#include "common/terminal/project.hpp"
#include "common/workbook/catalogue.hpp"
#include "common/workbook/lesson.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

using namespace rt;
using nlohmann::json;
namespace fs = std::filesystem;

namespace {

/// A command as a text shows it: `./course render x.scene -o x.png`, without its comment.
struct Command {
    std::string place;  ///< "README.md:33"
    std::vector<std::string> words;

    bool has(const std::string& word) const { return std::ranges::find(words, word) != words.end(); }
    /// The word after an option; empty if it is not there.
    std::string after(const std::string& option) const {
        const auto at = std::ranges::find(words, option);
        return at == words.end() || at + 1 == words.end() ? "" : at[1];
    }
    std::string name() const { return words.size() < 2 ? "" : words[1]; }
    std::string text() const { return fmt::format("{}: {}", place, fmt::join(words, " ")); }
};

std::vector<std::string> words_of(const std::string& line) {
    std::istringstream in(line.substr(0, line.find(" #")));
    std::vector<std::string> words;
    for (std::string word; in >> word;) words.push_back(word);
    return words;
}

bool is_command(const std::string& text) {
    return text.starts_with("./course") || text.starts_with("course ") || text.starts_with("build/bin/");
}

/// The texts that users read.
std::vector<fs::path> texts() {
    const fs::path root = test::repository();
    std::vector<fs::path> files{root / "README.md", root / "CONTRIBUTING.md",
                                root / "common/grading/README.md", root / "common/grading/REFERENCE.md",
                                root / "common/scene/README.md"};
    for (const auto& entry : fs::directory_iterator(root / "chapters"))
        for (const fs::path& page : pages_of(entry.path())) files.push_back(page);
    std::ranges::sort(files);
    return files;
}

/// The commands in blocks, a line each, and those within sentences.
std::vector<Command> commands_in(const fs::path& file) {
    std::vector<Command> commands;
    std::istringstream in(read_file(file));
    const std::regex code("`([^`]+)`");
    bool in_block = false;
    int number = 0;
    for (std::string line; std::getline(in, line);) {
        const std::string place = fmt::format("{}:{}", relative(this_project(), file), ++number);
        if (line.starts_with("```")) {
            in_block = !in_block;
        } else if (in_block) {
            if (is_command(line)) commands.push_back({place, words_of(line)});
        } else {
            for (std::sregex_iterator i(line.begin(), line.end(), code), end; i != end; ++i)
                if (is_command((*i)[1])) commands.push_back({place, words_of((*i)[1])});
        }
    }
    return commands;
}

/// Where the commands run: a directory that looks like the repository's root, and where pictures may lie
/// about.
fs::path place_to_run() {
    const fs::path directory = fs::path(test::scratch_directory()) / "texts";
    fs::remove_all(directory);
    fs::create_directories(directory);
    for (const char* name : {"chapters", "references", "tests", "common"})
        fs::create_directory_symlink(fs::path(test::repository()) / name, directory / name);
    return directory;
}

/// What a student has written passes as the solutions do, so they take its place.
Command with_solutions(Command command) {
    if (command.name() != "render") return command;
    std::erase(command.words, "--mine");
    if (!command.has("--solutions")) command.words.emplace_back("--solutions");
    return command;
}

/// What takes long for a person is made short for a test, where the promise stays the same.
Command quick(Command command, const std::set<std::string>& compared) {
    if (command.name() != "render" || compared.contains(command.after("-o"))) return command;
    for (std::size_t i = 0; i + 1 < command.words.size(); ++i)
        if (command.words[i] == "--seconds") command.words[i + 1] = "0.1";
    if (!command.has("--size")) command.words.insert(command.words.end(), {"--size", "80x60"});
    return command;
}

ProcessResult run(const Command& command, const fs::path& directory) {
    std::string line = "cd '" + directory.string() + "' && '" +
                       (this_project().build / "bin" / fs::path(command.words.front()).filename()).string() +
                       "'";
    for (std::size_t i = 1; i < command.words.size(); ++i) line += " '" + command.words[i] + "'";
    ProcessOptions options;
    options.time_limit = 120;
    return run_process({"sh", "-c", line}, options);
}

/// Commands of the program that other parts of the project run whole, by the file that runs them.
struct Elsewhere {
    const char* name;
    const char* file;
    const char* line;
};
constexpr Elsewhere elsewhere[] = {
    {"tour", ".ci/run", "./course --yes tour"},
    {"book", "tests/program/browser/book.py", "\"book\", \"-o\""},
    {"test", ".ci/run", "./course --yes test"},
    {"report", ".ci/run", "./course --yes report --quick"},
    {"references", ".ci/run", "./course --yes references"},
    {"figures", ".ci/run", "./course --yes figures"},
    {"exercises", "tests/program/scratch_course.sh", "./course exercises --make"},
    {"check", "tests/program/scratch_course.sh", "./course check 99"},
    {"hint", "tests/program/scratch_course.sh", "./course hint 99.1"},
    {"reset", "tests/program/scratch_course.sh", "./course reset 99.1"},
    {"solution", "tests/program/scratch_course.sh", "./course solution 99.1"},
    {"new", "tests/program/scratch_course.sh", "./course new 97_fresh"},
    {"mutate", "tests/program/scratch_course.sh", "./course mutate 97.1"},
    {"grade", "tests/program/guide.sh", "follow README.md"},
    {"similarity", "tests/program/guide.sh", "follow README.md"},
    {"autograder", "tests/program/guide.sh", "follow REFERENCE.md"},
    {"handout", "tests/program/guide.sh", "follow README.md"},
};

/// Of these only what they name is looked at here: that there is such a chapter, step or option.
void check_elsewhere(const Command& command, const Elsewhere& where, const fs::path& directory) {
    const std::string text = read_file(fs::path(test::repository()) / where.file);
    CHECK(text.find(where.line) != std::string::npos);
    const ProcessResult help = run({command.place, {"./course", command.name(), "--help"}}, directory);
    CHECK(help.exit_code == 0);
    const std::vector<Chapter> chapters = read_catalogue(this_project());
    for (std::size_t i = 2; i < command.words.size(); ++i) {
        const std::string& word = command.words[i];
        if (word == "-o" || (command.words[i - 1].starts_with("-") && !word.starts_with("-")))
            continue;  // values
        if (word.find('/') != std::string::npos || word.ends_with(".json") || word.ends_with(".zip"))
            continue;  // a file
        if (word.starts_with("--"))
            CHECK(help.output.find(word) != std::string::npos);
        else if (word.find('.') != std::string::npos)
            CHECK_NOTHROW(find_step(chapters, word));
        else if (!word.starts_with("NN"))
            CHECK_NOTHROW(find_chapter(chapters, word));
    }
}

void check_promise(const Command& command, const ProcessResult& result, const fs::path& directory) {
    const std::string output = command.after("-o");
    if (!output.empty()) CHECK(fs::exists(directory / output));
    if (command.name() == "compare")
        CHECK_THAT(result.output, Catch::StartsWith("the same") || Catch::StartsWith("equal"));
}

/// All commands of a text, in their order: some need what those before them have made.
void run_all(const fs::path& file, const fs::path& directory) {
    const std::vector<Command> commands = commands_in(file);
    std::set<std::string> compared;
    for (const Command& command : commands)
        if (command.name() == "compare" && command.words.size() > 3)
            compared.insert({command.words[2], command.words[3]});
    for (const Command& shown : commands) {
        INFO(shown.text());
        const auto where = std::ranges::find(elsewhere, shown.name(), &Elsewhere::name);
        if (shown.words.front().ends_with("course") && where != std::end(elsewhere)) {
            check_elsewhere(shown, *where, directory);
            continue;
        }
        Command command = quick(with_solutions(shown), compared);
        // Only named, as in "`./course explain` says so": then there must be such a command.
        if (shown.words.size() == 2) command.words = {shown.words[0], shown.words[1], "--help"};
        // What would write into the repository writes beside it.
        if (command.words.front() == "build/bin/make_teapot") command.words.back() = "teapot.obj";
        const ProcessResult result = run(command, directory);
        INFO(result.output);
        CHECK(result.exit_code == 0);
        check_promise(command, result, directory);
    }
}

/// What a regular expression finds between its parentheses, without the commas that group digits.
std::string found(const std::string& text, const std::string& pattern) {
    std::smatch match;
    INFO(pattern);
    REQUIRE(std::regex_search(text, match, std::regex(pattern)));
    std::string number = match[1];
    std::erase(number, ',');
    return number;
}

json told(const std::string& arguments) {
    const fs::path directory = fs::path(test::scratch_directory()) / "texts";
    const std::string program = (this_project().build / "bin" / "course").string();
    ProcessOptions options;
    options.merge_errors = false;
    const ProcessResult result = run_process(
        {"sh", "-c", "cd '" + directory.string() + "' && '" + program + "' " + arguments + " --json"},
        options);
    REQUIRE(result.exit_code == 0);
    return json::parse(result.output);
}

}  // namespace

TEST_CASE("every command that a text shows is there and does what it promises", "[texts]") {
    const fs::path directory = place_to_run();
    std::size_t count = 0;
    for (const fs::path& file : texts()) {
        count += commands_in(file).size();
        run_all(file, directory);
    }
    CHECK(count > 50);
}

TEST_CASE("numbers in the lessons are what the commands beside them print", "[texts]") {
    place_to_run();
    SECTION("4: the memory of a forest") {
        const std::string numbers =
            read_file(fs::path(test::repository()) / "references/04_transforms/figures/numbers.csv");
        const long long bytes = told("explain references/04_transforms/forest.scene")["bytes"];
        CHECK(bytes == std::stoll(found(numbers, "by course explain\",([0-9]+)")));
    }
    SECTION("7: the rays of Whitted's picture") {
        const json rays =
            told("render references/07_recursion/whitted.scene --solutions -o whitted.pfm")["rays"];
        long long sum = 0;
        for (const auto& [kind, number] : rays.items()) sum += number.get<long long>();
        const std::string measured =
            read_file(fs::path(test::repository()) / "references/07_recursion/figures/measured_whitted.csv");
        CHECK(sum == std::stoll(found(measured, "\n1,[0-9]+,[0-9]+,([0-9]+),")));
    }
    SECTION("8: what half the error costs") {
        const std::string text =
            std::regex_replace(read_file(fs::path(test::repository()) /
                                         "chapters/08_antialiasing/part_3_errors_and_adaptivity.md"),
                               std::regex("<!--.*?-->"), "");
        const std::string render =
            "render references/08_antialiasing/aliased.scene --solutions -o aliased.pfm --size 80x60 "
            "--error ";
        for (const auto& [error, pattern] : {std::pair{"0.01", "need ([0-9]+) and\\s+[0-9]+ samples"},
                                             {"0.005", "need [0-9]+ and\\s+([0-9]+) samples"}}) {
            const json result = told(render + error);
            CHECK(result["rms_error"].get<double>() <= std::stod(error));
            CHECK(result["samples_per_pixel"].get<double>() ==
                  Approx(std::stod(found(text, pattern))).margin(0.5));
        }
    }
    SECTION("9: the triangles of a finer teapot") {
        const fs::path teapot = fs::path(test::scratch_directory()) / "texts" / "finer.obj";
        const ProcessResult made =
            run({"", {"build/bin/make_teapot", "120", teapot.string()}}, test::scratch_directory());
        REQUIRE(made.exit_code == 0);
        std::istringstream in(read_file(teapot));
        fs::remove(teapot);
        long long triangles = 0;
        for (std::string line; std::getline(in, line);)
            if (line.starts_with("f ")) triangles += std::ranges::count(line, ' ') - 2;
        const std::string text =
            read_file(fs::path(test::repository()) / "chapters/09_grids/part_4_crowds.md");
        CHECK(triangles == std::stoll(found(text, "makes\\s+one\\s+of ([0-9,]+)\\s")));
    }
}

TEST_CASE("hints ask the world as its header declares it, or as the solution does", "[texts]") {
    const fs::path root = test::repository();
    const auto without_blanks = [](std::string text) {
        std::erase_if(text, [](char c) { return c == ' ' || c == '\n'; });
        return text;
    };
    // "const Ray& local" becomes "local".
    const std::string declared = without_blanks(
        std::regex_replace(read_file(root / "common/world/query.hpp"),
                           std::regex("(const )?[A-Za-z_:]+(<[^>]*>)?&? ([a-z_]+)(?=[,)])"), "$3"));
    const std::regex query("\\b(closest_hit|occluded|any_hit|surface_at|material_at)\\([a-z][^()]*\\)");
    int count = 0;
    for (const Chapter& chapter : read_catalogue(this_project())) {
        std::string known = declared;
        for (const auto& entry : fs::directory_iterator(root / "solutions" / chapter.name))
            known += without_blanks(read_file(entry.path()));
        for (const Step& step : chapter.steps)
            for (const std::string& hint : step.hints)
                for (std::sregex_iterator i(hint.begin(), hint.end(), query), end; i != end; ++i, ++count) {
                    INFO(step.id << ": " << hint);
                    const bool is_known = known.find(without_blanks(i->str())) != std::string::npos;
                    CHECK(is_known);
                }
    }
    CHECK(count > 2);
}
