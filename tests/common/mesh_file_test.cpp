// Meshes from `.obj` files: what is read, how polygons are cut, and what is refused.
#include "common/scene/mesh_file.hpp"

#include "tests/catch.hpp"
#include "tests/support.hpp"

using namespace rt;

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string error_of(const std::string& text, const MeshOptions& options = {}) {
    return test::error_of([&] { parse_mesh(text, "m", options); });
}

Real area(const Mesh& mesh) {
    Real sum = 0;
    for (const auto& triangle : mesh.triangles) {
        const auto corner = [&](std::size_t i) {
            return mesh.positions.at(static_cast<std::size_t>(triangle[i].position));
        };
        sum += glm::cross(corner(1) - corner(0), corner(2) - corner(0)).z / 2;
    }
    return sum;
}

void check_corner(const Mesh::Corner& corner, int position, int uv, int normal) {
    CHECK(corner.position == position);
    CHECK(corner.uv == uv);
    CHECK(corner.normal == normal);
}

}  // namespace

TEST_CASE("a triangle of each way to write corners") {
    const std::string lists = square + "vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\nvn 0 0 2\nvn 0 1 1\n";
    const Mesh mesh =
        parse_mesh(lists + "f 1 2 3\nf 1/2 2/3 3/1\nf 1//1 2//2 3//3\nf 4/3/1 3/2/2 2/1/3\n", "m");
    CHECK(mesh.file == "m");
    REQUIRE(mesh.triangles.size() == 4);
    check_corner(mesh.triangles[0][0], 0, -1, -1);
    check_corner(mesh.triangles[1][0], 0, 1, -1);
    check_corner(mesh.triangles[1][2], 2, 0, -1);
    check_corner(mesh.triangles[2][1], 1, -1, 1);
    check_corner(mesh.triangles[3][0], 3, 2, 0);
    CHECK(mesh.positions.at(2) == Vec3(1, 1, 0));
    CHECK(mesh.normals.at(2) == Vec3(0, 1, 1));
    CHECK(mesh.uvs.at(1) == Vec2(1, 0));
}

TEST_CASE("negative indices count from the last vertex before the line") {
    const Mesh mesh = parse_mesh(square + "f -4 -3 -2\nv 5 5 5\nf -1 1 2\n", "m");
    REQUIRE(mesh.triangles.size() == 2);
    CHECK(mesh.triangles[0][0].position == 0);
    CHECK(mesh.triangles[0][2].position == 2);
    CHECK(mesh.triangles[1][0].position == 4);
}

TEST_CASE("polygons are cut into triangles of the same area and orientation") {
    CHECK(parse_mesh(square + "f 1 2 3 4\n", "m").triangles.size() == 2);
    CHECK(area(parse_mesh(square + "f 1 2 3 4\n", "m")) == 1);
    // An L of area 3, which no fan from its first corner would cover.
    const std::string l = "v 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nv 0 0 0\nv 2 0 0\nf 1 2 3 4 5 6\n";
    const Mesh mesh = parse_mesh(l, "m");
    CHECK(mesh.triangles.size() == 4);
    CHECK(area(mesh) == 3);
}

TEST_CASE("numbers are correctly rounded doubles") {
    const Mesh mesh =
        parse_mesh("v 0.1 0.123456789012345678 1e-3\nv 148376.03125 +1 .5\nv 1 0 0\nf 1 2 3\n", "m");
    CHECK(mesh.positions[0] == Vec3(0.1, 0.123456789012345678, 1e-3));
    CHECK(mesh.positions[1] == Vec3(148376.03125, 1, .5));
}

TEST_CASE("everything that is no shape is passed over, and order is that of the file") {
    const Mesh mesh =
        parse_mesh("\xEF\xBB\xBF# made by hand\r\nmtllib none.mtl\r\no thing\r\n" + square +
                       "vw 1 nonsense\ng a\nusemtl red\ns 1\nf 1 2 3 # first\nl 1 2\np 1\n\tf\t2 3 4\t\r\n"
                       "g b\nusemtl blue\nf 3 4 1",
                   "m");
    REQUIRE(mesh.triangles.size() == 3);
    CHECK(mesh.triangles[0][0].position == 0);
    CHECK(mesh.triangles[1][0].position == 1);
    CHECK(mesh.triangles[2][0].position == 2);
}

TEST_CASE("colours and weights behind a position are passed over") {
    const Mesh mesh =
        parse_mesh("v 0 0 0 1 0 0\nv 1 0 0 1\nv 0 1 0 0 1 0\nvt .5\nvt .5 .25 0\nf 1/1 2/2 3/1\n", "m");
    CHECK(mesh.positions.at(1) == Vec3(1, 0, 0));
    CHECK(mesh.uvs.at(0) == Vec2(.5, 0));
    CHECK(mesh.uvs.at(1) == Vec2(.5, .25));
}

TEST_CASE("a normal of length zero counts as none") {
    const Mesh mesh = parse_mesh(square + "vn 0 0 0\nvn 0 0 1\nf 1//1 2//2 3//2\n", "m");
    CHECK(mesh.triangles.at(0)[0].normal == -1);
    CHECK(mesh.triangles.at(0)[1].normal == 1);
}

TEST_CASE("empty parts of a corner are as good as none") {
    const std::string lists = square + "vt .5 .5\nvn 0 0 1\n";
    const Mesh mesh = parse_mesh(lists + "f 1// 2/ 3//1\nf 1/1/ 3/1/1 4/\n", "m");
    REQUIRE(mesh.triangles.size() == 2);
    check_corner(mesh.triangles[0][0], 0, -1, -1);
    check_corner(mesh.triangles[0][1], 1, -1, -1);
    check_corner(mesh.triangles[0][2], 2, -1, 0);
    check_corner(mesh.triangles[1][0], 0, 0, -1);
    check_corner(mesh.triangles[1][1], 2, 0, 0);
    check_corner(mesh.triangles[1][2], 3, -1, -1);
}

TEST_CASE("a backslash at the end of a line joins it with the next, and errors name the line of the word") {
    const Mesh mesh =
        parse_mesh("v 0 0 \\\n 0\nv 1 0\\\r\n0\nv 1 1 0\nv 0 1 \\\r\\\n\\\n0\nf 1 2 \\\n 3 4", "m");
    REQUIRE(mesh.positions.size() == 4);
    CHECK(mesh.positions[1] == Vec3(1, 0, 0));
    CHECK(mesh.positions[3] == Vec3(0, 1, 0));
    CHECK(mesh.triangles.size() == 2);
    CHECK(error_of("v 1 \\\n  2 \\\n   x\n") == "m:3:4: 'x' is not a number");
    CHECK(error_of("v 1 \\\n2 3\nv 1 2 \\\n\nv 1 x 2\n") == "m:3:6: 'v' needs 3 numbers, here are 2");
    CHECK(error_of("# a comment ends with its line \\\nv 1 x 2\n") == "m:2:5: 'x' is not a number");
    CHECK(error_of("v 1 \\ 2 3\n") == "m:1:5: '\\' is not a number");
    CHECK(error_of("v 1 2 \\") == "m:1:6: 'v' needs 3 numbers, here are 2");
}

TEST_CASE("lines end as on Unix, Windows and the old Macintosh, mixed") {
    const Mesh mesh = parse_mesh("# three\rv 0 0 0\rv 1 0 0\r\nv 1 1 0\nf 1 2 3\r\r\n", "m");
    CHECK(mesh.positions.size() == 3);
    CHECK(mesh.triangles.size() == 1);
    CHECK(error_of("v 0 0 0\r\nv 0 0 0\rv 0 0 0\n\rv 0 x 0\n") == "m:5:5: 'x' is not a number");
}

TEST_CASE("a mesh without its free-form surfaces is refused, or warned of when reading leniently") {
    const std::string text = square +
                             "f 1 2 3\ncstype bspline\ndeg 3 3\nsurf 0 1 0 1 1 2 3 4\nparm u 0 1\nend\n" +
                             "surf 0 1 0 1 1 2 3 4\nvw 1\nvw 2\n";
    const std::string message =
        "m:8:1: 'surf': free-form curves and surfaces are not supported; save the model as polygons";
    CHECK(error_of(text) == message);
    std::vector<std::string> warnings;
    CHECK(parse_mesh(text, "m", {.lenient = true, .warnings = &warnings}).triangles.size() == 1);
    CHECK(warnings ==
          std::vector<std::string>{message + " (such lines are skipped)",
                                   "m:12:1: 'vw' is not a statement of these files (such lines are "
                                   "skipped)"});
    CHECK(error_of(square + "curv 0 1 1 2\nf 1 2 3\n").starts_with("m:5:1: 'curv': free-form"));
    CHECK(error_of("call other.obj\n").starts_with("m:1:1: 'call': other files"));
}

TEST_CASE(
    "a comment inside a word is warned of where numbers are read, and NaN of any compiler is an error") {
    std::vector<std::string> warnings;
    const Mesh mesh =
        parse_mesh("g a#1\nv 0 0 0#1\nv 1 0 0\nv 1 1 0\nf 1 2 3\n", "m", {.warnings = &warnings});
    CHECK(mesh.positions.at(0) == Vec3(0));
    CHECK(warnings ==
          std::vector<std::string>{"m:2:8: a comment begins inside a word; put a blank before the '#'"});
    for (const char* word : {"-1.#IND", "1.#QNAN", "1.#INF", "-1.#INF00", "1.#SNAN", "1.#J", "nan", "-nan",
                             "-nan(ind)", "NaN", "inf", "-Infinity", "+inf"}) {
        INFO(word);
        CHECK(error_of("v 0 " + std::string(word) + " 0\n") ==
              "m:1:5: '" + std::string(word) + "' is not a finite number");
    }
    CHECK(error_of("v 0 nanq 0\n") == "m:1:5: 'nanq' is not a number");
}

TEST_CASE("a face that cannot be cut is an error with its line, or skipped when reading leniently") {
    const std::string bow = square + "v 3 0 0\n\n f 1 2 4 3\nf 1 2 3\n";
    CHECK(error_of(bow) == "m:7:2: the face crosses itself");
    CHECK(error_of(square + "v 3 0 0\nf 1 2 5 2\n") == "m:6:1: the face has no area");
    CHECK(error_of(square + "f 1 1 2 2 1\n") == "m:5:1: the face has no area");
    std::vector<std::string> warnings;
    CHECK(parse_mesh(bow, "m", {.lenient = true, .warnings = &warnings}).triangles.size() == 1);
    CHECK(warnings == std::vector<std::string>{"m:7:2: the face crosses itself (skipped)"});
    // Three corners are never cut, and what has no area is never hit.
    CHECK(parse_mesh(square + "f 1 1 2\n", "m").triangles.size() == 1);
}

TEST_CASE("faces of any number of corners keep the order of the file, and their corners' parts") {
    const Mesh mesh = parse_mesh(square + "v .5 2 0\nvt 0 0\nvt 1 0\nvn 0 0 1\n" +
                                     "f 1 2 3\nf 1/1/1 2/2/1 3//1 4\nf 2 3 4\nf 1 2 3 5 4\nf 3 4 1\n",
                                 "m");
    REQUIRE(mesh.triangles.size() == 8);
    CHECK(mesh.triangles[0][0].position == 0);
    CHECK(mesh.triangles[3][0].position == 1);
    CHECK(mesh.triangles[7][0].position == 2);
    for (const std::size_t i : {1u, 2u})
        for (const Mesh::Corner& corner : mesh.triangles[i]) {
            INFO(corner.position);
            CHECK(corner.uv == (corner.position < 2 ? corner.position : -1));
            CHECK(corner.normal == (corner.position < 3 ? 0 : -1));
        }
}

TEST_CASE("what is wrong in a mesh is said with its line") {
    const std::pair<std::string, std::string> wrong[] = {
        {"", "m: has no faces"},
        {square, "m: has no faces"},
        {"v 0 0\n", "m:1:6: 'v' needs 3 numbers, here are 2"},
        {"\nv 0 zero 0\n", "m:2:5: 'zero' is not a number"},
        {"v 0 nan 0\n", "m:1:5: 'nan' is not a finite number"},
        {"v 0 1e999 0\n", "m:1:5: '1e999' is beyond the numbers that a double can hold"},
        {"vn 0 0 inf\n", "m:1:8: 'inf' is not a finite number"},
        {"vt\n", "m:1:3: 'vt' needs 1 number, here are 0"},
        {square + "f 1 2\n", "m:5:6: a face needs at least 3 corners, here are 2"},
        {square + "f 1 2 5\n", "m:5:7: there is no vertex 5: the file has 4"},
        {square + "f 1 2 99999999999\n", "m:5:7: '99999999999': there is no file with so many vertices"},
        {square + "f 1 2 0\n", "m:5:7: '0': indices count from 1"},
        {square + "f 1 2 -5\n", "m:5:7: '-5': the number of vertices before this line is 4"},
        {square + "f 1/1 2/1 3/1\n", "m:5:3: there is no texture coordinate 1: the file has 0"},
        {square + "f 1//2 2//1 3//1\nvn 0 0 1\n", "m:5:3: there is no normal 2: the file has 1"},
        {square + "f 1 2 x\n", "m:5:7: 'x' is not a corner of a face; expected: v, v/vt, v//vn or v/vt/vn"},
        {square + "f /1 2 3\n", "m:5:3: '/1' is not a corner of a face; expected: v, v/vt, v//vn or v/vt/vn"},
        {square + "f 1/1/1/1 2 3\n",
         "m:5:3: '1/1/1/1' is not a corner of a face; expected: v, v/vt, v//vn or v/vt/vn"},
        {square + "f 1.5 2 3\n",
         "m:5:3: '1.5' is not a corner of a face; expected: v, v/vt, v//vn or v/vt/vn"},
        {std::string("v 0 0 0\0", 8), "m:1:8: a zero byte: this is not a text file"},
    };
    for (const auto& [text, message] : wrong) {
        INFO(text);
        CHECK(error_of(text) == message);
    }
}
