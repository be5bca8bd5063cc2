// Meshes from `.obj` files: what is read, how polygons are cut, and what is refused.
#include "common/scene/mesh_file.hpp"

#include "common/math/input_error.hpp"
#include "tests/catch.hpp"

using namespace rt;

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

std::string error_of(const std::string& text) {
    try {
        parse_mesh(text, "m");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
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

TEST_CASE("what is wrong in a mesh is said with its line") {
    const std::pair<std::string, std::string> wrong[] = {
        {"", "m: has no faces"},
        {square, "m: has no faces"},
        {"v 0 0\n", "m:1: 'v' needs 3 numbers, here are 2"},
        {"\nv 0 zero 0\n", "m:2: 'zero' is not a number"},
        {"v 0 nan 0\n", "m:1: 'nan' is not a finite number"},
        {"v 0 1e999 0\n", "m:1: '1e999' is beyond the numbers that a double can hold"},
        {"vn 0 0 inf\n", "m:1: 'inf' is not a finite number"},
        {"vt\n", "m:1: 'vt' needs 1 number, here are 0"},
        {square + "f 1 2\n", "m:5: a face needs at least 3 corners, here are 2"},
        {square + "f 1 2 5\n", "m:5: there is no vertex 5: the file has 4"},
        {square + "f 1 2 99999999999\n", "m:5: there is no vertex 99999999999: the file has 4"},
        {square + "f 1 2 0\n", "m:5: '0': indices count from 1"},
        {square + "f 1 2 -5\n", "m:5: '-5': the number of vertices before this line is 4"},
        {square + "f 1/1 2/1 3/1\n", "m:5: there is no texture coordinate 1: the file has 0"},
        {square + "f 1//2 2//1 3//1\nvn 0 0 1\n", "m:5: there is no normal 2: the file has 1"},
        {square + "f 1 2 x\n", "m:5: 'x' is not a corner of a face; expected: v, v/vt, v//vn or v/vt/vn"},
        {square + "f 1/ 2/ 3/\n", "m:5: '1/' is not a corner of a face; expected: v, v/vt, v//vn or v/vt/vn"},
        {square + "f 1/1/1/1 2 3\n",
         "m:5: '1/1/1/1' is not a corner of a face; expected: v, v/vt, v//vn or v/vt/vn"},
        {square + "f 1.5 2 3\n", "m:5: '1.5' is not a corner of a face; expected: v, v/vt, v//vn or v/vt/vn"},
        {std::string("v 0 0 0\0", 8), "m: a zero byte: this is not a text file"},
    };
    for (const auto& [text, message] : wrong) {
        INFO(text);
        CHECK(error_of(text) == message);
    }
}
