// Draws the figures of lesson 7 into the directory that it is given.
// Numbers in the figures are computed here, by the course's own functions where there is one.
#include "references/figures.hpp"
#include "chapters/01_ray_casting/camera.hpp"
#include "chapters/07_recursion/optics.hpp"
#include "common/render/trace.hpp"
#include "tests/pictures.hpp"
#include "tests/stability/optics.hpp"

#include <array>
#include <deque>
#include <functional>

using namespace rt;
using namespace rt::figures;

namespace {

/// Words that can be read when the figure is shown at half its size.
const SvgFont words{.size = 16};
const SvgFont remark{.size = 16, .color = "#666666"};

/// Numbers of the lesson that have no figure of their own.
Numbers numbers;

const char* color_of(RayKind kind) {
    return kind == RayKind::Camera ? ink : kind == RayKind::Reflection ? red : blue;
}

// The tree of rays -------------------------------------------------------------------------------------

void draw_tree(const Path& directory) {
    // A cut through a scene in the plane z = 0: a ball of glass over a mirror, a lamp, a wall.
    const Scene scene = parse_scene_text(
        "size 4 4\nmaxdepth 3\ncamera -3.6 2.1 0  0 0.9 0  0 1 0  40\nambient 0 0 0\nbackground .6 .75 .95\n"
        "transmission 1 1 1\nior 1.5\nfresnel exact\nsphere 0 1.05 0 .8\ntransmission 0 0 0\n"
        "specular .7 .7 .7\nplane 0 0 0  0 1 0\n",
        "figure");
    const World world = compile(scene);
    const Ray ray{{-3.6, 2.1, 0}, glm::normalize(Vec3(3.2, -0.72, 0))};
    const std::vector<TraceRecord> tree = trace_tree(world, ray);

    Svg svg{.width = 700, .height = 400};
    text(svg, {170, 26}, "The rays", heading);
    text(svg, {530, 26}, "Their tree", heading);
    const auto place = [](const Vec3& p) { return Vec2(188 + 46 * p.x, 280 - 46 * p.y); };
    const auto round_place = [](Real angle) {
        return Vec3(0.8 * std::cos(angle), 1.05 + 0.8 * std::sin(angle), 0);
    };
    std::vector<Vec2> ball;
    for (int i = 0; i < 72; ++i) ball.push_back(place(round_place(2 * pi * i / 72)));
    polygon(svg, ball, {.stroke = sky, .width = 2, .fill = "#eaf5fc"});
    rectangle(svg, {15, 280}, {325, 9}, {.stroke = "none", .fill = light});
    line(svg, {15, 280}, {340, 280}, {.width = 2});
    text(svg, {20, 308}, "mirror, specular 0.7", remark);
    text(svg, place({0.9, 1.75, 0}), "glass", remark);

    // Where in the second picture each ray has its node: a row a depth, leaves one beside the other.
    std::vector<std::vector<std::size_t>> children(tree.size());
    for (std::size_t i = 1; i < tree.size(); ++i)
        children[static_cast<std::size_t>(tree[i].parent)].push_back(i);
    std::size_t leaves = 0, all_leaves = 0;
    for (const auto& c : children) all_leaves += c.empty();
    std::vector<Vec2> node(tree.size());
    const std::function<void(std::size_t)> arrange = [&](std::size_t i) {
        const Real y = 66 + 88.0 * tree[i].branch.depth;
        if (children[i].empty()) {
            node[i] = {372 + 310 * (static_cast<Real>(leaves++) + 0.5) / static_cast<Real>(all_leaves), y};
            return;
        }
        for (const std::size_t c : children[i]) arrange(c);
        node[i] = {(node[children[i].front()].x + node[children[i].back()].x) / 2, y};
    };
    arrange(0);
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const TraceRecord& r = tree[i];
        const SvgStyle style{.stroke = color_of(r.branch.kind), .width = 1.4 + 1.4 * r.weight.y};
        const Vec3& o = r.branch.ray.origin;
        const Vec3 end = o + (r.hit ? r.hit->t : 0.7) * r.branch.ray.direction;
        arrow(svg, place(o), place(end), style, 8);
        if (i > 0) line(svg, node[static_cast<std::size_t>(r.parent)], node[i], style);
    }
    dot_at(svg, place(ray.origin), purple, 6);
    text(svg, place(ray.origin) + Vec2(-8, -12), "eye", words);
    for (std::size_t i = 0; i < tree.size(); ++i) {
        const TraceRecord& r = tree[i];
        circle(svg, node[i], 9, {.stroke = color_of(r.branch.kind), .width = 2, .fill = "#ffffff"});
        const bool glass = r.hit && world.materials[r.material].transmission.x > 0;
        text(svg, node[i] + Vec2(0, 4.5), !r.hit ? "s" : glass ? "g" : "m", middle(SvgFont{.size = 14}));
        text(svg, node[i] + Vec2(14, 6), decimal(r.branch.weight.y, r.branch.weight.y < 0.1 ? 3 : 2),
             {.size = 15, .color = ink});
    }
    text(svg, {372, 385}, "g glass, m mirror, s sky; with weights", remark);
    text(svg, {20, 345}, "red: reflected, blue: refracted", remark);
    text(svg, {20, 365}, "the thicker, the more it weighs", remark);
    write_svg(directory / "tree.svg", svg);
}

// Snell ------------------------------------------------------------------------------------------------

void draw_snell(const Path& directory) {
    Svg svg{.width = 700, .height = 390};
    const std::array<const char*, 4> colors{green, blue, orange, red};
    const auto draw = [&](Vec2 center, bool into, const std::vector<Real>& angles, const char* title) {
        text(svg, {center.x, 26}, title, heading);
        const Real eta = into ? 1 / 1.5 : 1.5, y = into ? 0 : -130;
        rectangle(svg, center + Vec2(-160, y), {320, 130}, {.stroke = "none", .fill = "#eaf5fc"});
        line(svg, center + Vec2(-160, 0), center + Vec2(160, 0), {.stroke = sky, .width = 2});
        line(svg, center + Vec2(0, -130), center + Vec2(0, 130), {.stroke = grey, .width = 1, .dash = "5 4"});
        for (std::size_t i = 0; i < angles.size(); ++i) {
            const Real angle = radians(angles[i]);
            const Vec3 d(std::sin(angle), -std::cos(angle), 0), n(0, 1, 0);
            const SvgStyle style{.stroke = colors[i], .width = 2};
            const auto at = [&](const Vec3& p) { return center + 122.0 * Vec2(p.x, -p.y); };
            line(svg, at(-d), center, style);
            const auto t = refract(d, n, eta);
            arrow(svg, center, at(t ? *t : reflect(d, n)), style, 8);
            text(svg, center + 144.0 * Vec2(-d.x, d.y) + Vec2(0, 5), decimal(angles[i], 1) + "°",
                 middle(colored(words, colors[i])));
            const Real out = t ? std::asin(t->x) * 180 / pi : 0;
            if (t && angles[i] > 0)
                text(svg, center + 146.0 * Vec2(t->x, -t->y) + Vec2(0, 6), decimal(out, 1) + "°",
                     middle(colored(words, colors[i])));
        }
    };
    draw({178, 200}, true, {15, 45, 75}, "Into glass, eta = 1/1.5");
    draw({522, 200}, false, {12, 28, 41.5, 55}, "Out of glass, eta = 1.5");
    text(svg, {350, 372}, "Out of glass nothing is refracted beyond 41.8°: the red ray is mirrored whole.",
         middle(remark));
    write_svg(directory / "snell.svg", svg);
}

// Fresnel and Schlick ----------------------------------------------------------------------------------

void draw_fresnel(const Path& directory) {
    std::string csv = "degrees,into_exact,into_schlick,into_error,out_exact,out_schlick,out_error\n";
    Svg svg{.width = 700, .height = 440};
    text(svg, {350, 26}, "Reflected part of the light, glass with ior 1.5", heading);
    const Plot plot{{70, 45}, {600, 220}, {0, 90}, {0, 1}};
    const Plot below{{70, 300}, {600, 85}, {0, 90}, {-0.06, 0.06}};
    draw_axes(svg, plot, {}, {{0, "0"}, {0.25, "0.25"}, {0.5, "0.5"}, {0.75, "0.75"}, {1, "1"}});
    draw_axes(svg, below,
              {{0, "0°"}, {15, "15°"}, {30, "30°"}, {45, "45°"}, {60, "60°"}, {75, "75°"}, {90, "90°"}},
              {{-0.05, "−0.05"}, {0, "0"}, {0.05, "0.05"}});
    std::array<std::vector<Vec2>, 2> exact, approximate, error;
    const std::array<Real, 2> etas{1 / 1.5, 1.5};
    std::array<Real, 2> worst{0, 0}, worst_at{0, 0};
    for (int i = 0; i <= 900; ++i) {
        const Real degrees = i / 10.0, cosine = std::max(std::cos(radians(degrees)), 0.0);
        if (i % 10 == 0) csv += decimal(degrees, 0);
        for (std::size_t k = 0; k < 2; ++k) {
            const Real f = fresnel(cosine, etas[k]), s = schlick(cosine, etas[k]);
            if (std::abs(s - f) > std::abs(worst[k])) worst[k] = s - f, worst_at[k] = degrees;
            // Steeper near the critical angle than a step of a degree can show.
            if (i % 2 == 0 || (i > 410 && i < 424)) {
                exact[k].push_back(plot.place(degrees, f));
                approximate[k].push_back(plot.place(degrees, s));
                error[k].push_back(below.place(degrees, s - f));
            }
            if (i % 10 == 0) csv += "," + decimal(f, 6) + "," + decimal(s, 6) + "," + decimal(s - f, 6);
        }
        if (i % 10 == 0) csv += "\n";
    }
    for (std::size_t k = 0; k < 2; ++k) {
        const char* color = k == 0 ? blue : red;
        polyline(svg, exact[k], {.stroke = color, .width = 2});
        polyline(svg, approximate[k], {.stroke = color, .width = 2, .dash = "6 4"});
        polyline(svg, error[k], {.stroke = color, .width = 1.6});
    }
    text(svg, plot.place(52, 0.22), "into glass", colored(words, blue));
    text(svg, plot.place(27, 0.6), "out of glass", colored(words, red));
    text(svg, plot.place(3, 0.86), "solid: Fresnel; dashed: Schlick", remark);
    text(svg, below.place(3, 0.035), "Schlick − Fresnel", remark);
    text(svg, {370, 432}, "angle of incidence", middle(words));
    write_svg(directory / "fresnel.svg", svg);
    write_file(directory / "fresnel.csv", csv);
    for (std::size_t k = 0; k < 2; ++k)
        numbers.add(std::string("greatest error of Schlick's approximation ") + (k == 0 ? "into" : "out of") +
                        " glass",
                    decimal(std::abs(worst[k]), 4));
    numbers.add("critical angle of glass in degrees", decimal(std::asin(1 / 1.5) * 180 / pi, 2));
    numbers.add("part that glass mirrors of straight light", decimal(fresnel(1, 1 / 1.5), 4));
}

// Cancellation -----------------------------------------------------------------------------------------

/// How far `refract` is off where a ray grazes the border between equal media, and so should go straight on.
void draw_cancellation(const Path& directory) {
    Svg svg{.width = 700, .height = 340};
    text(svg, {370, 26}, "From glass into the same glass: how far off is the ray?", heading);
    const Plot plot{{95, 45}, {575, 215}, {1e-10, 1, true}, {1e-17, 1e-7, true}};
    draw_axes(svg, plot,
              {{1e-10, "1e-10"}, {1e-8, "1e-8"}, {1e-6, "1e-6"}, {1e-4, "1e-4"}, {1e-2, "1e-2"}, {1, "1"}},
              {{1e-16, "1e-16"}, {1e-14, "1e-14"}, {1e-12, "1e-12"}, {1e-10, "1e-10"}, {1e-8, "1e-8"}});
    std::string csv = "cosine,error_1_minus_eta2_sin2,error_of_ours\n";
    for (Real exponent = -9.9; exponent < 0; exponent += 0.1) {
        Real textbook = 0, ours = 0, cosine = 0;
        for (int i = 0; i < 20; ++i) {
            const Real c = std::pow(10.0, exponent + 0.005 * i);
            if (i == 0) cosine = c;
            const Vec3 n(0, 1, 0), d(std::sqrt((1 - c) * (1 + c)), -c, 0);
            const auto a = naive::refract_cancelling(d, n, 1), b = refract(d, n, 1);
            textbook = std::max(textbook, a ? length(*a - d) : 1.0);
            ours = std::max(ours, b ? length(*b - d) : 1.0);
        }
        dot_at(svg, plot.place(cosine, std::max(textbook, 1e-17)), red, 3);
        dot_at(svg, plot.place(cosine, std::max(ours, 1e-17)), blue, 3);
        char row[80];
        std::snprintf(row, sizeof row, "%.3g,%.2g,%.2g\n", cosine, textbook, ours);
        csv += row;
    }
    text(svg, plot.place(1e-5, 3e-9), "1 − eta²·(1 − cos²)", colored(words, red));
    text(svg, plot.place(2e-10, 1.5e-15), "(1 − eta)·(1 + eta) + (eta·cos)²", colored(words, blue));
    text(svg, {370, 305}, "cosine of the angle of incidence (left: grazing)", middle(words));
    text(svg, {28, 152}, "error of the direction", {.size = 16, .anchor = "middle", .turn = -90});
    text(svg, {370, 328}, "Points at the bottom have no error at all.", middle(remark));
    write_svg(directory / "cancellation.svg", svg);
    write_file(directory / "cancellation.csv", csv);
}

/// What percentage of 100,000 random cases between nearly equal media break the bound of the tests.
void count_failures() {
    const auto families = stability::interface_families();
    const auto nearly_equal =
        std::find_if(families.begin(), families.end(), [](const stability::InterfaceFamily& family) {
            return std::string(family.name).starts_with("nearly equal media");
        });
    const std::vector<stability::InterfaceCase> questions = nearly_equal->make(100'000, 7);
    const auto failures = [&](auto method) {
        std::vector<std::optional<Vec3>> answers;
        for (const stability::InterfaceCase& q : questions) answers.push_back(method(q.d, q.n, q.eta));
        const auto wrong = static_cast<Real>(stability::judge_refraction(questions, answers).mismatches);
        return decimal(wrong / static_cast<Real>(questions.size()) * 100, 1);
    };
    numbers.add("wrong of 100 between nearly equal media by the textbook's form",
                failures(naive::refract_cancelling));
    numbers.add("wrong of 100 between nearly equal media by ours", failures(refract));
}

// Media ------------------------------------------------------------------------------------------------

void draw_media(const Path& directory) {
    Svg svg{.width = 700, .height = 340};
    const auto draw = [&](Real left, const char* title, const std::string& objects,
                          const std::vector<std::pair<Vec2, Real>>& circles,
                          const std::vector<std::string>& names, const std::array<Vec2, 2>& name_at,
                          Real height) {
        text(svg, {left + 165, 26}, title, heading);
        const World world = compile(parse_scene_text(
            "size 4 4\nmaxdepth 9\ncamera -9 0 0 0 0 0 0 1 0 45\nambient 0 0 0\ntransmission 1 1 1\n" +
                objects,
            "figure"));
        const auto place = [&](const Vec3& p) { return Vec2(left + 165 + 48 * p.x, 165 - 48 * p.y); };
        const std::array<const char*, 2> fills{"#dff0fa", "#bcdff2"};
        for (std::size_t i = 0; i < circles.size(); ++i)
            circle(svg, place({circles[i].first.x, circles[i].first.y, 0}), 48 * circles[i].second,
                   {.stroke = sky, .width = 1.5, .fill = fills[i], .opacity = 0.85});
        for (std::size_t i = 0; i < circles.size(); ++i)
            text(svg, place({circles[i].first.x, circles[i].first.y, 0}) + name_at[i], names[i],
                 middle(remark));
        const auto tree = trace_tree(world, {{-3.1, height, 0}, {1, 0, 0}});
        for (const TraceRecord& r : tree) {
            const Vec3& o = r.branch.ray.origin;
            const Vec3 end = o + (r.hit ? r.hit->t : 0.9) * r.branch.ray.direction;
            arrow(svg, place(o), place(end), {.stroke = blue, .width = 2}, 8);
            std::string inside;
            for (const Medium& medium : r.branch.media)
                inside += (inside.empty() ? "" : ", ") + names[medium.object];
            const std::size_t step = static_cast<std::size_t>(&r - tree.data());
            const Vec2 at = place(0.5 * (o + end));
            dot_at(svg, at, "#ffffff", 8);
            text(svg, at + Vec2(0, 5), std::to_string(step + 1), middle(colored(words, ink)));
            text(svg, {left + 16 + (step >= 3 ? 185.0 : 0), 284 + 21 * static_cast<Real>(step % 3)},
                 std::to_string(step + 1) + ": [" + inside + "]", words);
        }
    };
    draw(0, "Glass in water", "ior 1.33\nsphere 0 0 0 2\nior 1.5\nsphere 0 0 0 1\n",
         {{{0, 0}, 2}, {{0, 0}, 1}}, {"water", "glass"}, {Vec2(0, 78), Vec2(0, 30)}, 0.55);
    draw(350, "Two that overlap", "ior 1.5\nsphere -.7 0 0 1.5\nior 1.33\nsphere .7 0 0 1.5\n",
         {{{-0.7, 0}, 1.5}, {{0.7, 0}, 1.5}}, {"glass", "water"}, {Vec2(-32, 40), Vec2(32, 40)}, 0.5);
    write_svg(directory / "media.svg", svg);
}

// Termination ------------------------------------------------------------------------------------------

/// A floor that mirrors makes the trees large.
void mirror_the_floor(Scene& scene) {
    for (Material& m : scene.materials)
        if (m.transmission == Vec3(0) && !(m.diffuse == Vec3(0))) m.specular = Vec3(0.4);
}

void measure_termination(const Path& directory) {
    constexpr std::size_t repeats = 9;
    Scene scene = scene_beside(__FILE__, "fresnel");
    scene.width = 160, scene.height = 120;
    mirror_the_floor(scene);
    scene.max_depth = 40;
    scene.min_contribution = 1e-7;
    const RenderResult truth = render(compile(scene), {});
    std::string csv = "rule,milliseconds,rmse,rays\n";
    struct Point {
        std::string value;
        World world;
        Real error;
        std::uint64_t rays;
        Real time = 0;
        std::array<Real, repeats> times = {};
    };
    std::array<std::vector<Point>, 2> curves;
    const auto add = [&](std::size_t method, const std::string& value) {
        const World world = compile(scene);
        const RenderResult result = render(world, {1, {}});
        const std::uint64_t rays = result.rays.camera + result.rays.reflection + result.rays.refraction;
        curves[method].push_back({value, world, test::rms_difference(result.image, truth.image), rays});
    };
    scene.min_contribution = 0;
    for (const int depth : {0, 1, 2, 3, 4, 5, 6, 8, 10, 12}) {
        scene.max_depth = depth;
        add(0, std::to_string(depth));
    }
    scene.max_depth = 40;
    for (const char* c : {"0.5", "0.2", "0.1", "0.05", "0.02", "0.01", "0.005", "0.002", "0.001", "0.0001"}) {
        scene.min_contribution = std::stod(c);
        add(1, c);
    }
    // Round after round, so that a busy moment of the machine hits all points alike.
    for (std::size_t round = 0; round < repeats; ++round)
        for (auto& curve : curves)
            for (Point& p : curve) p.times[round] = 1000 * render(p.world, {1, {}}).cpu_seconds;
    for (auto& curve : curves) {
        for (Point& p : curve) {
            std::sort(p.times.begin(), p.times.end());
            p.time = p.times[repeats / 2];
            char row[120];
            std::snprintf(row, sizeof row, "%s %s,%.2f,%.3g,%llu\n",
                          &curve == &curves[0] ? "depth" : "contribution", p.value.c_str(), p.time, p.error,
                          static_cast<unsigned long long>(p.rays));
            csv += row;
        }
    }
    write_file(directory / "measured_termination.csv", csv);

    Svg svg{.width = 700, .height = 400};
    text(svg, {370, 26}, "Error against time: ending trees by depth and by contribution", heading);
    Real slowest = 0, fastest = infinity, best = infinity, worst = 0;
    for (const auto& curve : curves)
        for (const Point& p : curve)
            slowest = std::max(slowest, p.time), fastest = std::min(fastest, p.time),
            best = std::min(best, p.error), worst = std::max(worst, p.error);
    const Plot plot{
        {85, 45}, {590, 290}, {fastest * 0.8, slowest * 1.25, true}, {best * 0.5, worst * 2, true}};
    std::vector<std::pair<Real, std::string>> xs, ys;
    for (const Real t : {10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0})
        if (t > plot.x.low && t < plot.x.high) xs.emplace_back(t, decimal(t) + " ms");
    for (int k = -8; k <= 0; ++k)
        if (const Real e = std::pow(10.0, k); e > plot.y.low && e < plot.y.high)
            ys.emplace_back(e, "1e" + std::to_string(k));
    draw_axes(svg, plot, xs, ys);
    for (std::size_t k = 0; k < 2; ++k) {
        const char* color = k == 0 ? blue : red;
        std::vector<Vec2> points;
        for (const Point& p : curves[k]) points.push_back(plot.place(p.time, p.error));
        polyline(svg, points, {.stroke = color, .width = 2});
        for (std::size_t i = 0; i < points.size(); ++i) {
            dot_at(svg, points[i], color, 4);
            text(svg, points[i] + (k == 0 ? Vec2(8, -4) : Vec2(-8, 14)), curves[k][i].value,
                 {.size = 15, .color = color, .anchor = k == 0 ? "start" : "end"});
        }
    }
    text(svg, {410, 70}, "by depth (maxdepth)", colored(words, blue));
    text(svg, {410, 92}, "by mincontribution", colored(words, red));
    text(svg, {370, 382}, "CPU time of one thread, median of 9", middle(words));
    text(svg, {24, 190}, "RMSE to the truth", {.size = 16, .anchor = "middle", .turn = -90});
    write_svg(directory / "measured_termination.svg", svg);
}

void measure_whitted(const Path& directory) {
    const World world = compile(scene_beside(__FILE__, "whitted"));
    std::string csv =
        "threads,milliseconds,cpu_milliseconds,rays,million_rays_per_second,times faster than 74 minutes\n";
    for (const int threads : {1, 2}) {
        std::array<Real, 5> times{};
        Real cpu = 0;
        std::uint64_t rays = 0;
        for (Real& t : times) {
            const RenderResult result = render(world, {threads, {}});
            const RayCounts& n = result.rays;
            rays = n.camera + n.shadow + n.reflection + n.refraction;
            t = result.seconds;
            cpu += 1000 * result.cpu_seconds / static_cast<Real>(times.size());
        }
        std::sort(times.begin(), times.end());
        char row[120];
        std::snprintf(row, sizeof row, "%d,%.0f,%.0f,%llu,%.2f,%.0f\n", threads, 1000 * times[2], cpu,
                      static_cast<unsigned long long>(rays), static_cast<Real>(rays) / times[2] / 1e6,
                      74 * 60 / times[2]);
        csv += row;
    }
    write_file(directory / "measured_whitted.csv", csv);
}

// The stack ---------------------------------------------------------------------------------------------

/// How many rays wait at once, at most, for any pixel, where the last or the first of them is taken.
std::size_t most_waiting(const World& world, bool take_last) {
    std::size_t most = 0;
    for (int y = 0; y < world.view.height; ++y)
        for (int x = 0; x < world.view.width; ++x) {
            std::deque<Branch> waiting(1);
            waiting[0].ray = pixel_ray(world.view, x + 0.5, y + 0.5);
            while (!waiting.empty()) {
                most = std::max(most, waiting.size());
                const Branch b = take_last ? waiting.back() : waiting.front();
                if (take_last)
                    waiting.pop_back();
                else
                    waiting.pop_front();
                const auto met = closest_hit(world, b.ray, Interval{0, infinity});
                if (!met) continue;
                const Surface s = surface_at(world, b.ray, *met);
                const Branches sent = scatter(world, b, *met, s, material_at(world, *met, s));
                for (int k = 0; k < sent.count; ++k)
                    waiting.push_back(sent.branch[static_cast<std::size_t>(k)]);
            }
        }
    return most;
}

void count_waiting() {
    Scene scene = scene_beside(__FILE__, "fresnel", 160, 120);
    mirror_the_floor(scene);
    scene.max_depth = 12;
    const World world = compile(scene);
    numbers.add("most rays that wait at depth 12 if the last is taken",
                std::to_string(most_waiting(world, true)));
    numbers.add("most rays that wait at depth 12 if the first is taken",
                std::to_string(most_waiting(world, false)));
    numbers.add(
        "rays of pixel (200; 250)",
        std::to_string(trace_tree(compile(scene_beside(__FILE__, "whitted")),
                                  pixel_ray(compile(scene_beside(__FILE__, "whitted")).view, 200.5, 250.5))
                           .size()));
}

// Mistakes ----------------------------------------------------------------------------------------------

enum class Mistake { UpsideDown, TotalIsLost, NoOffset, NoWeights };

/// What arrives along a ray, by a function that calls itself, with a mistake in it.
Vec3 seen(const World& world, const Branch& b, Mistake mistake) {
    const auto met = closest_hit(world, b.ray, Interval{0, infinity});
    if (!met) return background(world, b.ray.direction);
    const Surface s = surface_at(world, b.ray, *met);
    const Material m = material_at(world, *met, s);
    const Vec3& d = b.ray.direction;
    const Vec3 facing = dot(s.shading_normal, d) > 0 ? -s.shading_normal : s.shading_normal;
    Vec3 color = local_light(world, s, m, facing, -d);
    const Branches sent = scatter(world, b, *met, s, m);
    const bool total = sent.count == 1 && m.transmission.x > 0 && sent.branch[0].kind == RayKind::Reflection;
    for (int k = 0; k < sent.count; ++k) {
        Branch one = sent.branch[static_cast<std::size_t>(k)];
        Vec3 factor = one.weight;
        one.weight = Vec3(1);
        if (mistake == Mistake::NoWeights) factor = Vec3(1);
        if (mistake == Mistake::TotalIsLost && total) factor = m.specular;
        if (mistake == Mistake::NoOffset) one.ray.origin = s.point;
        if (mistake == Mistake::UpsideDown && one.kind == RayKind::Refraction) {
            const auto bent = refract(d, facing, ior(world, one.media) / ior(world, b.media));
            if (!bent) continue;
            one.ray.direction = *bent;
        }
        color += factor * seen(world, one, mistake);
    }
    return color;
}

/// The ball of glass, or Whitted's picture, with the mistakes that the lesson names.
void draw_mistakes(const Path& directory) {
    std::vector<Image> images;
    for (const auto& [name, mistake] : {std::pair{"glass", Mistake::UpsideDown},
                                        {"whitted", Mistake::TotalIsLost},
                                        {"glass", Mistake::NoOffset},
                                        {"whitted", Mistake::NoWeights}}) {
        const World world = compile(scene_beside(__FILE__, name, 300, 225));
        Image image = make_image(world.view.width, world.view.height);
        for (int y = 0; y < image.height; ++y)
            for (int x = 0; x < image.width; ++x) {
                Branch camera;
                camera.ray = pixel_ray(world.view, x + 0.5, y + 0.5);
                pixel(image, x, y) = seen(world, camera, mistake);
            }
        images.push_back(image);
    }
    write_image(directory / "mistakes.png", in_rows(images, 2));
}

// Pictures ---------------------------------------------------------------------------------------------

/// Whitted's scene with 0, 1, 3, 4 and 8 bounces, side by side.
void draw_depths(const Path& directory) {
    std::vector<Image> images;
    for (const int depth : {0, 1, 3, 4, 8}) {
        Scene scene = scene_beside(__FILE__, "whitted", 140, 140);
        scene.max_depth = depth;
        images.push_back(render(compile(scene)).image);
    }
    write_image(directory / "depths.png", in_rows(images, 5, 4));
}

void draw_all(const Path& directory) {
    draw_tree(directory);
    draw_snell(directory);
    draw_fresnel(directory);
    draw_cancellation(directory);
    draw_media(directory);
    draw_depths(directory);
    draw_mistakes(directory);
    draw_scenes(directory, __FILE__, {"whitted", "mirrors", "glass", "neighbours", "fresnel", "tir", "ice"});
    count_failures();
    count_waiting();
    numbers.write(directory);
    measure_whitted(directory);
    measure_termination(directory);
}

}  // namespace

int main(int argc, char** argv) { return draw_figures(argc, argv, draw_all); }
