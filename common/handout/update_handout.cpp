// Handouts in mid-semester: what is given is brought up to date, what a student has written stays.
#include "common/handout/handout.hpp"
#include "common/handout/handout_files.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/lock.hpp"
#include "common/workbook/backup.hpp"
#include "common/workbook/chosen_chapters.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// Throws if the way from the directory to a file of it leads over a symbolic link, or to what is no file.
void require_plain(const fs::path& directory, const fs::path& file) {
    fs::path way = directory;
    for (const fs::path& part : file) {
        way /= part;
        const fs::file_status status = fs::symlink_status(way);
        const bool last = way == directory / file;
        if (fs::is_symlink(status))
            throw InputError(way.string() + " is a symbolic link, which no handout has; nothing was changed");
        if (fs::exists(status) && (last ? !fs::is_regular_file(status) : !fs::is_directory(status)))
            throw InputError(
                fmt::format("{} is no {}; nothing was changed", way.string(), last ? "file" : "directory"));
    }
}

HandoutRecord record_of(const fs::path& directory) {
    if (!fs::is_regular_file(fs::symlink_status(directory / record_file)))
        throw InputError(directory.string() + " is no handout; nothing was changed");
    require_plain(directory, record_file);
    return read_record(read_file(directory / record_file), (directory / record_file).string());
}

/// The chapters that are asked for, or those that the handout has.
std::vector<Chapter> chapters_for(const std::vector<Chapter>& all, const HandoutOptions& options,
                                  const HandoutRecord& record, const fs::path& directory) {
    std::vector<Chapter> chapters;
    if (options.chapters.empty()) {
        for (const std::string& number : record.chapters) chapters.push_back(find_chapter(all, number));
        if (chapters.empty()) throw InputError(directory.string() + " has no chapters");
        return chapters;
    }
    chapters = chosen_chapters(all, options.chapters);
    for (const std::string& number : record.chapters)
        if (std::ranges::find(chapters, number, &Chapter::number) == chapters.end())
            throw InputError(fmt::format("--chapters: {} has chapter {}, and an update hides none",
                                         directory.string(), number));
    return chapters;
}

/// A file of the handout as it is there, as it was handed out, and as it is to be.
struct ThreeStates {
    fs::path path;                    ///< on this machine
    std::optional<std::string> mine;  ///< what is there, if anything is
    std::string before;               ///< its fingerprint when it was handed out; empty if it was not

    bool is_untouched() const { return mine && fingerprint(*mine) == before; }
};

ThreeStates states_of(const fs::path& directory, const std::string& path, const HandoutRecord& record) {
    ThreeStates states{directory / path, std::nullopt, ""};
    if (fs::exists(states.path)) states.mine = read_file(states.path);
    if (const auto old = record.files.find(path); old != record.files.end()) states.before = old->second;
    return states;
}

void write(const fs::path& path, const HandoutFile& file) {
    make_directories(path.parent_path());
    write_file(path, file.text);
    if (file.executable) fs::permissions(path, fs::perms::owner_exec, fs::perm_options::add);
}

void update_exercise(const HandoutFile& file, const ThreeStates& states, UpdatedHandout& result) {
    const bool is_new = states.before.empty(), has_changed = states.before != fingerprint(file.text);
    if (states.is_untouched() || (is_new && !states.mine)) {
        write(states.path, file);
        result.written.push_back(file.path);
    } else if (states.mine && has_changed) {
        const std::string number = file.path.substr(std::string_view("chapters/").size(), 2);
        result.kept.push_back(
            {file.path, fmt::format("{}; yours stays, and ./course reset {} brings the new one",
                                    is_new ? "the exercise is new" : "the exercise has changed", number)});
    }
}

void update_given(const HandoutFile& file, const ThreeStates& states, UpdatedHandout& result) {
    const bool has_changed = states.before != fingerprint(file.text);
    const bool is_changed_there = states.mine && !states.is_untouched();
    if (is_changed_there && !has_changed) return;
    if (is_changed_there) {
        const fs::path backup = keep_backup(states.path, *states.mine);
        result.kept.push_back(
            {file.path, "was changed there, and has changed in the course; what was there is in " +
                            backup.filename().string()});
    }
    write(states.path, file);
    result.written.push_back(file.path);
}

/// What the course has no more.
void remove(const std::string& path, const ThreeStates& states, UpdatedHandout& result) {
    if (!states.mine) return;
    if (!states.is_untouched()) {
        result.kept.push_back({path, "is no part of the course any more; yours stays"});
        return;
    }
    fs::remove(states.path);
    result.removed.push_back(path);
}

}  // namespace

UpdatedHandout update_handout(const Project& project, const fs::path& directory,
                              const HandoutOptions& options) {
    require_solutions(project, "./course handout");
    const std::vector<Chapter> all = read_catalogue(project);
    const HandoutRecord first_look = record_of(directory);
    const std::vector<Chapter> chapters = chapters_for(all, options, first_look, directory);
    const ClassFacts about = options.about.empty() ? first_look.about : read_class_facts(options.about, all);
    const std::vector<HandoutFile> files = handout_files(project, chapters, about);

    std::set<std::string> paths{".course/memory.lock"};
    for (const HandoutFile& file : files) paths.insert(file.path);
    for (const auto& [path, mark] : first_look.files) paths.insert(path);
    for (const std::string& path : paths) require_plain(directory, path);

    const Lock lock(memory_lock({directory, directory / "build"}), "updating the handout");
    const HandoutRecord record = record_of(directory);  // another update may have ended meanwhile
    UpdatedHandout result;
    for (const Chapter& chapter : chapters) result.chapters.push_back(chapter.number);
    for (const auto& [path, mark] : record.files)
        if (std::ranges::find(files, path, &HandoutFile::path) == files.end())
            remove(path, states_of(directory, path, record), result);
    for (const HandoutFile& file : files) {
        const ThreeStates states = states_of(directory, file.path, record);
        if (states.mine == file.text) continue;
        if (file.path == record_file)
            write(states.path, file);
        else if (is_exercise(file.path))
            update_exercise(file, states, result);
        else
            update_given(file, states, result);
    }
    return result;
}

}  // namespace rt
