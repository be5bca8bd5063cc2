// What crosses between a judge and a worker: values come back as they went, and bytes that are no values are
// refused before they become any.
#include "tests/grading/wire.hpp"
#include "chapters/07_recursion/radiance.hpp"
#include "tests/catch.hpp"

#include <cstring>

using namespace rt;
using grading::BadBytes;
using grading::Reader;
using grading::Writer;

namespace {

template <class T>
T sent(const T& value) {
    Writer out;
    out(value);
    Reader in(out.bytes());
    T back = in.read<T>();
    REQUIRE(in.at_end());
    return back;
}

/// The bytes of some values, one after the other.
template <class... T>
std::vector<std::byte> written(const T&... value) {
    Writer out;
    (out(value), ...);
    return out.bytes();
}

template <class T>
void check_refused(const std::vector<std::byte>& bytes) {
    CHECK_THROWS_AS(Reader(bytes).read<T>(), BadBytes);
}

template <class Number>
Number as(std::uint64_t bits) {
    Number number;
    std::memcpy(&number, &bits, sizeof number);
    return number;
}

std::uint64_t bits_of(Real x) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, &x, sizeof bits);
    return bits;
}

}  // namespace

TEST_CASE("numbers cross to the bit, those that are none too", "[wire]") {
    for (const std::uint64_t bits : {0x0ull, 0x8000000000000000ull, 0x1ull, 0x7ff0000000000000ull,
                                     0x7ff8000000000001ull, 0xfff4000000000123ull, 0x3ff0000000000001ull})
        CHECK(bits_of(sent(as<Real>(bits))) == bits);
    CHECK(sent(std::int32_t{-5}) == -5);
    CHECK(sent(std::uint64_t{1} << 63) == std::uint64_t{1} << 63);
}

TEST_CASE("structs cross field by field, whatever they are made of", "[wire]") {
    Branch branch;
    branch.ray = {{1, 2, 3}, {0, 0, -1}};
    branch.weight = {0.25, 0.5, 1};
    branch.depth = 3;
    branch.kind = RayKind::Refraction;
    branch.media = {{7, 1}, {9, 2}};
    const Branch back = sent(branch);
    CHECK(back.ray.origin == branch.ray.origin);
    CHECK(back.weight == branch.weight);
    CHECK(back.depth == 3);
    CHECK(back.kind == RayKind::Refraction);
    REQUIRE(back.media.size() == 2);
    CHECK(back.media[1].object == 9);

    CHECK(sent(std::optional<Vec3>()) == std::nullopt);
    CHECK(sent(std::optional<Vec3>(Vec3(1, 2, 3))) == Vec3(1, 2, 3));
    CHECK(sent(std::string("a\0b", 3)) == std::string("a\0b", 3));
}

TEST_CASE("all that two pointers share is still shared after it has crossed", "[wire]") {
    const auto mesh = std::make_shared<SharedMesh>();
    mesh->triangles.shapes = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}};
    mesh->triangles.normals.resize(1);
    mesh->bound = {{1, 2, 3}, 4};
    World world;
    world.meshes = {mesh};
    Group<Instance> group;
    group.shapes.resize(2);
    group.shapes[0].shape.mesh = group.shapes[1].shape.mesh = mesh;
    world.groups = {group};

    const World back = sent(world);
    const auto& shapes = std::get<Group<Instance>>(back.groups.at(0)).shapes;
    CHECK(shapes[0].shape.mesh == back.meshes.at(0));
    CHECK(shapes[1].shape.mesh == back.meshes.at(0));
    CHECK(back.meshes[0]->bound.radius == 4);
    CHECK(back.meshes[0]->triangles.shapes.at(0).b == Vec3(1, 0, 0));
    CHECK(back.meshes[0]->triangles.normals.size() == 1);
}

TEST_CASE("a truth value is 0 or 1", "[wire]") {
    CHECK(Reader(written(std::uint8_t{1})).read<bool>());
    check_refused<bool>(written(std::uint8_t{2}));
    check_refused<bool>(written(std::uint8_t{7}));
    check_refused<std::optional<Real>>(written(std::uint8_t{255}, 1.0));
}

TEST_CASE("an enumeration has only its own values", "[wire]") {
    CHECK(Reader(written(2)).read<RayKind>() == RayKind::Refraction);
    check_refused<RayKind>(written(3));
    check_refused<RayKind>(written(-1));
    check_refused<RayKind>(written(1'000'000));
}

TEST_CASE("lists are no longer than their bytes, and are not nested without end", "[wire]") {
    check_refused<std::vector<Vec3>>(written(~std::uint64_t{0}));
    check_refused<std::vector<Vec3>>(written(std::uint64_t{2}, Vec3(1), 1.0));
    check_refused<std::string>(written(std::uint64_t{1} << 40));
    check_refused<std::vector<Grid>>(written(std::uint64_t{1} << 40));
    check_refused<Real>({});

    Grid grid;
    for (int i = 0; i < 100; ++i) {
        Grid around;
        around.grids.push_back(std::move(grid));
        grid = std::move(around);
    }
    check_refused<Grid>(written(grid));
}

TEST_CASE("an image has as many pixels as it says", "[wire]") {
    CHECK(sent(make_image(3, 2)).pixels.size() == 6);
    Image image = make_image(3, 2);
    image.pixels.pop_back();
    check_refused<Image>(written(image));
    image = make_image(3, 2);
    image.width = image.height = -1;
    image.pixels.resize(1);
    check_refused<Image>(written(image));
}

TEST_CASE("a variant has only its own alternatives, and what is shared must be there", "[wire]") {
    check_refused<TransformStep>(written(std::uint8_t{3}, Vec3(1)));
    // It names an object that there is not.
    check_refused<std::shared_ptr<SharedMesh>>(written(std::uint32_t{5}));
}
