// The pictures that a judge draws for students, into the directory --pictures: the difference of two that a
// test finds different, as TEST.png with the fingerprint of the test's name.
#include "common/image/compare.hpp"
#include "common/image/file.hpp"
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "common/terminal/project.hpp"
#include "tests/catch.hpp"
#include "tests/own_options.hpp"
#include "tests/pictures.hpp"

#include <filesystem>
#include <string>

namespace fs = std::filesystem;

namespace rt::grading {

namespace {

// One a chapter, in base64, and all together have room in the smallest of the formats (1 MB, PrairieLearn's).
constexpr int most_pixels_wide = 320;
constexpr std::uintmax_t most_bytes = 48 * 1024;

test::OwnOption pictures("--pictures", "directory", "where difference pictures go");
test::OwnOption scenes("--scene", "file", "one of the chapter's scenes, for the test [picture]");

/// Half as wide and as high. Of four pixels the brightest: one that differs must not vanish.
Image halved(const Image& image) {
    Image half = make_image((image.width + 1) / 2, (image.height + 1) / 2);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            Vec3& brightest = pixel(half, x / 2, y / 2);
            brightest = glm::max(brightest, pixel(image, x, y));
        }
    return half;
}

/// The first of a test.
void draw_difference(const Image& image, const Image& reference) {
    const bool alike = image.width == reference.width && image.height == reference.height &&
                       image.pixels.size() == reference.pixels.size();
    if (pictures.values.empty() || !alike) return;
    const std::string test = Catch::getResultCapture().getCurrentTestName();
    const fs::path file = fs::path(pictures.values.back()) / (fingerprint(test) + ".png");
    if (fs::exists(file)) return;
    Image shown = difference(image, reference, visible_gain(compare(image, reference)));
    while (shown.width > most_pixels_wide) shown = halved(shown);
    write_image(file, shown);
    while (fs::file_size(file) > most_bytes && shown.width > 1) {
        shown = halved(shown);
        write_image(file, shown);
    }
}

const bool pictures_are_drawn = (test::pictures_differ = draw_difference, true);

}  // namespace

}  // namespace rt::grading

// Not run with the others, and no part of a mark. Pictures with samples at random differ from POV-Ray's by
// their noise, and are left out.
TEST_CASE("the chapter's pictures are POV-Ray's", "[.][picture]") {
    for (const std::string& name : rt::grading::scenes.values) {
        const rt::Scene scene = rt::parse_scene(name);
        const fs::path reference_file = fs::path(name).replace_extension(".png");
        if (scene.sampling.count > 1 || !fs::exists(reference_file)) continue;
        const rt::Image image = rt::render(rt::compile(scene)).image;
        const rt::Image reference = rt::read_image(reference_file);
        REQUIRE(image.pixels.size() == reference.pixels.size());
        const bool same = rt::compare(image, reference).within[1] >= rt::same_share;
        if (!same) rt::test::pictures_differ(image, reference);
        REQUIRE(same);
    }
}
