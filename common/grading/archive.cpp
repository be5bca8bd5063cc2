// Archives that students hand in, opened in a box.
#include "common/grading/archive.hpp"

#include "common/image/descriptor.hpp"
#include "common/math/printable.hpp"
#include "common/sandbox/system_files.hpp"
#include "common/terminal/staged_directory.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <map>
#include <set>
#include <sstream>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// Of names, as bytes: some fifty thousand files. Students pack what they have built, too.
constexpr std::uint64_t longest_list = std::uint64_t{4} << 20;

/// The status of a shell that could not start a program, and of a program without its libraries.
constexpr int not_started = 127;

Sandbox box_for(Isolation isolation) {
    Sandbox box;
    box.isolation = isolation;
    box.limits = unpacking_limits();
    box.mounts = library_mounts();
    // With C.UTF-8 names that are not ASCII can be told.
    for (const char* path : {"/usr/bin", "/usr/lib/locale"})
        if (fs::exists(path)) box.mounts.push_back({path, path});
    box.environment = {{"LC_ALL", "C.UTF-8"}};
    return box;
}

/// The first line that bsdtar has said, without words that say nothing.
std::string complaint(const std::string& errors) {
    std::string line = errors.substr(0, errors.find('\n'));
    const std::string name = "bsdtar: ", unknown = ": Unknown error -1";
    if (line.ends_with(unknown)) line.resize(line.size() - unknown.size());
    return line.starts_with(name) ? line.substr(name.size()) : line;
}

/// Runs bsdtar on an archive, which it gets as a descriptor: no path to it need be open to the box. A
/// password is given so that it asks nobody for one. Throws BadSubmission if it has anything to complain
/// about.
Ending bsdtar(const fs::path& archive, const Sandbox& box, const std::vector<std::string>& arguments) {
    const Descriptor file(::open(archive.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.number < 0)
        throw InputError(fmt::format("{}: {}", printable(archive.string()), std::strerror(errno)));
    std::vector<std::string> command{"/usr/bin/sh", "-c",           "exec bsdtar \"$@\" -f - <&3",
                                     "sh",          "--passphrase", "none"};
    command.insert(command.end(), arguments.begin(), arguments.end());
    const int descriptors[] = {file.number};
    Ending ending = run_in(box, command, descriptors);
    if (ending.end == End::Output)
        throw BadSubmission(archive, "cannot be unpacked: there are too many files in it");
    if (ending.end != End::Exited)
        throw BadSubmission(archive, "cannot be unpacked: that " + in_words(ending, box.limits));
    if (ending.number == 0) return ending;
    const std::string said = printable(complaint(ending.errors));
    if (ending.number == not_started) throw InputError("bsdtar does not start: " + said);
    if (ending.errors.find("passphrase") != std::string::npos) throw BadSubmission(archive, "is encrypted");
    throw BadSubmission(archive, "cannot be unpacked: " + said);
}

/// How many directories a path of an archive has; "./a//b/" has two. Nothing for one that leads upwards.
std::optional<int> depth_of(const std::string& prefix) {
    int depth = 0;
    std::istringstream in(prefix);
    for (std::string part; std::getline(in, part, '/');) {
        if (part == "..") return {};
        if (!part.empty() && part != ".") ++depth;
    }
    return depth;
}

/// The exercises in an archive by the directory that they are in, as it is written there: "" or "top/".
using Found = std::map<std::string, std::set<std::string>>;

/// Those at most one directory below the top, by the archive's list.
Found find_exercises(const std::string& list, const std::vector<std::string>& places) {
    Found found;
    std::istringstream in(list);
    for (std::string name; std::getline(in, name);)
        for (const std::string& place : places) {
            if (!name.ends_with(place)) continue;
            const std::string prefix = name.substr(0, name.size() - place.size());
            if (!prefix.empty() && !prefix.ends_with('/')) continue;
            if (const auto depth = depth_of(prefix); depth && *depth <= 1) found[prefix].insert(place);
        }
    return found;
}

/// The one directory that counts: the top, or the only one below.
Found::value_type chosen(const fs::path& archive, const Found& found) {
    for (const int depth : {0, 1}) {
        std::vector<Found::value_type> there;
        for (const auto& one : found)
            if (depth_of(one.first) == depth) there.push_back(one);
        if (there.size() > 1)
            throw BadSubmission(archive, fmt::format("has exercises in both {} and {}",
                                                     printable(there[0].first), printable(there[1].first)));
        if (!there.empty()) return there.front();
    }
    return {};
}

/// Arguments that unpack these files, without the directory that they are in.
std::vector<std::string> to_unpack(const Found::value_type& exercises) {
    const auto slashes = std::count(exercises.first.begin(), exercises.first.end(), '/');
    std::vector<std::string> arguments{"-x", "-m", "--strip-components", std::to_string(slashes)};
    for (const std::string& place : exercises.second) {
        arguments.emplace_back("--include");
        // No place has a character of patterns. bsdtar takes "./" from names before it compares them.
        arguments.push_back((depth_of(exercises.first) > 0 ? "*/" : "") + place);
    }
    return arguments;
}

}  // namespace

Limits unpacking_limits() {
    Limits limits;
    limits.cpu_seconds = 20;
    limits.wall_seconds = 60;
    limits.files = 512;
    limits.output = longest_list;
    return limits;
}

Submission read_archive(const fs::path& archive, const std::vector<const Chapter*>& chapters,
                        Isolation isolation) {
    if (!fs::exists("/usr/bin/bsdtar"))
        throw InputError("bsdtar, which unpacks archives, is not installed (Debian: libarchive-tools)");
    std::vector<std::string> places;
    for (const Chapter* chapter : chapters)
        for (const std::string& file : files_of_steps(*chapter))
            for (const std::string& place : places_of(*chapter, file)) places.push_back(place);

    Sandbox box = box_for(isolation);
    const auto exercises = chosen(archive, find_exercises(bsdtar(archive, box, {"-t"}).output, places));
    if (exercises.second.empty()) throw without_exercises(archive, chapters);

    const StagedDirectory unpacked(fs::temp_directory_path() / "course-unpacked");
    for (const std::string& place : exercises.second) {
        box.products.push_back({place, (unpacked.path / place).string()});
        fs::create_directories((unpacked.path / place).parent_path());
    }
    const Ending ending = bsdtar(archive, box, to_unpack(exercises));

    Submission submission;
    if (!ending.products.empty()) submission = read_submission(unpacked.path, chapters);
    submission.name = name_of_submission(archive);
    for (const std::string& place : exercises.second)
        if (std::ranges::find(ending.products, place) == ending.products.end())
            submission.remarks.push_back(place + " is no regular file");
    return submission;
}

Submission read_handed_in(const fs::path& path, const std::vector<const Chapter*>& chapters,
                          Isolation isolation) {
    try {
        return fs::is_regular_file(path) ? read_archive(path, chapters, isolation)
                                         : read_submission(path, chapters);
    } catch (const BadSubmission& bad) {
        Submission none{name_of_submission(path), {}, {}};
        none.refused = bad.why;
        return none;
    }
}

}  // namespace rt
