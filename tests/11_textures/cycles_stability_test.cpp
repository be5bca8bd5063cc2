// Steps 11.15, 11.16 and 11.20 beside another renderer: what Blender's Cycles says of the same lobes. Its
// numbers are in cycles.csv, made by cycles.py, so that no test needs Blender.
#include "chapters/11_textures/lobes.hpp"
#include "tests/11_textures/lobe_checks.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <fstream>
#include <sstream>
#include <string>

using namespace rt;
using test::near;
using test::towards;

namespace {

/// A line of the table: f·cos as Cycles has it, and the standard error of that.
struct Row {
    std::string lobe;
    Real roughness = 0, light = 0, viewer = 0, turn = 0, value = 0, error = 0;
};

std::vector<Row> rows_of(const std::string& lobe) {
    std::ifstream file(test::repository() + "/tests/11_textures/cycles.csv");
    std::vector<Row> rows;
    std::string line;
    for (std::getline(file, line); std::getline(file, line);) {
        std::istringstream in(line);
        Row row;
        char comma = 0;
        std::getline(in, row.lobe, ',');
        in >> row.roughness >> comma >> row.light >> comma >> row.viewer >> comma >> row.turn >> comma >>
            row.value >> comma >> row.error;
        REQUIRE_FALSE(in.fail());
        if (row.lobe == lobe) rows.push_back(row);
    }
    return rows;
}

/// `part_of(roughness, l, v)` is what single precision may do to Cycles' value, as a part of it, above
/// `least`.
template <class LobeOf, class PartOf>
void compare_with_cycles(const std::string& name, LobeOf lobe_of, PartOf part_of, Real least) {
    const std::vector<Row> rows = rows_of(name);
    CHECK(rows.size() > 100);
    for (const Row& row : rows) {
        const Vec3 l = towards(row.light), v = towards(row.viewer, row.turn);
        INFO(name << " of roughness " << row.roughness << ", the light " << row.light << " and the viewer "
                  << row.viewer << " degrees from the normal, " << row.turn << " degrees apart around it");
        INFO("Cycles says that f cos is " << row.value << " ± " << row.error);
        const Real ours = evaluate(lobe_of(row.roughness), l, v).x * l.z;
        CHECK(near(ours, row.value, part_of(row.roughness, l, v) * row.value + least + 4 * row.error));
    }
}

}  // namespace

TEST_CASE("a matte lobe is that of Cycles", "[11.15][stability]") {
    // Measured: at most 1.5e-5, for σ = 1 in grazing light, where 1 + σ·t is nearly 0; elsewhere 6.3e-6.
    const auto part = [](Real, const Vec3&, const Vec3&) { return 1.8e-5; };
    const auto matte = [](Real roughness) { return Matte{Vec3(1), roughness}; };
    compare_with_cycles("matte", matte, part, 0);
}

TEST_CASE("the lobe of white rough metal is that of Cycles", "[11.16][stability]") {
    // Measured: at most 6.6e-6, in grazing light seen from near the horizon.
    const auto part = [](Real, const Vec3&, const Vec3&) { return 1e-5; };
    const auto metal = [](Real roughness) { return RoughMetal{Vec3(1), roughness}; };
    compare_with_cycles("metal", metal, part, 0);
}

TEST_CASE("a velvet lobe is that of Cycles", "[11.20][stability]") {
    // The exponent is rounded, and passes that on; below 1e-37 single precision has few digits.
    const auto part = [](Real roughness, const Vec3& l, const Vec3& v) {
        const Vec3 h = normalize(l + v);
        return 1e-5 * (1 + h.z * h.z / ((h.x * h.x + h.y * h.y) * roughness * roughness));
    };
    const auto velvet = [](Real roughness) { return Velvet{Vec3(1), roughness}; };
    compare_with_cycles("velvet", velvet, part, 1e-37);
}
