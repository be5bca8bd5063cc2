// Where things are: the repository and its build directory.
#include "common/terminal/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace rt {

namespace fs = std::filesystem;

Project this_project() { return {COURSE_SOURCE_DIR, COURSE_BUILD_DIR}; }

fs::path memory(const Project& project, std::string_view name) {
    const fs::path file = project.root / ".course" / name, once = project.build / name;
    std::error_code ignored;
    if (fs::exists(file, ignored) || !fs::exists(once, ignored)) return file;
    fs::create_directories(file.parent_path(), ignored);
    fs::rename(once, file, ignored);
    if (!fs::exists(file, ignored)) fs::copy_file(once, file, ignored);
    return file;
}

std::string relative(const Project& project, const fs::path& path) {
    const fs::path inside = fs::absolute(path).lexically_normal().lexically_relative(project.root);
    return inside.empty() || *inside.begin() == ".." ? path.string() : inside.string();
}

std::vector<fs::path> files_in(const fs::path& directory, const std::vector<std::string>& endings) {
    std::vector<fs::path> files;
    if (!fs::is_directory(directory)) return files;
    for (const auto& entry : fs::directory_iterator(directory))
        if (entry.is_regular_file() &&
            (endings.empty() ||
             std::ranges::find(endings, entry.path().extension().string()) != endings.end()))
            files.push_back(entry.path());
    std::ranges::sort(files);
    return files;
}

std::string fingerprint(std::string_view text) {
    std::uint64_t hash = 0xcbf29ce484222325;
    for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
    return fmt::format("{:016x}", hash);
}

}  // namespace rt
