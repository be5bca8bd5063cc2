// Random scenes by POV-Ray and by us: each must be equal, or the export must refuse it.
#include "common/evidence/random_references.hpp"

#include "common/evidence/agreement.hpp"
#include "common/evidence/povray_picture.hpp"
#include "common/evidence/random_scenes.hpp"
#include "common/image/whole_file.hpp"
#include "common/povray/export.hpp"
#include "common/render/compile.hpp"
#include "common/render/decisions.hpp"
#include "common/render/render.hpp"
#include "common/render/snapshots.hpp"
#include "common/scene/parse.hpp"

#include <fmt/format.h>

#include <atomic>
#include <thread>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// Judges by the gate of the tour what a ray each has seen, before a filter makes many pixels of one, and our
/// picture by what our filter makes of these. Where POV-Ray itself puts its samples together, or each is of a
/// picture of its own, there are as many decisions as samples, and so often may one be another. Where its
/// picture is but the mean of ours, ours must be as wrong as it says of itself.
Agreement judge_random(const Scene& scene, const Image& theirs, const PovrayRun& run) {
    const RenderOptions options{.threads = 1, .progress = {}, .estimate = !run.exact};
    const World world = compile(scene);
    const RenderResult result = render(world, options);
    const Image& ours = result.image;
    if (!run.exact) return judge_samples(ours, theirs, result.rms_error.value_or(0));
    if (!run.filter || run.frames > 1) {
        Agreement agreement = judge(ours, theirs, [&] { return decisions(world); });
        const Real samples = static_cast<Real>(ours.pixels.size()) * scene.sampling.count;
        agreement.passed =
            agreement.unexplained == 0 && static_cast<Real>(agreement.over) <= gate_share * samples;
        return agreement;
    }
    const World samples = compile(scene_of_samples(scene, run.scale));
    const Image our_samples = render(samples, options).image;
    const Agreement weighed =
        judge(ours, filtered(our_samples, run.scale, scene), [&] { return decisions(world); });
    return weighed.passed ? judge(our_samples, theirs, [&] { return decisions(samples); }) : weighed;
}

/// As `check_random_scene`; what goes wrong is thrown.
RandomFinding compare_random_scene(const std::string& name, const fs::path& directory) {
    const Scene scene = parse_scene(directory / (name + ".scene"));
    std::string text;
    try {
        text = export_povray(scene, snapshots_of(scene));
    } catch (const InputError& error) {
        return {RandomFinding::Refused, error.what()};
    }
    const PovrayRun run = povray_run(scene);
    const Image theirs = run.frames > 1 ? picture_by_povray(name, text, scene, directory).image
                                        : samples_by_povray(name, text, scene, directory).image;
    const Agreement agreement = judge_random(scene, theirs, run);
    if (agreement.passed) return {};
    if (agreement.ratio)
        return {RandomFinding::Differs,
                fmt::format("its true error is {:.2f} times its estimate of it", *agreement.ratio)};
    return {RandomFinding::Differs,
            fmt::format("{} of {} pixels by up to {:.0f}/65535, {} of them not at silhouettes",
                        agreement.over, theirs.pixels.size(), agreement.greatest, agreement.unexplained)};
}

RandomFinding check_random_scene(std::uint64_t number, const fs::path& directory) {
    const std::string name = fmt::format("{}", number);
    write_file(directory / (name + ".scene"), random_scene(number));
    try {
        RandomFinding finding = compare_random_scene(name, directory);
        if (finding.state != RandomFinding::Differs)
            for (const char* ending : {".scene", ".pov", ".png", ".hdr"})
                fs::remove(directory / (name + ending));
        return finding;
    } catch (const std::exception& error) {
        return {RandomFinding::Differs, error.what()};
    }
}

}  // namespace

std::vector<RandomFinding> check_random_scenes(std::uint64_t first, std::uint64_t count,
                                               const fs::path& directory,
                                               const std::function<void(double)>& progress) {
    require_povray();
    write_random_files(directory);
    std::vector<RandomFinding> findings(count);
    std::atomic<std::uint64_t> next{0};
    const auto work = [&](bool tells_progress) {
        for (std::uint64_t i = next++; i < count; i = next++) {
            findings[i] = check_random_scene(first + i, directory);
            if (tells_progress) progress(static_cast<double>(i) / static_cast<double>(count));
        }
    };
    // Most of POV-Ray's time for so small pictures is its start, so two are made at a time.
    std::jthread other([&] { work(false); });
    work(true);
    return findings;
}

}  // namespace rt
