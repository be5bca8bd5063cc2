// `course figures`: whether the lessons' figures are what their programs draw.
#include "common/commands/changed_files.hpp"
#include "common/commands/commands.hpp"
#include "common/evidence/side_by_side.hpp"
#include "common/image/file.hpp"
#include "common/image/whole_file.hpp"
#include "common/terminal/base64.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/catalogue.hpp"
#include "common/workbook/check.hpp"

#include <algorithm>
#include <stdexcept>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// Timings differ each time.
bool is_measured(const fs::path& file) { return file.filename().string().starts_with("measured_"); }

/// The chapters that have figures, or the one of them that is asked for.
std::vector<const Chapter*> chapters_with_figures(const Project& project,
                                                  const std::vector<Chapter>& chapters,
                                                  const std::string& number) {
    const Chapter* only = number.empty() ? nullptr : &find_chapter(chapters, number);
    std::vector<const Chapter*> chosen;
    for (const Chapter& chapter : chapters)
        if ((!only || only == &chapter) &&
            fs::exists(project.root / "references" / chapter.name / "figures.cpp"))
            chosen.push_back(&chapter);
    return chosen;
}

std::string target_of(const Chapter& chapter) { return "figures_" + chapter.number; }

void build_programs(const Project& project, const std::vector<const Chapter*>& chapters) {
    std::vector<std::string> targets;
    for (const Chapter* chapter : chapters) targets.push_back(target_of(*chapter));
    if (targets.empty()) return;
    const BuildResult build = build_targets(project, targets, "Building what draws figures");
    if (!build.ok) throw std::runtime_error(build.message);
}

/// Runs a chapter's program; returns the directory with what it has drawn.
fs::path draw_figures(const Project& project, const Chapter& chapter) {
    const std::string target = target_of(chapter);
    const fs::path drawn = project.build / "figures" / chapter.name;
    fs::remove_all(drawn);
    make_directories(drawn);
    const ProcessResult result = run_process({program(project, target).string(), drawn.string()});
    if (!succeeded(result)) throw std::runtime_error(target + " failed: " + result.output);
    return drawn;
}

/// A drawing without the pictures in it, and their pixels.
struct Unpacked {
    std::string text;
    std::vector<Vec3> pixels;
    friend bool operator==(const Unpacked&, const Unpacked&) = default;
};

Unpacked unpacked(const fs::path& drawing) {
    const std::string svg = read_file(drawing), mark = "data:image/png;base64,";
    Unpacked parts;
    std::size_t from = 0;
    for (auto at = svg.find(mark); at != std::string::npos; at = svg.find(mark, from)) {
        const std::size_t begin = at + mark.size(), end = std::min(svg.find('"', begin), svg.size());
        const auto bytes = from_base64(std::string_view(svg).substr(begin, end - begin));
        if (!bytes) return {svg, {}};
        const Image image = decode_picture(fs::path(drawing) += ".png", *bytes, Encoding::Linear).image;
        parts.text += svg.substr(from, begin - from);
        parts.pixels.insert(parts.pixels.end(), image.pixels.begin(), image.pixels.end());
        from = end;
    }
    parts.text += svg.substr(from);
    return parts;
}

/// Whether a figure is what it was: pictures by their pixels, however they are packed, other files by their
/// bytes.
bool is_same_figure(const fs::path& a, const fs::path& b) {
    if (a.extension() == ".svg") return unpacked(a) == unpacked(b);
    if (a.extension() != ".png") return read_file(a) == read_file(b);
    const Picture one = read_picture(a, Encoding::Linear), other = read_picture(b, Encoding::Linear);
    return one.eight_bits == other.eight_bits && one.image.width == other.image.width &&
           one.image.height == other.image.height && one.image.pixels == other.image.pixels;
}

/// What of the chapter's figures differs from what was drawn; `make` writes it.
std::vector<std::string> changed_figures(const Project& project, const fs::path& drawn, const fs::path& kept,
                                         bool make) {
    std::vector<std::string> changed;
    for (const fs::path& file : files_in(drawn)) {
        const fs::path old = kept / file.filename();
        const bool equal = fs::exists(old) && (is_measured(file) || is_same_figure(file, old));
        if (equal && !(make && is_measured(file))) continue;
        if (make) {
            make_directories(kept);
            write_file(old, read_file(file));
        }
        changed.push_back(relative(project, old));
    }
    for (const fs::path& old : files_in(kept)) {
        if (fs::exists(drawn / old.filename())) continue;
        if (make) fs::remove(old);
        changed.push_back(relative(project, old) + " (no longer drawn)");
    }
    return changed;
}

}  // namespace

int run_figures(const std::string& number, bool make, bool json) {
    const Project project = this_project();
    const std::vector<Chapter> catalogue = read_catalogue(project);
    const std::vector<const Chapter*> chapters = chapters_with_figures(project, catalogue, number);
    build_programs(project, chapters);

    std::vector<std::vector<std::string>> changed_of(chapters.size());
    std::vector<std::string> failures(chapters.size());
    const auto look_at = [&](std::size_t i) {
        try {
            const fs::path drawn = draw_figures(project, *chapters[i]);
            const fs::path kept = project.root / "references" / chapters[i]->name / "figures";
            changed_of[i] = changed_figures(project, drawn, kept, make);
        } catch (const std::exception& error) {
            failures[i] = error.what();
        }
    };
    // Times that are kept are taken with nothing beside.
    if (make)
        for (std::size_t i = 0; i < chapters.size(); ++i) look_at(i);
    else
        side_by_side(chapters.size(), look_at);

    std::vector<std::string> changed;
    for (std::size_t i = 0; i < chapters.size(); ++i) {
        if (!failures[i].empty()) throw std::runtime_error(failures[i]);
        changed.insert(changed.end(), changed_of[i].begin(), changed_of[i].end());
    }
    return report_changed(changed, make, json, "./course figures --make");
}

}  // namespace rt
