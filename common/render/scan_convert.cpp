// Scan conversion with a z-buffer: the other way to find what each pixel sees.
// a and b are a pixel's coordinates on the image plane, as in chapter 1.
#include "common/render/scan_convert.hpp"

#include "chapters/01_ray_casting/camera.hpp"
#include "common/math/input_error.hpp"
#include "common/render/integrators.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace rt {
namespace {

/// x·a + y·b + z: a quantity that is linear on the image plane.
using Linear = Vec3;

Real at(const Linear& f, Real a, Real b) { return f.x * a + f.y * b + f.z; }

/// A triangle as the camera sees it.
struct Projected {
    /// Weights of the corners; in perspective still to be divided by their sum. All of them are positive
    /// inside, and zero on the opposite edge.
    std::array<Linear, 3> weight;
    /// Greater is nearer: 1/depth in perspective, −depth in an orthographic view.
    Linear nearness{0};
    bool visible = false;  ///< false for a triangle that is seen edge-on
    Tile pixels;           ///< outside of these nothing is covered
};

/// p in the camera's frame, with the third coordinate the depth: positive in front of the eye.
Vec3 to_camera(const View& view, const Vec3& p) {
    const Vec3 q = p - view.eye;
    return {glm::dot(q, view.frame.u), glm::dot(q, view.frame.v), -glm::dot(q, view.frame.w)};
}

/// Perspective. The direction d = (a, b, 1) is wa·A + wb·B + wc·C for exactly one (wa, wb, wc), by Cramer's
/// rule; where all three are positive, d/(wa + wb + wc) is a point of the triangle, so the sum is 1/depth.
Projected project_perspective(const std::array<Vec3, 3>& p) {
    Projected result;
    const Vec3 bc = glm::cross(p[1], p[2]);
    const Real determinant = glm::dot(p[0], bc);
    if (determinant == 0 || !std::isfinite(1 / determinant)) return result;
    result.weight = {bc / determinant, glm::cross(p[2], p[0]) / determinant,
                     glm::cross(p[0], p[1]) / determinant};
    result.nearness = result.weight[0] + result.weight[1] + result.weight[2];
    result.visible = true;
    return result;
}

/// Orthographic. The weights are ratios of areas on the image plane, the depth is linear there.
Projected project_orthographic(const std::array<Vec3, 3>& p) {
    Projected result;
    const auto edge = [](const Vec3& from, const Vec3& to) {
        return Linear(from.y - to.y, to.x - from.x, from.x * to.y - from.y * to.x);
    };
    const Linear opposite_a = edge(p[1], p[2]);
    const Real area = at(opposite_a, p[0].x, p[0].y);
    if (area == 0 || !std::isfinite(1 / area)) return result;
    result.weight = {opposite_a / area, edge(p[2], p[0]) / area, edge(p[0], p[1]) / area};
    for (int i = 0; i < 3; ++i) {
        const auto k = static_cast<std::size_t>(i);
        result.nearness -= p[k].z * result.weight[k];
    }
    result.visible = true;
    return result;
}

/// The pixels around the projections of the corners; the whole picture for a triangle that reaches behind
/// the eye, none for one that lies there.
Tile covered_pixels(const View& view, const std::array<Vec3, 3>& p) {
    const Tile all{0, 0, view.width, view.height};
    const bool perspective = view.projection == Projection::Perspective;
    const auto in_front = [](const Vec3& q) { return q.z > 0; };
    if (std::none_of(p.begin(), p.end(), in_front)) return {};
    if (perspective && !std::all_of(p.begin(), p.end(), in_front)) return all;

    const Real pixels_per_unit = view.height / (2 * view.half_height);
    Vec2 low(infinity), high(-infinity);
    for (const Vec3& q : p) {
        const Vec2 on_plane = (perspective ? Vec2(q) / q.z : Vec2(q)) * pixels_per_unit;
        const Vec2 place(0.5 * view.width + on_plane.x, 0.5 * view.height - on_plane.y);
        low = glm::min(low, place);
        high = glm::max(high, place);
    }
    // A pixel of margin: rounding must not shave off what the edge functions let in.
    const auto clamp_to = [](Real value, int size) {
        return static_cast<int>(std::clamp(value, Real(0), static_cast<Real>(size)));
    };
    return {clamp_to(std::floor(low.x) - 1, view.width), clamp_to(std::floor(low.y) - 1, view.height),
            clamp_to(std::ceil(high.x) + 1, view.width), clamp_to(std::ceil(high.y) + 1, view.height)};
}

Projected project(const View& view, const Triangle& triangle) {
    const std::array<Vec3, 3> p = {to_camera(view, triangle.a), to_camera(view, triangle.b),
                                   to_camera(view, triangle.c)};
    Projected result =
        view.projection == Projection::Perspective ? project_perspective(p) : project_orthographic(p);
    if (result.visible) result.pixels = covered_pixels(view, p);
    return result;
}

/// What the z-buffer keeps of a pixel; nothing is as far as −∞ is near.
struct Fragment {
    Real nearness = -infinity;
    Vec2 uv{0};
    std::uint32_t primitive = 0;
    std::uint32_t element = 0;
};

/// A picture in the making.
struct Canvas {
    explicit Canvas(const View& seen_by)
        : view(seen_by),
          buffer(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height)) {}

    const View& view;
    std::vector<Fragment> buffer;

    Real column(int x) const { return view.half_height * (2 * x + 1 - view.width) / view.height; }
    Real row(int y) const { return view.half_height * (view.height - 2 * y - 1) / view.height; }
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(view.width) +
               static_cast<std::size_t>(x);
    }

    void draw(const Triangle& triangle, std::uint32_t primitive, std::uint32_t element = 0) {
        const Projected p = project(view, triangle);
        for (int y = p.pixels.y0; y < p.pixels.y1; ++y)
            for (int x = p.pixels.x0; x < p.pixels.x1; ++x) {
                const Real a = column(x), b = row(y);
                const Real wa = at(p.weight[0], a, b), wb = at(p.weight[1], a, b), wc = at(p.weight[2], a, b);
                if (!(wa >= 0 && wb >= 0 && wc >= 0)) continue;
                const Real sum = wa + wb + wc;
                const Fragment fragment{at(p.nearness, a, b), {wb / sum, wc / sum}, primitive, element};
                if (in_front(fragment, buffer[index(x, y)])) buffer[index(x, y)] = fragment;
            }
    }

    bool in_front(const Fragment& one, const Fragment& other) const {
        // In perspective the weights are positive in front of the eye only; here it must be asked.
        if (view.projection == Projection::Orthographic && one.nearness >= 0) return false;
        if (one.nearness != other.nearness) return one.nearness > other.nearness;
        return std::tie(one.primitive, one.element) < std::tie(other.primitive, other.element);
    }

    std::vector<std::optional<Hit>> hits() const {
        std::vector<std::optional<Hit>> result(buffer.size());
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                const Fragment& f = buffer[index(x, y)];
                if (f.nearness == -infinity) continue;
                // A ray's direction is a unit vector: t is the distance along it, not the depth.
                const Real t = view.projection == Projection::Perspective
                                   ? glm::length(Vec3(column(x), row(y), 1)) / f.nearness
                                   : -f.nearness;
                result[index(x, y)] = Hit{.t = t, .uv = f.uv, .primitive = f.primitive, .element = f.element};
            }
        return result;
    }
};

void draw(Canvas& canvas, const Group<Triangle>& group) {
    for (std::size_t i = 0; i < group.shapes.size(); ++i) canvas.draw(group.shapes[i], group.primitive[i]);
}

void draw(Canvas& canvas, const Group<Instance>& group) {
    for (std::size_t i = 0; i < group.shapes.size(); ++i) {
        const Instance& instance = group.shapes[i];
        const auto to_world = [&](const Vec3& p) { return Vec3(instance.transform.to_world * Vec4(p, 1)); };
        std::uint32_t element = 0;
        for (const Triangle& t : instance.shape.mesh->triangles.shapes)
            canvas.draw({to_world(t.a), to_world(t.b), to_world(t.c)}, group.primitive[i], element++);
    }
}

template <class Shape>
void draw(Canvas&, const Group<Shape>&) {
    throw InputError("scan conversion draws triangles only; this scene has other shapes too");
}

}  // namespace

std::vector<std::optional<Hit>> scan_convert(const World& world) {
    Canvas canvas(world.view);
    for (const AnyGroup& any : world.groups) std::visit([&](const auto& group) { draw(canvas, group); }, any);
    return canvas.hits();
}

Image rasterize(const World& world) {
    const HitColor color = hit_color_function(world);
    const std::vector<std::optional<Hit>> hits = scan_convert(world);
    Image image = make_image(world.view.width, world.view.height);
    std::size_t i = 0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x, ++i) {
            const Ray ray = pixel_ray(world.view, x + 0.5, y + 0.5);
            pixel(image, x, y) = hits[i] ? color(world, ray, *hits[i]) : background(world, ray.direction);
        }
    }
    return image;
}

}  // namespace rt
