// Writes the teapot as a Wavefront file, the same text on every machine.
// make_teapot FINENESS FILE.obj: each of the 32 patches becomes 2·FINENESS² triangles, or a little fewer.
#include "common/image/file.hpp"
#include "common/math/input_error.hpp"
#include "references/09_grids/teapot.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

namespace {

using namespace rt;

/// Five decimals: the last bits of a machine's arithmetic do not show.
std::string line(std::string_view word, const Vec3& v) {
    // Adding zero makes -0 a 0.
    const auto rounded = [](Real x) { return std::round(x * 1e5) / 1e5 + 0.0; };
    return fmt::format("{} {:.8g} {:.8g} {:.8g}\n", word, rounded(v.x), rounded(v.y), rounded(v.z));
}

std::string to_obj(const Mesh& mesh) {
    std::string obj =
        fmt::format("# Newell's teapot, {} triangles, made by make_teapot\n", mesh.triangles.size());
    for (const Vec3& position : mesh.positions) obj += line("v", position);
    for (const Vec3& normal : mesh.normals) obj += line("vn", normal);
    for (const auto& [a, b, c] : mesh.triangles)
        obj += fmt::format("f {0}//{0} {1}//{1} {2}//{2}\n", a.position + 1, b.position + 1, c.position + 1);
    return obj;
}

}  // namespace

int main(int argc, char** argv) {
    int fineness = 0;
    if (argc == 3) {
        const std::string_view digits = argv[1];
        std::from_chars(digits.data(), digits.data() + digits.size(), fineness);
    }
    if (fineness < 1 || fineness > 400) {
        std::fputs("usage: make_teapot FINENESS FILE.obj (FINENESS from 1 to 400)\n", stderr);
        return 2;
    }
    try {
        write_file(argv[2], to_obj(teapot::tessellate(fineness)));
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
