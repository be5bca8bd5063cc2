// Copies of what a person has written, kept when something else takes its place.
#include "common/workbook/backup.hpp"

#include "common/image/whole_file.hpp"

#include <fmt/format.h>

namespace rt {

namespace fs = std::filesystem;

fs::path keep_backup(const fs::path& file, const std::string& text) {
    for (int number = 1;; ++number) {
        const fs::path backup = fmt::format("{}.{:03}.backup", file.string(), number);
        if (fs::exists(fs::symlink_status(backup))) continue;
        write_file(backup, text);
        return backup;
    }
}

}  // namespace rt
