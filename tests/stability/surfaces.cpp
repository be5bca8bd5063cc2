// Surfaces without holes for chapter 3: rays aimed at shared edges and corners, and their judge.
// Coordinates are short multiples of powers of two, so that the rays pass exactly through what they are aimed
// at.
#include "tests/stability/triangles.hpp"

#include "common/math/error.hpp"
#include "tests/oracle/triangle.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt::stability {
namespace {

using test::Random;

constexpr Real band = 8 * unit_roundoff;

/// A whole number in [−limit, limit].
Real whole(Random& random, int limit) {
    return static_cast<Real>(static_cast<int>(random.index(static_cast<std::size_t>(2 * limit + 1))) - limit);
}

Real power_of_two(int exponent) { return std::ldexp(Real(1), exponent); }

/// Rounds every component differently, by at most an ulp or so: what was aimed at an edge passes just beside
/// it.
Vec3 nudged(const Vec3& v, Random& random) {
    const Real factor = random.uniform(0.5, 2);
    return v * factor;
}

/// An affine map that needs no rounding on the points of this file.
struct Map {
    Real scale = 1;
    Real stretch = 0;  ///< along (1, 1, 1), times x
    Vec3 offset{0};
};

Vec3 apply(const Map& map, const Vec3& v) { return map.scale * v + Vec3(map.stretch * v.x) + map.offset; }

Vec3 apply_to_vector(const Map& map, const Vec3& v) { return map.scale * v + Vec3(map.stretch * v.x); }

const Vec3 far_away(148376, 1234, -223423);

Map some_map(Random& random) {
    switch (random.index(5)) {
        case 0:
            return {};
        case 1:
            return {.scale = power_of_two(66)};  // edges of about 1e20
        case 2:
            return {.scale = power_of_two(-66)};  // and 1e-20
        case 3:
            return {.stretch = power_of_two(27)};  // needles of aspect about 1e8
        default:
            return {.offset = far_away};
    }
}

/// A closed convex mesh of 8 triangles: an octahedron with its corners moved about.
std::array<Triangle, 8> octahedron(Random& random) {
    std::array<Vec3, 6> corners;  // x, −x, y, −y, z, −z
    for (std::size_t i = 0; i < 6; ++i) {
        Vec3 corner(whole(random, 20), whole(random, 20), whole(random, 20));
        corner[static_cast<int>(i / 2)] = (i % 2 == 0 ? 1 : -1) * (225 + whole(random, 25));
        corners[i] = corner / Real(256);
    }
    std::array<Triangle, 8> faces;
    for (std::size_t i = 0; i < 8; ++i) {
        faces[i] = {corners[i & 1], corners[2 + (i >> 1 & 1)], corners[4 + (i >> 2 & 1)]};
        // An odd number of reflections turns the order round.
        if (((i & 1) + (i >> 1 & 1) + (i >> 2 & 1)) % 2 == 1) std::swap(faces[i].b, faces[i].c);
    }
    return faces;
}

/// Rays through a mesh of 8 triangles; each passes exactly through a point of an edge (or a corner).
Bundles aimed_at_mesh(std::size_t rays, std::uint64_t seed, bool at_corner) {
    Random random(seed);
    Bundles result;
    result.cases.reserve(8 * rays);
    for (std::size_t i = 0; i < rays; ++i) {
        const std::array<Triangle, 8> faces = octahedron(random);
        const Triangle& face = faces[random.index(8)];
        const std::array<Vec3, 3> corners{face.a, face.b, face.c};
        const std::size_t first = random.index(3);
        const Vec3 &p = corners[first], &q = corners[(first + 1) % 3];
        const Vec3 target = at_corner ? p : p + (static_cast<Real>(1 + random.index(15)) / 16) * (q - p);
        // Well inside; if it can be, at the target's x, so that a needle is also crossed and not only
        // followed.
        Vec3 inner = Vec3(whole(random, 40), whole(random, 40), whole(random, 40)) / Real(256);
        if (std::abs(target.x) < 0.15 && random.index(2) == 0) inner.x = target.x;

        const Vec3 out = target - inner;
        const bool from_inside = random.index(2) == 0;
        const Real distance = power_of_two(3 + static_cast<int>(random.index(4)));
        Ray ray{inner, out};
        if (!from_inside && random.index(2) == 0)
            ray = {inner - distance * out, out};
        else if (!from_inside)
            ray = {target + distance * out, -out};

        const Map map = some_map(random);
        ray = {apply(map, ray.origin), apply_to_vector(map, ray.direction)};
        if (random.index(2) == 0) ray.direction = nudged(ray.direction, random);
        result.bundles.push_back({result.cases.size(), 8, from_inside});
        for (const auto& [a, b, c] : faces)
            result.cases.push_back({{apply(map, a), apply(map, b), apply(map, c)}, ray});
    }
    return result;
}

Bundles at_edges(std::size_t rays, std::uint64_t seed) { return aimed_at_mesh(rays, seed, false); }

Bundles at_corners(std::size_t rays, std::uint64_t seed) { return aimed_at_mesh(rays, seed, true); }

constexpr std::size_t fan_size = 1000;

/// The rim of a fan around (0, 0, 0): 1 to 1000 away, nearly flat, so that a ray that is no more than 45° off
/// the z axis sees all triangles from the same side.
std::vector<Vec3> fan_rim(Random& random) {
    std::vector<Vec3> rim(fan_size);
    for (std::size_t i = 0; i < fan_size; ++i) {
        const Real angle = 2 * pi * static_cast<Real>(i) / static_cast<Real>(fan_size);
        const Real radius = random.magnitude(0, 3);
        const Vec3 p = radius * Vec3(std::cos(angle), std::sin(angle), random.uniform(-0.001, 0.001));
        rim[i] = glm::floor(p * Real(65536)) / Real(65536);
    }
    return rim;
}

Ray down_on(const Vec3& target, Random& random) {
    const Vec3 direction = Vec3(whole(random, 180), whole(random, 180), 256) / Real(256);
    return {target - power_of_two(static_cast<int>(random.index(11))) * direction, direction};
}

Bundles at_fan(std::size_t rays, std::uint64_t seed, bool at_hub) {
    Random random(seed);
    Bundles result;
    const std::vector<Vec3> rim = fan_rim(random);
    for (std::size_t i = 0; i < rays; ++i) {
        const std::size_t spoke = random.index(fan_size);
        const Vec3 target =
            at_hub ? Vec3(0) : rim[spoke] * power_of_two(-1 - static_cast<int>(random.index(4)));
        Ray ray = down_on(target, random);
        const Map map = some_map(random);
        ray = {apply(map, ray.origin), apply_to_vector(map, ray.direction)};
        if (random.index(2) == 0) ray.direction = nudged(ray.direction, random);

        const std::size_t count = at_hub ? fan_size : 4;
        result.bundles.push_back({result.cases.size(), count, true});
        for (std::size_t k = 0; k < count; ++k) {
            // Two triangles on either side of the spoke; all of them at the hub.
            const std::size_t first = (spoke + fan_size - 2 + k) % fan_size;
            const Vec3 &p = rim[first], &q = rim[(first + 1) % fan_size];
            result.cases.push_back({{apply(map, Vec3(0)), apply(map, p), apply(map, q)}, ray});
        }
    }
    return result;
}

Bundles at_hubs(std::size_t rays, std::uint64_t seed) { return at_fan(rays, seed, true); }

Bundles at_spokes(std::size_t rays, std::uint64_t seed) { return at_fan(rays, seed, false); }

/// Rays from inside a closed box of 12 triangles that is 2^-50 as high as wide, at its edges, corners and
/// faces.
Bundles from_flat_boxes(std::size_t rays, std::uint64_t seed) {
    Random random(seed);
    Bundles result;
    result.cases.reserve(12 * rays);
    for (std::size_t i = 0; i < rays; ++i) {
        const int flat = static_cast<int>(random.index(3));
        Vec3 size(1);
        size[flat] = power_of_two(-50);
        const auto corner = [&](std::size_t k) {
            return size *
                   Vec3(static_cast<Real>(k & 1), static_cast<Real>(k >> 1 & 1), static_cast<Real>(k >> 2));
        };
        const std::size_t first = result.cases.size();
        const std::size_t from = random.index(8), to = from ^ (std::size_t{1} << random.index(3));
        const Real at = static_cast<Real>(random.index(17)) / 16;
        const Vec3 target = random.index(4) == 0 ? size * (random.in_cube() + Real(1)) / Real(2)
                                                 : corner(from) + at * (corner(to) - corner(from));
        const Vec3 inner =
            size * (Vec3(8) + Vec3(whole(random, 7), whole(random, 7), whole(random, 7))) / Real(16);
        Ray ray{inner, target - inner};
        if (random.index(2) == 0) ray.direction = nudged(ray.direction, random);
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (std::size_t side = 0; side < 2; ++side) {
                const std::size_t a = side << axis, x = std::size_t{1} << (axis + 1) % 3,
                                  y = std::size_t{1} << (axis + 2) % 3;
                // Seen from outside the corners turn counterclockwise.
                const std::size_t b = side == 1 ? a | x : a | y, d = side == 1 ? a | y : a | x, c = a | x | y;
                result.cases.push_back({{corner(a), corner(b), corner(c)}, ray});
                result.cases.push_back({{corner(a), corner(c), corner(d)}, ray});
            }
        result.bundles.push_back({first, 12, true});
    }
    return result;
}

constexpr std::array<SurfaceFamily, 5> families{{
    {"rays at the edges of closed meshes", 8, at_edges},
    {"rays at the corners of closed meshes", 8, at_corners},
    {"rays at the hubs of fans of 1000 triangles", fan_size, at_hubs},
    {"rays at the spokes of fans of 1000 triangles", 4, at_spokes},
    {"rays from inside closed boxes that are 2^-50 as high as wide", 12, from_flat_boxes},
}};

// ------------------------------------------------------------------------------------------------ judge

/// A hit that is to be merged with others.
struct Crossing {
    const Triangle* triangle;
    Real t;
    Real allowed;  ///< 8κu|t|
    int side;      ///< which side of the triangle the ray meets, +1 or −1; 0 where it is exactly edge-on
};

Crossing crossing_of(const TriangleCase& item, Real t) {
    const auto& [a, b, c] = item.triangle;
    const Vec3& d = item.ray.direction;
    const Vec3 normal = cross(b - a, c - a);
    const Real size = length(normal);
    Real along = dot(normal, d);
    // Rounding can't change this sign unless it is small, and then exact arithmetic tells it.
    if (std::abs(along) < 1e-3 * size * length(d))
        along = oracle::judge_triangle(item.triangle, item.ray, t).sum;
    const Vec3& o = item.ray.origin;
    const Real reach = std::max({length(a - o), length(b - o), length(c - o)});
    const Real allowed =
        along == 0 ? infinity : band * (reach + std::abs(t) * length(d)) * (size / std::abs(along));
    return {&item.triangle, t, allowed, (along > 0) - (along < 0)};
}

bool share_a_corner(const Triangle& p, const Triangle& q) {
    for (const Vec3& corner : {p.a, p.b, p.c})
        if (corner == q.a || corner == q.b || corner == q.c) return true;
    return false;
}

bool same_crossing(const Crossing& p, const Crossing& q) {
    return p.side == q.side && std::abs(p.t - q.t) <= p.allowed + q.allowed &&
           share_a_corner(*p.triangle, *q.triangle);
}

/// Number of crossings after merging.
std::size_t merged(std::vector<Crossing> left) {
    std::size_t count = 0;
    for (std::vector<Crossing> group; !left.empty(); ++count) {
        group.assign(1, left.back());
        left.pop_back();
        // The group grows while it is walked through.
        for (std::size_t k = 0; k < group.size(); ++k)
            for (std::size_t i = left.size(); i-- > 0;) {
                if (!same_crossing(group[k], left[i])) continue;
                group.push_back(left[i]);
                left[i] = left.back();
                left.pop_back();
            }
    }
    return count;
}

}  // namespace

std::span<const SurfaceFamily> surface_families() { return families; }

Verdict judge(const Bundles& bundles, std::span<const std::optional<Hit>> answers) {
    Verdict verdict;
    verdict.cases = bundles.bundles.size();
    for (const Bundle& bundle : bundles.bundles) {
        std::vector<Crossing> crossings;
        std::size_t hits = 0;
        bool numbers = true;
        for (std::size_t i = bundle.first; i < bundle.first + bundle.count; ++i) {
            if (!answers[i]) continue;
            ++hits;
            const Hit& hit = *answers[i];
            numbers = numbers && std::isfinite(hit.t) && std::isfinite(hit.uv.x) && std::isfinite(hit.uv.y);
            if (!numbers) break;
            const Crossing crossing = crossing_of(bundles.cases[i], hit.t);
            // Exactly edge-on, the ray does not get to the other side.
            if (crossing.side != 0) crossings.push_back(crossing);
        }
        const std::size_t count = merged(crossings);
        if (numbers && count > 0 && (count % 2 == 1) == bundle.odd) continue;
        const TriangleCase& item = bundles.cases[bundle.first];
        std::string what = literal(item.ray) + "\n  right: an " + (bundle.odd ? "odd" : "even") +
                           " number of crossings of " + std::to_string(bundle.count) +
                           " triangles\n  answered: " +
                           (numbers ? std::to_string(hits) + " hits, merged " + std::to_string(count)
                                    : "something that is not a number");
        for (std::size_t i = 0; i < std::min<std::size_t>(bundle.count, 8); ++i)
            what += "\n  " + literal(bundles.cases[bundle.first + i].triangle);
        count_mismatch(verdict, what);
    }
    return verdict;
}

}  // namespace rt::stability
