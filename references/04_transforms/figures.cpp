// Figures of chapter 4: turning, the stack, normals, spaces, and what goes wrong with long chains and with t.
// Usage: figures_04 DIRECTORY
#include "references/figures.hpp"
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/04_transforms/instance.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "common/render/explain.hpp"
#include "references/panels.hpp"
#include "tests/stability/naive.hpp"
#include "tests/stability/transforms.hpp"
#include "tests/support.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>
#include <optional>

using namespace rt;
namespace fs = std::filesystem;

namespace {

const SvgFont italic{.size = 17, .italic = true};
const SvgFont small{.size = 13};
const SvgFont middle{.size = 14, .anchor = "middle"};

SvgFont colored(const char* color) { return {.size = 16, .color = color, .italic = true}; }
SvgStyle stroke(const char* color, Real width = 2) { return {.stroke = color, .width = width}; }

void dot_at(Svg& svg, Vec2 at, const char* color, Real radius = 4) {
    circle(svg, at, radius, {.stroke = color, .width = 1, .fill = color});
}

// -------------------------------------------------------------------------------------------- rotation

/// The part of v along the axis stays; the rest turns in the plane of itself and k × v.
Svg rotation_figure() {
    Svg svg{.width = 700, .height = 320, .body = {}};
    // An oblique view: k up, the plane of the turn foreshortened.
    const Vec2 o(210, 260), up(0, -1);
    const Real height = 130, reach = 150, flat = 0.32;
    const Vec2 center = o + height * up;
    const auto at = [&](Real angle) {
        return center + reach * Vec2(std::cos(angle), -flat * std::sin(angle));
    };
    std::vector<Vec2> ring;
    for (int i = 0; i <= 72; ++i) ring.push_back(at(2 * pi * i / 72));
    polygon(svg, ring, {.stroke = svg_color::grey, .width = 1, .fill = "#eef3f7"});
    const Real from = -1.9, to = -0.9;
    line(svg, o, center + 80.0 * up, {.stroke = svg_color::ink, .width = 1, .dash = "4 4"});
    arrow(svg, o, center, stroke(svg_color::green, 2.5), 10);
    arrow(svg, o, o + 60.0 * up, stroke(svg_color::ink, 3), 11);
    arrow(svg, center, at(from), stroke(svg_color::orange, 2.5), 10);
    arrow(svg, center, at(from + pi / 2), stroke(svg_color::purple, 2.5), 10);
    arrow(svg, o, at(from), stroke(svg_color::blue, 2.5), 10);
    arrow(svg, o, at(to), stroke(svg_color::red, 2.5), 10);
    line(svg, center, at(to), {.stroke = svg_color::red, .width = 1.2, .dash = "4 4"});
    std::vector<Vec2> way;
    for (int i = 0; i <= 20; ++i) way.push_back(center + 0.5 * (at(from + (to - from) * i / 20) - center));
    polyline(svg, way, stroke(svg_color::grey, 1.5));
    text(svg, o + Vec2(8, -30), "k", italic);
    text(svg, center + Vec2(6, 62), "(k·v) k", colored("#00795a"));
    text(svg, at(from) + Vec2(-20, 8), "v", colored(svg_color::blue));
    text(svg, at(to) + Vec2(6, 18), "turned v", colored(svg_color::red));
    text(svg, at(from + pi / 2) + Vec2(12, 4), "k × v", colored("#a8598a"));
    text(svg, center + Vec2(16, 42), "θ", {.size = 16, .italic = true});
    dot_at(svg, o, svg_color::ink);

    // The same, seen from the tip of k.
    const Vec2 c(560, 160);
    const Real r = 105;
    const auto flat_at = [&](Real angle) { return c + r * Vec2(std::cos(angle), -std::sin(angle)); };
    circle(svg, c, r, {.stroke = svg_color::grey, .width = 1, .fill = "#eef3f7"});
    arrow(svg, c, flat_at(0), stroke(svg_color::orange, 2.5), 10);
    arrow(svg, c, flat_at(pi / 2), stroke(svg_color::purple, 2.5), 10);
    const Real angle = 0.95;
    arrow(svg, c, flat_at(angle), stroke(svg_color::red, 2.5), 10);
    const Vec2 foot(c.x + r * std::cos(angle), c.y);
    line(svg, foot, flat_at(angle), {.stroke = svg_color::purple, .width = 2, .dash = "5 4"});
    arc(svg, c, 34, 0, angle, stroke(svg_color::grey, 1.5));
    text(svg, {c.x, 24}, "seen from the tip of k", {.size = 15, .anchor = "middle", .bold = true});
    text(svg, {c.x + 34, c.y + 22}, "cos θ", middle);
    text(svg, {foot.x + 8, c.y - 36}, "sin θ", {.size = 14});
    text(svg, {c.x + 76, c.y + 42}, "v − (k·v) k",
         {.size = 14, .color = "#a06c00", .anchor = "middle", .italic = true});
    text(svg, flat_at(pi / 2) + Vec2(-46, -4), "k × v", {.size = 14, .color = "#a8598a", .italic = true});
    text(svg, {540, 306}, "turned: cos θ · (v − (k·v) k) + sin θ · (k × v)", middle);
    return svg;
}

// ------------------------------------------------------------------------------------------- the stack

Svg stack_figure() {
    Svg svg{.width = 700, .height = 300, .body = {}};
    const char* lines[] = {"translate 0 2 0", "sphere ...",        "pushTransform", "  rotate 0 0 1 30",
                           "  sphere ...",    "  translate 1 0 0", "  sphere ...",  "popTransform",
                           "scale 2 1 1",     "sphere ..."};
    const char* nodes[] = {"T", "T", "", "T R", "T R", "T R T′", "T R T′", "", "T S", "T S"};
    for (int i = 0; i < 10; ++i) {
        const Real y = 34 + 26 * i;
        const bool is_step =
            std::string_view(lines[i]).find("sphere") == std::string_view::npos && nodes[i][0] != 0;
        // Leading blanks are drawn as space.
        const Real indent = lines[i][0] == ' ' ? 22 : 0;
        text(svg, {30 + indent, y}, std::string_view(lines[i]).substr(lines[i][0] == ' ' ? 2 : 0),
             {.size = 14, .color = is_step ? svg_color::blue : svg_color::ink});
        if (nodes[i][0] != 0 && !is_step) text(svg, {205, y}, fmt::format("under {}", nodes[i]), small);
    }
    struct Node {
        Vec2 at;
        const char* step;
        const char* product;
        int parent;
    };
    const std::array<Node, 5> tree{{{{330, 150}, "I", "", -1},
                                    {{420, 150}, "translate", "T", 0},
                                    {{520, 85}, "rotate", "T R", 1},
                                    {{630, 85}, "translate", "T R T′", 2},
                                    {{520, 215}, "scale", "T S", 1}}};
    for (const Node& node : tree)
        if (node.parent >= 0) {
            const Vec2 from = tree[static_cast<std::size_t>(node.parent)].at;
            const Vec2 way = glm::normalize(node.at - from);
            arrow(svg, from + 20.0 * way, node.at - 20.0 * way, stroke(svg_color::grey, 2));
        }
    for (const Node& node : tree) {
        circle(svg, node.at, 19, {.stroke = svg_color::blue, .width = 2, .fill = "#eef3f7"});
        if (node.parent < 0)
            text(svg, node.at + Vec2(0, 5), node.step, {.size = 16, .anchor = "middle", .italic = true});
        else
            text(svg, node.at + Vec2(0, 38), node.step,
                 {.size = 13, .color = svg_color::blue, .anchor = "middle"});
        text(svg, node.at + Vec2(0, -28), node.product, {.size = 15, .anchor = "middle", .italic = true});
    }
    text(svg, {480, 285}, "a push keeps a node, a pop goes back to it", middle);
    return svg;
}

// --------------------------------------------------------------------------------------------- normals

/// A roof and its normal, stretched along x: M·n leans with the roof, the inverse transpose stays upright on
/// it.
Svg normals_figure() {
    Svg svg{.width = 700, .height = 270, .body = {}};
    const auto panel = [&](Real x, const char* title, Real stretch, const char* below) {
        text(svg, {x, 26}, title, {.size = 15, .anchor = "middle", .bold = true});
        text(svg, {x, 255}, below, middle);
        const Vec2 top(x, 120), left(x - 55 * stretch, 210), right(x + 55 * stretch, 210);
        polygon(svg, std::array{left, top, right}, {.stroke = svg_color::ink, .width = 2, .fill = "#eef3f7"});
        return (top + right) / 2.0;
    };
    const Real wider = 1.7;
    const Vec2 tangent = glm::normalize(Vec2(55, 90)), normal(tangent.y, -tangent.x);  // y down
    const auto right_angle = [&](Vec2 at, Vec2 along, Vec2 up) {
        const Vec2 a = 11.0 * glm::normalize(along), b = 11.0 * glm::normalize(up);
        polyline(svg, std::array{at + a, at + a + b, at + b}, stroke(svg_color::grey, 1.2));
    };
    Vec2 at = panel(95, "before", 1, "n is at right angles to v");
    arrow(svg, at, at + 62.0 * normal, stroke(svg_color::green, 2.5), 10);
    arrow(svg, at, at + 38.0 * tangent, stroke(svg_color::blue, 2.5), 10);
    right_angle(at, tangent, normal);
    text(svg, at + 62.0 * normal + Vec2(6, 2), "n", colored("#00795a"));
    text(svg, at + Vec2(26, 26), "v", colored(svg_color::blue));

    const Vec2 along = glm::normalize(Vec2(wider * tangent.x, tangent.y));
    at = panel(325, "n moved as v is", wider, "M n: too flat");
    arrow(svg, at, at + 70.0 * glm::normalize(Vec2(wider * normal.x, normal.y)), stroke(svg_color::red, 2.5),
          10);
    arrow(svg, at, at + 45.0 * along, stroke(svg_color::blue, 2.5), 10);
    text(svg, at + Vec2(46, -32), "M n", colored(svg_color::red));
    text(svg, at + Vec2(40, 24), "M v", colored(svg_color::blue));

    at = panel(565, "n by the inverse transpose", wider, "at right angles again");
    const Vec2 right = glm::normalize(Vec2(normal.x / wider, normal.y));
    arrow(svg, at, at + 70.0 * right, stroke(svg_color::green, 2.5), 10);
    arrow(svg, at, at + 45.0 * along, stroke(svg_color::blue, 2.5), 10);
    right_angle(at, along, right);
    text(svg, at + 70.0 * right + Vec2(-12, -8), "M⁻ᵀ n", colored("#00795a"));
    text(svg, at + Vec2(40, 24), "M v", colored(svg_color::blue));
    return svg;
}

/// One ray in two spaces, with marks at t = 0, 1, 2, ...
Svg spaces_figure() {
    Svg svg{.width = 700, .height = 250, .body = {}};
    const Mat4 m = rotation({0, 0, 1}, radians(20)) * scaling({150, 55, 1});
    const Mat4 back = inverse(m).value_or(Mat4(1));
    const Vec2 world(215, 130), local(560, 145);
    const Real unit = 55;  // pixels a local unit
    const auto place = [](Vec2 center, Vec3 p) { return center + Vec2(p.x, -p.y); };
    std::vector<Vec2> curve;
    for (int i = 0; i < 72; ++i) {
        const Real a = 2 * pi * i / 72;
        curve.push_back(place(world, transform_point(m, {std::cos(a), std::sin(a), 0})));
    }
    polygon(svg, curve, {.stroke = svg_color::ink, .width = 2, .fill = "#eef3f7"});
    circle(svg, local, unit, {.stroke = svg_color::ink, .width = 2, .fill = "#eef3f7"});
    const Ray ray{{-200, 20, 0}, {62, 2, 0}};
    const Ray inside = to_local({m, back}, ray);
    const auto draw = [&](Vec2 center, const Ray& r, Real scale, Real end) {
        const auto point = [&](Real t) { return place(center, scale * point_at(r, t)); };
        arrow(svg, point(0), point(end), stroke(svg_color::blue, 2), 10);
        for (int t = 0; t < 6; ++t) {
            dot_at(svg, point(t), svg_color::blue, 3);
            text(svg, point(t) + Vec2(-4, -9), std::to_string(t), {.size = 12, .color = svg_color::blue});
        }
    };
    draw(world, ray, 1, 6);
    draw(local, inside, unit, 6);
    const std::optional<Hit> hit = intersect(Sphere{{0, 0, 0}, 1}, inside, {0, infinity});
    const Real t = hit ? hit->t : 0;
    dot_at(svg, place(world, point_at(ray, t)), svg_color::red, 5);
    dot_at(svg, place(local, unit * point_at(inside, t)), svg_color::red, 5);
    text(svg, {world.x, 26}, "world: o + t·d", {.size = 15, .anchor = "middle", .bold = true});
    text(svg, {local.x, 26}, "local: M⁻¹o + t·M⁻¹d", {.size = 15, .anchor = "middle", .bold = true});
    text(svg, {350, 238}, fmt::format("the hit is at t = {:.2f} in both", t), middle);
    return svg;
}

// ------------------------------------------------------------------------------ what mistakes look like

/// What one pixel shows; the camera looks along −z, parallel rays.
using Look = std::function<Vec3(const Ray&)>;

const Vec3 nothing{0.02, 0.02, 0.03};

std::vector<Ellipsoid> still_life() {
    const auto make = [](const Vec3& at, const Vec3& axis, Real degrees, const Vec3& by) {
        const Mat4 m = translation(at) * rotation(axis, radians(degrees)) * scaling(by);
        return Ellipsoid{{m, inverse(m).value_or(Mat4(1))}};
    };
    return {make({-1.2, 0.2, 0}, {0, 0, 1}, 35, {1.5, 0.45, 0.6}),
            make({0.7, -0.2, -2}, {0, 0, 1}, -30, {1.7, 0.9, 1.4}),
            make({0.2, 0.7, 0.8}, {0, 0, 1}, 10, {0.9, 0.25, 0.25}),
            make({1.5, -0.75, 1}, {1, 1, 0}, 70, {0.3, 0.7, 1})};
}

enum class Fault { None, NormalsByMatrix, Renormalised };

Vec3 look(const std::vector<Ellipsoid>& shapes, const Ray& ray, Fault fault) {
    Real nearest = infinity;
    Vec3 color = nothing;
    for (const Ellipsoid& shape : shapes) {
        const bool wrong = fault == Fault::Renormalised;
        const Ray local = wrong ? naive::to_local(shape.transform, ray) : to_local(shape.transform, ray);
        const std::optional<Hit> hit = intersect(Sphere{Vec3(0), 1}, local, {0, infinity});
        if (!hit || hit->t >= nearest) continue;
        nearest = hit->t;
        const Surface surface = surface_at(Sphere{Vec3(0), 1}, local, *hit);
        Vec3 n = fault == Fault::NormalsByMatrix
                     ? naive::transform_normal(shape.transform.to_world, surface.normal)
                     : transform_normal(shape.transform.to_local, surface.normal);
        n = normalize(n);
        color = 0.5 * ((dot(n, ray.direction) > 0 ? -n : n) + 1.0);
    }
    return color;
}

Svg faults() {
    const std::vector<Ellipsoid> shapes = still_life();
    const int width = 240, height = 156;
    std::vector<figures::Panel> panels;
    const std::pair<Fault, const char*> looks[] = {{Fault::None, "right"},
                                                   {Fault::NormalsByMatrix, "normals by M"},
                                                   {Fault::Renormalised, "unit vector"}};
    for (const auto& [fault, words] : looks) {
        Image image = make_image(width, height);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const Vec3 from(5.6 * ((x + 0.5) / width - 0.5), 5.6 * (height / 2 - y - 0.5) / width, 10);
                pixel(image, x, y) = look(shapes, {from, {0, 0, -1}}, fault);
            }
        panels.push_back({image, words});
    }
    return figures::side_by_side(panels, 3);
}

// ------------------------------------------------------------------------------------------- roundings

/// The greatest element of |MᵀM − I|, which is 0 for a rotation.
Real off_rotation(const Mat3& m) {
    const Mat3 product = glm::transpose(m) * m;
    Real greatest = 0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) greatest = std::max(greatest, std::abs(product[c][r] - (r == c ? 1 : 0)));
    return greatest;
}

/// How far products of many rotations are from a rotation, by the greatest element of |MᵀM − I|; mean over
/// some chains.
std::string drift() {
    std::string csv = "rotations,double precision,single precision\n";
    constexpr int chains = 50, longest = 1'000'000;
    for (int length = 1; length <= longest; length *= 10) {
        test::Random random(4);
        Real sum = 0, in_single = 0;
        const int count = length > 100'000 ? 5 : chains;
        for (int i = 0; i < count; ++i) {
            const std::array<Mat4, 3> steps{rotation(random.direction(), random.uniform(-pi, pi)),
                                            rotation(random.direction(), random.uniform(-pi, pi)),
                                            rotation(random.direction(), random.uniform(-pi, pi))};
            const std::array<glm::mat3, 3> rough{glm::mat3(steps[0]), glm::mat3(steps[1]),
                                                 glm::mat3(steps[2])};
            Mat3 m(1);
            glm::mat3 single(1);
            for (int k = 0; k < length; ++k) {
                const auto turn = static_cast<std::size_t>(k % 3);
                m = m * Mat3(steps[turn]);
                single = single * rough[turn];
            }
            sum += off_rotation(m);
            in_single += off_rotation(Mat3(single));
        }
        csv += fmt::format("{},{:.0e},{:.0e}\n", length, sum / count, in_single / count);
    }
    return csv;
}

constexpr std::size_t count = 5000;
const std::string head_of_families = "family,cases,wrong (textbook),wrong (chapter)\n";

/// How many inverses of the extreme families are wrong, by both methods.
std::string inverses() {
    std::string csv = head_of_families;
    for (const stability::MatrixFamily& family : stability::matrix_families()) {
        const std::vector<Mat4> cases = family.make(count, 4);
        std::vector<std::optional<Mat4>> naive, stable;
        for (const Mat4& m : cases) naive.push_back(naive::inverse(m)), stable.push_back(inverse(m));
        csv += fmt::format("\"{}\",{},{},{}\n", family.name, count, stability::judge(cases, naive).mismatches,
                           stability::judge(cases, stable).mismatches);
    }
    return csv;
}

/// How many hits with ellipsoids of the extreme families are.
std::string hits() {
    std::string csv = head_of_families;
    for (const stability::EllipsoidFamily& family : stability::ellipsoid_families()) {
        const std::vector<stability::EllipsoidCase> cases = family.make(count, 4);
        std::vector<std::optional<Hit>> naive, stable;
        for (const auto& [ellipsoid, ray] : cases) {
            naive.push_back(
                naive::intersect(Sphere{Vec3(0), 1}, naive::to_local(ellipsoid.transform, ray), {}));
            stable.push_back(intersect(ellipsoid, ray, {}));
        }
        csv += fmt::format("\"{}\",{},{},{}\n", family.name, count, stability::judge(cases, naive).mismatches,
                           stability::judge(cases, stable).mismatches);
    }
    return csv;
}

// ------------------------------------------------------------------------------------------ the forest

Scene forest_scene(std::size_t trees) {
    Scene scene = parse_scene(fs::path(__FILE__).parent_path() / "forest.scene");
    scene.objects.resize(std::min(trees, scene.objects.size()));
    scene.accelerator = AcceleratorChoice::None;  // chapter 9 is not there yet
    scene.width = 40;
    scene.height = 30;
    return scene;
}

/// The same trees with a mesh of their own each, which compile bakes.
Scene without_instances(Scene scene) {
    const Mesh mesh = scene.meshes.front();
    scene.meshes.assign(scene.objects.size(), mesh);
    for (std::size_t i = 0; i < scene.objects.size(); ++i)
        scene.objects[i].shape = MeshObject{static_cast<std::uint32_t>(i)};
    return scene;
}

/// Memory in megabytes, as `course explain` counts it.
std::string memory(const Scene& scene) {
    return fmt::format("{:.2f}", static_cast<double>(explain(scene, compile(scene)).bytes) / 1e6);
}

/// What trees cost in memory, as instances of one and baked.
std::string forest() {
    std::string csv = "trees,triangles,megabytes (instances),megabytes (baked)\n";
    for (const std::size_t trees : {2u, 8u, 32u, 128u, 1024u}) {
        const Scene scene = forest_scene(trees);
        csv += fmt::format("{},{},{},{}\n", trees,
                           trees * compile(scene).meshes.front()->triangles.shapes.size(), memory(scene),
                           trees <= 128 ? memory(without_instances(scene)) : "");
    }
    return csv;
}

/// What they cost in time, when every ray asks every tree.
std::string forest_times() {
    const auto seconds = [](const Scene& scene) {
        return fmt::format("{:.2f}", render(compile(scene), {.threads = 1, .progress = {}}).cpu_seconds);
    };
    std::string csv = "trees,seconds (instances),seconds (baked)\n";
    for (const std::size_t trees : {2u, 8u, 32u, 128u, 1024u}) {
        const Scene scene = forest_scene(trees);
        csv += fmt::format("{},{},{}\n", trees, seconds(scene),
                           trees <= 32 ? seconds(without_instances(scene)) : "");
    }
    return csv;
}

/// Numbers that the lesson says in passing.
figures::Numbers lesson_numbers() {
    const Scene whole = parse_scene(fs::path(__FILE__).parent_path() / "forest.scene");
    const World world = compile(whole);
    const std::size_t triangles = world.meshes.front()->triangles.shapes.size();
    figures::Numbers numbers;
    numbers.add("bytes of the forest, by course explain", explain(whole, world).bytes);
    numbers.add("trees", whole.objects.size());
    numbers.add("triangles of a tree", triangles);
    numbers.add("bytes of all its triangles, written out",
                whole.objects.size() * triangles * sizeof(Triangle));
    numbers.add("cosine of 90 degrees", fmt::format("{:.1e}", std::cos(radians(90))));
    return numbers;
}

void draw_all(const figures::Path& out) {
    write_svg(out / "rotation.svg", rotation_figure());
    write_svg(out / "stack.svg", stack_figure());
    write_svg(out / "normals.svg", normals_figure());
    write_svg(out / "spaces.svg", spaces_figure());
    write_svg(out / "faults.svg", faults());
    write_file(out / "drift.csv", drift());
    write_file(out / "inverses.csv", inverses());
    write_file(out / "hits.csv", hits());
    write_file(out / "forest.csv", forest());
    write_file(out / "measured_forest.csv", forest_times());
    lesson_numbers().write(out);
    figures::draw_scenes(out, __FILE__, {"ellipsoids", "stack", "axes", "instanced", "forest"}, 240, 180);
}

}  // namespace

int main(int argc, char** argv) { return figures::draw_figures(argc, argv, draw_all); }
