// Two ray trees of one pixel: the first quantity that differs, and the step that computes it.
#include "common/pictures/tree_difference.hpp"
#include "tests/catch.hpp"

using namespace rt;
using nlohmann::ordered_json;

namespace {

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
            {"lights",
             {{{"direction", {0.0, 1.0, 0.0}},
               {"distance", 4.0},
               {"color", {1.0, 1.0, 1.0}},
               {"visible", {1.0, 1.0, 1.0}},
               {"contribution", {0.25, 0.25, 0.25}}}}},
            {"local", {0.5, 0.5, 0.5}}};
}

ordered_json tree() {
    ordered_json mirrored = camera_ray();
    mirrored["kind"] = "reflection";
    mirrored["parent"] = 0;
    return {{"color", {0.75, 0.75, 0.75}}, {"rays", {camera_ray(), mirrored}}};
}

void check_difference(const ordered_json& mine, std::size_t ray, const std::string& quantity,
                      const std::string& step) {
    const auto difference = first_difference(mine, tree());
    REQUIRE(difference);
    CHECK(difference->ray == ray);
    CHECK(difference->quantity == quantity);
    CHECK(difference->step == step);
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
    const std::vector<std::tuple<std::string, ordered_json, std::string>> cases = {
        {"direction", {0.0, 0.1, -1.0}, "01.2"},
        {"origin", {1.0, 1.0, 6.0}, "01.3"},
        {"weight", {0.5, 1.0, 1.0}, "07.5"},
        {"t", 7.0, "02.3"},
        {"hit", false, "02.3"},
        {"point", {0.0, 1.0, 2.0}, "02.4"},
        {"normal", {0.0, 0.0, -1.0}, "02.4"},
        {"arriving_weight", {0.5, 1.0, 1.0}, "07.4"},
    };
    for (const auto& [quantity, value, step] : cases) {
        INFO(quantity);
        ordered_json mine = tree();
        mine["rays"][0][quantity] = value;
        check_difference(mine, 0, quantity, step);
    }
}

TEST_CASE("what a light gives names its step") {
    const std::vector<std::tuple<std::string, ordered_json, std::string>> cases = {
        {"direction", {1.0, 0.0, 0.0}, "05.1"},
        {"distance", 3.0, "05.1"},
        {"visible", {0.0, 0.0, 0.0}, "06.3"},
        {"contribution", {0.1, 0.1, 0.1}, "05.5"},
    };
    for (const auto& [quantity, value, step] : cases) {
        INFO(quantity);
        ordered_json mine = tree();
        mine["rays"][1]["lights"][0][quantity] = value;
        check_difference(mine, 1, "light 1: " + quantity, step);
    }
}

TEST_CASE("the shape that was hit decides whose step it is") {
    for (const auto& [shape, step] : std::vector<std::pair<std::string, std::string>>{
             {"plane", "01.4"}, {"triangle", "03.7"}, {"mesh", "03.7"}, {"polygon", "03.2"}}) {
        INFO(shape);
        ordered_json mine = tree(), theirs = tree();
        mine["rays"][0]["shape"] = theirs["rays"][0]["shape"] = shape;
        mine["rays"][0]["t"] = 2.0;
        const auto difference = first_difference(mine, theirs);
        REQUIRE(difference);
        CHECK(difference->step == step);
    }
}

TEST_CASE("mirrored and refracted directions are chapter 7's, a missing ray is scatter's") {
    ordered_json mine = tree();
    mine["rays"][1]["direction"] = {1.0, 0.0, 0.0};
    check_difference(mine, 1, "direction", "07.1");

    mine = tree();
    mine["rays"].erase(1);
    check_difference(mine, 1, "number of rays", "07.5");

    mine = tree();
    mine["color"] = {0.1, 0.1, 0.1};
    check_difference(mine, 0, "colour of the pixel", "07.6");
}
