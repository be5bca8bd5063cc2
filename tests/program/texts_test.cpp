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
        if (fs::exists(entry.path() / "README.md"))
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
    if (command.name() == "compare") CHECK_THAT(result.output, Catch::StartsWith("the same"));
}

/// All commands of a text, in their order: some need what those before them have made.
void run_all(const fs::path& file, const fs::path& directory) {
    const std::vector<Command> commands = commands_in(file);
    std::set<std::string> compared;
    for (const Command& command : commands)
        if (command.name() == "compare" && command.words.size() > 2) compared.insert(command.words[2]);
    for (const Command& shown : commands) {
        INFO(shown.text());
        const auto where = std::ranges::find(elsewhere, shown.name(), &Elsewhere::name);
        if (shown.words.front().ends_with("course") && where != std::end(elsewhere)) {
            check_elsewhere(shown, *where, directory);
            continue;
        }
        Command command = quick(with_solutions(shown), compared);
        // Only named, as in "`./course explain` says so": then there must be such a command.
        if (command.words.size() == 2) command.words.emplace_back("--help");
        // What would write into the repository writes beside it.
        if (command.words.front() == "build/bin/make_teapot") command.words.back() = "teapot.obj";
        const ProcessResult result = run(command, directory);
        INFO(result.output);
        CHECK(result.exit_code == 0);
        check_promise(command, result, directory);
    }
}

std::string lesson(const std::string& chapter) {
    return read_file(fs::path(test::repository()) / "chapters" / chapter / "README.md");
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

/// Powers of ten as a file has them: 3e-6 for 3·10⁻⁶, and 1e5 for 10⁵.
std::string with_exponents(std::string text) {
    const std::pair<const char*, const char*> signs[] = {{"·10", "e"}, {"⁰", "0"}, {"¹", "1"}, {"²", "2"},
                                                         {"³", "3"},   {"⁴", "4"}, {"⁵", "5"}, {"⁶", "6"},
                                                         {"⁷", "7"},   {"⁸", "8"}, {"⁹", "9"}, {"⁻", "-"}};
    text = std::regex_replace(text, std::regex("(^|[^·0-9])10(?=⁻|⁰|¹|²|³|⁴|⁵|⁶|⁷|⁸|⁹)"), "$011·10");
    for (const auto& [sign, plain] : signs) text = std::regex_replace(text, std::regex(sign), plain);
    return text;
}

/// The numbers in a line of a table or file, in their order; digits may be grouped by commas in a table.
std::vector<double> numbers_in(std::string line) {
    if (line.starts_with("|")) std::erase(line, ',');
    line = with_exponents(line);
    std::vector<double> numbers;
    const std::regex number("[0-9]+(\\.[0-9]+)?(e[-+]?[0-9]+)?");
    for (std::sregex_iterator i(line.begin(), line.end(), number), end; i != end; ++i)
        numbers.push_back(std::stod(i->str()));
    return numbers;
}

/// The lines of a text from the one that begins with `head`, without it and the rule below, to an empty one.
std::vector<std::string> table_after(const std::string& text, const std::string& head) {
    std::istringstream in(text.substr(std::min(text.find("\n" + head), text.size() - 1) + 1));
    std::vector<std::string> rows;
    for (std::string line; std::getline(in, line) && line.starts_with("|");) rows.push_back(line);
    if (rows.size() > 2) rows.erase(rows.begin(), rows.begin() + 2);
    return rows;
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
        const double megabytes = std::stod(found(lesson("04_transforms"), "counts about (\\S+) MB"));
        const double bytes = told("explain references/04_transforms/forest.scene")["bytes"];
        CHECK(bytes / 1e6 == Approx(megabytes).epsilon(0.1));
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
        const std::string text = lesson("08_antialiasing");
        const std::string render =
            "render references/08_antialiasing/aliased.scene --solutions -o aliased.pfm --size 80x60 "
            "--error ";
        for (const auto& [error, pattern] : {std::pair{"0.01", "need ([0-9]+) and [0-9]+ samples"},
                                             {"0.005", "need [0-9]+ and ([0-9]+) samples"}}) {
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
        CHECK(triangles == std::stoll(found(text, "makes one\\s+of ([0-9,]+)\\s")));
    }
}

/// The lines of a file of a chapter's figures, without its head.
std::vector<std::string> lines_of(const std::string& chapter, const std::string& file) {
    std::istringstream in(
        read_file(fs::path(test::repository()) / "references" / chapter / "figures" / file));
    std::vector<std::string> lines;
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) lines.push_back(line);
    return lines;
}

TEST_CASE("lesson 3 says the times that its figures program has measured", "[texts]") {
    const auto compare = [&](const std::string& head, const std::string& file, auto same) {
        const std::vector<std::string> rows = table_after(lesson("03_triangles"), head);
        const std::vector<std::string> lines = lines_of("03_triangles", file);
        REQUIRE(rows.size() == lines.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            INFO(rows[i] << "\n" << file << ": " << lines[i]);
            same(rows[i], lines[i]);
        }
    };
    compare(
        "| triangles | pixels |", "measured_scan_conversion.csv",
        [](const std::string& row, const std::string& line) { CHECK(numbers_in(row) == numbers_in(line)); });
    compare("| scene | camera |", "measured_profile.csv",
            [](const std::string& row, const std::string& line) {
                // A knot's triangles, then three shares, rounded in the lesson, and the time.
                const std::vector<double> said = numbers_in(row), measured = numbers_in(line);
                REQUIRE(said.size() == 5);
                REQUIRE(measured.size() == 5);
                CHECK(said[0] == measured[0]);
                for (std::size_t i = 1; i < 4; ++i)
                    CHECK(said[i] == Approx(measured[i]).margin(0.5).epsilon(0));
                CHECK(said[4] == measured[4]);
            });
}

TEST_CASE("lesson 10 says what its figures program has counted", "[texts]") {
    const std::string chapter = "10_surfaces", text = lesson(chapter);
    // A row is one of the file's lines, those of nearer distances left out.
    const auto compare = [&](const std::string& head, const std::string& file,
                             const std::vector<std::size_t>& order) {
        const std::vector<std::string> rows = table_after(text, head), lines = lines_of(chapter, file);
        REQUIRE(rows.size() > 3);
        REQUIRE(rows.size() <= lines.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::string& line = lines[lines.size() - rows.size() + i];
            INFO(rows[i] << "\n" << file << ": " << line);
            const std::vector<double> said = numbers_in(rows[i]), counted = numbers_in(line);
            REQUIRE(said.size() == counted.size());
            // The row's last ones; what is before them says which row it is.
            const std::size_t first = said.size() - order.size();
            if (first > 0) CHECK(said[0] == counted[0]);
            for (std::size_t k = 0; k < order.size(); ++k)
                CHECK(said[first + k] == counted[first + order[k]]);
        }
    };
    compare("| distance in radii |", "far_pole.csv", {0, 1, 2, 3});
    compare("| length in radii |", "long_rod.csv", {0, 1, 2, 3});
    compare("| lines |", "closed_formulas.csv", {0, 2, 1, 3});
    // In prose: the last error from near, and where those from the eye are as large as the tube.
    const std::vector<std::string> far_ring = lines_of(chapter, "far_ring.csv");
    const std::vector<double> last = numbers_in(far_ring.back());
    const std::string prose = with_exponents(text);
    CHECK(std::stod(found(prose, "is (\\S+) radii where\\s+the\\s+torus\\s+is\\s+\\S+\\s+radii")) ==
          last.back());
    CHECK(std::stod(found(prose, "is \\S+ radii where\\s+the\\s+torus\\s+is\\s+(\\S+)\\s+radii")) ==
          last.front());
    const double noise = std::stod(found(prose, "all is noise at (\\S+)\\s+radii"));
    for (const std::string& line : far_ring) {
        const std::vector<double> numbers = numbers_in(line);
        INFO(line);
        REQUIRE(numbers.size() > 4);
        CHECK((numbers[2] > 0.1) == (numbers[0] >= noise));
    }
}

TEST_CASE("lesson 11 says what its figures program has counted", "[texts]") {
    const std::string chapter = "11_textures", text = lesson(chapter);
    const std::vector<std::string> rows = table_after(text, "| filter | samples a pixel |"),
                                   lines = lines_of(chapter, "filter_errors.csv");
    REQUIRE(rows.size() == lines.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        INFO(rows[i] << "\n" << lines[i]);
        CHECK(numbers_in(rows[i]) == numbers_in(lines[i]));
        CHECK_THAT(rows[i], Catch::Contains("`" + lines[i].substr(0, lines[i].find(',')) + "`"));
    }
    // A lobe's name and value, and what it returns at the three cosines of the head; rounded in the lesson.
    const std::vector<std::string> returned = table_after(text, "| lobe | of | cosine 1 | 0.5 | 0.1 |");
    CHECK(returned.size() > 8);
    for (const std::string& row : returned) {
        INFO(row);
        const std::string name = row.substr(2, row.find(' ', 2) - 2);
        const std::vector<double> said = numbers_in(row);
        REQUIRE(said.size() == 4);
        std::vector<double> counted;
        for (const double cosine : {1.0, 0.5, 0.1})
            for (const std::string& line : lines_of(chapter, "furnace.csv")) {
                const std::vector<double> numbers = numbers_in(line);
                const bool is_above = line.starts_with(name + ",") && line.find(",-") == std::string::npos;
                if (is_above && numbers[0] == said[0] && numbers[1] == cosine) counted.push_back(numbers[2]);
            }
        REQUIRE(counted.size() == 3);
        for (std::size_t i = 0; i < 3; ++i)
            CHECK(said[i + 1] == Approx(counted[i]).margin(0.00051).epsilon(0));
    }
    double worst = 0;
    for (const std::string& line : lines_of(chapter, "chi_square.csv")) {
        const std::vector<double> numbers = numbers_in(line);
        REQUIRE(numbers.size() == 6);
        worst = std::max(worst, numbers[4] / numbers[5]);
    }
    const double said = std::stod(found(text, "is at most (\\S+) of\\s+the\\s+limit\\s+that\\s+right"));
    CHECK(said == Approx(worst).margin(0.0051).epsilon(0));
    const std::vector<double> missed = numbers_in(lines_of(chapter, "cells_missed.csv").front());
    REQUIRE(missed.size() == 3);
    CHECK(missed[0] == 2e6);
    CHECK(std::stod(found(text, "F1 was wrong at (\\S+) and F2")) == missed[1]);
    CHECK(std::stod(found(text, "F1 was wrong at \\S+ and F2 at (\\d+)")) == missed[2]);
    const std::vector<double> led_back = numbers_in(lines_of(chapter, "led_back.csv").front());
    const std::regex prose(
        "viewer at (\\S+)° and a normal at −(\\S+)°, the mirrored ray goes down by (\\S+);"
        "\\s+at\\s+−(\\S+)° it rises by 1/(\\d+) of the viewer's height");
    std::smatch told;
    REQUIRE(std::regex_search(text, told, prose));
    REQUIRE(led_back.size() + 1 == told.size());
    for (std::size_t i = 0; i < led_back.size(); ++i) CHECK(std::stod(told[i + 1]) == led_back[i]);
}

TEST_CASE("lesson 12 says what its figures program has counted", "[texts]") {
    const std::string chapter = "12_distribution", text = lesson(chapter), prose = with_exponents(text);
    // A row of the lesson is a line of the file, of which it shows the last columns.
    const auto compare = [&](const std::string& head, const std::string& file, std::size_t shown) {
        const std::vector<std::string> rows = table_after(text, head), lines = lines_of(chapter, file);
        REQUIRE(rows.size() > 2);
        REQUIRE(rows.size() == lines.size());
        for (std::size_t i = 0; i < rows.size(); ++i) {
            INFO(rows[i] << "\n" << file << ": " << lines[i]);
            const std::vector<double> said = numbers_in(rows[i]), counted = numbers_in(lines[i]);
            REQUIRE(said.size() >= shown);
            REQUIRE(counted.size() >= shown);
            CHECK(std::equal(said.end() - static_cast<std::ptrdiff_t>(shown), said.end(),
                             counted.end() - static_cast<std::ptrdiff_t>(shown)));
        }
    };
    compare("| pixels | a key for each pixel |", "blocks.csv", 2);
    compare("| what blurs |", "costs.csv", 2);
    compare("| samples a pixel | shadow rays to each lamp |", "nesting.csv", 4);

    // Slopes of four ways: a name, the dimensions, then of each way the slope and what theory says.
    const std::vector<std::string> slopes = lines_of(chapter, "slopes.csv");
    const std::vector<std::string> rows = table_after(text, "| | dimensions | independent |");
    CHECK(rows.size() * 5 == slopes.size());
    double widest = 0;
    // slope, plus_minus, theory, rms_16, rms_1024
    const auto line_of = [&](const std::string& name, const std::string& way) {
        const auto line = std::ranges::find_if(
            slopes, [&](const std::string& one) { return one.starts_with(name + "," + way + ","); });
        INFO(name << ", " << way);
        REQUIRE(line != slopes.end());
        std::vector<double> numbers = numbers_in(line->substr(name.size() + way.size() + 2));
        REQUIRE(numbers.size() == 5);
        return numbers;
    };
    for (const std::string& row : rows) {
        INFO(row);
        const std::vector<double> said = numbers_in(row);
        REQUIRE(said.size() == 9);
        const std::string name =
            row.substr(2, row.find(" |", 2) - 2) + "," + std::to_string(static_cast<int>(said[0]));
        std::size_t next = 1;
        for (const char* way : {"independent", "stratified pairs", "Sobol' pairs", "Sobol' in all"}) {
            const std::vector<double> counted = line_of(name, way);
            CHECK(said[next] == counted[0]);
            CHECK(said[next + 1] == counted[2]);
            widest = std::max(widest, counted[1]);
            next += 2;
        }
    }
    const auto says = [&](const std::string& pattern) { return std::stod(found(prose, pattern)); };
    CHECK(says("known to ±(\\S+) with") == widest);
    CHECK(says("error of (\\S+) by\\s+independent") == line_of("smooth,4", "independent")[4]);
    CHECK(says("and of (\\S+) by\\s+stratified") == line_of("smooth,4", "stratified pairs")[4]);
    CHECK(says("function is −(\\S+)\\s+instead") == line_of("smooth,8", "Sobol' in all")[0]);
    CHECK(says("16\\s+samples\\s+the\\s+error\\s+is\\s+(\\S+), where") ==
          line_of("smooth,8", "Sobol' in all")[3]);
    CHECK(says("stratified\\s+pairs\\s+have\\s+(\\d\\.\\d+)") == line_of("smooth,8", "stratified pairs")[3]);
    CHECK(says("error\\s+of\\s+(\\S+)\\s+by\\s+them") == line_of("sum of smooth,8", "Sobol' in all")[3]);
    CHECK(says("by\\s+them\\s+and\\s+of\\s+(\\S+)\\s+by") == line_of("sum of smooth,8", "Sobol' pairs")[3]);
    CHECK(says("at\\s+1024\\s+samples\\s+they\\s+have\\s+(\\d\\.\\d+)") ==
          line_of("smooth,4", "Sobol' pairs")[4]);
    CHECK(says("\\(12\\.1\\)\\s+they\\s+have\\s+(\\d\\.\\d+)") ==
          line_of("smooth,4", "Sobol' pairs in any order")[4]);

    const std::vector<double> pixel = numbers_in(lines_of(chapter, "blocks.csv").front()),
                              block = numbers_in(lines_of(chapter, "blocks.csv").back());
    CHECK(pixel[1] / block[1] == Approx(says("by\\s+a\\s+factor\\s+of\\s+(\\d+), and")).margin(0.5));
    CHECK(pixel[2] / block[2] > std::stod(found(text, "sequence\\s+by\\s+more\\s+than\\s+([0-9,]+\\d)")));

    const auto last_of = [&](const char* file, std::size_t line) {
        const std::vector<std::string> lines = lines_of(chapter, file);
        REQUIRE(line < lines.size());
        return numbers_in(lines[line]);
    };
    CHECK(says("coins\\s+fell\\s+in\\s+only\\s+(\\d) of") == last_of("coins.csv", 0).back());
    // Errors of a small lamp at 1e5 and 1e7 times its side: by acos, by unit vectors, by the edge.
    CHECK(says("are\\s+off\\s+by\\s+(\\S+)\\s+%\\s+or\\s+more\\.\\s+With") ==
          Approx(100 * last_of("small_lamps.csv", 1)[1]));
    CHECK(says("half\\s+are\\s+off\\s+by\\s+(\\S+)\\s+%") == Approx(100 * last_of("small_lamps.csv", 2)[2]));
    CHECK(says("times\\s+are\\s+at\\s+most\\s+(\\S+[0-9])\\.") == Approx(last_of("small_lamps.csv", 2)[3]));
    // Degrees, samples, lost, greatest weight: all facets, visible facets.
    const std::vector<double> all = last_of("facets.csv", 4), visible = last_of("facets.csv", 5);
    CHECK(says("(\\d+)\\s+%\\s+of\\s+the\\s+samples\\s+are\\s+lost") == all[2]);
    CHECK(says("weights\\s+up\\s+to\\s+(\\d+), where") == all[3]);
    CHECK(says("facets\\s+(\\d+)\\s+%\\s+are\\s+lost") == visible[2]);
    CHECK(visible[3] <= says("no\\s+weight\\s+is\\s+above\\s+(\\d+)"));
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
