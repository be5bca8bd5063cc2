// Which transparent faces of a scene, each an object of its own, enclose a body together.
#include "common/render/bodies.hpp"

#include "common/render/object_limits.hpp"
#include "common/scene/cut_open.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <compare>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace rt {
namespace {

/// Numbers for points: equal ones get the same. 0 and −0 are equal.
class Corners {
public:
    std::uint32_t number(const Vec3& p) {
        return numbers.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(numbers.size())).first->second;
    }

private:
    std::map<std::tuple<Real, Real, Real>, std::uint32_t> numbers;
};

/// One side of a face; sides that are equal but for the object are met there.
struct Side {
    std::uint32_t material = 0;
    int transform = -1;
    std::uint32_t from = 0, to = 0;  ///< corners, the lesser first
    std::uint32_t object = 0;

    auto place() const { return std::tie(material, transform, from, to); }
    friend auto operator<=>(const Side&, const Side&) = default;
};

/// The corners of a face by which it meets others; none where it meets none, and of what has an inside.
std::vector<Vec3> corners_of(const Scene& scene, const Object& object) {
    std::vector<Vec3> corners;
    if (const auto* triangle = std::get_if<TriangleObject>(&object.shape))
        for (const std::uint32_t i : triangle->vertex)
            corners.push_back(triangle->smooth ? scene.smooth_vertices[i].position : scene.vertices[i]);
    if (const auto* polygon = std::get_if<PolygonObject>(&object.shape))
        for (const std::uint32_t i : polygon->vertex) corners.push_back(scene.vertices[i]);
    return corners;
}

/// For each material the first that equals it.
std::vector<std::uint32_t> equal_materials(const std::vector<Material>& materials) {
    const auto colors = [](const Vec3& v) { return std::tuple(v.x, v.y, v.z); };
    const auto key = [&](const Material& m) {
        return std::tuple(m.ior, colors(m.transmission), colors(m.absorption), colors(m.diffuse));
    };
    std::multimap<decltype(key(materials[0])), std::uint32_t> seen;
    std::vector<std::uint32_t> first(materials.size());
    for (std::uint32_t i = 0; i < materials.size(); ++i) {
        const auto [begin, end] = seen.equal_range(key(materials[i]));
        const auto same =
            std::find_if(begin, end, [&](const auto& one) { return materials[one.second] == materials[i]; });
        first[i] = same == end ? i : same->second;
        if (same == end) seen.emplace(key(materials[i]), i);
    }
    return first;
}

/// The sides of all transparent faces, sorted; none of faces that have the corners of an earlier one.
std::vector<Side> sides_of(const Scene& scene) {
    const std::vector<std::uint32_t> material = equal_materials(scene.materials);
    Corners numbers;
    std::vector<Side> sides;
    std::set<std::tuple<std::uint32_t, int, std::vector<std::uint32_t>>> faces;
    for (std::uint32_t i = 0; i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        if (scene.materials[object.material].transmission == Vec3(0)) continue;
        std::vector<std::uint32_t> corners;
        for (const Vec3& corner : corners_of(scene, object)) corners.push_back(numbers.number(corner));
        if (corners.empty()) continue;
        std::vector<std::uint32_t> sorted = corners;
        std::sort(sorted.begin(), sorted.end());
        if (!faces.emplace(material[object.material], object.transform, std::move(sorted)).second) continue;
        for (std::size_t k = 0; k < corners.size(); ++k) {
            const auto [from, to] = std::minmax(corners[k], corners[(k + 1) % corners.size()]);
            if (from != to) sides.push_back({material[object.material], object.transform, from, to, i});
        }
    }
    std::sort(sides.begin(), sides.end());
    return sides;
}

/// The first object of the body of `object`, as far as they are joined yet.
std::uint32_t first_of(std::vector<std::uint32_t>& of, std::uint32_t object) {
    while (of[object] != object) object = of[object] = of[of[object]];
    return object;
}

std::string why_no_body(const FileShape& shape) {
    if (const std::optional<Vec3> opening = cut_open(shape))
        return fmt::format(
            "a transparent {} that its box cuts open: at {} {} {}, on a face, is its inside; make the box "
            "larger, or close it by an `intersection` with a `box`",
            words_of(shape).name, opening->x, opening->y, opening->z);
    return "a transparent object without an inside: with the faces that share corners, material and "
           "transform with it, it does not enclose one; put all its faces into one `mesh`";
}

}  // namespace

Bodies bodies_of(const Scene& scene, bool refraction) {
    Bodies bodies;
    std::vector<bool> is_transparent_face;
    for (const Object& object : scene.objects)
        is_transparent_face.push_back(scene.materials[object.material].transmission != Vec3(0) &&
                                      !has_inside(object.shape));
    if (std::ranges::find(is_transparent_face, true) == is_transparent_face.end()) return bodies;
    std::vector<std::uint32_t>& of = bodies.of;
    of.resize(scene.objects.size());
    const std::vector<Side> sides = sides_of(scene);
    std::iota(of.begin(), of.end(), 0u);
    std::vector<std::uint32_t> open;  // faces of which a side is met an odd number of times
    for (auto side = sides.begin(); side != sides.end();) {
        const auto next =
            std::find_if(side, sides.end(), [&](const Side& one) { return one.place() != side->place(); });
        const bool in_pairs = (next - side) % 2 == 0;
        for (auto one = side; one != next; ++one) {
            if (!in_pairs) {
                open.push_back(one->object);
                continue;
            }
            const std::uint32_t a = first_of(of, side->object), b = first_of(of, one->object);
            of[std::max(a, b)] = std::min(a, b);
        }
        side = next;
    }
    for (std::uint32_t i = 0; i < of.size(); ++i) of[i] = first_of(of, i);

    std::vector<bool> is_open(of.size(), false), is_face(of.size(), false);
    for (const Side& side : sides) is_face[side.object] = true;
    for (const std::uint32_t object : open) is_open[of[object]] = true;
    for (std::uint32_t i = 0; i < of.size(); ++i) {
        const Object& object = scene.objects[i];
        const Material& material = scene.materials[object.material];
        const bool is_sheet = is_transparent_face[i] && of[i] == i && (is_open[i] || !is_face[i]);
        if (!is_sheet) continue;
        if (refraction && (material.ior != 1 || material.absorption != Vec3(0)))
            refuse(scene, object.place, why_no_body(object.shape));
        bodies.sheets.push_back(i);
    }
    return bodies;
}

}  // namespace rt
