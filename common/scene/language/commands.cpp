// The tables of all subjects as one.
#include "common/scene/language/commands.hpp"

#include <algorithm>

namespace rt::language {

std::span<const CommandRow> all_commands() {
    static const std::vector<CommandRow> all = [] {
        std::vector<CommandRow> rows;
        for (const std::span<const CommandRow> subject :
             {picture_commands(), tracing_commands(), shape_commands(), transform_commands(),
              light_commands(), material_commands(), sampling_commands(), texture_commands(),
              blur_commands()})
            rows.insert(rows.end(), subject.begin(), subject.end());
        std::ranges::stable_sort(rows, {}, [](const CommandRow& row) { return row.reference.chapter; });
        return rows;
    }();
    return all;
}

}  // namespace rt::language
