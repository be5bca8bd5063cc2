// Commands that put objects into the scene, and the vertices that some of them are made of.
#include "common/scene/language/arguments.hpp"
#include "common/scene/language/commands.hpp"
#include "common/scene/mesh_file.hpp"
#include "common/scene/range.hpp"
#include "common/scene/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

namespace rt::language {

namespace {

/// The index of what is in force in its list, at whose end it may stand already; −1 if it is nothing special.
template <class What>
std::int32_t index_in(std::vector<What>& list, const What& in_force) {
    if (in_force == What{}) return -1;
    if (list.empty() || list.back() != in_force) list.push_back(in_force);
    return static_cast<std::int32_t>(list.size()) - 1;
}

/// Refuses rough glass of an index of refraction for which there is no lobe.
void require_index_of_glass(const Parser& parser) {
    const Real ior = parser.material.ior;
    if (parser.finish.kind == FinishKind::Glass && !(ior >= 1.01 && ior <= 4))
        fail(parser, parser.words[0],
             "'finish glass' takes an 'ior' from 1.01 to 4, and the one in force is " + shown(ior));
}

/// The index of the material in force.
std::uint32_t material_in_force(Parser& parser) {
    require_index_of_glass(parser);
    parser.material.texturing = index_in(parser.scene.texturings, parser.texturing);
    parser.material.finish = index_in(parser.scene.finishes, parser.finish);
    std::vector<Material>& materials = parser.scene.materials;
    if (materials.empty() || !(materials.back() == parser.material)) materials.push_back(parser.material);
    return static_cast<std::uint32_t>(materials.size() - 1);
}

/// Refuses a part of the open combination that is of another material.
void require_its_material(const Parser& parser, std::uint32_t material) {
    const OpenCombination& whole = parser.combinations.back();
    if (material != whole.material)
        fail(parser, parser.words[0],
             "a solid is of one material, the one in force at its '" + whole.word + "' in line " +
                 std::to_string(whole.place.line) + ": this part has another");
}

/// Refuses what has no inside as a part of the open combination.
void require_inside(const Parser& parser, const FileShape& shape) {
    const FileShapeWords& words = words_of(shape);
    if (!words.has_inside)
        fail(parser, parser.words[0],
             "'" + parser.combinations.back().word + "' takes solids only, and this " +
                 std::string(words.name) + " has no inside");
}

/// Adds a whole object to the scene or, where a combination is open, as its next part.
void append(Parser& parser, Object object) {
    if (parser.combinations.empty()) return parser.scene.objects.push_back(std::move(object));
    parser.combinations.back().made.parts.push_back(static_cast<std::uint32_t>(parser.scene.parts.size()));
    parser.scene.parts.push_back(std::move(object));
}

/// The shape as an object, with the material and transform in force.
void add_object(Parser& parser, FileShape shape) {
    const std::uint32_t material = material_in_force(parser);
    if (!parser.combinations.empty()) {
        require_inside(parser, shape);
        require_its_material(parser, material);
    }
    append(parser,
           {std::move(shape), material, parser.transform, place_of(parser, parser.words[0]), parser.motion});
}

void add_triangle(Parser& parser) {
    TriangleObject triangle;
    for (std::size_t i = 0; i < 3; ++i)
        triangle.vertex[i] = index(parser, i + 1, parser.scene.vertices.size(), "vertex");
    add_object(parser, triangle);
}

void add_smooth_triangle(Parser& parser) {
    TriangleObject triangle{{}, true};
    for (std::size_t i = 0; i < 3; ++i)
        triangle.vertex[i] = index(parser, i + 1, parser.scene.smooth_vertices.size(), "vertexnormal");
    add_object(parser, triangle);
}

void add_polygon(Parser& parser) {
    PolygonObject polygon;
    for (std::size_t i = 1; i < parser.words.size(); ++i)
        polygon.vertex.push_back(index(parser, i, parser.scene.vertices.size(), "vertex"));
    add_object(parser, std::move(polygon));
}

void read_new_mesh(Parser& parser, const std::filesystem::path& path, std::string_view word) {
    std::vector<std::string> warnings;
    try {
        parser.scene.meshes.push_back(
            read_mesh(path, {.lenient = parser.options.lenient, .warnings = &warnings}));
    } catch (const InputError& problem) {
        fail(parser, word, std::string("mesh ") + problem.what());
    }
    for (const std::string& warning : warnings) warn(parser, word.data(), "mesh " + warning);
    parser.scene.meshes.back().file = word;
}

void add_mesh(Parser& parser) {
    const std::string_view word = parser.words[1];
    const std::filesystem::path path = file_named(parser, word);
    const auto [found, is_new] = parser.mesh_of_file.try_emplace(
        whole_path(path), static_cast<std::uint32_t>(parser.scene.meshes.size()));
    if (is_new) read_new_mesh(parser, path, word);
    add_object(parser, MeshObject{found->second});
}

/// From two opposite corners, in whichever order; the first argument is the i-th.
Box box(const Parser& parser, std::size_t i) {
    const Vec3 one = place3(parser, i), other = place3(parser, i + 3);
    for (int axis = 0; axis < 3; ++axis)
        if (one[axis] == other[axis])
            fail(parser, parser.words[i + 3 + static_cast<std::size_t>(axis)],
                 "the box has no thickness along " +
                     std::string("xyz").substr(static_cast<std::size_t>(axis), 1) + ": both corners are at " +
                     shown(one[axis]));
    return {glm::min(one, other), glm::max(one, other)};
}

/// The rest of the line is the expression.
Implicit implicit(const Parser& parser) {
    const Box around = box(parser, 1);
    const std::string_view first = parser.words[7], last = parser.words.back();
    const std::string_view text(first.data(),
                                static_cast<std::size_t>(last.data() + last.size() - first.data()));
    try {
        return {around, std::make_shared<const Formula>(parse_formula(text))};
    } catch (const FormulaError& problem) {
        fail(parser, text.substr(problem.at), problem.what());
    }
}

Quadric quadric(const Parser& parser) {
    std::array<Real, 10> c{};
    for (std::size_t i = 0; i < c.size(); ++i) {
        c[i] = number(parser, i + 1);
        if (std::abs(c[i]) > largest_number)
            fail(parser, parser.words[i + 1],
                 "coefficients beyond " + shown(largest_number) + " are not possible, and this is " +
                     shown(c[i]));
    }
    if (std::all_of(c.begin(), c.end() - 1, [](Real one) { return one == 0; }))
        fail(parser, parser.words[1], "A to I are all 0, so it has no surface");
    // It is the same surface with all of them a power of two times as large; where they are tiny, their
    // squares would vanish.
    Real greatest = 0;
    for (const Real one : c) greatest = std::max(greatest, std::abs(one));
    if (greatest < smallest_size)
        for (Real& one : c) one = std::ldexp(one, -std::ilogb(greatest));
    return {{c[0], c[1], c[2]}, {c[3], c[4], c[5]}, {c[6], c[7], c[8]}, c[9], box(parser, 11)};
}

/// A radius that may be 0, where the cone has its apex.
Real radius_or_apex(const Parser& parser, std::size_t i) {
    return not_negative(parser, i, "the radius") == 0 ? 0 : sized(parser, i, "the radius");
}

/// The cone, if its ends are apart; the words of its second end begin at `b`.
Cone checked(const Parser& parser, const Cone& cone, std::size_t b) {
    const Real size = size_of(cone.b - cone.a);
    if (size < smallest_size)
        fail(parser, parser.words[b],
             size == 0 ? "both ends are the same point"
                       : "the ends are " + shown(size) + " apart, less than " + shown(smallest_size));
    return cone;
}

Cone cylinder(const Parser& parser) {
    const Vec3 a = place3(parser, 1), b = place3(parser, 4);
    const Real radius = sized(parser, 7, "the radius");
    return checked(parser, {a, radius, b, radius}, 4);
}

Cone cone(const Parser& parser) {
    const Vec3 a = place3(parser, 1), b = place3(parser, 5);
    const Real radius_a = radius_or_apex(parser, 4), radius_b = radius_or_apex(parser, 8);
    if (radius_a == 0 && radius_b == 0) fail(parser, parser.words[8], "only one radius of a cone may be 0");
    return checked(parser, {a, radius_a, b, radius_b}, 5);
}

/// One inside the other; more would be nothing but a mistake of the program that wrote the file.
constexpr std::size_t most_open_combinations = 1000;

template <SetOperation operation>
void open_combination(Parser& parser) {
    if (parser.combinations.size() == most_open_combinations)
        fail(parser, parser.words[0],
             "more than " + std::to_string(most_open_combinations) + " solids inside each other");
    const std::uint32_t material = material_in_force(parser);
    if (!parser.combinations.empty()) require_its_material(parser, material);
    parser.combinations.push_back({{operation, {}},
                                   std::string(parser.words[0]),
                                   place_of(parser, parser.words[0]),
                                   material,
                                   parser.motion});
}

void close_combination(Parser& parser) {
    if (parser.combinations.empty())
        fail(parser, parser.words[0], "'end' without a 'union', 'intersection' or 'difference' before it");
    OpenCombination whole = std::move(parser.combinations.back());
    parser.combinations.pop_back();
    if (whole.made.parts.size() < 2)
        fail(parser, parser.words[0],
             "'" + whole.word + "' needs at least 2 solids, but has " +
                 std::to_string(whole.made.parts.size()));
    append(parser, {std::move(whole.made), whole.material, -1, whole.place,
                    whole.motion});  // its parts have transforms
}

const CommandRow rows[] = {
    {{"plane", "px py pz nx ny nz",
      "Plane through (px, py, pz) with the normal (nx, ny, nz), of any length but 0.", "01"},
     [](Parser& p) {
         add_object(p, Plane{vec3(p, 1), direction(p, 4, "the normal")});
     }},
    {{"sphere", "x y z r", "Sphere with centre (x, y, z) and radius r > 0.", "02"},
     [](Parser& p) {
         add_object(p, Sphere{vec3(p, 1), positive(p, 4, "the radius")});
     }},
    {{"maxverts", "n",
      "Number of `vertex` lines to expect; accepted because old scenes say it, and not trusted.", "03"},
     [](Parser& p) { whole(p, 1, "the number of vertices", 0, 0x1p53); }},
    {{"maxvertnorms", "n", "The same for `vertexnormal` lines.", "03"},
     [](Parser& p) { whole(p, 1, "the number of vertices", 0, 0x1p53); }},
    {{"vertex", "x y z", "Appended to the list of vertices, which are counted from 0; not transformed here.",
      "03"},
     [](Parser& p) { p.scene.vertices.push_back(vec3(p, 1)); }},
    {{"tri", "a b c",
      "Triangle of three vertices, counterclockwise seen from the side that its normal points to.", "03"},
     add_triangle},
    {{"vertexnormal", "x y z nx ny nz",
      "Appended to a second list, of vertices with normals, of any length but 0; also counted from 0.", "03"},
     [](Parser& p) {
         p.scene.smooth_vertices.push_back({vec3(p, 1), direction(p, 4, "the normal")});
     }},
    {{"trinormal", "a b c", "Triangle of three vertices of the second list, with interpolated normals.",
      "03"},
     add_smooth_triangle},
    {{"polygon", "i j k ...", "Planar polygon of three vertices or more of the first list, in order.", "03"},
     add_polygon},
    {{"mesh", "file.obj",
      "The triangles of a Wavefront file, its path relative to the scene's; the name is without blanks. A "
      "file that several objects name is read once.",
      "03"},
     add_mesh},
    {{"box", "x0 y0 z0 x1 y1 z1", "Box along the axes, from one corner to the opposite one.", "10"},
     [](Parser& p) { add_object(p, box(p, 1)); }},
    {{"disc", "x y z nx ny nz r",
      "Disc around the centre (x, y, z), with the normal (nx, ny, nz), of any length but 0, and the radius r "
      "> 0.",
      "10"},
     [](Parser& p) {
         add_object(p,
                    Disc{place3(p, 1), near_one(direction(p, 4, "the normal")), sized(p, 7, "the radius")});
     }},
    {{"cylinder", "x0 y0 z0 x1 y1 z1 r",
      "Cylinder of radius r > 0 about the axis from (x0, y0, z0) to (x1, y1, z1), with flat ends.", "10"},
     [](Parser& p) { add_object(p, cylinder(p)); }},
    {{"openCylinder", "x0 y0 z0 x1 y1 z1 r", "The same without the ends: a tube.", "10"},
     [](Parser& p) { add_object(p, OpenCone{cylinder(p)}); }},
    {{"cone", "x0 y0 z0 r0 x1 y1 z1 r1",
      "Cone about the axis from (x0, y0, z0), where its radius is r0, to (x1, y1, z1), where it is r1, with "
      "flat "
      "ends. One radius may be 0.",
      "10"},
     [](Parser& p) { add_object(p, cone(p)); }},
    {{"openCone", "x0 y0 z0 r0 x1 y1 z1 r1", "The same without the ends: a funnel.", "10"},
     [](Parser& p) { add_object(p, OpenCone{cone(p)}); }},
    {{"torus", "x y z ax ay az R r",
      "Torus around the centre (x, y, z), with the axis (ax, ay, az), of any length but 0: a tube of radius "
      "r > 0 whose "
      "middle is a ring of radius R > 0. Where r is R or more, the hole is closed.",
      "10"},
     [](Parser& p) {
         add_object(p, Torus{place3(p, 1), near_one(direction(p, 4, "the axis")),
                             sized(p, 7, "the radius of the ring"), sized(p, 8, "the radius of the tube")});
     }},
    {{"implicit", "x0 y0 z0 x1 y1 z1 expression ...",
      "Where the expression is 0, in the box between two corners; inside is where it is negative. The rest "
      "of the line "
      "is the expression: numbers, `x`, `y`, `z`, `+ - * / ^`, parentheses, `sqrt`, `exp`, `log` (natural), "
      "`sin`, "
      "`cos`, `abs`, `min(a, b)`, `max(a, b)`. `-x^2` is -(x^2); powers other than whole numbers from -64 to "
      "64 have no value where the base is negative.",
      "10"},
     [](Parser& p) { add_object(p, implicit(p)); }},
    {{"quadric", "A B C D E F G H I J x0 y0 z0 x1 y1 z1",
      "Ax^2 + By^2 + Cz^2 + Dxy + Exz + Fyz + Gx + Hy + Iz + J = 0 in the box between two corners; inside is "
      "where it is "
      "negative.",
      "10"},
     [](Parser& p) { add_object(p, quadric(p)); }},
    {{"union", "", "What is inside any of the solids from here to the matching `end`, as one solid.", "10"},
     open_combination<SetOperation::Union>},
    {{"intersection", "", "What is inside all of the solids from here to the matching `end`.", "10"},
     open_combination<SetOperation::Intersection>},
    {{"difference", "",
      "What is inside the first of the solids from here to the matching `end`, but in none of the others.",
      "10"},
     open_combination<SetOperation::Difference>},
    {{"end", "",
      "Ends a `union`, an `intersection` or a `difference`; these may stand inside others. The whole has one "
      "material, the one in force where it begins; its parts have their own transforms.",
      "10"},
     close_combination},
};

}  // namespace

void require_closed_combinations(const Parser& parser) {
    if (parser.combinations.empty()) return;
    const OpenCombination& whole = parser.combinations.back();
    fail_at(parser, whole.place, "'" + whole.word + "' has no 'end'");
}

std::span<const CommandRow> shape_commands() { return rows; }

}  // namespace rt::language
