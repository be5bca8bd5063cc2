// The stability families at full size, in batches, with their verdicts side by side.
#include "tests/report/families.hpp"

#include "chapters/02_spheres/sphere.hpp"
#include "chapters/03_triangles/polygon.hpp"
#include "chapters/03_triangles/triangle.hpp"
#include "chapters/04_transforms/instance.hpp"
#include "chapters/04_transforms/transform.hpp"
#include "chapters/07_recursion/optics.hpp"
#include "chapters/10_surfaces/box.hpp"
#include "chapters/10_surfaces/cone.hpp"
#include "chapters/10_surfaces/disc.hpp"
#include "chapters/10_surfaces/implicit.hpp"
#include "chapters/10_surfaces/quadric.hpp"
#include "chapters/10_surfaces/torus.hpp"
#include "tests/stability/grids.hpp"
#include "tests/stability/hierarchies.hpp"
#include "tests/stability/leaving.hpp"
#include "tests/stability/naive.hpp"
#include "tests/stability/optics.hpp"
#include "tests/stability/shadows.hpp"
#include "tests/stability/spheres.hpp"
#include "tests/stability/transforms.hpp"
#include "tests/stability/triangles.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

namespace rt::report {
namespace {

using namespace stability;

/// Both verdicts on a batch of new cases; that on the textbook method only where it is wanted.
using Batch = std::function<void(std::size_t count, std::uint64_t seed, Verdict& stable, Verdict* naive)>;

struct Task {
    FamilyRow row;
    std::size_t cases = 0;
    std::size_t part = 0;  ///< cases in a batch: all of them at once would fill the memory
    Batch batch;
};

/// The batch of a family: `make` makes cases, `stable` and `naive` answer one, `verdict` judges all.
template <class Answer, class Make, class Stable, class Naive>
Batch ask(Make make, Stable stable, Naive naive) {
    return [=](std::size_t count, std::uint64_t seed, Verdict& right, Verdict* wrong) {
        const auto questions = make(count, seed);
        const auto answers = [&](const auto& method) {
            std::vector<Answer> result;
            result.reserve(questions.size());
            for (const auto& question : questions) result.push_back(method(question));
            return result;
        };
        right = judge(questions, answers(stable));
        if (wrong) *wrong = judge(questions, answers(naive));
    };
}

using OptionalHit = std::optional<Hit>;

constexpr std::size_t usual_part = 10'000;
constexpr std::size_t rays_a_scene = 100;  ///< of a grid

void add_spheres(std::vector<Task>& tasks, std::size_t cases) {
    tasks.push_back(
        {{"02",
          "roots of a quadratic",
          "coefficients of all sizes",
          "1, the discriminant is data",
          "4u",
          "textbook formula",
          {},
          {}},
         cases,
         usual_part,
         ask<Roots>(
             quadratic_cases,
             [](const QuadraticCase& q) { return solve_quadratic(q.a, q.h, q.c, q.discriminant); },
             [](const QuadraticCase& q) { return naive::solve_quadratic(q.a, q.h, q.c); })});
    for (const SphereFamily& family : sphere_families()) {
        tasks.push_back({{"02",
                          "both roots of line and sphere",
                          family.name,
                          family.condition,
                          "8κu",
                          "textbook formula",
                          {},
                          {}},
                         cases,
                         usual_part,
                         ask<Roots>(
                             family.make, [](const SphereCase& q) { return intersections(q.sphere, q.ray); },
                             [](const SphereCase& q) { return naive::intersections(q.sphere, q.ray); })});
        tasks.push_back(
            {{"02",
              "nearest hit with a sphere",
              family.name,
              family.condition,
              "8κu",
              "textbook formula, epsilon 1e-4",
              {},
              {}},
             cases,
             usual_part,
             ask<OptionalHit>(
                 family.make, [](const SphereCase& q) { return intersect(q.sphere, q.ray, Interval{}); },
                 [](const SphereCase& q) { return naive::intersect(q.sphere, q.ray, Interval{}); })});
    }
}

void add_triangles(std::vector<Task>& tasks, const FamiliesOptions& options) {
    const auto stable = [](const TriangleCase& q) { return intersect(q.triangle, q.ray, Interval{}); };
    const auto textbook = [](const TriangleCase& q) {
        return naive::intersect(q.triangle, q.ray, Interval{});
    };
    constexpr const char* name = "Möller–Trumbore with its constants";
    for (const TriangleFamily& family : triangle_families())
        tasks.push_back({{"03", "hit with a triangle", family.name, family.condition, "8κu", name, {}, {}},
                         family.at_edges ? options.aimed : options.judged,
                         usual_part,
                         ask<OptionalHit>(family.make, stable, textbook)});
    tasks.push_back({{"03",
                      "unit normal of a triangle",
                      "needles, in every order of the corners",
                      "unbounded: exact where rounding weighs",
                      "128u",
                      "edges from the first corner",
                      {},
                      {}},
                     options.judged,
                     usual_part,
                     [](std::size_t count, std::uint64_t seed, Verdict& right, Verdict* wrong) {
                         const auto cases = needles(count, seed);
                         const auto verdict = [&](auto normal) {
                             std::vector<Vec3> answers;
                             for (const TriangleCase& item : cases) answers.push_back(normal(item.triangle));
                             return judge_normals(cases, answers);
                         };
                         right = verdict(unit_normal);
                         if (wrong) *wrong = verdict(naive::unit_normal);
                     }});
    tasks.push_back({{"03",
                      "tiles of polygons: exactly one is hit",
                      "rays at the seams",
                      "exactly at edges and corners",
                      "",
                      "the rounded point in each polygon",
                      {},
                      {}},
                     options.judged,
                     usual_part,
                     ask<std::size_t>(
                         tiles_cases, [](const TilesCase& q) { return tiles_hit(q, rt::intersect); },
                         [](const TilesCase& q) { return tiles_hit(q, naive::intersect); })});
    for (const SurfaceFamily& family : surface_families()) {
        // A fan has a thousand triangles; each of them is asked.
        const bool fan = family.triangles > 100;
        tasks.push_back({{"03",
                          "no gaps between triangles",
                          family.name,
                          "exactly at edges and corners",
                          "",
                          name,
                          {},
                          {}},
                         fan ? options.aimed / 200 : options.aimed,
                         std::max<std::size_t>(1, 2 * usual_part / family.triangles),
                         [=](std::size_t count, std::uint64_t seed, Verdict& right, Verdict* wrong) {
                             const Bundles bundles = family.make(count, seed);
                             const auto answers = [&](const auto& method) {
                                 std::vector<OptionalHit> result;
                                 result.reserve(bundles.cases.size());
                                 for (const TriangleCase& item : bundles.cases)
                                     result.push_back(method(item));
                                 return result;
                             };
                             right = judge(bundles, answers(stable));
                             if (wrong) *wrong = judge(bundles, answers(textbook));
                         }});
    }
    tasks.push_back({{"03",
                      "sign of an edge function",
                      "nearly parallel vectors",
                      "unbounded: signs are exact",
                      "",
                      "rounded products",
                      {},
                      {}},
                     options.judged,
                     usual_part,
                     ask<Real>(
                         turn_cases, [](const TurnCase& q) { return edge_function(q.p, q.q); },
                         [](const TurnCase& q) { return q.p.x * q.q.y - q.p.y * q.q.x; })});
    tasks.push_back({{"03",
                      "barycentric weights",
                      "weights in sixteenths, aspect up to 2^27",
                      "longest edge over lowest height",
                      "8κu",
                      "Cramer's rule on dot products",
                      {},
                      {}},
                     options.judged,
                     usual_part,
                     ask<std::optional<Vec3>>(
                         weight_cases, [](const WeightCase& q) { return barycentric(q.triangle, q.point); },
                         [](const WeightCase& q) { return naive::barycentric(q.triangle, q.point); })});
    const auto outline = [](auto inside) {
        return [inside](const OutlineCase& q) {
            return OutlineAnswer{inside(q.whole, q.point), inside(q.left, q.point), inside(q.right, q.point)};
        };
    };
    tasks.push_back(
        {{"03",
          "point in polygon",
          "polygons cut in two",
          "points on the cut",
          "",
          "crossings, not symmetric",
          {},
          {}},
         options.judged,
         usual_part,
         ask<OutlineAnswer>(
             outline_cases, outline([](const auto& p, const Vec2& at) { return point_in_polygon(p, at); }),
             outline([](const auto& p, const Vec2& at) { return naive::point_in_polygon(p, at); }))});
}

void add_transforms(std::vector<Task>& tasks, std::size_t cases) {
    // Judging a matrix takes ten times as long as judging a hit.
    const std::size_t matrices = (cases + 3) / 4;
    for (const MatrixFamily& family : matrix_families())
        tasks.push_back({{"04",
                          "inverse of a matrix",
                          family.name,
                          family.condition,
                          "8κu",
                          "adjugate over determinant, constant 1e-12",
                          {},
                          {}},
                         matrices,
                         usual_part,
                         ask<std::optional<Mat4>>(
                             family.make, [](const Mat4& m) { return inverse(m); },
                             [](const Mat4& m) { return naive::inverse(m); })});
    for (const MatrixFamily& family : matrix_families().first(6))
        tasks.push_back(
            {{"04",
              "normal of an image",
              family.name,
              "of the normal and the tangent",
              "8κu",
              "normal taken for a direction",
              {},
              {}},
             matrices,
             usual_part,
             ask<Vec3>([&family](std::size_t count,
                                 std::uint64_t seed) { return normal_cases(family, count, seed); },
                       [](const NormalCase& q) {
                           Surface local;
                           local.normal = local.shading_normal = normalize(q.normal);
                           return to_world(q.transform, local).normal;
                       },
                       [](const NormalCase& q) {
                           return normalize(naive::transform_normal(q.transform.to_world, q.normal));
                       })});
    for (const EllipsoidFamily& family : ellipsoid_families())
        tasks.push_back({{"04",
                          "hit with an ellipsoid",
                          family.name,
                          family.condition,
                          "8κu",
                          "direction made a unit vector",
                          {},
                          {}},
                         cases,
                         usual_part,
                         ask<OptionalHit>(
                             family.make,
                             [](const EllipsoidCase& q) { return intersect(q.ellipsoid, q.ray, Interval{}); },
                             [](const EllipsoidCase& q) {
                                 return naive::intersect(Sphere{Vec3(0), 1},
                                                         naive::to_local(q.ellipsoid.transform, q.ray),
                                                         Interval{});
                             })});
}

void add_shadows(std::vector<Task>& tasks, std::size_t cases) {
    for (const ShadowFamily& family : shadow_families())
        tasks.push_back({{"06",
                          "shadow ray: self hits and lost occluders",
                          family.name,
                          family.extremes,
                          "",
                          "fixed epsilon 1e-4",
                          {},
                          {}},
                         cases / shadow_families().size(),
                         usual_part,
                         [&family](std::size_t count, std::uint64_t seed, Verdict& right, Verdict* wrong) {
                             const std::vector<ShadowCase> questions = make_cases(family, count, seed);
                             const auto verdict = [&](auto method) {
                                 std::vector<ShadowRay> rays;
                                 rays.reserve(questions.size());
                                 for (const ShadowCase& q : questions)
                                     rays.push_back(method(q.surface, q.light));
                                 const ShadowVerdict judged = judge(questions, rays);
                                 return Verdict{judged.cases,
                                                0,
                                                judged.self_hits + judged.lost,
                                                0,
                                                "",
                                                judged.first_self_hit.empty() ? judged.first_lost
                                                                              : judged.first_self_hit};
                             };
                             right = verdict(shadow_ray);
                             if (wrong) *wrong = verdict(naive::shadow_ray_with_epsilon);
                         }});
}

void add_optics(std::vector<Task>& tasks, std::size_t cases) {
    // Its judge needs numbers with more than 53 bits.
    if (std::numeric_limits<long double>::digits < 64) return;
    using Refract = std::optional<Vec3> (*)(const Vec3&, const Vec3&, Real);
    using Fresnel = Real (*)(Real, Real);
    const auto refracted = [](const std::vector<InterfaceCase>& questions, Refract method) {
        std::vector<std::optional<Vec3>> answers;
        answers.reserve(questions.size());
        for (const InterfaceCase& q : questions) answers.push_back(method(q.d, q.n, q.eta));
        return answers;
    };
    const auto there_and_back = [refracted](const std::vector<InterfaceCase>& questions, Refract method) {
        const auto there = refracted(questions, method);
        std::vector<std::optional<Vec3>> back(questions.size());
        for (std::size_t i = 0; i < questions.size(); ++i)
            if (there[i]) back[i] = method(-*there[i], -questions[i].n, 1 / questions[i].eta);
        return judge_way_back(questions, there, back);
    };
    const auto reflected = [](const std::vector<CosineCase>& questions, Fresnel method) {
        std::vector<Real> answers;
        answers.reserve(questions.size());
        for (const CosineCase& q : questions) answers.push_back(method(q.cos_i, q.eta));
        return answers;
    };
    for (const InterfaceFamily& family : interface_families()) {
        const auto task = [&](const char* question, const char* demand, Batch batch) {
            tasks.push_back({{"07",
                              question,
                              family.name,
                              family.condition,
                              demand,
                              "cosine from 1 - eta²(1 - cos²)",
                              {},
                              {}},
                             cases,
                             usual_part,
                             std::move(batch)});
        };
        task("refraction", "8κu",
             [=, &family](std::size_t count, std::uint64_t seed, Verdict& right, Verdict* wrong) {
                 const auto questions = family.make(count, seed);
                 right = judge_refraction(questions, refracted(questions, refract));
                 if (wrong)
                     *wrong = judge_refraction(questions, refracted(questions, naive::refract_cancelling));
             });
        task("refraction there and back", "8κu",
             [=, &family](std::size_t count, std::uint64_t seed, Verdict& right, Verdict* wrong) {
                 const auto questions = family.make(count, seed);
                 right = there_and_back(questions, refract);
                 if (wrong) *wrong = there_and_back(questions, naive::refract_cancelling);
             });
        task("Fresnel's reflectance", "8κu",
             [=, &family](std::size_t count, std::uint64_t seed, Verdict& right, Verdict* wrong) {
                 const auto questions = cosine_cases(family, count, seed);
                 right = judge_reflectance(questions, reflected(questions, fresnel));
                 if (wrong)
                     *wrong = judge_reflectance(questions, reflected(questions, naive::fresnel_cancelling));
             });
        task("reflected and transmitted make 1", "4u",
             [=, &family](std::size_t count, std::uint64_t seed, Verdict& right, Verdict* wrong) {
                 const auto questions = cosine_cases(family, count, seed);
                 right = judge_energy(questions, reflected(questions, fresnel));
                 if (wrong) *wrong = judge_energy(questions, reflected(questions, naive::fresnel_cancelling));
             });
    }
}

/// What a search answers that ends in the first cell with any hit; it knows triangles and plain grids only.
Verdict judge_first_cell(const GridScene& scene, std::span<const GridQuestion> questions) {
    Verdict verdict;
    const auto* triangles = std::get_if<std::vector<Triangle>>(&scene.shapes);
    if (!triangles || !scene.grid.grids.empty()) return verdict;
    for (const GridQuestion& q : questions) {
        const OptionalHit right = nearest_of_all(scene, q);
        const OptionalHit answer = naive::closest_hit(scene.grid, *triangles, q.ray, q.range);
        ++verdict.cases;
        verdict.mismatches +=
            right.has_value() != answer.has_value() || (right && right->primitive != answer->primitive);
    }
    return verdict;
}

void add_grids(std::vector<Task>& tasks, std::size_t cases) {
    for (const GridFamily& family : grid_families())
        tasks.push_back({{"09",
                          "nearest hit by a grid, to the bit",
                          family.name,
                          family.extremes,
                          "",
                          "stops in the first cell with a hit",
                          {},
                          {}},
                         cases / grid_families().size(),
                         20 * rays_a_scene,
                         [&family](std::size_t count, std::uint64_t seed, Verdict& right, Verdict* wrong) {
                             for (std::size_t first = 0; first < count; first += rays_a_scene) {
                                 // Scenes of different batches must differ too.
                                 const std::uint64_t own = 1000 * seed + first / rays_a_scene;
                                 const GridScene scene = make_scene(family, own);
                                 const auto questions =
                                     make_questions(scene, std::min(rays_a_scene, count - first), own);
                                 add(right, judge_nearest(scene, questions));
                                 if (wrong) add(*wrong, judge_first_cell(scene, questions));
                             }
                         }});
}

/// What a search answers that passes over nodes that are entered just at the nearest hit so far, and whose
/// boxes have no margin; it knows triangles only.
Verdict judge_without_margin(const GridScene& scene, const Hierarchy& tree,
                             std::span<const GridQuestion> questions) {
    Verdict verdict;
    const auto* triangles = std::get_if<std::vector<Triangle>>(&scene.shapes);
    if (!triangles) return verdict;
    for (const GridQuestion& question : questions) {
        const OptionalHit right = nearest_of_all(scene, question);
        const OptionalHit answer = naive::closest_hit(tree, *triangles, question.ray, question.range);
        ++verdict.cases;
        verdict.mismatches +=
            right.has_value() != answer.has_value() || (right && right->primitive != answer->primitive);
    }
    return verdict;
}

void add_hierarchies(std::vector<Task>& tasks, std::size_t cases) {
    for (const GridFamily& family : grid_families())
        tasks.push_back({{"13",
                          "nearest hit by a hierarchy, to the bit",
                          family.name,
                          family.extremes,
                          "",
                          "no margin, and equal distances passed over",
                          {},
                          {}},
                         cases / grid_families().size(),
                         20 * rays_a_scene,
                         [&family](std::size_t count, std::uint64_t seed, Verdict& right, Verdict* wrong) {
                             for (std::size_t first = 0; first < count; first += rays_a_scene) {
                                 const std::uint64_t own = 1000 * seed + first / rays_a_scene;
                                 const GridScene scene = make_scene_of_trees(family, own);
                                 test::Random random(own);
                                 const Hierarchy tree = hierarchy_over(scene.shapes, some_options(random));
                                 const auto questions =
                                     make_questions(scene, std::min(rays_a_scene, count - first), own);
                                 add(right, judge_nearest(scene, tree, questions));
                                 if (wrong) add(*wrong, judge_without_margin(scene, tree, questions));
                             }
                         }});
}

template <class Shape>
void add_solids(std::vector<Task>& tasks, std::size_t cases, const char* what, const char* demand,
                const char* textbook, std::span<const SolidFamily<Shape>> families) {
    for (const SolidFamily<Shape>& family : families)
        tasks.push_back(
            {{"10", what, family.name, "the data moved by 8u", demand, textbook, {}, {}},
             cases,
             usual_part,
             ask<OptionalHit>(
                 family.make, [](const SolidCase<Shape>& q) { return intersect(q.shape, q.ray, Interval{}); },
                 [](const SolidCase<Shape>& q) { return naive::intersect(q.shape, q.ray, Interval{}); })});
}

/// Of surfaces in boxes; the cases are those of all families together.
template <class Shape>
void add_in_box(std::vector<Task>& tasks, std::size_t cases, const char* what, const char* condition,
                const char* demand, const char* textbook, std::span<const SolidFamily<Shape>> families) {
    for (const SolidFamily<Shape>& family : families)
        tasks.push_back(
            {{"10", what, family.name, condition, demand, textbook, {}, {}},
             cases / families.size(),
             usual_part / 10,
             ask<OptionalHit>(
                 family.make, [](const SolidCase<Shape>& q) { return intersect(q.shape, q.ray, Interval{}); },
                 [](const SolidCase<Shape>& q) { return naive::intersect(q.shape, q.ray, Interval{}); })});
}

/// Rays that leave a shape where others met it; the cases are those of all families together.
template <class Family>
void add_leaving(std::vector<Task>& tasks, std::size_t cases, const char* what,
                 std::span<const Family> families) {
    tasks.push_back({{"10",
                      what,
                      "from all hits of the families above",
                      "cosine to the normal from 1e-6 to 1",
                      "no self-hit, and the right next one",
                      "",
                      {},
                      {}},
                     cases,
                     usual_part / 10,
                     [families](std::size_t count, std::uint64_t seed, Verdict& right, Verdict*) {
                         for (const Family& family : families)
                             add(right, leave(family.make(count / families.size(), seed), seed));
                     }});
}

void add_surfaces(std::vector<Task>& tasks, std::size_t cases) {
    add_solids(tasks, cases, "hit with a box", "4u|t|", "slabs by 1/d", box_families());
    add_solids(tasks, cases, "hit with a disc", "η = 8u(|f| + radius)", "the point in the world",
               disc_families());
    add_solids(tasks, cases, "hit with a cone or cylinder", "η = 8u(|f| + 5·size)",
               "side and caps by themselves", cone_families());
    for (const PolynomialFamily& family : polynomial_families())
        tasks.push_back(
            {{"10",
              "roots of a quartic",
              family.name,
              "Σ|aᵢtⁱ|/|t·p′(t)|",
              "the coefficients moved by 8u",
              "closed formulas",
              {},
              {}},
             cases,
             usual_part,
             ask<SignChanges>(
                 family.make,
                 [](const PolynomialCase& q) { return sign_changes(q.polynomial, q.low, q.high); },
                 [](const PolynomialCase& q) { return naive::sign_changes(q.polynomial, q.low, q.high); })});
    for (const TorusFamily& family : torus_families())
        tasks.push_back({{"10",
                          "inside a torus",
                          family.name,
                          "the data moved by 8u",
                          "η = 8u(|f| + 5(R + r))",
                          "closed formulas from the eye",
                          {},
                          {}},
                         cases,
                         usual_part,
                         ask<TorusSpans>(
                             family.make, [](const TorusCase& q) { return inside(q.torus, q.ray); },
                             [](const TorusCase& q) { return naive::inside(q.torus, q.ray); })});
    add_in_box(tasks, cases, "first crossing of an implicit surface", "f within rounding of 0", "|f| ≤ 3β",
               "100 equal steps", implicit_families());
    add_in_box(tasks, cases, "hit with a quadric", "coefficients moved by 96u", "|f| ≤ 3β",
               "h² − ac at the eye", quadric_families());
    add_leaving(tasks, cases, "leaving a box", box_families());
    add_leaving(tasks, cases, "leaving a cone or cylinder", cone_families());
    add_leaving(tasks, cases, "leaving a torus", torus_families());
    add_leaving(tasks, cases, "leaving an implicit surface", implicit_families());
    add_leaving(tasks, cases, "leaving a quadric", quadric_families());
}

/// All batches of one task; one in ten is also put to the textbook method.
FamilyRow run(const Task& task, const Told& told) {
    const std::size_t batches = (task.cases + task.part - 1) / task.part;
    std::vector<Verdict> stable(batches), naive(batches);
    std::atomic<std::size_t> done = 0;
    tbb::parallel_for(std::size_t{0}, batches, [&](std::size_t i) {
        const std::size_t count = std::min(task.part, task.cases - i * task.part);
        // A seed of a batch's own; the tests use small ones.
        task.batch(count, 1000 + i, stable[i], i % 10 == 0 ? &naive[i] : nullptr);
        told(static_cast<double>(++done) / static_cast<double>(batches));
    });
    FamilyRow row = task.row;
    for (const Verdict& verdict : stable) add(row.stable, verdict);
    for (const Verdict& verdict : naive) add(row.naive, verdict);
    return row;
}

}  // namespace

std::vector<FamilyRow> measure_families(const FamiliesOptions& options, const Told& told) {
    std::vector<Task> tasks;
    add_spheres(tasks, options.judged);
    add_triangles(tasks, options);
    add_transforms(tasks, options.judged);
    add_shadows(tasks, options.aimed);
    add_optics(tasks, options.judged);
    add_grids(tasks, options.aimed);
    add_hierarchies(tasks, options.aimed);
    add_surfaces(tasks, options.judged);

    std::vector<FamilyRow> rows;
    for (const Task& task : tasks)
        rows.push_back(run(task, [&](double done) {
            if (told) told((static_cast<double>(rows.size()) + done) / static_cast<double>(tasks.size()));
        }));
    return rows;
}

}  // namespace rt::report
