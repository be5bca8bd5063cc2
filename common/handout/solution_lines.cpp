// Lines of solutions, and texts that have one where there must be none.
#include "common/handout/solution_lines.hpp"

#include "common/image/whole_file.hpp"
#include "common/workbook/exercise.hpp"

#include <cctype>
#include <vector>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// Shorter ones, such as `return true;`, tell nothing.
constexpr std::size_t least_length = 12;

/// All sources below a directory: files with one of these endings.
std::vector<fs::path> sources_below(const fs::path& directory, const std::vector<std::string>& endings) {
    std::vector<fs::path> files;
    if (!fs::is_directory(directory)) return files;
    for (const auto& entry : fs::recursive_directory_iterator(directory))
        if (entry.is_directory())
            for (const fs::path& file : files_in(entry.path(), endings)) files.push_back(file);
    return files;
}

/// Adds the lines of the marked parts.
void add_marked(SolutionLines& lines, const std::string& solution, const std::string& file) {
    const std::vector<std::string> all = split_lines(solution);
    for (const ExerciseRegion& region : exercise_regions(solution, file))
        for (int number = region.first_line + 1; number < region.last_line; ++number)
            if (std::string line = folded(all[static_cast<std::size_t>(number - 1)]);
                line.size() >= least_length)
                lines.try_emplace(std::move(line), SolutionLine{file, number});
}

void take_out(SolutionLines& lines, const std::string& given) {
    for (const std::string& line : split_lines(given)) lines.erase(folded(line));
}

}  // namespace

std::string folded(std::string_view line) {
    std::string text;
    for (const char c : line) {
        const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
        if (!blank)
            text += c;
        else if (!text.empty() && text.back() != ' ')
            text += ' ';
    }
    if (text.ends_with(' ')) text.pop_back();
    return text;
}

SolutionLines solution_lines(const Project& project) {
    SolutionLines lines;
    const std::vector<fs::path> solutions = sources_below(project.root / "solutions", {".cpp"});
    for (const fs::path& file : solutions) add_marked(lines, read_file(file), relative(project, file));
    for (const fs::path& file : solutions)
        take_out(lines, exercise_text(read_file(file), relative(project, file)));
    for (const fs::path& file : sources_below(project.root / "chapters", {".hpp"}))
        take_out(lines, read_file(file));
    for (const fs::path& file : sources_below(project.root / "common", {".cpp", ".hpp"}))
        take_out(lines, read_file(file));
    return lines;
}

std::optional<Leak> find_leak(const SolutionLines& lines, std::string_view text) {
    int number = 0;
    for (const std::string& line : split_lines(text)) {
        ++number;
        if (const auto found = lines.find(folded(line)); found != lines.end())
            return Leak{number, found->second};
    }
    return std::nullopt;
}

}  // namespace rt
