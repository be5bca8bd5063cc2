// Writes this chapter's meshes as Wavefront files, the same text on every machine.
// make_mesh flat|smooth ALONG AROUND FILE.obj: a knot of 2·ALONG·AROUND triangles, without or with normals.
#include "common/image/file.hpp"
#include "common/math/input_error.hpp"
#include "references/03_triangles/knot.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <string>
#include <string_view>

namespace {

using namespace rt;

/// Six decimals: the last bits of a machine's sine do not show.
std::string line(std::string_view word, const Vec3& v) {
    // Rounded first, so that what would be written as -0.000000 becomes -0, and adding zero makes that 0.
    const auto rounded = [](Real x) { return std::round(x * 1e6) / 1e6 + 0.0; };
    return fmt::format("{} {:.6f} {:.6f} {:.6f}\n", word, rounded(v.x), rounded(v.y), rounded(v.z));
}

std::string to_obj(const Mesh& mesh, bool smooth) {
    std::string obj =
        fmt::format("# Trefoil knot of {} triangles, made by make_mesh\n", mesh.triangles.size());
    for (const Vec3& position : mesh.positions) obj += line("v", position);
    if (smooth)
        for (const Vec3& normal : mesh.normals) obj += line("vn", normal);
    for (const auto& corners : mesh.triangles) {
        obj += "f";
        for (const Mesh::Corner& corner : corners)
            obj += smooth ? fmt::format(" {0}//{0}", corner.position + 1)
                          : fmt::format(" {}", corner.position + 1);
        obj += "\n";
    }
    return obj;
}

/// The whole number in `text`, or 0 where there is none.
int number(std::string_view text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? value : 0;
}

}  // namespace

int main(int argc, char** argv) {
    const std::string_view kind = argc == 5 ? argv[1] : "";
    const int along = argc == 5 ? number(argv[2]) : 0, around = argc == 5 ? number(argv[3]) : 0;
    if ((kind != "flat" && kind != "smooth") || along < 3 || around < 3 || along > 5000 || around > 5000) {
        std::fputs("usage: make_mesh flat|smooth ALONG AROUND FILE.obj (ALONG and AROUND from 3 to 5000)\n",
                   stderr);
        return 2;
    }
    try {
        write_file(argv[4], to_obj(knot(along, around), kind == "smooth"));
    } catch (const InputError& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
}
