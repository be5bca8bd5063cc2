// Program `draw_toys SCENE PICTURE`: draws a scene, and writes beside the picture what POV-Ray would be
// given, or why it is given nothing.
#include "common/image/file.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/povray/export.hpp"
#include "common/render/compile.hpp"
#include "common/render/render.hpp"
#include "common/scene/parse.hpp"

#include <iostream>
#include <string>

namespace {

std::string for_povray(const rt::Scene& scene) {
    try {
        return rt::export_povray(scene);
    } catch (const rt::InputError& error) {
        return error.what();
    }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    try {
        const rt::Scene scene = rt::parse_scene(argv[1]);
        rt::write_image(argv[2], rt::render(rt::compile(scene)).image);
        rt::write_file(std::string(argv[2]) + ".pov", for_povray(scene));
    } catch (const rt::InputError& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
