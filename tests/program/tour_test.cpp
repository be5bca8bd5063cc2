// The tour's gate, its page, and the pictures that it stands on.
#include "common/evidence/tour.hpp"
#include "common/commands/commands.hpp"
#include "common/evidence/references.hpp"
#include "common/image/file.hpp"
#include "common/image/worst_places.hpp"
#include "common/math/input_error.hpp"
#include "common/pictures/comparison_page.hpp"
#include "common/terminal/json_text.hpp"
#include "tests/catch.hpp"
#include "tests/program/sandbox.hpp"

#include <cstdlib>
#include <limits>

using namespace rt;

namespace {

namespace fs = std::filesystem;

constexpr Real step = 1. / 65535;
constexpr int width = 50, height = 40;

/// A picture of two halves, and the decisions that made it.
Image halves() {
    Image image = make_image(width, height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) pixel(image, x, y) = Vec3(x < width / 2 ? 0.25 : 0.75);
    return image;
}
std::vector<std::uint64_t> decided() {
    std::vector<std::uint64_t> decisions;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) decisions.push_back(x < width / 2 ? 1 : 2);
    return decisions;
}

Agreement judged(const Image& image) { return judge(image, halves(), decided); }

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// A repository with one chapter whose scene is a white disc on black: exact in 8 bits, too.
Project white_disc(const std::string& name) {
    const Project project = test::sandbox(name);
    test::add_chapter(project, "02_spheres", test::good_chapter);
    test::write(project.root / "references/02_spheres/one.scene",
                "version 1\nsize 24 16\nencoding srgb\nintegrator flat\ncamera 0 0 4  0 0 0  0 1 0  40\n"
                "ambient 1 1 1\nsphere 0 0 0 1\n");
    return project;
}

}  // namespace

TEST_CASE("a picture that equals its reference passes, and nobody asks for its decisions", "[tour]") {
    const Agreement v = judge(halves(), halves(), []() -> std::vector<std::uint64_t> {
        FAIL("decisions were asked for");
        return {};
    });
    CHECK(v.passed);
    CHECK(v.greatest == 0);
    CHECK(v.over == 0);
}

TEST_CASE("two steps pass everywhere, three at one pixel inside fail", "[tour]") {
    Image image = halves();
    for (Vec3& p : image.pixels) p += Vec3(1.9 * step, 0, -1.9 * step);
    CHECK(judged(image).passed);
    CHECK(judged(image).greatest == Approx(1.9));

    pixel(image, 5, 7).y += 3 * step;
    const Agreement v = judged(image);
    CHECK(v.over == 1);
    CHECK(v.unexplained == 1);
    CHECK_FALSE(v.passed);
}

TEST_CASE("a pixel at a silhouette may differ by anything, one beside it may not", "[tour]") {
    for (const int x : {width / 2 - 1, width / 2}) {
        Image image = halves();
        pixel(image, x, 3) = Vec3(1, 0, 0);
        const Agreement v = judged(image);
        CAPTURE(x);
        CHECK(v.over == 1);
        CHECK(v.unexplained == 0);
        CHECK(v.passed);
    }
    for (const int x : {width / 2 - 2, width / 2 + 1, 0, width - 1}) {
        Image image = halves();
        pixel(image, x, 3) = Vec3(1, 0, 0);
        CAPTURE(x);
        CHECK_FALSE(judged(image).passed);
    }
}

TEST_CASE("neighbours are above, below and across corners, too", "[tour]") {
    // One pixel was decided differently from all others.
    std::vector<std::uint64_t> decisions(halves().pixels.size(), 1);
    decisions[20 * width + 30] = 2;
    for (int y = 18; y <= 22; ++y) {
        for (int x = 28; x <= 32; ++x) {
            Image image = halves();
            pixel(image, x, y) = Vec3(0);
            CAPTURE(x, y);
            const bool near = std::abs(x - 30) <= 1 && std::abs(y - 20) <= 1;
            CHECK(judge(image, halves(), [&] { return decisions; }).passed == near);
        }
    }
}

TEST_CASE("more than a thousandth of the pixels fail even at silhouettes", "[tour]") {
    Image image = halves();
    pixel(image, width / 2, 1) = pixel(image, width / 2, 2) = Vec3(0);
    CHECK(judged(image).passed);  // 2 of 2000
    pixel(image, width / 2, 3) = Vec3(0);
    CHECK(judged(image).unexplained == 0);
    CHECK_FALSE(judged(image).passed);
}

TEST_CASE("NaN is a difference, and values over 1 are what a display shows", "[tour]") {
    Image image = halves();
    pixel(image, 2, 2).z = std::numeric_limits<Real>::quiet_NaN();
    CHECK_FALSE(judged(image).passed);
    CHECK(judged(image).greatest == Approx(65535));

    Image bright = halves(), white = halves();
    pixel(bright, 2, 2) = Vec3(7);
    pixel(white, 2, 2) = Vec3(1);
    CHECK(judge(bright, white, decided).passed);
}

TEST_CASE("pictures of two sizes are not compared", "[tour]") {
    CHECK_THROWS_AS(judge(halves(), make_image(width, height + 1), decided), InputError);
    CHECK_THROWS_AS(judge(halves(), make_image(width - 1, height), decided), InputError);
}

TEST_CASE("the tour passes a picture like its reference and fails an altered one", "[tour]") {
    const Project project = white_disc("tour");
    const fs::path output = project.build / "tour",
                   reference = project.root / "references/02_spheres/one.png";
    const TourCommand command{.output = output, .json = false, .quiet = true};

    CHECK(run_tour(command, project) == 1);  // there is no reference
    const fs::path ours = output / "02_spheres/one.png";
    REQUIRE(fs::exists(ours));
    Image image = read_image(ours);
    CHECK(pixel(image, 12, 8) == Vec3(1));
    CHECK(pixel(image, 0, 0) == Vec3(0));

    write_image(reference, image);
    CHECK(run_tour(command, project) == 0);
    const std::string page = read_file(output / "index.html");
    CHECK(contains(page, "prefers-color-scheme: dark"));
    CHECK(contains(page, "02_spheres/one.reference.png"));
    CHECK(contains(page, "1 picture compared, all equal"));
    CHECK(contains(page, "href=\"#02_spheres\"><img src=\"02_spheres/one.png\""));
    CHECK(page.find("<img") < page.find("<table"));
    CHECK_FALSE(contains(page, "http"));  // nothing is loaded from elsewhere

    pixel(image, 12, 8) = Vec3(0);
    write_image(reference, image);
    CHECK(run_tour(command, project) == 1);
    CHECK(contains(read_file(output / "index.html"), "differs"));
}

TEST_CASE("a scene without a reference needs a reason", "[tour]") {
    const Project project = white_disc("tour_why");
    test::write(project.root / "references/02_spheres/one.why", "It shows what POV-Ray cannot.\n");
    const TourCommand command{.output = project.build / "tour", .json = false, .quiet = true};
    CHECK(run_tour(command, project) == 0);
    CHECK(contains(read_file(command.output / "index.html"), "It shows what POV-Ray cannot."));
}

TEST_CASE("a scene that cannot be read fails its tour and is named", "[tour]") {
    const Project project = white_disc("tour_broken");
    test::write(project.root / "references/02_spheres/other.scene", "version 1\nsfere 0 0 0 1\n");
    const TourCommand command{.output = project.build / "tour", .json = false, .quiet = true};
    CHECK(run_tour(command, project) == 1);
    CHECK(contains(read_file(command.output / "index.html"), "other.scene:2:1"));
}

TEST_CASE("a chapter's own scenes come first, in its order, then all others", "[references]") {
    const Project project = white_disc("scenes");
    test::write(project.root / "references/02_spheres/another.scene", "");
    const auto scenes = reference_scenes(project, read_catalogue(project).front());
    REQUIRE(scenes.size() == 2);
    CHECK(scenes[0].name == "one");
    CHECK(scenes[1].name == "another");
    CHECK(scenes[0].picture == project.root / "references/02_spheres/one.png");

    fs::remove(project.root / "references/02_spheres/one.scene");
    CHECK_THROWS_AS(reference_scenes(project, read_catalogue(project).front()), InputError);
}

TEST_CASE("a thumbnail is the mean light of boxes", "[references]") {
    Image image = make_image(4, 2);
    pixel(image, 0, 0) = Vec3(1, 0, 0);
    pixel(image, 1, 1) = Vec3(1, 1, 0);
    pixel(image, 3, 0) = Vec3(0, 0, 1);
    const Image small = thumbnail(image, 2);
    CHECK(small.width == 2);
    CHECK(small.height == 1);
    CHECK(pixel(small, 0, 0) == Vec3(0.5, 0.25, 0));
    CHECK(pixel(small, 1, 0) == Vec3(0, 0, 0.25));
    CHECK(thumbnail(image, 100).width == 4);
}

TEST_CASE("a comparison's page holds its pictures and shows names as text", "[page]") {
    Image image = halves();
    pixel(image, 3, 4).x += 0.5;
    const std::string page =
        comparison_page(image, halves(), compare(image, halves()), "<mine>.png", "theirs.png");
    CHECK(contains(page, "&lt;mine&gt;.png"));
    CHECK_FALSE(contains(page, "<mine>"));
    CHECK(contains(page, "src=\"data:image/png;base64,iVBORw0KGgo"));
    CHECK(contains(page, "<dt>at pixel</dt><dd>3, 4</dd>"));
    CHECK_FALSE(contains(page, "http:"));
    CHECK_FALSE(contains(page, "https:"));
    CHECK(contains(page, "content=\"default-src &apos;none&apos;; img-src data:;"));
}

TEST_CASE("a comparison's page holds the rays of pixels as text", "[page]") {
    PageExtras extras;
    extras.scene = "</script>.scene";
    extras.rays = {{3, 4, "hits <nothing>", "hits </script>", "First difference: hit."},
                   {1, 2, "alike", "alike", ""}};
    const std::string page =
        comparison_page(halves(), halves(), compare(halves(), halves()), "a.png", "b.png", extras);
    const std::size_t begin = page.find("id=\"data\">") + 10;
    const auto data = read_json(page.substr(begin, page.find("</script>", begin) - begin));
    REQUIRE_FALSE(data.is_discarded());
    CHECK(data["scene"] == extras.scene);
    REQUIRE(data["rays"].size() == 2);
    CHECK(data["rays"][0]["mine"] == "hits <nothing>");
    CHECK(data["rays"][0]["theirs"] == "hits </script>");
    CHECK_FALSE(data["rays"][1].contains("theirs"));  // once is enough
    CHECK(contains(page, "None: no pixel differs."));
}

TEST_CASE("rays are told of the pixels that differ most, then of some all over the picture", "[page]") {
    Image image = halves();
    pixel(image, 3, 4).x += 0.1;
    pixel(image, 40, 30).x += 0.2;
    const std::vector<PixelRays> pixels = pixels_to_trace(image, halves());
    REQUIRE(pixels.size() == 2 + 16 * 12);
    CHECK(pixels[0].x == 40);
    CHECK(pixels[1].y == 4);
    CHECK(pixels_to_trace(make_image(1, 1), make_image(1, 1)).size() == 1);
}

TEST_CASE("of places that differ most none is near another", "[page]") {
    Image image = halves();
    pixel(image, 3, 4).x += 0.1;
    pixel(image, 5, 4).y -= 0.2;
    pixel(image, 30, 4).z += 0.2;
    const std::vector<DifferingPixel> pixels = differing_pixels(image, halves(), 10);
    REQUIRE(pixels.size() == 3);
    CHECK(pixels.front().x == 5);  // of equal ones the first
    const std::vector<DifferingPixel> worst = worst_places(pixels, 10, 3);
    REQUIRE(worst.size() == 2);
    CHECK(worst[1].x == 30);
    CHECK(worst_places(pixels, 10, 2).size() == 3);
    CHECK(worst_places(pixels, 1, 2).size() == 1);
    CHECK(differing_pixels(image, halves(), 2).size() == 2);
}

TEST_CASE("the gain of a difference grows as the difference shrinks", "[page]") {
    const auto gain = [](Real difference) {
        Image image = halves();
        for (Vec3& p : image.pixels) p += Vec3(difference);
        return visible_gain(compare(image, halves()));
    };
    CHECK(gain(0) == 1);
    CHECK(gain(0.25) == 1);
    CHECK(gain(1. / 256) == 64);
    CHECK(gain(1e-9) == 4096);
}

TEST_CASE("a scene's opening comment is one paragraph", "[tour]") {
    CHECK(opening_comment("# A ball\n#  and a box. \r\nversion 1\n# not this\n") == "A ball and a box.");
    CHECK(opening_comment("#\n# Words\n\n# other words") == "Words");
    CHECK(opening_comment("version 1\n# late") == "");
    CHECK(opening_comment("# no end") == "no end");
    CHECK(opening_comment("") == "");
}

TEST_CASE("a picture of random samples must differ from its reference as much as it says", "[tour]") {
    Image image = halves();
    for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] += Vec3(i % 2 == 0 ? 0.01 : -0.01);
    const Agreement right = judge_samples(image, halves(), 0.01);
    CHECK(right.passed);
    REQUIRE(right.ratio.has_value());
    CHECK(std::abs(*right.ratio - 1) < 1e-9);
    CHECK(judge_samples(image, halves(), 0.0067).passed);
    CHECK_FALSE(judge_samples(image, halves(), 0.0066).passed);  // it is worse than it says,
    CHECK_FALSE(judge_samples(image, halves(), 0.0151).passed);  // or better
    CHECK_FALSE(judge_samples(image, halves(), 0).passed);
    CHECK_FALSE(judge_samples(halves(), halves(), 0).passed);  // NaN
    CHECK_THROWS_AS(judge_samples(image, make_image(width, height + 1), 0.01), InputError);
}
