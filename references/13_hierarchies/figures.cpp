// Draws the figures of lesson 13 into the directory that it is given.
// Boxes, nodes and counts in them are those of the course's own functions.
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/09_grids/walk.hpp"
#include "chapters/10_surfaces/box.hpp"
#include "chapters/13_hierarchies/build.hpp"
#include "chapters/13_hierarchies/walk.hpp"
#include "common/math/random.hpp"
#include "references/09_grids/teapots.hpp"
#include "references/13_hierarchies/figures_volumes.hpp"
#include "references/costs.hpp"

#include <fmt/format.h>

#include <array>
#include <functional>

using namespace rt;
using namespace rt::figures;
using teapot::rays_around;
using teapot::teapot_of;

namespace {

/// Numbers of the lesson that have no figure of their own.
Numbers numbers;

/// The ways of parting the shapes of a node, as the lesson calls them.
struct NamedMethod {
    const char* name;
    SplitMethod method;
    const char* color;
};
constexpr std::array<NamedMethod, 4> methods{{{"halves", SplitMethod::Halves, red},
                                              {"sweep", SplitMethod::Sweep, green},
                                              {"bins", SplitMethod::Bins, blue},
                                              {"codes", SplitMethod::Codes, purple}}};

template <class Shape>
std::vector<Bounds> boxes_of(const std::vector<Shape>& shapes) {
    std::vector<Bounds> boxes;
    for (const Shape& shape : shapes) boxes.push_back(bounds_of(shape));
    return boxes;
}

/// The hierarchy by a method; those that know no costs go on to leaves of one shape.
Hierarchy built(const std::vector<Bounds>& boxes, SplitMethod method) {
    const bool knows_costs = method == SplitMethod::Sweep || method == SplitMethod::Bins;
    return build_hierarchy(boxes, {.method = method, .most = knows_costs ? 16u : 1u});
}

/// A point of the box, uniform.
Vec3 random_in(const Bounds& box, Random& random) {
    Vec3 p;
    for (int i = 0; i < 3; ++i) p[i] = box.low[i] + random_real(random) * (box.high[i] - box.low[i]);
    return p;
}

/// A unit vector, uniform.
Vec3 random_direction(Random& random) {
    const Real z = 2 * random_real(random) - 1, turn = 2 * pi * random_real(random);
    const Real r = std::sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

/// Lines that come from everywhere alike, and meet the box.
std::vector<Ray> lines_through(const Bounds& box, std::size_t count, std::uint64_t seed) {
    std::vector<Ray> lines;
    Random random = random_for(13, seed, 0);
    const Real radius = length(box.high - box.low) / 2;
    while (lines.size() < count) {
        // Across the direction, a point of the disc that the ball around the box shows.
        const Vec3 direction = random_direction(random), u = normalize(any_across(direction)),
                   v = cross(direction, u);
        const Real a = 2 * random_real(random) - 1, b = 2 * random_real(random) - 1;
        if (a * a + b * b > 1) continue;
        const Ray ray{middle_of(box) + radius * (a * u + b * v - Real(2) * direction), direction};
        if (clip(box, ray, {0, infinity})) lines.push_back(ray);
    }
    return lines;
}

// Levels ------------------------------------------------------------------------------------------------

/// Appends the boxes of the nodes `depth` below this one, and of leaves above that.
void boxes_below(const Hierarchy& hierarchy, std::uint32_t number, int depth, std::vector<Bounds>& boxes) {
    const HierarchyNode& node = hierarchy.nodes[number];
    if (depth == 0 || node.count > 0) {
        boxes.push_back(node.box);
        return;
    }
    for (const std::uint32_t child : {node.first, node.first + 1})
        boxes_below(hierarchy, child, depth - 1, boxes);
}

/// A teapot as the boxes of its tree see it, from coarse to fine.
void draw_levels(const Path& directory) {
    const Hierarchy tree = built(boxes_of(teapot_of(25)), SplitMethod::Halves);
    std::vector<Image> images;
    for (const int depth : {3, 6, 9, 12}) {
        std::vector<Bounds> boxes;
        boxes_below(tree, 0, depth, boxes);
        numbers.add(fmt::format("boxes at depth {}", depth), boxes.size());
        std::string scene =
            "size 346 210\ncamera 1.5 3.6 9.6  .25 1.4 0  0 1 0  31\nbackground .9 .93 .96\n"
            "directional .5 1 .7  1 .96 .9\ndirectional -.8 .3 .5  .2 .24 .3\nambient .12 .12 .12\n"
            "diffuse .75 .77 .8\nplane 0 -.001 0  0 1 0\n";
        for (const Bounds& box : boxes) {
            // Neighbours in the list are neighbours in the tree: the colour says how far along the list.
            const Real turn =
                2 * pi * static_cast<Real>(&box - boxes.data()) / static_cast<Real>(boxes.size());
            const auto part = [&](Real phase) {
                return 0.03 + 0.62 * std::pow(0.5 + 0.5 * std::cos(turn + phase), 1.5);
            };
            scene +=
                fmt::format("diffuse {:.3f} {:.3f} {:.3f}\nbox {} {} {} {} {} {}\n", part(0), part(-2.1),
                            part(-4.2), box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z);
        }
        images.push_back(render(compile(parse_scene_text(scene, "figure"))).image);
    }
    write_image(directory / "levels.png", in_rows(images, 2));
}

// A small tree ------------------------------------------------------------------------------------------

/// Eight discs, seen from above, and a ray through them.
const std::array<Sphere, 8> discs{{{{0.7, 0.8, 0}, 0.4},
                                   {{1.5, 2.3, 0}, 0.45},
                                   {{2.9, 0.7, 0}, 0.4},
                                   {{3.5, 2.35, 0}, 0.35},
                                   {{5.0, 1.75, 0}, 0.5},
                                   {{5.8, 0.6, 0}, 0.35},
                                   {{6.9, 2.3, 0}, 0.4},
                                   {{7.6, 0.9, 0}, 0.45}}};
const Ray ray_at_discs{{-0.5, 1.3, 0}, {1, 0.06, 0}};

/// What became of a node on the way of a ray.
enum class Fate : std::uint8_t { Unseen, Missed, Entered, PassedOver };

/// How a ray goes through a tree: as it should, without looking which child is nearer, or only up to the
/// first leaf in which something is hit.
enum class Walk { NearerFirst, AsTheyStand, UpToTheFirstHit };

/// The way of a ray from the root, by the course's children_met.
template <class Shape>
struct Way {
    const Hierarchy& tree;
    std::span<const Shape> shapes;
    Ray ray;
    Walk walk = Walk::NearerFirst;
    Nearest nearest{{0, infinity}};
    std::vector<Fate> fate = std::vector<Fate>(tree.nodes.size());

    void enter(const NodeVisit& visit) {
        const bool is_late =
            visit.t.min > nearest.range.max || (walk == Walk::UpToTheFirstHit && nearest.hit);
        fate[visit.node] = is_late ? Fate::PassedOver : Fate::Entered;
        if (is_late) return;
        const HierarchyNode& node = tree.nodes[visit.node];
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
            nearest.ask(shapes, tree.items[k], ray);
        if (node.count > 0) return;
        ChildVisits met = children_met(tree, visit.node, ray, nearest.range);
        for (const std::uint32_t child : {node.first, node.first + 1}) fate[child] = Fate::Missed;
        if (walk == Walk::AsTheyStand && met.count == 2 && met.visits[0].node > met.visits[1].node)
            std::swap(met.visits[0], met.visits[1]);
        for (int i = 0; i < met.count; ++i) enter(met.visits[static_cast<std::size_t>(i)]);
    }
};

template <class Shape>
Way<Shape> way_of(const Hierarchy& tree, const std::vector<Shape>& shapes, const Ray& ray,
                  Walk walk = Walk::NearerFirst) {
    Way<Shape> way{tree, shapes, ray, walk};
    if (const auto inside = clip(tree.nodes[0].box, ray, {0, infinity})) way.enter({0, *inside});
    return way;
}

/// The places of the nodes in a drawing of the tree: leaves beside each other, others above their children.
void place_nodes(const Hierarchy& tree, std::uint32_t number, int depth, std::vector<Vec2>& places,
                 int& leaves) {
    const HierarchyNode& node = tree.nodes[number];
    places[number].y = depth;
    if (node.count > 0) {
        places[number].x = leaves++;
        return;
    }
    for (const std::uint32_t child : {node.first, node.first + 1})
        place_nodes(tree, child, depth + 1, places, leaves);
    places[number].x = (places[node.first].x + places[node.first + 1].x) / 2;
}

void draw_tree(const Path& directory) {
    const std::vector<Sphere> shapes(discs.begin(), discs.end());
    const Hierarchy tree = built(boxes_of(shapes), SplitMethod::Halves);
    const std::vector<Fate> fate = way_of(tree, shapes, ray_at_discs).fate;
    std::vector<Vec2> places(tree.nodes.size());
    int leaves = 0;
    place_nodes(tree, 0, 0, places, leaves);

    Svg svg{.width = 760, .height = 560};
    const Real unit = 84;
    const auto place = [&](Real x, Real y) { return Vec2(55 + unit * x, 272 - unit * y); };
    const std::array<const char*, 4> colors{ink, blue, red, grey};
    for (const Sphere& disc : shapes)
        circle(svg, place(disc.center.x, disc.center.y), unit * disc.radius,
               {.stroke = grey, .width = 1.2, .fill = "#eef1f3"});
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const auto depth = static_cast<std::size_t>(places[i].y);
        // Boxes of one edge would lie on top of each other.
        const Real out = 4.5 * (3 - static_cast<Real>(depth));
        const Bounds& box = tree.nodes[i].box;
        const Vec2 corner = place(box.low.x, box.high.y) - out;
        rectangle(svg, corner, unit * Vec2(box.high.x - box.low.x, box.high.y - box.low.y) + 2 * out,
                  {.stroke = colors[depth], .width = depth == 3 ? 1 : 1.8});
        if (tree.nodes[i].count > 0) {
            text(svg, place(middle_of(box).x, middle_of(box).y) + Vec2(0, 5),
                 std::to_string(tree.items[tree.nodes[i].first]),
                 middle(SvgFont{.size = 16, .italic = true}));
            continue;
        }
        // Between the children where there is room.
        const Bounds &a = tree.nodes[tree.nodes[i].first].box, &b = tree.nodes[tree.nodes[i].first + 1].box;
        const Real gap = place((a.high.x + b.low.x) / 2, 0).x;
        text(svg, {depth < 2 ? gap - 6 : corner.x + 12, corner.y + 17}, std::to_string(i),
             middle(SvgFont{.size = 15, .color = colors[depth], .bold = true}));
    }
    const auto at = [&](Real t) { return place(point_at(ray_at_discs, t).x, point_at(ray_at_discs, t).y); };
    arrow(svg, at(0), at(8.9), {.stroke = green, .width = 1.8});

    const auto spot = [&](const Vec2& p) { return Vec2(62 + 90 * p.x, 335 + 62 * p.y); };
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        if (tree.nodes[i].count == 0)
            for (const std::uint32_t child : {tree.nodes[i].first, tree.nodes[i].first + 1})
                line(svg, spot(places[i]), spot(places[child]), {.stroke = grey, .width = 1.2});
    int entered = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
        const bool is_leaf = tree.nodes[i].count > 0;
        const char* fill = fate[i] == Fate::Entered      ? "#9fd8c3"
                           : fate[i] == Fate::Missed     ? "#f6d3bd"
                           : fate[i] == Fate::PassedOver ? "#f7e7b4"
                                                         : "#ffffff";
        entered += fate[i] == Fate::Entered;
        circle(svg, spot(places[i]), 16,
               {.stroke = colors[static_cast<std::size_t>(places[i].y)], .width = 1.8, .fill = fill});
        text(svg, spot(places[i]) + Vec2(0, 5), std::to_string(i), middle(SvgFont{.size = 15, .bold = true}));
        if (is_leaf)
            text(svg, spot(places[i]) + Vec2(0, 34), std::to_string(tree.items[tree.nodes[i].first]),
                 middle(SvgFont{.size = 16, .italic = true}));
    }
    numbers.add("nodes entered among the discs", entered);
    numbers.add("nodes among the discs", tree.nodes.size());
    write_svg(directory / "tree.svg", svg);
}

// Why the area ------------------------------------------------------------------------------------------

/// How many of the lines that meet a cube meet a box in it: counted, against shares of area and of volume.
void draw_area(const Path& directory) {
    const Bounds cube{Vec3(0), Vec3(1)};
    const std::vector<Ray> lines = lines_through(cube, 40'000, 3);
    Random random = random_for(13, 4, 0);
    Svg svg{.width = 700, .height = 400};
    const Plot plot{{80, 40}, {560, 290}, {0, 0.5}, {0, 0.5}};
    const Ticks ticks{{0, "0"}, {0.1, "0.1"}, {0.2, "0.2"}, {0.3, "0.3"}, {0.4, "0.4"}, {0.5, "0.5"}};
    draw_axes(svg, plot, ticks, ticks);
    text(svg, plot.corner + Vec2(280, 332), "share of the cube's area, or of its volume",
         middle(SvgFont{.size = 16}));
    text(svg, plot.corner + Vec2(0, -12), "share of the lines that meet the box", {.size = 16});
    line(svg, plot.place(0, 0), plot.place(0.5, 0.5), {.stroke = grey, .width = 1.2, .dash = "5 4"});
    std::string csv = "edges,share of the lines,share of the area,share of the volume\n";
    Real worst = 0;
    for (int i = 0; i < 40; ++i) {
        Bounds box{random_in(cube, random), random_in(cube, random)};
        // A tenth of them plates, without thickness.
        if (i % 10 == 0) box.low.z = box.high.z;
        box = merge({box.low, box.low}, {box.high, box.high});
        std::size_t met = 0;
        for (const Ray& ray : lines) met += clip(box, ray, {0, infinity}).has_value();
        const Vec3 e = box.high - box.low;
        const Real share = static_cast<Real>(met) / static_cast<Real>(lines.size());
        const Real area = half_area(box) / half_area(cube), volume = e.x * e.y * e.z;
        csv += fmt::format("{:.2f} x {:.2f} x {:.2f},{:.4f},{:.4f},{:.4f}\n", e.x, e.y, e.z, share, area,
                           volume);
        worst = std::max(worst, std::abs(share - area));
        dot_at(svg, plot.place(volume, share), red, 4);
        dot_at(svg, plot.place(area, share), blue, 4);
    }
    numbers.add("lines at the cube", lines.size());
    numbers.add("farthest from the share of the area", fmt::format("{:.4f}", worst));
    text(svg, plot.place(0.36, 0.32), "area", colored(SvgFont{.size = 17, .bold = true}, blue));
    text(svg, plot.place(0.06, 0.35), "volume", colored(SvgFont{.size = 17, .bold = true}, red));
    write_file(directory / "area.csv", csv);
    write_svg(directory / "area.svg", svg);
}

// The cheapest cut --------------------------------------------------------------------------------------

/// A street: some large houses far from each other, and a crowd of small ones at one end.
std::vector<Bounds> street() {
    std::vector<Bounds> boxes;
    for (const auto& [x, width, height] :
         {std::array<Real, 3>{0.2, 0.9, 1.5}, {1.6, 0.7, 0.9}, {2.7, 1.0, 1.9}, {4.3, 0.8, 1.2}})
        boxes.push_back({{x, 0, 0}, {x + width, height, 1}});
    for (int i = 0; i < 16; ++i) {
        const Real x = 6.0 + 0.22 * (i / 2), y = i % 2 == 0 ? 0 : 0.3;
        boxes.push_back({{x, y, 0.4}, {x + 0.16, y + 0.2, 0.6}});
    }
    return boxes;
}

Bin one_bin(std::span<const Bounds> boxes) {
    Bin bin;
    for (const Bounds& box : boxes) bin.box = merge(bin.box, box), ++bin.count;
    return bin;
}

void draw_cut(const Path& directory) {
    const std::vector<Bounds> boxes = street();
    std::vector<Bin> row;
    for (const Bounds& box : boxes) row.push_back({box, 1});
    const Cut best = cheapest_cut(row);
    std::string csv = "shapes before the cut,cost\n";
    std::vector<Vec2> curve;
    for (std::size_t i = 1; i < boxes.size(); ++i) {
        const std::span<const Bounds> all(boxes);
        const Real cost = cheapest_cut(std::array{one_bin(all.first(i)), one_bin(all.subspan(i))}).cost;
        csv += fmt::format("{},{:.2f}\n", i, cost);
        curve.push_back({(middle_of(boxes[i - 1]).x + middle_of(boxes[i]).x) / 2, cost});
    }
    numbers.add("shapes of the street", boxes.size());
    numbers.add("shapes before the cheapest cut", best.at);
    numbers.add("cost of the cheapest cut", fmt::format("{:.2f}", best.cost));
    numbers.add("cost of halves", fmt::format("{:.2f}", curve[boxes.size() / 2 - 1].y));
    write_file(directory / "cut.csv", csv);

    Svg svg{.width = 700, .height = 440};
    const Real unit = 72;
    const auto place = [&](Real x, Real y) { return Vec2(70 + unit * x, 170 - unit * y); };
    for (const Bounds& box : boxes)
        rectangle(svg, place(box.low.x, box.high.y),
                  unit * Vec2(box.high.x - box.low.x, box.high.y - box.low.y),
                  {.stroke = grey, .width = 1.2, .fill = "#e3eff7"});
    const Plot plot{place(0, 0) + Vec2(0, 42), {unit * 8, 180}, {0, 8}, {0, 20}};
    draw_axes(svg, plot, {}, {{0, "0"}, {5, "5"}, {10, "10"}, {15, "15"}, {20, "20"}});
    text(svg, plot.corner + Vec2(0, -10), "cost of the cut", {.size = 16});
    draw_curve(svg, plot, curve, ink);
    const auto mark = [&](std::size_t at, const char* color, const std::string& words, Real down) {
        const Vec2 p = plot.place(curve[at - 1].x, curve[at - 1].y);
        line(svg, {p.x, 18}, {p.x, plot.corner.y + plot.size.y},
             {.stroke = color, .width = 1.8, .dash = "6 4"});
        dot_at(svg, p, color, 6);
        text(svg, {p.x - 8, down}, words, anchored(colored(SvgFont{.size = 16}, color), "end"));
    };
    mark(best.at, red, "cheapest", 32);
    mark(boxes.size() / 2, blue, "halves", 58);
    write_svg(directory / "cut.svg", svg);
}

// The stadium -------------------------------------------------------------------------------------------

/// A scene of chapter 9 in another size.
Scene scene_of_grids(const std::string& name, int width, int height) {
    return scene_beside((Path(__FILE__).parent_path().parent_path() / "09_grids" / "x").c_str(), name, width,
                        height);
}

/// The world without accelerators of its own.
World world_of(Scene scene) {
    scene.accelerator = AcceleratorChoice::None;
    return compile(scene);
}

std::vector<Ray> camera_rays(const World& world) {
    std::vector<Ray> rays;
    for (int y = 0; y < world.view.height; ++y)
        for (int x = 0; x < world.view.width; ++x) rays.push_back(pixel_ray(world.view, x + 0.5, y + 0.5));
    return rays;
}

/// How deep the deepest node is whose box has at least half of the root's area.
int deepest_large_box(const Hierarchy& tree, std::uint32_t number = 0, int depth = 0) {
    const HierarchyNode& node = tree.nodes[number];
    if (half_area(node.box) < half_area(tree.nodes[0].box) / 2) return depth - 1;
    if (node.count > 0) return depth;
    return std::max(deepest_large_box(tree, node.first, depth + 1),
                    deepest_large_box(tree, node.first + 1, depth + 1));
}

/// Pictures of the nodes or cells that each pixel's ray comes to, and of the shapes that it asks.
void draw_stadium(const Path& directory) {
    const int width = 228, height = 171;
    const World world = world_of(scene_of_grids("stadium", width, height));
    const std::vector<Triangle> triangles = shapes_of<Triangle>(world);
    const std::vector<Bounds> boxes = boxes_of(triangles);
    const std::vector<Ray> rays = camera_rays(world);
    std::string csv =
        "accelerator,nodes or cells a ray,most of them,triangles a ray,most of these,bytes a triangle\n";
    std::vector<Image> nodes_images, shapes_images;
    const auto measure = [&](const std::string& name, const auto& accelerator, bool is_drawn) {
        Image nodes = make_image(width, height), shapes = nodes;
        Mailbox mailbox;
        SearchCounts sum, most;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const SearchCounts one = cost(accelerator, triangles, rays[i], mailbox);
            nodes.pixels[i] = heat(static_cast<Real>(one.cells));
            shapes.pixels[i] = heat(static_cast<Real>(one.shapes));
            sum.cells += one.cells, sum.shapes += one.shapes;
            most.cells = std::max(most.cells, one.cells), most.shapes = std::max(most.shapes, one.shapes);
        }
        const auto n = static_cast<Real>(rays.size());
        csv += fmt::format("{},{:.1f},{},{:.2f},{},{:.0f}\n", name, static_cast<Real>(sum.cells) / n,
                           most.cells, static_cast<Real>(sum.shapes) / n, most.shapes,
                           static_cast<Real>(bytes_of(accelerator)) / static_cast<Real>(triangles.size()));
        if (is_drawn) nodes_images.push_back(nodes), shapes_images.push_back(shapes);
    };
    measure("grids in grids", build_grid(triangles), true);
    measure("halves", built(boxes, SplitMethod::Halves), true);
    measure("sweep", built(boxes, SplitMethod::Sweep), false);
    measure("bins", built(boxes, SplitMethod::Bins), true);
    measure("codes", built(boxes, SplitMethod::Codes), false);
    for (const NamedMethod& way : methods)
        numbers.add(fmt::format("depth of the deepest large box by {}", way.name),
                    deepest_large_box(built(boxes, way.method)));
    write_file(directory / "stadium.csv", csv);
    nodes_images.insert(nodes_images.end(), shapes_images.begin(), shapes_images.end());
    write_image(directory / "heat.png", in_rows(nodes_images, 3));
}

// Growth ------------------------------------------------------------------------------------------------

void draw_growth(const Path& directory) {
    const std::vector<Ray> rays = rays_around(20'000);
    const auto mean = [&](std::uint64_t sum) {
        return static_cast<Real>(sum) / static_cast<Real>(rays.size());
    };
    std::string csv =
        "fineness,triangles,log2 of them,grid: cells,grid: triangles,halves: nodes,halves: "
        "triangles,bins: nodes,bins: triangles\n";
    std::string measured =
        "triangles,ns a ray: brute force,ns a ray: grids in grids,ns a ray: halves,ns a ray: bins,build ms: "
        "grids "
        "in grids,build ms: halves,build ms: bins,rays that pay for bins\n";
    std::vector<Vec2> brute, grid_curve, halves_curve, bins_curve;
    for (const int fineness : {2, 4, 7, 13, 22, 40, 70, 125}) {
        const std::vector<Triangle> triangles = teapot_of(fineness);
        const std::vector<Bounds> boxes = boxes_of(triangles);
        const auto n = static_cast<Real>(triangles.size());
        Mailbox mailbox;
        csv += fmt::format("{},{},{:.1f}", fineness, triangles.size(), std::log2(n));
        const auto counts = [&](const auto& accelerator) {
            SearchCounts sum;
            for (const Ray& ray : rays) {
                const SearchCounts one = cost(accelerator, triangles, ray, mailbox);
                sum.cells += one.cells, sum.shapes += one.shapes;
            }
            csv += fmt::format(",{:.1f},{:.2f}", mean(sum.cells), mean(sum.shapes));
            return Vec2(n, mean(sum.cells) + mean(sum.shapes));
        };
        const auto ns_a_ray = [&](const auto& accelerator) {
            return 1e9 / static_cast<Real>(rays.size()) * seconds_of([&] {
                       for (const Ray& ray : rays)
                           closest_hit(accelerator, triangles, ray, {0, infinity}, mailbox);
                   });
        };
        const std::size_t few = std::clamp<std::size_t>(static_cast<std::size_t>(4e6 / n), 4, rays.size());
        const double brute_ns = 1e9 / static_cast<Real>(few) * seconds_of([&] {
                                    for (std::size_t i = 0; i < few; ++i)
                                        closest_hit(triangles, rays[i], {0, infinity});
                                });
        std::vector<double> ns, build;
        Grid grid;
        build.push_back(seconds_of([&] { grid = build_grid(triangles); }));
        ns.push_back(ns_a_ray(grid));
        grid_curve.push_back(counts(build_grid(triangles, {.nested = false})));
        for (const auto& [method, curve] :
             {std::pair{SplitMethod::Halves, &halves_curve}, {SplitMethod::Bins, &bins_curve}}) {
            Hierarchy tree;
            build.push_back(seconds_of([&, by = method] { tree = built(boxes_of(triangles), by); }));
            ns.push_back(ns_a_ray(tree));
            curve->push_back(counts(tree));
        }
        csv += "\n";
        brute.push_back({n, n});
        measured += fmt::format("{},{:.3g}", triangles.size(), brute_ns);
        for (const double one : ns) measured += fmt::format(",{:.3g}", one);
        for (const double one : build) measured += fmt::format(",{:.2g}", 1e3 * one);
        measured += fmt::format(",{:.2g}\n", 1e9 * build.back() / (brute_ns - ns.back()));
    }
    write_file(directory / "growth.csv", csv);
    write_file(directory / "measured_growth.csv", measured);
    // Slopes over the large teapots, where the ends do not matter.
    const auto tail = [](const std::vector<Vec2>& curve) {
        return std::vector<Vec2>(curve.begin() + 3, curve.end());
    };
    write_file(
        directory / "growth_exponents.csv",
        fmt::format("what,exponent\nbrute force,1\ngrid,{:.2f}\nhalves,{:.2f}\nbins,{:.2f}\n",
                    exponent(tail(grid_curve)), exponent(tail(halves_curve)), exponent(tail(bins_curve))));

    Svg svg{.width = 700, .height = 390};
    const Plot plot{{80, 50}, {570, 280}, {100, 1.2e6, true}, {1, 1e6, true}};
    draw_axes(svg, plot, "triangles", "asked a ray: shapes, cells, nodes");
    draw_curve(svg, plot, brute, grey);
    draw_curve(svg, plot, grid_curve, blue);
    draw_curve(svg, plot, halves_curve, red);
    const SvgFont words{.size = 16, .anchor = "end"};
    text(svg, plot.place(2500, 9000), "brute force: all", colored(words, "#666666"));
    text(svg, plot.place(1.1e6, grid_curve.back().y) + Vec2(0, -14),
         fmt::format("grid: n^{:.2f}", exponent(tail(grid_curve))), colored(words, blue));
    text(svg, plot.place(1.1e6, halves_curve.back().y) + Vec2(0, 28),
         fmt::format("tree in halves: n^{:.2f}", exponent(tail(halves_curve))), colored(words, red));
    write_svg(directory / "growth.svg", svg);
}

// Predictions -------------------------------------------------------------------------------------------

/// What rays pay in the hierarchy, in the unit of the prediction; those that stop where they hit, or not.
template <class Shape>
Real paid(const Hierarchy& tree, const std::vector<Shape>& shapes, const std::vector<Ray>& rays,
          bool they_stop) {
    const SplitCosts costs;
    const SearchCounts before = search_counts();
    std::uint64_t leaves = 0, asked = 0;
    for (const Ray& ray : rays) {
        Nearest nearest{{0, infinity}};
        search(tree, ray, {0, infinity}, [&](std::span<const std::uint32_t> some, Interval) {
            ++leaves, asked += some.size();
            if (!they_stop) return infinity;
            for (const std::uint32_t i : some) nearest.ask(std::span<const Shape>(shapes), i, ray);
            return nearest.range.max;
        });
    }
    // The search counts leaves as nodes, too.
    const std::uint64_t inner = search_counts().cells - before.cells - leaves;
    return (costs.node * static_cast<Real>(inner) + costs.shape * static_cast<Real>(asked)) /
           static_cast<Real>(rays.size());
}

void draw_predictions(const Path& directory) {
    std::string csv = "scene and method,shapes,predicted,lines pay,rays pay\n";
    Svg svg{.width = 700, .height = 430};
    const Plot plot{{80, 50}, {480, 310}, {9, 200, true}, {6, 200, true}};
    draw_axes(svg, plot, "predicted cost of a line", "what lines and rays pay");
    line(svg, plot.place(9, 9), plot.place(200, 200), {.stroke = grey, .width = 1.2, .dash = "5 4"});
    Real worst = 0;
    const auto measure = [&](const std::string& name, const auto& shapes) {
        const std::vector<Bounds> boxes = boxes_of(shapes);
        for (const NamedMethod& way : methods) {
            const Hierarchy tree = built(boxes, way.method);
            const std::vector<Ray> lines = lines_through(tree.nodes[0].box, 30'000, 7);
            const Real predicted = predicted_cost(tree), by_lines = paid(tree, shapes, lines, false),
                       by_rays = paid(tree, shapes, lines, true);
            csv += fmt::format("{} {},{},{:.1f},{:.1f},{:.1f}\n", name, way.name, shapes.size(), predicted,
                               by_lines, by_rays);
            worst = std::max(worst, std::abs(by_lines / predicted - 1));
            dot_at(svg, plot.place(predicted, by_lines), way.color, 5);
            circle(svg, plot.place(predicted, by_rays), 4.5, {.stroke = way.color, .width = 2});
        }
    };
    measure("teapot", teapot_of(25));
    measure("stadium", shapes_of<Triangle>(world_of(scene_of_grids("stadium", 64, 48))));
    measure("cloud", shapes_of<Triangle>(world_of(scene_of_grids("cloud", 64, 48))));
    measure("needles", shapes_of<Triangle>(world_of(scene_beside(__FILE__, "needles"))));
    measure("city", shapes_of<Box>(world_of(scene_beside(__FILE__, "city"))));
    numbers.add("lines farthest from their prediction (percent)", fmt::format("{:.2g}", 100 * worst));
    int row = 0;
    for (const NamedMethod& way : methods) {
        const Vec2 p(585, 90 + 26 * row++);
        dot_at(svg, p, way.color, 5);
        text(svg, p + Vec2(12, 5), way.name, label);
    }
    dot_at(svg, {585, 226}, grey, 5), text(svg, {597, 231}, "lines", label);
    circle(svg, {585, 252}, 4.5, {.stroke = grey, .width = 2}), text(svg, {597, 257}, "rays", label);
    write_file(directory / "predicted.csv", csv);
    write_svg(directory / "predicted.svg", svg);
}

// Motion ------------------------------------------------------------------------------------------------

/// The triangles at an instant from 0 to 1.
using Motion = std::function<std::vector<Triangle>(const std::vector<Triangle>&, Real)>;

template <class Map>
std::vector<Triangle> mapped(const std::vector<Triangle>& triangles, const Map& map) {
    std::vector<Triangle> result;
    for (std::size_t i = 0; i < triangles.size(); ++i)
        result.push_back({map(i, triangles[i].a), map(i, triangles[i].b), map(i, triangles[i].c)});
    return result;
}

/// By two turns more at the top than at the bottom.
std::vector<Triangle> twisted(const std::vector<Triangle>& triangles, Real time) {
    return mapped(triangles, [&](std::size_t, const Vec3& p) {
        const Real turn = 4 * pi * time * (p.y / 3.15 - 0.5), c = std::cos(turn), s = std::sin(turn);
        return Vec3(c * p.x + s * p.z, p.y, c * p.z - s * p.x);
    });
}

/// Each triangle in a direction of its own.
std::vector<Triangle> scattered(const std::vector<Triangle>& triangles, Real time) {
    return mapped(triangles, [&](std::size_t i, const Vec3& p) {
        Random random = random_for(13, 8, i);
        const Vec3 direction = random_direction(random);
        return p + time * direction * (0.5 + random_real(random));
    });
}

/// The triangles by the colours of their normals, turned to the viewer; `nearest(ray)` finds them.
template <class NearestOf>
Image picture_of(const std::vector<Triangle>& triangles, const View& view, const NearestOf& nearest) {
    Image image = make_image(view.width, view.height);
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            const Ray ray = pixel_ray(view, x + 0.5, y + 0.5);
            const std::optional<Hit> hit = nearest(ray);
            const Vec3 n = hit ? unit_normal(triangles[hit->primitive]) : Vec3(0.86);
            pixel(image, x, y) = Real(0.5) * ((hit && dot(n, ray.direction) > 0 ? -n : n) + Real(1));
        }
    return image;
}

View view_of(const std::string& words) {
    return compile(parse_scene_text(words + "\nsphere 0 0 0 1\n", "figure")).view;
}

/// What trees cost when the teapot has been twisted and turned back: one that is refitted, and one whose
/// boxes only grow.
void note_twist_and_back(const std::vector<Triangle>& teapot) {
    const Hierarchy tree = built(boxes_of(teapot), SplitMethod::Bins);
    Hierarchy swollen = tree;
    for (int frame = 0; frame <= 20; ++frame) {
        const Real time = 1 - std::abs(static_cast<Real>(frame) / 10 - 1);
        const Hierarchy now = refit(tree, boxes_of(twisted(teapot, time)));
        for (std::size_t i = 0; i < now.nodes.size(); ++i)
            swollen.nodes[i].box = merge(swollen.nodes[i].box, now.nodes[i].box);
    }
    numbers.add("cost when all is as it was", fmt::format("{:.1f}", predicted_cost(tree)));
    numbers.add("cost when boxes have only grown", fmt::format("{:.1f}", predicted_cost(swollen)));
}

void draw_motion(const Path& directory) {
    const std::vector<Triangle> teapot = teapot_of(13);
    const View view = view_of("size 228 160\ncamera 2 4.5 10  .1 1.5 0  0 1 0  34");
    const int frames = 20;
    std::string csv = "motion and frame,cost of the refitted tree,of a new one,ratio\n",
                measured = "what,seconds\n";
    std::vector<Image> images;
    std::vector<std::vector<Vec2>> curves;
    Mailbox mailbox;
    const std::array<std::pair<const char*, Motion>, 2> motions{{{"twist", twisted}, {"scatter", scattered}}};
    for (const auto& [name, motion] : motions) {
        Hierarchy tree = built(boxes_of(teapot), SplitMethod::Bins);
        curves.emplace_back();
        for (int frame = 0; frame <= frames; ++frame) {
            const std::vector<Triangle> now = motion(teapot, static_cast<Real>(frame) / frames);
            tree = refit(std::move(tree), boxes_of(now));
            const Real old_cost = predicted_cost(tree),
                       cost = predicted_cost(built(boxes_of(now), SplitMethod::Bins));
            csv += fmt::format("{} {},{:.1f},{:.1f},{:.2f}\n", name, frame, old_cost, cost, old_cost / cost);
            curves.back().push_back({frame, old_cost / cost});
            if (frame == 2 || frame == 5 || frame == 20)
                images.push_back(picture_of(now, view, [&](const Ray& ray) {
                    return closest_hit(tree, now, ray, {0, infinity}, mailbox);
                }));
        }
    }
    note_twist_and_back(teapot);
    const std::vector<Bounds> boxes = boxes_of(teapot_of(40));
    Hierarchy tree;
    for (const NamedMethod& way : methods)
        measured +=
            fmt::format("{},{:.2g}\n", way.name, seconds_of([&] { tree = built(boxes, way.method); }));
    measured += fmt::format("refit,{:.2g}\n", seconds_of([&] { tree = refit(std::move(tree), boxes); }));
    write_file(directory / "refit.csv", csv);
    write_file(directory / "measured_refit.csv", measured);
    write_image(directory / "motion.png", in_rows(images, 3));

    Svg svg{.width = 700, .height = 340};
    const Plot plot{{80, 50}, {540, 230}, {0, 20}, {1, 16, true}};
    draw_axes(svg, plot, {{0, "0"}, {5, "5"}, {10, "10"}, {15, "15"}, {20, "20"}},
              {{1, "1"}, {2, "2"}, {4, "4"}, {8, "8"}, {16, "16"}});
    text(svg, plot.corner + Vec2(270, 272), "frame", middle(SvgFont{.size = 16}));
    text(svg, plot.corner + Vec2(0, -12), "cost of the refitted tree, by that of a new one", {.size = 16});
    draw_curve(svg, plot, curves[0], blue);
    draw_curve(svg, plot, curves[1], red);
    text(svg, plot.place(20, curves[0].back().y) + Vec2(10, 5), "twist", colored(label, blue));
    text(svg, plot.place(20, curves[1].back().y) + Vec2(10, 5), "scatter", colored(label, red));
    write_svg(directory / "refit.svg", svg);
}

// Mistakes ----------------------------------------------------------------------------------------------

/// A teapot between a floor and a screen of large triangles.
std::vector<Triangle> teapot_on_floor() {
    std::vector<Triangle> triangles = teapot_of(12);
    const auto quad = [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        triangles.push_back({a, b, c}), triangles.push_back({a, c, d});
    };
    quad({-7, 0, 5}, {7, 0, 5}, {7, 0, -5}, {-7, 0, -5});
    quad({-6, 0, -2.4}, {6, 0, -4}, {6, 4.2, -5}, {-6, 4.2, -3.4});
    return triangles;
}

/// The picture with a right search, and with one that ends at the first leaf in which something is hit.
void draw_first_leaf(const Path& directory) {
    const std::vector<Triangle> triangles = teapot_on_floor();
    const Hierarchy tree = built(boxes_of(triangles), SplitMethod::Halves);
    const View view = view_of("size 346 200\ncamera 2.5 5 10  0 1.5 0  0 1 0  32");
    std::vector<Image> images;
    for (const Walk walk : {Walk::NearerFirst, Walk::UpToTheFirstHit})
        images.push_back(picture_of(
            triangles, view, [&](const Ray& ray) { return way_of(tree, triangles, ray, walk).nearest.hit; }));
    write_image(directory / "first_leaf.png", in_rows(images, 2));
}

/// What the order of the children is worth.
void count_orders() {
    const std::vector<Triangle> triangles = teapot_of(25);
    const Hierarchy tree = built(boxes_of(triangles), SplitMethod::Halves);
    const std::vector<Ray> rays = rays_around(4'000);
    for (const auto& [walk, name] :
         {std::pair{Walk::NearerFirst, "nearer first"}, {Walk::AsTheyStand, "as they stand"}}) {
        std::ptrdiff_t entered = 0;
        for (const Ray& ray : rays)
            entered += std::ranges::count(way_of(tree, triangles, ray, walk).fate, Fate::Entered);
        numbers.add(fmt::format("nodes a ray with children {}", name),
                    fmt::format("{:.1f}", static_cast<Real>(entered) / static_cast<Real>(rays.size())));
    }
}

// A curve -----------------------------------------------------------------------------------------------

/// The cells of a square in the order of their codes, and where the first bits cut them.
void draw_curve_of_codes(const Path& directory) {
    const Bounds box{Vec3(0), Vec3(8)};
    std::vector<std::pair<std::uint64_t, Vec2>> cells;
    for (int x = 0; x < 8; ++x)
        for (int y = 0; y < 8; ++y) {
            const Vec2 middle(x + 0.5, y + 0.5);
            cells.emplace_back(morton_code(box, Vec3(middle, 0)), middle);
        }
    std::ranges::sort(cells, {}, [](const auto& cell) { return cell.first; });
    Svg svg{.width = 420, .height = 390};
    const auto place = [](const Vec2& p) { return Vec2(30 + 44 * p.x, 370 - 44 * p.y); };
    rectangle(svg, place({0, 8}), {352, 352}, {.stroke = ink, .width = 1.5});
    line(svg, place({0, 4}), place({8, 4}), {.stroke = red, .width = 2.5});
    for (const Real y : {0.0, 4.0})
        line(svg, place({4, y}), place({4, y + 4}), {.stroke = blue, .width = 1.8, .dash = "7 4"});
    std::vector<Vec2> curve;
    for (std::size_t i = 0; i < cells.size(); ++i) curve.push_back(place(cells[i].second));
    polyline(svg, curve, {.stroke = green, .width = 1.6});
    for (std::size_t i = 0; i < curve.size(); ++i) {
        dot_at(svg, curve[i], green, 3);
        text(svg, curve[i] + Vec2(4, -5), std::to_string(i), {.size = 13});
    }
    write_svg(directory / "curve.svg", svg);
}

void draw(const Path& directory) {
    numbers.add("deepest leaf", deepest_leaf);
    numbers.add("bytes a node", sizeof(HierarchyNode));
    draw_levels(directory);
    draw_tree(directory);
    draw_first_leaf(directory);
    count_orders();
    draw_area(directory);
    draw_cut(directory);
    draw_heat_scale(directory);
    draw_stadium(directory);
    draw_growth(directory);
    draw_predictions(directory);
    draw_motion(directory);
    draw_curve_of_codes(directory);
    draw_volumes(directory);
    numbers.write(directory);
    draw_scenes(directory, __FILE__, {"city", "forest", "needles", "swarm"}, 240, 180);
}

}  // namespace

int main(int argc, char** argv) { return draw_figures(argc, argv, draw); }
