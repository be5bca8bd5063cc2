// The picture that shows a step, and what is behind a pixel.
#include "common/pictures/step_picture.hpp"

#include "common/image/file.hpp"
#include "common/math/todo.hpp"
#include "common/pictures/drawings.hpp"
#include "common/pictures/ray_tree.hpp"
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"
#include "common/terminal/json_text.hpp"

namespace rt {

namespace {

Scene scene_of(const Shown& shown) {
    Scene scene = parse_scene(shown.what);
    if (shown.width > 0) scene.width = shown.width, scene.height = shown.height;
    return scene;
}

/// The arguments `WHAT WIDTH HEIGHT`.
Shown shown_from(const std::vector<std::string>& arguments) {
    return {arguments.at(0), std::stoi(arguments.at(1)), std::stoi(arguments.at(2))};
}

/// `work`, and the status of the program that did it.
template <class Work>
int status_of(const Work& work) {
    try {
        work();
        return 0;
    } catch (const NotImplemented&) {
        return picture_not_started;
    } catch (const std::exception&) {
        return 1;
    }
}

}  // namespace

Image step_picture(const Shown& shown) {
    if (const Drawing* drawing = drawing_named(shown.what)) {
        Image image = make_image(drawing->width, drawing->height);
        const std::vector<DrawnPixel> pixels = drawing->draw(*drawing);
        for (std::size_t i = 0; i < pixels.size(); ++i) image.pixels[i] = pixels[i].color;
        return image;
    }
    RenderOptions options;
    options.estimate = false;
    return render(compile(scene_of(shown)), options).image;
}

nlohmann::ordered_json step_pixel(const Shown& shown, int x, int y) {
    const Drawing* drawing = drawing_named(shown.what);
    if (!drawing) return ray_tree(scene_of(shown), x, y);
    const auto index = static_cast<std::size_t>(y * drawing->width + x);
    const DrawnPixel pixel = drawing->draw(*drawing).at(index);
    return {{"place", pixel.place}, {"answer", pixel.answer}};
}

int write_step_picture(const std::vector<std::string>& arguments) {
    return status_of([&] { write_image(arguments.at(3), step_picture(shown_from(arguments))); });
}

int write_step_pixel(const std::vector<std::string>& arguments) {
    return status_of([&] {
        const auto pixel =
            step_pixel(shown_from(arguments), std::stoi(arguments.at(3)), std::stoi(arguments.at(4)));
        write_file(arguments.at(5), json_text(pixel));
    });
}

}  // namespace rt
