// The reference pictures: made by POV-Ray from our scenes, and watched for change.
#include "common/evidence/references.hpp"

#include "chapters/08_antialiasing/film.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/process.hpp"
#include "common/evidence/random_scenes.hpp"
#include "common/pictures/scene_file.hpp"
#include "common/evidence/tour.hpp"
#include "common/image/compare.hpp"
#include "common/image/file.hpp"
#include "common/math/input_error.hpp"
#include "common/render/compile.hpp"
#include "common/render/decisions.hpp"
#include "common/povray/export.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

namespace rt {
namespace {

namespace fs = std::filesystem;

constexpr int thumbnail_width = 160;
constexpr int povray_threads = 2;

/// A larger export is not kept in the repository: it is mostly a mesh, and `course export` writes it again.
constexpr std::size_t largest_kept_export = 1 << 20;

/// Not a matter of one scene, so it ends the whole check.
struct MissingProgram : InputError {
    using InputError::InputError;
};

enum class State { Same, Changed, Missing };

std::string word(State state) {
    switch (state) {
        case State::Same:
            return "same";
        case State::Changed:
            return "changed";
        case State::Missing:
            return "missing";
    }
    return "";
}

/// What a check of one scene found.
struct Finding {
    ReferenceScene scene;
    State pov = State::Same;
    State picture = State::Same;
    std::size_t changed_pixels = 0;
    Real greatest = 0;   ///< steps of 1/65535
    double seconds = 0;  ///< that POV-Ray took, its start-up of an empty scene subtracted
    double our_seconds =
        0;  ///< that we took for the same samples on as many threads, with reading and compiling
    std::string problem = {};  ///< why the scene could not be checked

    bool is_same() const { return pov == State::Same && picture == State::Same && problem.empty(); }
};

/// A picture that is `scale` times as large, as samples of the scene's pixels, weighed by its filter.
Image filtered(const Image& large, int scale, const Scene& scene) {
    std::vector<FilmSample> samples;
    samples.reserve(large.pixels.size());
    for (int y = 0; y < large.height; ++y)
        for (int x = 0; x < large.width; ++x)
            samples.push_back({Vec2(x + 0.5, y + 0.5) / Real(scale), pixel(large, x, y), 1});
    Image image = make_image(scene.width, scene.height);
    const std::vector<FilmPixel> film =
        film_of(samples, scene.sampling.filter, {0, 0, scene.width, scene.height});
    std::ranges::transform(film, image.pixels.begin(), color_of);
    return image;
}

/// Runs POV-Ray in `directory` on scene.pov; its picture is 16-bit, linear, and is left there, too. Its
/// pixels may be samples, which are not weighed yet.
Image samples_by_povray(const ReferenceScene& scene, const std::string& text, const Scene& parsed,
                        const fs::path& directory, double& seconds) {
    const fs::path source = directory / (scene.name + ".pov"), picture = directory / (scene.name + ".png");
    write_file(source, text);
    const PovrayRun run = povray_run(parsed);
    std::vector<std::string> line = {"povray",
                                     "+I" + source.string(),
                                     "+O" + picture.string(),
                                     fmt::format("+W{}", parsed.width * run.scale),
                                     fmt::format("+H{}", parsed.height * run.scale),
                                     "+FN16",
                                     "-D",
                                     fmt::format("+WT{}", povray_threads),
                                     "File_Gamma=1.0"};
    if (run.options.empty()) line.emplace_back("-A");
    line.insert(line.end(), run.options.begin(), run.options.end());
    const ProcessResult result = run_process(line);
    if (result.exit_code == 127)
        throw MissingProgram("povray is not installed; install it with: apt-get install povray");
    if (!succeeded(result)) {
        const fs::path log = directory / (scene.name + ".log");
        write_file(log, result.output);
        throw InputError(
            fmt::format("POV-Ray failed on {}; its messages are in {}", source.string(), log.string()));
    }
    seconds = result.seconds;
    return read_image(picture);
}

/// The same with the samples weighed: the picture.
Image run_povray(const ReferenceScene& scene, const std::string& text, const Scene& parsed,
                 const fs::path& directory, double& seconds) {
    const Image samples = samples_by_povray(scene, text, parsed, directory, seconds);
    const PovrayRun run = povray_run(parsed);
    if (!run.filter) return samples;
    const fs::path picture = directory / (scene.name + ".png");
    write_png16(picture, filtered(samples, run.scale, parsed));
    return read_image(picture);
}

State compare_text(const fs::path& path, const std::string& text) {
    const bool keep = text.size() <= largest_kept_export;
    if (!fs::exists(path)) return keep ? State::Missing : State::Same;
    return keep && read_file(path) == text ? State::Same : State::Changed;
}

/// Pixels, not bytes: PNG files carry dates.
void compare_picture(const Image& made, Finding& finding) {
    if (!fs::exists(finding.scene.picture)) {
        finding.picture = State::Missing;
        return;
    }
    const Image kept = read_image(finding.scene.picture);
    if (kept.width != made.width || kept.height != made.height) {
        finding.picture = State::Changed;
        finding.changed_pixels = made.pixels.size();
        return;
    }
    for (std::size_t i = 0; i < made.pixels.size(); ++i)
        if (made.pixels[i] != kept.pixels[i]) ++finding.changed_pixels;
    finding.greatest = compare(made, kept).max * 65535;
    if (finding.changed_pixels > 0) finding.picture = State::Changed;
}

/// What POV-Ray takes for a picture of nothing, the least of three runs.
double povray_startup(const fs::path& directory) {
    double least = infinity;
    for (int i = 0; i < 3; ++i) {
        Scene nothing;
        nothing.width = nothing.height = 16;
        double seconds = 0;
        run_povray({.name = "nothing"}, export_povray(nothing), nothing, directory, seconds);
        least = std::min(least, seconds);
    }
    return least;
}

/// The scene whose pixels are the samples of this one.
Scene scene_of_samples(Scene scene, int scale) {
    scene.width *= scale, scene.height *= scale;
    scene.sampling = {};
    return scene;
}

/// Seconds from the scene's file to our picture of the samples that POV-Ray was asked for; 0 where these are
/// not ours.
double our_time(const fs::path& file, const PovrayRun& run) {
    if (!run.exact) return 0;
    const auto start = std::chrono::steady_clock::now();
    Scene scene = parse_scene(file);
    if (run.scale > 1) scene = scene_of_samples(std::move(scene), run.scale);
    RenderOptions options;
    options.threads = povray_threads;
    options.estimate = false;
    render(compile(scene), options);
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Fills in what POV-Ray says of a scene, and with `make` writes it.
void check_scene(Finding& finding, const fs::path& directory, double startup, bool make) {
    const ReferenceScene& scene = finding.scene;
    const Scene parsed = parse_scene(scene.scene);
    const std::string text = export_povray(parsed);
    finding.pov = compare_text(scene.pov, text);
    const Image made = run_povray(scene, text, parsed, directory, finding.seconds);
    finding.seconds = std::max(finding.seconds - startup, 0.);
    finding.our_seconds = our_time(scene.scene, povray_run(parsed));
    compare_picture(made, finding);
    if (!make) return;
    if (finding.pov != State::Same) {
        if (text.size() <= largest_kept_export)
            write_file(scene.pov, text);
        else
            fs::remove(scene.pov);
    }
    if (finding.picture != State::Same)
        write_file(scene.picture, read_file(directory / (scene.name + ".png")));
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
State check_thumbnail(const fs::path& picture, const fs::path& file, bool make) {
    const Image small = thumbnail(read_image(picture), thumbnail_width);
    if (is_kept_in(file, small)) return State::Same;
    const State state = fs::exists(file) ? State::Changed : State::Missing;
    if (make) write_image(file, small, Encoding::Srgb);
    return state;
}

std::string describe(const Finding& finding) {
    if (!finding.scene.why_none.empty()) return "no reference: " + finding.scene.why_none;
    if (!finding.problem.empty()) return finding.problem;
    if (finding.is_same()) return "same";
    std::vector<std::string> parts;
    if (finding.pov != State::Same) parts.push_back("scene for POV-Ray " + word(finding.pov));
    if (finding.picture == State::Missing) parts.push_back("picture missing");
    if (finding.picture == State::Changed)
        parts.push_back(fmt::format("picture changed in {} by up to {:.0f}/65535",
                                    counted(static_cast<long long>(finding.changed_pixels), "pixel"),
                                    finding.greatest));
    return fmt::format("{}", fmt::join(parts, ", "));
}

/// What a chapter's first picture says of its thumbnail.
struct Thumbnail {
    std::string chapter;
    State state = State::Same;
};

std::optional<Thumbnail> check_thumbnail(const Project& project, const Chapter& chapter, bool make) {
    for (const ReferenceScene& scene : reference_scenes(project, chapter))
        if (scene.why_none.empty() && fs::exists(scene.picture))
            return Thumbnail{
                chapter.name,
                check_thumbnail(scene.picture, scene.picture.parent_path() / "thumbnail.png", make)};
    return std::nullopt;
}

nlohmann::ordered_json json_of(const Finding& finding) {
    nlohmann::ordered_json json = {{"chapter", finding.scene.chapter}, {"scene", finding.scene.name}};
    if (!finding.scene.why_none.empty()) {
        json["why_none"] = finding.scene.why_none;
    } else if (!finding.problem.empty()) {
        json["problem"] = finding.problem;
    } else {
        json["pov"] = word(finding.pov);
        json["picture"] = word(finding.picture);
        json["changed_pixels"] = finding.changed_pixels;
        json["greatest16"] = std::lround(finding.greatest);
        json["seconds"] = finding.seconds;
        json["our_seconds"] = finding.our_seconds;
    }
    return json;
}

void print_row(std::string_view chapter, std::string_view name, double seconds, double ours,
               std::string_view what, Tone tone) {
    const auto time = [](double s) { return s > 0 ? fmt::format("{:8.2f}", s) : std::string(8, ' '); };
    fmt::print("{:<16} {:<24} {} {}  {}\n", chapter, name, time(seconds), time(ours), paint(what, tone));
}

/// Judges by the gate of the tour what a ray each has seen, before a filter makes many pixels of one, and our
/// picture by what our filter makes of these. Where POV-Ray itself puts its samples together, there are as
/// many decisions as samples, and so often may one be another.
Verdict judge_random(const Scene& scene, const Image& theirs, const PovrayRun& run) {
    const RenderOptions options{.threads = 1, .progress = {}, .estimate = false};
    const World world = compile(scene);
    const Image ours = render(world, options).image;
    if (!run.filter) {
        Verdict verdict = judge(ours, theirs, [&] { return decisions(world); });
        const Real samples = static_cast<Real>(ours.pixels.size()) * scene.sampling.count;
        verdict.passed = verdict.unexplained == 0 && static_cast<Real>(verdict.over) <= gate_share * samples;
        return verdict;
    }
    const World samples = compile(scene_of_samples(scene, run.scale));
    const Image our_samples = render(samples, options).image;
    const Verdict weighed =
        judge(ours, filtered(our_samples, run.scale, scene), [&] { return decisions(world); });
    return weighed.passed ? judge(our_samples, theirs, [&] { return decisions(samples); }) : weighed;
}

/// What became of one random scene.
struct RandomFinding {
    enum { Equal, Refused, Differs } state = Equal;
    std::string why = {};  ///< it was refused, or how it differs
};

RandomFinding check_random_scene(std::uint64_t number, const fs::path& directory) {
    ReferenceScene scene;
    scene.name = fmt::format("{}", number);
    scene.scene = directory / (scene.name + ".scene");
    write_file(scene.scene, random_scene(number));
    const auto remove = [&] {
        for (const char* ending : {".scene", ".pov", ".png"}) fs::remove(directory / (scene.name + ending));
    };
    try {
        const Scene parsed = parse_scene(scene.scene);
        std::string text;
        try {
            text = export_povray(parsed);
        } catch (const InputError& error) {
            remove();
            return {RandomFinding::Refused, error.what()};
        }
        double seconds = 0;
        const Image theirs = samples_by_povray(scene, text, parsed, directory, seconds);
        const Verdict verdict = judge_random(parsed, theirs, povray_run(parsed));
        if (verdict.passed) {
            remove();
            return {};
        }
        return {RandomFinding::Differs,
                fmt::format("{} of {} pixels by up to {:.0f}/65535, {} of them not at silhouettes",
                            verdict.over, theirs.pixels.size(), verdict.greatest, verdict.unexplained)};
    } catch (const std::exception& error) {
        return {RandomFinding::Differs, error.what()};
    }
}

/// Most of POV-Ray's time for so small pictures is its start, so two are made at a time.
std::vector<RandomFinding> check_random_scenes(const RandomReferencesOptions& options,
                                               const fs::path& directory) {
    std::vector<RandomFinding> findings(options.count);
    std::atomic<std::uint64_t> next{0};
    Progress progress("random scenes", !options.json);
    const auto work = [&](bool shows_progress) {
        for (std::uint64_t i = next++; i < options.count; i = next++) {
            findings[i] = check_random_scene(options.first + i, directory);
            if (shows_progress)
                progress.update(static_cast<double>(i) / static_cast<double>(options.count), "");
        }
    };
    std::jthread other([&] { work(false); });
    work(true);
    return findings;
}

}  // namespace

std::vector<ReferenceScene> reference_scenes(const Project& project, const Chapter& chapter) {
    const fs::path directory = project.root / "references" / chapter.name;
    std::vector<std::string> files = chapter.scenes;
    for (const std::string& file : files)
        if (!fs::exists(directory / file))
            throw InputError(fmt::format("chapters/{}/chapter.json: references/{}/{} does not exist",
                                         chapter.name, chapter.name, file));
    std::vector<std::string> others;
    if (fs::exists(directory))
        for (const auto& entry : fs::directory_iterator(directory)) {
            const std::string file = entry.path().filename().string();
            if (entry.path().extension() == ".scene" && std::ranges::find(files, file) == files.end())
                others.push_back(file);
        }
    std::ranges::sort(others);
    files.insert(files.end(), others.begin(), others.end());

    std::vector<ReferenceScene> scenes;
    for (const std::string& file : files) {
        ReferenceScene scene;
        scene.chapter = chapter.name;
        scene.name = fs::path(file).stem().string();
        scene.scene = directory / file;
        scene.pov = directory / (scene.name + ".pov");
        scene.picture = directory / (scene.name + ".png");
        if (const fs::path why = directory / (scene.name + ".why"); fs::exists(why)) {
            scene.why_none = read_file(why);
            while (scene.why_none.ends_with('\n')) scene.why_none.pop_back();
        }
        scenes.push_back(std::move(scene));
    }
    return scenes;
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

int run_references(const ReferencesOptions& options, const Project& project) {
    std::vector<Chapter> chapters = read_catalogue(project);
    if (!options.chapter.empty()) chapters = {find_chapter(chapters, options.chapter)};

    std::vector<Finding> findings;
    for (const Chapter& chapter : chapters)
        for (ReferenceScene& scene : reference_scenes(project, chapter))
            findings.push_back({.scene = std::move(scene)});
    {
        double startup = -1;  // not measured yet
        Progress progress("references", !options.json && !options.quiet);
        for (std::size_t i = 0; i < findings.size(); ++i) {
            Finding& finding = findings[i];
            const ReferenceScene& scene = finding.scene;
            progress.update(static_cast<double>(i) / static_cast<double>(findings.size()),
                            fmt::format("{}/{}", scene.chapter, scene.name));
            if (!scene.why_none.empty()) continue;
            const fs::path directory = project.build / "references" / scene.chapter;
            make_directories(directory);
            try {
                if (startup < 0) startup = povray_startup(directory);
                check_scene(finding, directory, startup, options.make);
            } catch (const MissingProgram&) {
                throw;
            } catch (const std::exception& error) {
                finding.problem = error.what();
            }
        }
    }
    std::vector<Thumbnail> thumbnails;
    for (const Chapter& chapter : chapters)
        if (const auto found = check_thumbnail(project, chapter, options.make)) thumbnails.push_back(*found);

    const auto problems =
        std::ranges::count_if(findings, [](const Finding& f) { return !f.problem.empty(); });
    const auto changed =
        std::ranges::count_if(findings, [](const Finding& f) { return !f.is_same(); }) - problems +
        std::ranges::count_if(thumbnails, [](const Thumbnail& t) { return t.state != State::Same; });
    if (options.json) {
        nlohmann::ordered_json report = {{"scenes", nlohmann::ordered_json::array()},
                                         {"thumbnails", nlohmann::ordered_json::object()}};
        for (const Finding& finding : findings) report["scenes"].push_back(json_of(finding));
        for (const Thumbnail& t : thumbnails) report["thumbnails"][t.chapter] = word(t.state);
        report["changed"] = changed;
        report["problems"] = problems;
        report["written"] = options.make && changed > 0;
        fmt::print("{}\n", json_text(report, 2));
    } else if (!options.quiet) {
        fmt::print("{}\n", paint(fmt::format("{:<41} {:>8} {:>8}  the picture by POV-Ray is",
                                             "seconds for the same "
                                             "pixels",
                                             "POV-Ray", "ours"),
                                 Tone::Dim));
        const Tone tone = options.make ? Tone::Accent : Tone::Bad;
        for (const Finding& f : findings)
            print_row(f.scene.chapter, f.scene.name, f.seconds, f.our_seconds, describe(f),
                      f.is_same()         ? Tone::Good
                      : f.problem.empty() ? tone
                                          : Tone::Bad);
        for (const Thumbnail& t : thumbnails)
            print_row(t.chapter, "thumbnail", 0, 0, word(t.state),
                      t.state == State::Same ? Tone::Good : tone);
        if (problems > 0) fmt::print("{} could not be checked\n", counted(problems, "scene"));
        if (changed == 0 && problems == 0) fmt::print("all references are as POV-Ray makes them now\n");
        if (changed > 0)
            fmt::print("{} {}\n", counted(changed, "reference"),
                       options.make
                           ? "written"
                           : "changed or missing; `course references --make` writes what POV-Ray makes now");
    }
    return problems > 0 || (changed > 0 && !options.make) ? 1 : 0;
}

int run_random_references(const RandomReferencesOptions& options, const Project& project) {
    if (run_process({"povray", "--version"}).exit_code == 127)
        throw InputError("povray is not installed; install it with: apt-get install povray");
    const fs::path directory = project.build / "references" / "random";
    fs::create_directories(directory);
    write_random_meshes(directory);
    const std::vector<RandomFinding> findings = check_random_scenes(options, directory);

    const auto count = [&](auto state) {
        return std::ranges::count_if(findings, [&](const RandomFinding& f) { return f.state == state; });
    };
    const auto equal = count(RandomFinding::Equal), refused = count(RandomFinding::Refused),
               differ = count(RandomFinding::Differs);
    if (options.json) {
        nlohmann::ordered_json json = {{"equal", equal}, {"refused", refused}, {"differ", differ}};
        json["scenes"] = nlohmann::ordered_json::array();
        for (std::size_t i = 0; i < findings.size(); ++i)
            if (findings[i].state != RandomFinding::Equal)
                json["scenes"].push_back({{"number", options.first + i},
                                          {"refused", findings[i].state == RandomFinding::Refused},
                                          {"why", findings[i].why}});
        fmt::print("{}\n", json.dump(2));
    } else {
        for (std::size_t i = 0; i < findings.size(); ++i)
            if (findings[i].state == RandomFinding::Differs)
                fmt::print("{} {}\n",
                           relative(project, directory / fmt::format("{}.scene", options.first + i)),
                           paint("differs: " + findings[i].why, Tone::Bad));
        fmt::print("{}: {} equal, {} refused, {} differ\n",
                   counted(static_cast<long long>(findings.size()), "random scene"), equal, refused, differ);
    }
    return differ > 0 || refused > equal ? 1 : 0;
}

int run_export(const fs::path& scene, const fs::path& output, bool lenient) {
    const Scene parsed = read_scene(scene, lenient);
    require_no_input(output, files_of(scene, parsed));
    require_writable(output);
    write_file(output, export_povray(parsed));
    return 0;
}

}  // namespace rt
