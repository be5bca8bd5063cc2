// The reference pictures: made by POV-Ray from our scenes, and watched for change.
#include "common/evidence/references.hpp"

#include "common/evidence/povray_picture.hpp"
#include "common/image/compare.hpp"
#include "common/image/file.hpp"
#include "common/math/stopwatch.hpp"
#include "common/povray/export.hpp"
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/render/snapshots.hpp"
#include "common/scene/parse.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {

namespace fs = std::filesystem;

namespace {

constexpr int thumbnail_width = 160;

/// A larger export is not kept in the repository: it is mostly a mesh, and `course export` writes it again.
constexpr std::size_t largest_kept_export = 1 << 20;

Kept compare_text(const fs::path& path, const std::string& text) {
    const bool keep = text.size() <= largest_kept_export;
    if (!fs::exists(path)) return keep ? Kept::Missing : Kept::Same;
    return keep && read_file(path) == text ? Kept::Same : Kept::Changed;
}

/// Pixels, not bytes: PNG files carry dates.
void compare_picture(const Image& made, ReferenceFinding& finding) {
    if (!fs::exists(finding.scene.picture)) {
        finding.picture = Kept::Missing;
        return;
    }
    const Image kept = read_image(finding.scene.picture);
    if (kept.width != made.width || kept.height != made.height) {
        finding.picture = Kept::Changed;
        finding.changed_pixels = made.pixels.size();
        return;
    }
    for (std::size_t i = 0; i < made.pixels.size(); ++i)
        if (made.pixels[i] != kept.pixels[i]) ++finding.changed_pixels;
    finding.greatest = compare(made, kept).max * 65535;
    if (finding.changed_pixels > 0) finding.picture = Kept::Changed;
}

/// Seconds from the scene's file to our picture of the samples that POV-Ray was asked for; 0 where these are
/// not ours.
double our_time(const fs::path& file, const PovrayRun& run) {
    if (!run.exact) return 0;
    const Stopwatch stopwatch;
    Scene scene = parse_scene(file);
    if (run.scale > 1) scene = scene_of_samples(std::move(scene), run.scale);
    RenderOptions options;
    options.threads = povray_threads;
    options.estimate = false;
    render(compile(scene), options);
    return stopwatch.seconds();
}

/// Writes what has changed: the export, unless it is too large to be kept, and POV-Ray's picture.
void write_changed(const ReferenceFinding& finding, const std::string& text, const fs::path& made) {
    const ReferenceScene& scene = finding.scene;
    if (finding.pov != Kept::Same) {
        if (text.size() <= largest_kept_export)
            write_file(scene.pov, text);
        else
            fs::remove(scene.pov);
    }
    if (finding.picture == Kept::Same) return;
    write_file(scene.picture, read_file(made));
    // A picture of the other format would be an old one.
    fs::path other = scene.picture;
    fs::remove(other.replace_extension(scene.picture.extension() == ".hdr" ? ".png" : ".hdr"));
}

/// Fills in what POV-Ray says of a scene, and with `make` writes it.
void check_scene(ReferenceFinding& finding, const fs::path& directory, double startup, bool make) {
    const ReferenceScene& scene = finding.scene;
    const Scene parsed = parse_scene(scene.scene);
    const std::string text = export_povray(parsed, snapshots_of(parsed));
    finding.pov = compare_text(scene.pov, text);
    const PovrayPicture made = picture_by_povray(scene.name, text, parsed, directory);
    finding.seconds = std::max(made.seconds - startup, 0.);
    finding.our_seconds = our_time(scene.scene, povray_run(parsed));
    finding.scene.picture.replace_extension(made.file.extension());
    compare_picture(made.image, finding);
    if (make) write_changed(finding, text, made.file);
}

bool same_bytes(const Vec3& a, const Vec3& b) {
    for (int c = 0; c < 3; ++c)
        if (encode_byte(a[c], Encoding::Srgb) != encode_byte(b[c], Encoding::Srgb)) return false;
    return true;
}

/// Whether the image, written as 8-bit sRGB, has the same pixels as the file.
bool is_kept_in(const fs::path& file, const Image& image) {
    if (!fs::exists(file)) return false;
    const Image kept = read_image(file);
    return kept.width == image.width && std::ranges::equal(kept.pixels, image.pixels, same_bytes);
}

/// The first scene of a chapter as the README shows it.
Kept check_thumbnail(const fs::path& picture, const fs::path& file, bool make) {
    const Image small = thumbnail(read_image(picture), thumbnail_width);
    if (is_kept_in(file, small)) return Kept::Same;
    const Kept state = fs::exists(file) ? Kept::Changed : Kept::Missing;
    if (make) write_image(file, small, Encoding::Srgb);
    return state;
}

}  // namespace

std::string_view name_of(Kept kept) {
    return kept == Kept::Same ? "same" : kept == Kept::Changed ? "changed" : "missing";
}

bool is_same(const ReferenceFinding& finding) {
    return finding.pov == Kept::Same && finding.picture == Kept::Same && finding.problem.empty();
}

std::vector<ReferenceFinding> check_references(
    const Project& project, const std::vector<Chapter>& chapters, bool make,
    const std::function<void(double fraction, const std::string& scene)>& progress) {
    std::vector<ReferenceFinding> findings;
    for (const Chapter& chapter : chapters)
        for (ReferenceScene& scene : reference_scenes(project, chapter))
            findings.push_back({.scene = std::move(scene)});
    double startup = -1;  // not measured yet
    for (std::size_t i = 0; i < findings.size(); ++i) {
        const ReferenceScene& scene = findings[i].scene;
        progress(static_cast<double>(i) / static_cast<double>(findings.size()),
                 scene.chapter + "/" + scene.name);
        if (!scene.why_none.empty()) continue;
        const fs::path directory = project.build / "references" / scene.chapter;
        make_directories(directory);
        try {
            if (startup < 0) startup = povray_startup(directory);
            check_scene(findings[i], directory, startup, make);
        } catch (const MissingProgram&) {
            throw;
        } catch (const std::exception& error) {
            findings[i].problem = error.what();
        }
    }
    return findings;
}

std::optional<ThumbnailFinding> check_thumbnail(const Project& project, const Chapter& chapter, bool make) {
    for (const ReferenceScene& scene : reference_scenes(project, chapter))
        if (scene.why_none.empty() && fs::exists(scene.picture))
            return ThumbnailFinding{
                chapter.name,
                check_thumbnail(scene.picture, scene.picture.parent_path() / "thumbnail.png", make)};
    return std::nullopt;
}

Image thumbnail(const Image& image, int width) {
    width = std::clamp(width, 1, image.width);
    const int height = std::max(1, (image.height * width + image.width / 2) / image.width);
    Image small = make_image(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const int x0 = x * image.width / width, x1 = (x + 1) * image.width / width;
            const int y0 = y * image.height / height, y1 = std::max(y0 + 1, (y + 1) * image.height / height);
            Vec3 sum(0);
            for (int j = y0; j < y1; ++j)
                for (int i = x0; i < x1; ++i) sum += pixel(image, i, j);
            pixel(small, x, y) = sum / static_cast<Real>((x1 - x0) * (y1 - y0));
        }
    }
    return small;
}

}  // namespace rt
