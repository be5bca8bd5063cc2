// What of this machine's system a box needs to run programs, and to compile them.
#include "common/sandbox/system_files.hpp"

#include <algorithm>
#include <iterator>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// Those that this machine has, seen at their own places. A link to a directory of /usr, such as /lib64, is
/// made in every box.
std::vector<Mount> existing(std::initializer_list<const char*> paths) {
    std::vector<Mount> mounts;
    for (const char* path : paths)
        if (fs::exists(path) && !fs::is_symlink(path)) mounts.push_back({path, path});
    return mounts;
}

}  // namespace

std::vector<Mount> library_mounts() {
    std::vector<Mount> mounts = existing({"/usr/lib64", "/lib64", "/lib"});
    // A directory an architecture, such as /usr/lib/x86_64-linux-gnu; some have their loader beside it.
    for (const auto& entry : fs::directory_iterator("/usr/lib"))
        if (const std::string name = entry.path().filename().string();
            name.find("-linux-gnu") != std::string::npos || name.starts_with("ld-linux"))
            mounts.push_back({entry.path().string(), entry.path().string()});
    return mounts;
}

std::vector<Mount> compiler_mounts() {
    std::vector<Mount> mounts = library_mounts();
    std::ranges::copy(existing({"/usr/bin", "/usr/lib/gcc", "/usr/include"}), std::back_inserter(mounts));
    return mounts;
}

Limits compiler_limits() {
    Limits limits;
    limits.cpu_seconds = 60;
    limits.wall_seconds = 120;
    limits.process_memory = std::uint64_t{1536} << 20;
    limits.memory = std::uint64_t{2048} << 20;
    limits.processes = 16;
    limits.file_size = std::uint64_t{64} << 20;
    limits.disk = std::uint64_t{128} << 20;
    limits.output = std::uint64_t{64} << 10;
    return limits;
}

std::vector<std::string> short_diagnostics() { return {"-fmax-errors=10", "-fno-diagnostics-show-caret"}; }

}  // namespace rt
