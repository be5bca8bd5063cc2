// Polygons cut into triangles: plain cases, then random outlines whose cut is judged by whole numbers.
#include "common/scene/cut_polygon.hpp"

#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

using namespace rt;

namespace {

/// A corner on whole numbers, so that areas are exact.
struct Point {
    long x = 0, y = 0;
    auto operator<=>(const Point&) const = default;
};
using Outline = std::vector<Point>;

/// Twice the signed area of a triangle.
long area(const Point& a, const Point& b, const Point& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Twice the signed area of a polygon.
long area(const Outline& p) {
    long sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Point &a = p[i], &b = p[(i + 1) % p.size()];
        sum += a.x * b.y - a.y * b.x;
    }
    return sum;
}

/// Stands the outline across an axis, scaled and moved.
std::vector<Vec3> corners_of(const Outline& outline, int axis = 2, Real scale = 1,
                             const Vec3& place = Vec3(0)) {
    std::vector<Vec3> corners;
    for (const Point& p : outline) {
        Vec3 corner(0);
        corner[(axis + 1) % 3] = static_cast<Real>(p.x);
        corner[(axis + 2) % 3] = static_cast<Real>(p.y);
        corners.push_back(scale * (corner + place));
    }
    return corners;
}

std::string text_of(const Outline& outline) {
    std::ostringstream text;
    for (const Point& p : outline) text << '(' << p.x << ' ' << p.y << ") ";
    return text.str();
}

/// Triangles that all go around as the outline does, and whose areas add up to its own, cover every point
/// just as often as the outline goes around it, because their sides inside cancel.
void check_cut(const Outline& outline, const PolygonCut& cut) {
    INFO(text_of(
        {outline.begin(), outline.begin() + static_cast<long>(std::min<std::size_t>(outline.size(), 40))}));
    REQUIRE(std::string(cut.problem) == "");
    const long whole = area(outline);
    long sum = 0;
    std::size_t wrong = 0;
    for (const auto& [a, b, c] : cut.triangles) {
        REQUIRE(std::max({a, b, c}) < outline.size());
        const long part = area(outline[a], outline[b], outline[c]);
        wrong += (part > 0) != (whole > 0) || part == 0;
        sum += part;
    }
    CHECK(wrong == 0);
    CHECK(sum == whole);
}

void check_cut(const Outline& outline) { check_cut(outline, cut_polygon(corners_of(outline))); }

std::string problem_of(const Outline& outline) {
    return std::string(cut_polygon(corners_of(outline)).problem);
}

int sign(long x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

/// Whether two sides that share no corner meet anywhere.
bool meet(const Point& a, const Point& b, const Point& c, const Point& d) {
    const int of_c = sign(area(a, b, c)), of_d = sign(area(a, b, d)), of_a = sign(area(c, d, a)),
              of_b = sign(area(c, d, b));
    const auto between = [](const Point& p, const Point& q, const Point& r) {
        return std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= r.y &&
               r.y <= std::max(p.y, q.y);
    };
    return (of_c != of_d && of_a != of_b) || (of_c == 0 && between(a, b, c)) ||
           (of_d == 0 && between(a, b, d)) || (of_a == 0 && between(c, d, a)) ||
           (of_b == 0 && between(c, d, b));
}

/// A random simple polygon of different corners in a square of whole numbers: sides that meet are uncrossed
/// until none do. Empty where that comes to no end or to no area.
Outline simple_polygon(test::Random& random, std::size_t count, std::size_t side) {
    std::set<Point> used;
    Outline p;
    while (p.size() < count) {
        const Point point{static_cast<long>(random.index(side)), static_cast<long>(random.index(side))};
        if (used.insert(point).second) p.push_back(point);
    }
    for (std::size_t round = 0; round < 100 * count; ++round) {
        bool met = false;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = i + 2; j < count; ++j) {
                if (i == 0 && j + 1 == count) continue;
                if (!meet(p[i], p[i + 1], p[j], p[(j + 1) % count])) continue;
                std::reverse(p.begin() + static_cast<long>(i) + 1, p.begin() + static_cast<long>(j) + 1);
                met = true;
            }
        if (!met) return area(p) == 0 ? Outline() : p;
    }
    return {};
}

/// Triangles of a lattice, each new one glued to a side of the outline: where they meet again sides lie on
/// one another and corners at one place, as where holes are joined to the outline.
Outline glued_triangles(test::Random& random, long width, long height, std::size_t count) {
    const auto near = [](const Point& a, const Point& b) {
        const Point d{b.x - a.x, b.y - a.y};
        return std::abs(d.x) <= 1 && std::abs(d.y) <= 1 && d.x != d.y;
    };
    const auto triangle = [](Point a, Point b, Point c) {
        std::array<Point, 3> t{a, b, c};
        std::sort(t.begin(), t.end());
        return t;
    };
    Outline p{{0, 0}, {1, 0}, {0, 1}};
    std::set<std::array<Point, 3>> used{triangle(p[0], p[1], p[2])};
    for (std::size_t failed = 0; used.size() < count && failed < 1000; ++failed) {
        const std::size_t i = random.index(p.size());
        const Point a = p[i], b = p[(i + 1) % p.size()];
        for (long dx = -1; dx <= 1; ++dx)
            for (long dy = -1; dy <= 1; ++dy) {
                const Point c{a.x + dx, a.y + dy};
                if (c.x < 0 || c.y < 0 || c.x > width || c.y > height || area(a, b, c) != -1 || !near(a, c) ||
                    !near(b, c) || p[i] != a || p[(i + 1) % p.size()] != b ||
                    !used.insert(triangle(a, b, c)).second)
                    continue;
                p.insert(p.begin() + static_cast<long>(i) + 1, c);
                failed = 0;
            }
    }
    return p;
}

const Outline comb{{-8, -8}, {8, -8}, {8, 8},  {6, 8},   {6, -6}, {2, -6},
                   {2, 8},   {0, 8},  {0, -6}, {-4, -6}, {-4, 8}, {-8, 8}};

}  // namespace

TEST_CASE("a notched quadrilateral is cut through its notch, whichever corner comes first", "[cut]") {
    Outline dart{{0, 8}, {-1, -2}, {0, 4}, {1, -2}};
    for (int i = 0; i < 4; ++i) {
        check_cut(dart);
        CHECK(cut_polygon(corners_of(dart)).triangles.size() == 2);
        std::rotate(dart.begin(), dart.begin() + 1, dart.end());
    }
    check_cut({{3, 5}, {5, 6}, {7, 5}, {2, 3}, {3, 4}});
    check_cut(comb);
}

TEST_CASE("a quadrilateral is cut along its shorter diagonal, a convex polygon into a fan", "[cut]") {
    using Triangles = std::vector<std::array<std::uint32_t, 3>>;
    CHECK(cut_polygon(corners_of({{0, 0}, {2, 0}, {3, 2}, {0, 1}})).triangles ==
          Triangles{{0, 1, 3}, {1, 2, 3}});
    CHECK(cut_polygon(corners_of({{0, 0}, {3, 0}, {2, 2}, {-1, 1}})).triangles ==
          Triangles{{0, 1, 2}, {0, 2, 3}});
    CHECK(cut_polygon(corners_of({{0, 0}, {2, 0}, {3, 2}, {1, 3}, {-1, 2}})).triangles ==
          Triangles{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}});
}

TEST_CASE("corners that lie straight between their neighbours are corners of triangles with area", "[cut]") {
    const Outline square{{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 1}, {3, 3}, {1, 3}, {0, 3}, {0, 2}};
    check_cut(square);
    CHECK(cut_polygon(corners_of(square)).triangles.size() == square.size() - 2);
    const Outline triangle{{0, 0}, {1, 1}, {2, 0}, {1, 0}};
    check_cut(triangle);
    CHECK(cut_polygon(corners_of(triangle)).triangles.size() == 2);
}

TEST_CASE("holes may be joined to the outline by cuts that are gone along twice", "[cut]") {
    const Outline frame{{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {2, 2}, {2, 4}, {4, 4}, {4, 2}, {2, 2}};
    check_cut(frame);
    CHECK(area(frame) == 2 * 32);
    CHECK(cut_polygon(corners_of(frame)).triangles.size() == frame.size() - 2);
    // Two holes, one joined to the other; and a hole that touches the outline in the middle of a side.
    check_cut({{0, 0},
               {9, 0},
               {9, 4},
               {0, 4},
               {0, 0},
               {1, 1},
               {1, 2},
               {2, 2},
               {5, 2},
               {5, 3},
               {6, 3},
               {6, 2},
               {5, 2},
               {2, 2},
               {2, 1},
               {1, 1}});
    check_cut({{0, 0}, {3, 0}, {2, 1}, {3, 2}, {4, 1}, {3, 0}, {6, 0}, {6, 6}, {0, 6}});
    check_cut({{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}, {3, 3}, {1, 4}, {0, 4}, {1, 4}, {3, 3}});
    // A spike outwards, with a bend.
    check_cut({{0, 0}, {3, 0}, {3, 3}, {4, 5}, {6, 6}, {4, 5}, {3, 3}, {0, 3}});
}

TEST_CASE("corners given twice in a row count once", "[cut]") {
    const Outline square{{0, 0}, {0, 0}, {2, 0}, {2, 2}, {2, 2}, {0, 2}, {0, 0}};
    check_cut(square);
    CHECK(cut_polygon(corners_of(square)).triangles.size() == 2);
}

TEST_CASE("a quadrilateral that folds back on itself has one triangle without area", "[cut]") {
    const auto twice_areas = [](const Outline& p) {
        const PolygonCut cut = cut_polygon(corners_of(p));
        CHECK(std::string(cut.problem) == "");
        std::multiset<long> areas;
        for (const auto& [a, b, c] : cut.triangles) areas.insert(std::abs(area(p[a], p[b], p[c])));
        return areas;
    };
    const std::multiset<long> expected{0, 9};
    CHECK(twice_areas({{3, 0}, {1, 0}, {3, 9}, {0, 0}}) == expected);
    CHECK(twice_areas({{3, 0}, {1, 0}, {1, 0}, {3, 9}, {0, 0}, {0, 0}, {3, 0}}) == expected);
}

TEST_CASE("outlines that cross themselves and those without an area are refused", "[cut]") {
    CHECK(problem_of({{0, 0}, {2, 2}, {2, 0}, {0, 2}}) == "crosses itself");
    CHECK(problem_of({{0, 0}, {4, 2}, {4, 0}, {1, 3}}) == "crosses itself");
    CHECK(problem_of({{0, 10}, {6, -8}, {-10, 3}, {10, 3}, {-6, -8}}) == "crosses itself");  // a pentagram
    // Around twice, one round within the other; and a strip that comes back over itself.
    CHECK(problem_of({{0, 0}, {9, 0}, {9, 9}, {1, 9}, {1, 1}, {8, 1}, {8, 8}, {0, 8}}) == "crosses itself");
    CHECK(problem_of({{0, 0}, {9, 0}, {9, 9}, {4, 9}, {4, -2}, {5, -2}, {5, 8}, {8, 8}, {8, 1}, {0, 1}}) ==
          "crosses itself");
    CHECK(problem_of({{0, 0}, {1, 1}, {2, 0}, {2, 2}, {1, 1}, {0, 2}}) == "");  // touches itself
    CHECK(problem_of({{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {0, 2}}) == "crosses itself");
    CHECK(problem_of({{0, 0}, {1, 0}, {2, 0}, {5, 0}}) == "has no area");
    CHECK(problem_of({{0, 0}, {1, 2}, {3, 3}, {1, 2}}) == "has no area");
    CHECK(problem_of({{1, 1}, {1, 1}, {1, 1}, {1, 1}}) == "has no area");
    CHECK(std::string(cut_polygon({}).problem) == "has no area");
}

TEST_CASE("neither the axis, the place nor the scale of a polygon changes how it is cut", "[cut]") {
    test::Random random(3);
    for (int i = 0; i < test::cases(300); ++i) {
        const Outline outline = simple_polygon(random, 4 + random.index(12), 40);
        if (outline.empty()) continue;
        const PolygonCut cut = cut_polygon(corners_of(outline));
        check_cut(outline, cut);
        const Vec3 place{std::round(random.uniform(-1e12, 1e12)), std::round(random.uniform(-1e12, 1e12)),
                         std::round(random.uniform(-1e12, 1e12))};
        for (int axis = 0; axis < 3; ++axis)
            for (const Real scale : {1.0, 0x1p-700, 0x1p900, 0x1p-1070})
                for (const Vec3& at : {Vec3(0), place}) {
                    INFO(text_of(outline)
                         << axis << ' ' << scale << ' ' << at.x << ' ' << at.y << ' ' << at.z);
                    const PolygonCut other = cut_polygon(corners_of(outline, axis, scale, at));
                    CHECK(std::string(other.problem) == "");
                    CHECK((other.triangles == cut.triangles));
                }
    }
}

TEST_CASE("random simple polygons are cut into triangles that use every corner", "[cut]") {
    test::Random random(1);
    int cut = 0;
    for (int i = 0; i < test::cases(20000); ++i) {
        Outline outline =
            simple_polygon(random, 4 + random.index(12), 4 + random.index(13) * random.index(60));
        if (outline.empty()) continue;
        if (random.index(2)) std::reverse(outline.begin(), outline.end());
        const PolygonCut result = cut_polygon(corners_of(outline));
        check_cut(outline, result);
        CHECK(result.triangles.size() == outline.size() - 2);
        ++cut;
    }
    CHECK(cut > test::cases(20000) / 2);
}

TEST_CASE("random outlines that touch themselves everywhere are cut", "[cut]") {
    test::Random random(2);
    for (int i = 0; i < test::cases(10000); ++i) {
        const long width = 1 + static_cast<long>(random.index(8)),
                   height = 1 + static_cast<long>(random.index(8));
        Outline outline = glued_triangles(random, width, height,
                                          1 + random.index(static_cast<std::size_t>(2 * width * height)));
        if (random.index(2)) std::reverse(outline.begin(), outline.end());
        std::rotate(outline.begin(), outline.begin() + static_cast<long>(random.index(outline.size())),
                    outline.end());
        check_cut(outline);
    }
}

TEST_CASE("random outlines that cross themselves are all refused", "[cut]") {
    test::Random random(4);
    int crossed = 0;
    for (int i = 0; i < test::cases(20000); ++i) {
        Outline p(4 + random.index(7));
        for (Point& point : p)
            point = {static_cast<long>(random.index(50)), static_cast<long>(random.index(50))};
        const auto side = [&](std::size_t k) { return std::pair(p[k], p[(k + 1) % p.size()]); };
        bool crosses = false;
        for (std::size_t k = 0; k < p.size(); ++k)
            for (std::size_t l = k + 1; l < p.size(); ++l) {
                const auto [a, b] = side(k);
                const auto [c, d] = side(l);
                const bool here = sign(area(a, b, c)) * sign(area(a, b, d)) < 0 &&
                                  sign(area(c, d, a)) * sign(area(c, d, b)) < 0;
                // Where a third side goes through the crossing it may be no crossing of the outline.
                bool alone = true;
                for (const Point& q : p) alone = alone && (area(a, b, q) != 0 || area(c, d, q) != 0);
                crosses = crosses || (here && alone);
            }
        if (!crosses) continue;
        ++crossed;
        INFO(text_of(p));
        CHECK(problem_of(p) == "crosses itself");
    }
    CHECK(crossed > test::cases(20000) / 2);
}

TEST_CASE("polygons of many corners are cut in about n log n steps", "[cut]") {
    // 200,000 corners took a minute once, and take seconds at worst now: whoever waits longer has n² steps.
    const long count = test::cases(200000);
    test::Random random(5);
    Outline star, teeth, turned, terrain;
    for (long i = 0; i < count; ++i) {
        const Real angle = 2 * pi * static_cast<Real>(i) / static_cast<Real>(count);
        const Real radius = random.uniform(0.2, 1) * 0x1p29;
        star.push_back({std::lround(radius * std::cos(angle)), std::lround(radius * std::sin(angle))});
        terrain.push_back({10 * i, static_cast<long>(random.index(10000))});
        teeth.push_back({2 * i, (i + 1) / 2 % 2 * 1000000});
    }
    terrain.insert(terrain.end(), {{10 * count, -1000000}, {-10, -1000000}, {-20, 1L << 34}});
    teeth.insert(teeth.end(), {{2 * count, -10}, {-1, -10}});
    for (const Point& p : teeth) turned.push_back({2 * p.x - p.y, p.x + 2 * p.y});
    check_cut(star);
    check_cut(teeth);
    check_cut(turned);
    check_cut(terrain);
}

TEST_CASE("corners that are not quite in one plane are cut as they appear along the nearest axis", "[cut]") {
    // A roof of a quadrilateral over a square, and a comb whose corners stand up and down.
    CHECK(cut_polygon(std::vector<Vec3>{{0, 0, 0}, {1, 0, .5}, {1, 1, 0}, {0, 1, .5}}).triangles.size() == 2);
    // One corner behind another: both stay.
    CHECK(cut_polygon(std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1}}).triangles.size() == 2);
    std::vector<Vec3> bent = corners_of(comb);
    for (std::size_t i = 0; i < bent.size(); ++i) bent[i].z = i % 3 == 0 ? .25 : i % 3 == 1 ? -.25 : 0;
    check_cut(comb, cut_polygon(bent));
}

TEST_CASE("small meshes from the field show as many pixels as they have area", "[cut]") {
    const std::string directory = test::scratch_directory() + "/field";
    std::filesystem::create_directories(directory);
    const auto white = [&](const std::string& obj) {
        std::ofstream(directory + "/m.obj", std::ios::binary) << obj;
        const Scene scene = parse_scene_text(
            "size 200 200\ncamera 0 0 10 0 0 0 0 1 0 45\northographic 20\nintegrator flat\nambient 1 1 "
            "1\nmesh "
            "m.obj\n",
            "s", directory);
        const std::vector<Vec3> pixels = render(compile(scene), {}).image.pixels;
        return std::count(pixels.begin(), pixels.end(), Vec3(1));
    };
    // A hundred pixels for a unit of area. No middle of a pixel is on a side but of the pentagon and the
    // dart.
    const auto outline = [](const Outline& p) {
        std::ostringstream text;
        for (const Point& point : p) text << "v " << point.x << ' ' << point.y << " 0\n";
        text << 'f';
        for (std::size_t i = 1; i <= p.size(); ++i) text << ' ' << i;
        return text.str() + "\n";
    };
    CHECK(white(outline(comb)) == 14400);
    CHECK(white(outline({{0, 8}, {-1, -2}, {0, 4}, {1, -2}})) == 400);
    CHECK(std::abs(white(outline({{3, 5}, {5, 6}, {7, 5}, {2, 3}, {3, 4}})) - 550) <= 20);
    const std::string square = "v -5 -5 \\\n 0\nv 5 -5 0\nv 5 5 0\nv -5 5 0\nvt 0 0\n";
    CHECK(white(square + "f 1 2 \\\n  3 4\n") == 10000);
    CHECK(white(square + "f 1// 2// 3//\nf 1/1/ 3/1/ 4/1/\n") == 10000);
}

TEST_CASE("a mesh and a polygon of the same corners have the same pixels", "[cut]") {
    // The rays go along z through the middles of cells, so that where they meet the plane is exact.
    const std::string directory = test::scratch_directory() + "/cut_polygon";
    std::filesystem::create_directories(directory);
    test::Random random(6);
    for (int round = 0; round < test::cases(60); ++round) {
        Outline outline = simple_polygon(random, 4 + random.index(10), 16);
        if (outline.empty()) continue;
        const Real scale = std::ldexp(1, static_cast<int>(random.index(61)) - 30);
        const Vec3 place{std::round(random.uniform(-1e6, 1e6)), std::round(random.uniform(-1e6, 1e6)), 0};
        std::ostringstream obj, vertices, face, polygon, head;
        obj.precision(17), vertices.precision(17), head.precision(17);
        face << 'f', polygon << "polygon";
        std::size_t count = 0;
        for (const Vec3& corner : corners_of(outline, 2, scale, place)) {
            obj << "v " << corner.x << ' ' << corner.y << ' ' << corner.z << '\n';
            vertices << "vertex " << corner.x << ' ' << corner.y << ' ' << corner.z << '\n';
            polygon << ' ' << count;
            face << ' ' << ++count;
        }
        const Vec3 eye = scale * (place + Vec3(8, 8, 10)), at = scale * (place + Vec3(8, 8, 0));
        head << "size 64 64\nintegrator flat\nambient 1 1 1\northographic " << 16 * scale << "\ncamera "
             << eye.x << ' ' << eye.y << ' ' << eye.z << ' ' << at.x << ' ' << at.y << ' ' << at.z
             << " 0 1 0 45\n";
        std::ofstream(directory + "/m.obj") << obj.str() << face.str() << '\n';
        const auto pixels = [&](const std::string& shape) {
            const Scene scene = parse_scene_text(head.str() + shape, "s", directory);
            return render(compile(scene), {}).image.pixels;
        };
        const std::vector<Vec3> of_mesh = pixels("mesh m.obj\n"),
                                of_polygon = pixels(vertices.str() + polygon.str() + "\n");
        int wrong_mesh = 0, wrong_polygon = 0;
        for (long row = 0; row < 64; ++row)
            for (long column = 0; column < 64; ++column) {
                // In eighths of a unit; by how often the outline crosses the half-line along +x.
                const Point p{2 * column + 1, 127 - 2 * row};
                bool inside = false, on_edge = false;
                for (std::size_t i = 0; i < outline.size(); ++i) {
                    Point a{8 * outline[i].x, 8 * outline[i].y};
                    const Point& next = outline[(i + 1) % outline.size()];
                    Point b{8 * next.x, 8 * next.y};
                    if (a.y > b.y) std::swap(a, b);
                    if (a.y > p.y || b.y <= p.y) continue;
                    on_edge = on_edge || area(a, b, p) == 0;
                    inside = inside != (area(a, b, p) > 0);
                }
                if (on_edge) continue;  // which of two neighbours has the edge is another question
                const auto i = static_cast<std::size_t>(64 * row + column);
                wrong_mesh += of_mesh[i] != Vec3(inside);
                wrong_polygon += of_polygon[i] != Vec3(inside);
            }
        INFO(text_of(outline) << "times " << scale << " at " << place.x << ' ' << place.y);
        CHECK(wrong_mesh == 0);
        CHECK(wrong_polygon == 0);
    }
}
