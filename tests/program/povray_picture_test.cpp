// Pictures put together from stills, as the renderer puts its samples together.
#include "common/evidence/povray_picture.hpp"

#include "chapters/01_ray_casting/raycast.hpp"
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/render/snapshots.hpp"
#include "common/scene/parse.hpp"
#include "common/world/query.hpp"
#include "tests/catch.hpp"

#include <string>

using namespace rt;

TEST_CASE("stills weighed are the picture, also where samples lie on the edges of pixels", "[references]") {
    // No lens: each still is a still scene, seen at a corner or an edge of its pixels.
    for (const std::string text : {"spp 9\nsampler trapezoid\n", "spp 10\nsampler centered\n",
                                   "spp 9\nsampler trapezoid\nfilter tent\n"}) {
        INFO(text);
        const Scene scene = parse_scene_text(
            "size 12 9\ncamera 0 0 5  0 0 0  0 1 0  50\nbackground .1 .2 .3\nintegrator flat\n" + text +
                "motion .5 .25 0\nambient .9 .5 .3\nsphere -.3 0 0 1\n",
            "small.scene");
        std::vector<FilmPixel> film(12 * 9);
        for (const Snapshot& snapshot : snapshots_of(scene)) {
            const World still = compile(scene_at(scene, snapshot.time));
            Image image = make_image(12, 9);
            for (int y = 0; y < 9; ++y)
                for (int x = 0; x < 12; ++x)
                    pixel(image, x, y) = cast_ray(still, camera_ray(still, {Vec2(x, y) + snapshot.at}));
            expose(film, image, snapshot, scene.sampling.filter);
        }
        const Image picture = render(compile(scene)).image;
        for (std::size_t i = 0; i < film.size(); ++i)
            for (int c = 0; c < 3; ++c) CHECK(color_of(film[i])[c] == Approx(picture.pixels[i][c]));
    }
}
