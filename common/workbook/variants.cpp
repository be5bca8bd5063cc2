// Right ways of writing a chapter that are not the solution's.
#include "common/workbook/variants.hpp"

#include "common/image/whole_file.hpp"

namespace rt {

namespace fs = std::filesystem;

std::vector<std::vector<Mistake>> right_variants(const Project& project, const Chapter& chapter) {
    std::vector<std::vector<Mistake>> programs;
    std::string last;
    std::size_t k = 0;
    for (const fs::path& file : files_in(project.root / "tests" / chapter.name / "variants", {".variant"})) {
        const Mistake variant = parse_mistake(read_file(file), relative(project, file));
        k = variant.step == last ? k + 1 : 0;
        last = variant.step;
        if (k == programs.size()) programs.emplace_back();
        programs[k].push_back(variant);
    }
    return programs;
}

std::map<std::string, std::string> solution_files(const Project& project, const Chapter& chapter) {
    std::map<std::string, std::string> files;
    for (const fs::path& file : files_in(project.root / "solutions" / chapter.name, {".cpp"}))
        files[file.filename().string()] = read_file(file);
    return files;
}

}  // namespace rt
