// Shadow rays on surfaces made to break them, and whole pictures at scales from 2^-40 to 2^40.
// Demands: tests/stability/shadows.hpp.
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "tests/06_shadows/things.hpp"
#include "tests/pictures.hpp"
#include "tests/stability/check.hpp"
#include "tests/stability/shadows.hpp"

#include <algorithm>
#include <cstring>
#include <iostream>

using namespace rt;
using namespace rt::stability;
using rt::test::cases;

namespace {

using Method = ShadowRay (*)(const Surface&, const LightSample&);

ShadowVerdict ask(Method method, const std::vector<ShadowCase>& questions) {
    std::vector<ShadowRay> answers;
    answers.reserve(questions.size());
    for (const ShadowCase& question : questions) answers.push_back(method(question.surface, question.light));
    return judge(questions, answers);
}

/// What each method did on all the families; printed once, in a full run.
struct Counts {
    ShadowVerdict derived, none, epsilon, integers;
    bool print = false;

    ~Counts() {
        if (!print) return;
        const auto line = [](const char* name, const ShadowVerdict& verdict) {
            std::cerr << "  " << name << ": " << verdict.self_hits << " self hits and " << verdict.lost
                      << " lost occluders in " << verdict.cases << '\n';
        };
        std::cerr << "06 shadows, by where the shadow ray starts:\n";
        line("offset from the error bound", derived);
        line("no offset", none);
        line("fixed epsilon", epsilon);
        line("integer offset with fixed constants", integers);
    }
} counts;

void scale(Scene& scene, Real factor) {
    scene.camera.eye *= factor;
    scene.camera.look_at *= factor;
    scene.camera.view_height *= factor;
    for (Vec3& vertex : scene.vertices) vertex *= factor;
    for (SmoothVertex& vertex : scene.smooth_vertices) vertex.position *= factor;
    for (Mesh& mesh : scene.meshes)
        for (Vec3& position : mesh.positions) position *= factor;
    for (Material& material : scene.materials) material.checker.size *= factor;
    for (TransformNode& node : scene.transforms)
        if (auto* move = std::get_if<Translate>(&node.step)) move->by *= factor;
    for (Object& object : scene.objects) {
        if (auto* sphere = std::get_if<Sphere>(&object.shape))
            sphere->center *= factor, sphere->radius *= factor;
        if (auto* plane = std::get_if<Plane>(&object.shape)) plane->point *= factor;
    }
    for (Light& light : scene.lights)
        if (auto* point = std::get_if<PointLight>(&light)) point->position *= factor;
}

std::size_t pixels_that_differ(const Image& a, const Image& b) {
    if (a.pixels.size() != b.pixels.size()) return std::max(a.pixels.size(), b.pixels.size());
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i)
        if (std::memcmp(&a.pixels[i], &b.pixels[i], sizeof(Vec3)) != 0) ++different;
    return different;
}

}  // namespace

TEST_CASE("no surface shadows itself, and no occluder is lost", "[06.2][stability]") {
    for (const ShadowFamily& family : shadow_families()) {
        // In parts, because a million cases at once fill the memory rather than the test.
        const auto all = static_cast<std::size_t>(cases(100'000)), part = std::size_t{10'000};
        counts.print = cases(10) == 10;
        ShadowVerdict derived, epsilon;
        for (std::size_t first = 0; first < all; first += part) {
            const auto questions = make_cases(family, std::min(part, all - first), 6 + first);
            add(derived, ask(shadow_ray, questions));
            // A tenth of the cases is enough to see the others fail.
            if (first > all / 10) continue;
            add(epsilon, ask(naive::shadow_ray_with_epsilon, questions));
            add(counts.none, ask(naive::shadow_ray_without_offset, questions));
            add(counts.integers, ask(naive::shadow_ray_by_integers, questions));
        }
        add(counts.derived, derived);
        add(counts.epsilon, epsilon);
        INFO(family.name << " (" << family.extremes << "): " << describe(derived));
        CHECK(test::or_say(derived.self_hits == 0, "shadow rays hit the surface that they start on"));
        CHECK(test::or_say(derived.lost == 0, "shadow rays miss what stands in their way"));
        INFO("a fixed epsilon: " << describe(epsilon));
        check_fails(epsilon.self_hits + epsilon.lost);
    }
    INFO("the other methods have to fail, each in its own way");
    CHECK(counts.none.self_hits > counts.none.cases / 10);
    CHECK(counts.epsilon.self_hits > 0);
    CHECK(counts.epsilon.lost > counts.epsilon.cases / 10);
    CHECK(counts.integers.self_hits > 0);
    CHECK(counts.integers.lost > 0);
}

TEST_CASE("a scene larger or smaller by a power of two makes the same picture, to the bit",
          "[06.4][stability]") {
    struct {
        const char* name;
        int width, height;
    } scenes[] = {{"shadows", 80, 60}, {"large_floor", 80, 60}, {"colored", 80, 60}, {"transformed", 24, 18}};
    for (const auto& [name, width, height] : scenes) {
        Scene scene = parse_scene(test::repository() + "/references/06_shadows/" + name + ".scene");
        scene.width = width;
        scene.height = height;
        for (Light& light : scene.lights)  // attenuation has a unit
            if (auto* point = std::get_if<PointLight>(&light)) point->attenuation = {1, 0, 0};
        const Image image = render(compile(scene)).image;
        for (const int k : {-40, -20, -1, 1, 20, 40}) {
            Scene scaled = scene;
            scale(scaled, std::ldexp(1.0, k));
            const Image other = render(compile(scaled)).image;
            const std::size_t different = pixels_that_differ(other, image);
            if (different > 0) test::pictures_differ(other, image);
            INFO("the scene " << name << " with all lengths times 2^" << k << ": how many of "
                              << image.pixels.size() << " pixels differ");
            CHECK(different == 0);
        }
    }
}
