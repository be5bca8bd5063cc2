// Two ray trees of one pixel: the first quantity that differs, and the step to look at.
#include "common/image/compare.hpp"
#include "common/image/file.hpp"
#include "common/pictures/drawings.hpp"
#include "common/pictures/step_picture.hpp"
#include "common/pictures/tree_difference.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/process.hpp"
#include "common/terminal/project.hpp"
#include "common/workbook/catalogue.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

using namespace rt;
using nlohmann::ordered_json;

namespace {

ordered_json lamp(const std::string& name) {
    return {{"light", name},
            {"direction", {0.0, 1.0, 0.0}},
            {"distance", 4.0},
            {"color", {1.0, 1.0, 1.0}},
            {"visible", {1.0, 1.0, 1.0}},
            {"contribution", {0.25, 0.25, 0.25}}};
}

ordered_json camera_ray() {
    return {{"kind", "camera"},
            {"parent", -1},
            {"depth", 0},
            {"origin", {0.0, 1.0, 6.0}},
            {"direction", {0.0, 0.0, -1.0}},
            {"weight", {1.0, 1.0, 1.0}},
            {"hit", true},
            {"shape", "sphere"},
            {"line", 7},
            {"primitive", 0},
            {"t", 5.0},
            {"point", {0.0, 1.0, 1.0}},
            {"normal", {0.0, 0.0, 1.0}},
            {"arriving_weight", {1.0, 1.0, 1.0}},
            {"lights", {lamp("point light at (0, 5, 1)"), lamp("point light at (0, 5, 2)")}},
            {"local", {0.5, 0.5, 0.5}}};
}

ordered_json tree() {
    ordered_json mirrored = camera_ray();
    mirrored["kind"] = "reflection";
    mirrored["parent"] = 0;
    mirrored["weight"] = mirrored["arriving_weight"] = {0.5, 0.5, 0.5};
    return {{"color", {0.75, 0.75, 0.75}},
            {"tree_color", {0.75, 0.75, 0.75}},
            {"rays", {camera_ray(), mirrored}}};
}

/// As if all of these failed; the last is never the cause.
std::string look_at(const TraceDifference& difference, const std::vector<WrongStep>& wrong) {
    return step_to_look_at(difference, wrong).value_or("none");
}

void check_difference(const ordered_json& mine, std::size_t ray, const std::string& quantity,
                      const WrongStep& step) {
    const auto difference = first_difference(mine, tree());
    REQUIRE(difference);
    CHECK(difference->ray == ray);
    CHECK(difference->quantity == quantity);
    CHECK(look_at(*difference, {{"08.6", "film.cpp"}, step}) == step.id);
    CHECK(look_at(*difference, {{"08.6", "film.cpp"}}) == "none");
}

}  // namespace

TEST_CASE("equal trees have no difference, and rounding is none") {
    CHECK_FALSE(first_difference(tree(), tree()));
    ordered_json mine = tree();
    mine["rays"][0]["t"] = 5.0 + 1e-12;
    mine["rays"][0]["normal"] = {0.0, 1e-12, 1.0};
    CHECK_FALSE(first_difference(mine, tree()));
}

TEST_CASE("each quantity names the step that computes it") {
    const std::vector<std::tuple<std::string, std::string, ordered_json, WrongStep>> cases = {
        {"direction", "direction of the ray", {0.0, 0.1, -1.0}, {"01.2", "camera.cpp"}},
        {"origin", "origin of the ray", {1.0, 1.0, 6.0}, {"01.3", "camera.cpp"}},
        {"weight", "weight of the ray", {0.5, 1.0, 1.0}, {"07.5", "radiance.cpp"}},
        {"t", "distance t", 7.0, {"02.3", "sphere.cpp"}},
        {"hit", "what is hit", false, {"02.3", "sphere.cpp"}},
        {"point", "point", {0.0, 1.0, 2.0}, {"02.4", "sphere.cpp"}},
        {"normal", "normal", {0.0, 0.0, -1.0}, {"02.4", "sphere.cpp"}},
        {"arriving_weight", "weight after absorption", {0.5, 1.0, 1.0}, {"07.4", "optics.cpp"}},
    };
    for (const auto& [key, quantity, value, step] : cases) {
        INFO(key);
        ordered_json mine = tree();
        mine["rays"][0][key] = value;
        check_difference(mine, 0, quantity, step);
    }
}

TEST_CASE("what a light gives names its step") {
    const std::vector<std::tuple<std::string, std::string, ordered_json, WrongStep>> cases = {
        {"direction", "direction to", {1.0, 0.0, 0.0}, {"05.1", "lighting.cpp"}},
        {"distance", "distance to", 3.0, {"05.1", "lighting.cpp"}},
        {"visible", "visible part of", {0.0, 0.0, 0.0}, {"06.1", "shadow.cpp"}},
        {"contribution", "light sent on from", {0.1, 0.1, 0.1}, {"05.3", "lighting.cpp"}},
    };
    for (const auto& [key, quantity, value, step] : cases) {
        INFO(key);
        ordered_json mine = tree();
        mine["rays"][1]["lights"][0][key] = value;
        check_difference(mine, 1, quantity + " the point light at (0, 5, 1)", step);
    }
}

TEST_CASE("the lobe of a finish names its own step, and what that uses") {
    const std::vector<std::pair<std::string, std::vector<std::string>>> finishes = {
        {"matte", {"11.15"}},
        {"metal", {"11.16"}},
        {"glass", {"07.3", "11.16", "11.18"}},
        {"velvet", {"11.20"}},
        {"coated", {"07.3", "11.22"}}};
    const std::vector<std::string> steps{"07.3", "11.15", "11.16", "11.18", "11.20", "11.22"};
    for (const auto& [kind, makers] : finishes)
        for (const char* quantity : {"lobe", "contribution"}) {
            ordered_json theirs = tree();
            theirs["rays"][0]["finish"] = {{"kind", kind}, {"roughness", 0.5}};
            theirs["rays"][0]["lights"][0]["lobe"] = {0.2, 0.2, 0.2};
            ordered_json mine = theirs;
            mine["rays"][0]["lights"][0][quantity] = {0.1, 0.1, 0.1};
            const auto difference = first_difference(mine, theirs);
            REQUIRE(difference);
            for (const std::string& step : steps) {
                INFO(kind << ", " << quantity << ": whether " << step << " is blamed");
                const bool is_maker = std::ranges::find(makers, step) != makers.end();
                CHECK(look_at(*difference, {{step, "x.cpp"}}) == (is_maker ? step : "none"));
            }
        }
}

TEST_CASE("a ray that a facet or a lobe sends on names who made it") {
    const auto blamed = [](const char* spreads, const char* key, const ordered_json& value,
                           const std::string& step) {
        ordered_json theirs = tree();
        theirs["rays"][0][spreads] = 0.3;
        ordered_json mine = theirs;
        mine["rays"][1][key] = value;
        const auto difference = first_difference(mine, theirs);
        REQUIRE(difference);
        return look_at(*difference, {{step, "x.cpp"}}) == step;
    };
    const ordered_json direction{0.0, 1.0, 0.0}, weight{0.1, 0.1, 0.1};
    for (const char* step : {"11.17", "07.1", "07.5"}) CHECK(blamed("facets", "direction", direction, step));
    for (const char* step : {"11.19", "12.16", "12.19"})
        CHECK_FALSE(blamed("facets", "direction", direction, step));
    for (const char* step : {"12.16", "12.19", "07.1", "07.5"})
        CHECK(blamed("gloss", "direction", direction, step));
    CHECK_FALSE(blamed("gloss", "direction", direction, "12.17"));
    CHECK(blamed("facets", "weight", weight, "11.16"));
    CHECK_FALSE(blamed("gloss", "weight", weight, "11.16"));
}

TEST_CASE("only a step that fails is proposed, and of several the part before what is made of it") {
    ordered_json mine = tree();
    mine["rays"][0]["lights"][0]["contribution"] = {0.1, 0.1, 0.1};
    const auto light = first_difference(mine, tree());
    REQUIRE(light);
    CHECK(look_at(*light, {{"05.5", "lighting.cpp"}}) == "05.5");
    CHECK(look_at(*light, {{"05.3", "lighting.cpp"}, {"05.5", "lighting.cpp"}}) == "05.3");
    CHECK(look_at(*light, {{"02.3", "sphere.cpp"}}) == "none");

    mine = tree();
    mine["rays"][0]["lights"][0]["visible"] = {0.0, 0.0, 0.0};
    const auto shadow = first_difference(mine, tree());
    REQUIRE(shadow);
    CHECK(look_at(*shadow, {{"06.1", "shadow.cpp"}, {"06.2", "shadow.cpp"}}) == "06.1");
    CHECK(look_at(*shadow, {{"09.7", "build.cpp"}}) == "09.7");
}

TEST_CASE("lamps are compared each with itself") {
    // The first is behind the surface, because the direction to it was turned round.
    ordered_json mine = tree();
    mine["rays"][0]["lights"].erase(0);
    check_difference(mine, 0, "side of the point light at (0, 5, 1)", {"05.1", "lighting.cpp"});
    mine = tree();
    mine["rays"][0]["lights"].push_back(lamp("point light at (0, -5, 1)"));
    check_difference(mine, 0, "side of the point light at (0, -5, 1)", {"05.1", "lighting.cpp"});
    // In another order they are the same.
    mine = tree();
    std::swap(mine["rays"][0]["lights"][0], mine["rays"][0]["lights"][1]);
    CHECK_FALSE(first_difference(mine, tree()));
}

TEST_CASE("the shape that was hit decides whose step it is") {
    for (const auto& [shape, step] :
         std::vector<std::pair<std::string, WrongStep>>{{"plane", {"01.4", "plane.cpp"}},
                                                        {"triangle", {"03.7", "triangle.cpp"}},
                                                        {"mesh", {"03.7", "triangle.cpp"}},
                                                        {"polygon", {"03.2", "polygon.cpp"}}}) {
        INFO(shape);
        ordered_json mine = tree(), theirs = tree();
        mine["rays"][0]["shape"] = theirs["rays"][0]["shape"] = shape;
        mine["rays"][0]["t"] = 2.0;
        const auto difference = first_difference(mine, theirs);
        REQUIRE(difference);
        CHECK(look_at(*difference, {{"02.3", "sphere.cpp"}, step}) == step.id);
    }
}

TEST_CASE("mirrored and refracted directions are chapter 7's, a missing ray is scatter's") {
    ordered_json mine = tree();
    mine["rays"][1]["direction"] = {1.0, 0.0, 0.0};
    check_difference(mine, 1, "direction of the ray", {"07.1", "optics.cpp"});

    mine = tree();
    mine["rays"].erase(1);
    check_difference(mine, 1, "number of rays", {"07.5", "radiance.cpp"});

    mine = tree();
    mine["color"] = {0.1, 0.1, 0.1};
    check_difference(mine, 0, "colour of the pixel", {"07.6", "radiance.cpp"});
}

TEST_CASE("a sum that forgets a weight, or a ray, is told apart from other sums") {
    ordered_json mine = tree();
    mine["color"] = {1.0, 1.0, 1.0};
    CHECK(first_difference(mine, tree())->mine ==
          "(1, 1, 1), as if the reflection ray that hits the sphere of line 7 counted in full, not by its "
          "weight");
    mine["color"] = {0.5, 0.5, 0.5};
    CHECK(first_difference(mine, tree())->mine ==
          "(0.5, 0.5, 0.5), as if the reflection ray that hits the sphere of line 7 were left out");
    mine["rays"].push_back(mine["rays"][1]);
    ordered_json theirs = mine;
    mine["color"] = {1.25, 1.25, 1.25};
    CHECK(first_difference(mine, theirs)->mine ==
          "(1.25, 1.25, 1.25), as if each ray counted in full, not by its weight");
    mine["color"] = {0.6, 0.6, 0.6};
    CHECK(first_difference(mine, theirs)->mine == "(0.6, 0.6, 0.6)");
}

// ----------------------------------------------------------------------------------------------------- grids

namespace {

ordered_json visit(int x, const ordered_json& shapes) {
    return {{"cell", {x, 0, 0}}, {"t", {1.0 * x, 1.0 * x + 1}}, {"shapes", shapes}};
}

/// A miss, or a hit, of a ray through a grid with these visits.
ordered_json tree_with_grid(bool hit, const ordered_json& visits) {
    ordered_json made = tree();
    ordered_json& ray = made["rays"][0];
    ray["hit"] = hit;
    ray["grids"] = {{{"of", "triangles"},
                     {"cells", {4, 1, 1}},
                     {"low", {0.0, 0.0, 0.0}},
                     {"high", {4.0, 1.0, 1.0}},
                     {"visits", visits}}};
    return made;
}

TraceDifference difference_of_grids(const ordered_json& mine, const ordered_json& theirs) {
    return first_difference(tree_with_grid(false, mine), tree_with_grid(true, theirs)).value();
}

const std::vector<WrongStep> grid_steps{{"09.7", "build.cpp"}, {"09.11", "walk.cpp"}};

}  // namespace

TEST_CASE("a hit that a grid has lost is followed to the cell") {
    const ordered_json right = {visit(0, {3}), visit(1, {3, 5}), visit(2, {8})};
    const auto skipped = difference_of_grids({visit(0, {3}), visit(2, {8})}, right);
    CHECK(in_words(skipped) ==
          "your cell 2 of 3 on the way through the grid over the triangles is (2, 0, 0), expected (1, 0, 0)");
    CHECK(look_at(skipped, grid_steps) == "09.11");
    const auto short_way = difference_of_grids({visit(0, {3}), visit(1, {3, 5})}, right);
    CHECK(in_words(short_way) ==
          "your cell 3 of 3 on the way through the grid over the triangles is none, expected (2, 0, 0)");
    const auto unlisted = difference_of_grids({visit(0, {3}), visit(1, {5}), visit(2, {8})}, right);
    CHECK(in_words(unlisted) ==
          "your content of cell (1, 0, 0) of the grid over the triangles is 1 shape, expected 2 shapes");
    CHECK(look_at(unlisted, grid_steps) == "09.7");
    // Where all cells are the same, it is not the grid.
    CHECK(difference_of_grids(right, right).quantity == "what is hit");
}

// -------------------------------------------------------------------------------- whole pictures, and
// mistakes

namespace {

/// What the program says about the pixel where the picture that a mistake draws differs most.
struct Traced {
    std::string words;
    std::string step;  ///< of those that the mistake's name says fail
};

/// The program of a mistake in tests/NN_name/mistakes, on a scene.
struct MistakeProgram {
    std::string name, scene;
    std::vector<WrongStep> wrong;

    Shown shown() const { return {test::repository() + "/references/" + scene, 80, 60}; }
    std::string run(const std::string& use, const std::vector<std::string>& more) const {
        const std::string file = test::scratch_directory() + "/" + name + more.back();
        std::vector<std::string> line{program(this_project(), "mistake_" + name).string(), use, shown().what,
                                      "80", "60"};
        line.insert(line.end(), more.begin(), more.end() - 1);
        line.push_back(file);
        REQUIRE(succeeded(run_process(line)));
        return file;
    }
    Traced trace() const {
        const Comparison comparison = compare(read_image(run("--picture", {".pfm"})), step_picture(shown()));
        const int x = comparison.worst_x, y = comparison.worst_y;
        const std::string file = run("--pixel", {std::to_string(x), std::to_string(y), ".json"});
        const auto difference =
            first_difference(read_ordered_json(read_file(file)), step_pixel(shown(), x, y));
        if (!difference) return {"no difference", ""};
        return {in_words(*difference), look_at(*difference, wrong)};
    }
};

}  // namespace

TEST_CASE("mistakes in whole programs: picture, pixel, quantity, step") {
    const std::vector<std::pair<MistakeProgram, std::string>> cases = {
        {{"02.3_only_the_near_root", "02_spheres/inside.scene", {{"02.3", "sphere.cpp"}}},
         "your ray hits nothing"},
        {{"05.3_half_not_unit",
          "05_lighting/highlights.scene",
          {{"05.3", "lighting.cpp"}, {"05.5", "lighting.cpp"}}},
         "your light sent on from the "},
        {{"05.1_from_the_light", "05_lighting/highlights.scene", {{"05.1", "lighting.cpp"}}},
         "your side of the "},
        {{"06.1_no_offset", "06_shadows/shadows.scene", {{"06.1", "shadow.cpp"}, {"06.2", "shadow.cpp"}}},
         "your visible part of the "},
        {{"07.6_unweighted", "07_recursion/whitted.scene", {{"07.6", "radiance.cpp"}}},
         "your colour of the pixel"},
        {{"09.1_diagonal_only", "04_transforms/ellipsoids.scene", {{"09.1", "bounds.cpp"}}},
         "the grid over the "},
    };
    for (const auto& [mistake, words] : cases) {
        INFO(mistake.name);
        const Traced traced = mistake.trace();
        CHECK_THAT(traced.words, Catch::Contains(words));
        CHECK(traced.step == mistake.wrong.front().id);
    }
}

TEST_CASE("every picture that a chapter names for a step can be drawn, and says what each pixel stands for") {
    for (const Chapter& chapter : read_catalogue(this_project()))
        for (const Step& step : chapter.steps) {
            if (step.picture.empty() || step.picture.ends_with(".scene")) continue;
            INFO(step.id << ": " << step.picture);
            REQUIRE(drawing_named(step.picture));
            const Image image = step_picture({step.picture});
            const ordered_json pixel = step_pixel({step.picture}, image.width - 1, image.height - 1);
            CHECK_FALSE(pixel["place"].get<std::string>().empty());
            CHECK_FALSE(pixel["answer"].get<std::string>().empty());
        }
}
