// The scripts that mark a class on several machines, run on stand-ins for the course and the engines;
// engines.sh runs them on real ones.
#include "common/grading/class_script.hpp"
#include "common/image/whole_file.hpp"
#include "common/terminal/process.hpp"
#include "common/terminal/shell.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <regex>

using namespace rt;
namespace fs = std::filesystem;

namespace {

const std::string all_bytes = [] {
    std::string text;
    for (int byte = 1; byte < 256; ++byte) text += static_cast<char>(byte);
    return text;
}();

const std::vector<std::string> names{"ada",   "it's",       "two words", "$HOME `x` *?[a]", "-n",
                                     "a\\nb", "line\nline", "{}",        "{{parts}}",       all_bytes};

void write_program(const fs::path& file, const std::string& text) {
    write_file(file, "#!/bin/sh\n" + text);
    fs::permissions(file, fs::perms(0755));
}

/// A directory with the course, which notes what it was called with, and engines that do all parts in their
/// order.
fs::path machine() {
    fs::path place = fs::path(test::scratch_directory()) / "class's script";
    fs::remove_all(place);
    fs::create_directories(place / "bin");
    fs::create_directories(place / "the class");
    write_program(place / "course",
                  "printf '[%s]' \"$@\" >>../calls; echo >>../calls\n"
                  "while [ \"$1\" != -o ]; do shift; done; echo marks >\"$2\"\n");
    // Called as: parallel --quote --sshloginfile FILE --ssh COMMAND --retries 3 sh SCRIPT {} DIRECTORY
    write_program(place / "bin/parallel",
                  "shift 7; while read -r part; do sh \"$2\" \"$part\" \"$4\" </dev/null; done\n");
    // Called as: sbatch --wait --output=FILE SCRIPT DIRECTORY, and by the script's own line for the number of
    // parts.
    write_program(place / "bin/sbatch",
                  "last=$(sed -n 's/^#SBATCH --array=1-\\([0-9]*\\) .*/\\1/p' \"$3\")\n"
                  "for part in $(seq \"$last\"); do SLURM_ARRAY_TASK_ID=$part sh \"$3\" \"$4\"; done\n");
    return place;
}

ClassScript example(const std::string& engine, const fs::path& place) {
    ClassScript script{engine, place / "course", place / "the class", {}, {}, "late's.json", 3, "csv"};
    for (const std::string& name : names) script.submissions.push_back("in/" + name);
    script.options = {"--chapter", "01", "--rubric", "late's.json", "--seed", "5"};
    return script;
}

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
    return std::regex_replace(text, std::regex(pattern), by);
}

}  // namespace

TEST_CASE("a shell reads a word as it was, whatever bytes it has") {
    for (const std::string& name : names) {
        ProcessOptions options;
        const ProcessResult result = run_process({"sh", "-c", "printf %s " + shell_word(name)}, options);
        CHECK(result.output == name);
    }
    CHECK(shell_word("") == "''");
    CHECK(shell_word("submissions/ada-1.0") == "submissions/ada-1.0");
    CHECK(shell_words({"a", "b c"}) == "a 'b c'");
}

TEST_CASE("an engine marks each part once by what was asked for, and then all are merged") {
    const auto engine = GENERATE(from_range(engines()));
    INFO(engine);
    const fs::path place = machine();
    const fs::path script = place / "mark it.sh";
    write_file(script, class_script(example(engine, place)));
    ProcessOptions options;
    options.environment = {{"PATH", (place / "bin").string() + ":/usr/bin:/bin"}};
    const ProcessResult result =
        run_process({"sh", "-c", "cd " + shell_word(place.string()) + " && sh 'mark it.sh'"}, options);
    INFO(result.output);
    REQUIRE(succeeded(result));

    std::string submissions;
    for (const std::string& name : names) submissions += "[in/" + name + "]";
    std::string expected;
    for (int part = 1; part <= 3; ++part)
        expected += fmt::format(
            "[grade][--chapter][01][--rubric][late's.json][--seed][5][--part][{0}/3][--format][json][-o]"
            "[parts/part_{0}.json][--]{1}\n",
            part, submissions);
    expected +=
        "[grade][--merge][parts/part_1.json][parts/part_2.json][parts/part_3.json][--format][csv]"
        "[--rubric][late's.json][-o][marks.csv]\n";
    CHECK(replaced(read_file(place / "calls"), "\\./tmp\\.\\w+/", "parts/") == expected);

    // Nothing else is left.
    std::vector<std::string> left;
    for (const auto& entry : fs::directory_iterator(place / "the class"))
        left.push_back(entry.path().filename().string());
    CHECK(left == std::vector<std::string>{"marks.csv"});
    fs::remove_all(place);
}

TEST_CASE("where a part fails nothing is merged, and what was said is shown") {
    const fs::path place = machine();
    write_program(place / "course",
                  "case $* in *--merge*) touch marks.csv ;; *) echo no box here >&2; exit 2 ;; esac\n");
    write_file(place / "mark.sh", class_script(example("parallel", place)));
    ProcessOptions options;
    options.environment = {{"PATH", (place / "bin").string() + ":/usr/bin:/bin"}};
    const ProcessResult result = run_process({"sh", (place / "mark.sh").string()}, options);
    CHECK(result.exit_code != 0);
    CHECK_THAT(result.output, Catch::Contains("no box here"));
    CHECK_FALSE(fs::exists(place / "the class/marks.csv"));
    fs::remove_all(place);
}

TEST_CASE("a class has a part for ten submissions; engines that there are not are refused") {
    CHECK(usual_parts(1) == 1);
    CHECK(usual_parts(10) == 1);
    CHECK(usual_parts(11) == 2);
    CHECK(usual_parts(300) == 30);
    CHECK(test::error_of([] { require_engine("moon"); }) ==
          "a class can be marked on parallel or slurm, not on 'moon'");
}
