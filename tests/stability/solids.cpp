// Families of extreme cases for chapter 10's boxes, discs and cones, and their judge.
#include "tests/stability/solids.hpp"

#include "common/math/error.hpp"
#include "tests/oracle/box.hpp"
#include "tests/oracle/solid.hpp"
#include "tests/stability/leaving.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt::stability {
namespace {

using test::many;
using test::Random;
using test::towards;

// 4 ulp, as a relative error: an ulp is at most 2u.
constexpr Real band = 8 * unit_roundoff;

// -------------------------------------------------------------------------------------------- some shapes

/// Of a size, and at a place up to some of its sizes away from the world's origin.
Box some_box(Random& random, Real size) {
    const Vec3 low = size * random.magnitude(-2, 2) * random.in_cube();
    Vec3 edges;
    for (int axis = 0; axis < 3; ++axis) edges[axis] = size * random.magnitude(-2, 0);
    return {low, low + edges};
}

/// A point of the box: in a face, an edge or a corner as a rule.
Vec3 on(Random& random, const Box& box) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis)
        p[axis] = random.index(3) == 0   ? glm::mix(box.low[axis], box.high[axis], random.uniform(0, 1))
                  : random.index(2) == 0 ? box.low[axis]
                                         : box.high[axis];
    return p;
}

Disc some_disc(Random& random, Real size) {
    return {size * random.magnitude(-2, 2) * random.in_cube(), random.magnitude(-3, 3) * random.direction(),
            size};
}

/// A cylinder now and then, an apex now and then; `slenderness` is its length over its radius.
Cone some_cone(Random& random, Real size, Real slenderness) {
    const Vec3 a = size * random.magnitude(-2, 2) * random.in_cube();
    const Vec3 u = std::min<Real>(1, slenderness) * size * random.direction();
    const Real r = std::min<Real>(1, 1 / slenderness) * size;
    Cone cone{a, r, a + u, r};
    const std::size_t kind = random.index(3);
    if (kind > 0)
        (random.index(2) == 0 ? cone.radius_a : cone.radius_b) = kind == 1 ? 0 : r * random.uniform(0, 1);
    return cone;
}
Cone some_cone(Random& random, Real size) { return some_cone(random, size, random.magnitude(-1, 1)); }

/// A point at the height s of the axis, `radii` of the cone there away from it.
Vec3 beside_axis(Random& random, const Cone& cone, Real s, Real radii) {
    const Vec3 u = cone.b - cone.a;
    return cone.a + s * u +
           radii * (cone.radius_a + s * (cone.radius_b - cone.radius_a)) * random.perpendicular_to(u);
}
Vec3 beside_axis(Random& random, const Cone& cone) {
    return beside_axis(random, cone, random.uniform(-0.1, 1.1), random.uniform(0, 1.2));
}

Real size_of(const Box& box) { return length(box.high - box.low); }
Real size_of(const Disc& disc) { return disc.radius; }
Real size_of(const Cone& cone) { return length(cone.b - cone.a) + std::max(cone.radius_a, cone.radius_b); }

Vec3 place_of(const Cone& cone) { return cone.a; }

Vec3 aim(Random& random, const Box& box) { return on(random, box); }
Vec3 aim(Random& random, const Cone& cone) { return beside_axis(random, cone); }
Vec3 aim(Random& random, const Disc& disc) {
    return disc.center + disc.radius * random.uniform(0, 1.2) * random.perpendicular_to(disc.normal);
}

template <class Shape>
Shape some(Random& random, Real size) {
    if constexpr (std::is_same_v<Shape, Box>)
        return some_box(random, size);
    else if constexpr (std::is_same_v<Shape, Disc>)
        return some_disc(random, size);
    else
        return some_cone(random, size);
}

// ---------------------------------------------------------------------------------- families of all shapes

template <class Shape>
using Cases = std::vector<SolidCase<Shape>>;

template <class Shape>
Cases<Shape> far(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Shape shape = some<Shape>(random, random.magnitude(-3, 3));
        return SolidCase<Shape>{shape,
                                towards(random, aim(random, shape), size_of(shape) * random.magnitude(0, 8))};
    });
}

template <class Shape>
Cases<Shape> tiny_and_huge(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Shape shape = some<Shape>(random, random.uniform(1, 2) * (random.sign() > 0 ? 1e12 : 1e-12));
        return SolidCase<Shape>{shape,
                                towards(random, aim(random, shape), size_of(shape) * random.magnitude(0, 4))};
    });
}

template <class Shape>
Cases<Shape> long_and_short_directions(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Shape shape = some<Shape>(random, random.magnitude(-1, 1));
        Ray ray = towards(random, aim(random, shape), size_of(shape) * random.magnitude(0, 4));
        ray.direction *= random.sign() > 0 ? 1e20 : 1e-20;
        return SolidCase<Shape>{shape, ray};
    });
}

// -------------------------------------------------------------------------------------------------- boxes

Cases<Box> edges_and_corners(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        // Whole numbers, so that the ray passes exactly through what it is aimed at.
        const auto whole = [&](std::size_t limit) {
            return static_cast<Real>(random.index(2 * limit + 1)) - static_cast<Real>(limit);
        };
        const Vec3 low(whole(20), whole(20), whole(20));
        const Box box{low, low + Vec3(21 + whole(20), 21 + whole(20), 21 + whole(20))};
        const Vec3 target = on(random, box), d(whole(9), whole(9), whole(9));
        const Ray ray{target - (4 + whole(3)) * d, d == Vec3(0) ? Vec3(1, 0, 0) : d};
        return SolidCase<Box>{box, ray};
    });
}

Cases<Box> along_faces(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Box box = some_box(random, random.magnitude(-3, 3));
        const int axis = static_cast<int>(random.index(3));
        Ray ray = towards(random, on(random, box), size_of(box) * random.magnitude(-1, 3));
        // In the plane of a face, or nearly.
        ray.origin[axis] = random.index(2) == 0 ? box.low[axis] : box.high[axis];
        if (random.index(2) == 0) ray.origin[axis] *= random.nudge();
        ray.direction[axis] =
            random.index(2) == 0 ? random.sign() * 0.0 : random.sign() * random.magnitude(-300, -10);
        return SolidCase<Box>{box, ray};
    });
}

Cases<Box> flat_and_thin(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        Box box = some_box(random, 1);
        for (int axis = 0; axis < 3; ++axis) box.high[axis] = box.low[axis] + random.magnitude(-12, 3);
        return SolidCase<Box>{box, towards(random, on(random, box), random.magnitude(-2, 3))};
    });
}

constexpr std::array<SolidFamily<Box>, 6> boxes{{
    {"distance over size from 1 to 1e8", far<Box>, false},
    {"exactly through edges and corners", edges_and_corners},
    {"in faces and along them", along_faces},
    {"edges from 1e-12 to 1e3", flat_and_thin, false},
    {"size 1e-12 and 1e12", tiny_and_huge<Box>, false},
    {"directions of length 1e-20 and 1e20", long_and_short_directions<Box>, false},
}};

// -------------------------------------------------------------------------------------------------- discs

Cases<Disc> rims(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Disc disc = some_disc(random, random.magnitude(-3, 3));
        const Vec3 target = disc.center + disc.radius * random.nudge() * random.perpendicular_to(disc.normal);
        return SolidCase<Disc>{disc, towards(random, target, disc.radius * random.magnitude(-1, 2))};
    });
}

Cases<Disc> edge_on(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Disc disc = some_disc(random, random.magnitude(-3, 3));
        const Vec3 n = normalize(disc.normal), target = aim(random, disc);
        const Vec3 d = random.perpendicular_to(n) + random.sign() * random.magnitude(-16, -1) * n;
        return SolidCase<Disc>{disc, {target - disc.radius * random.magnitude(-1, 2) * d, d}};
    });
}

constexpr std::array<SolidFamily<Disc>, 5> discs{{
    {"distance over radius from 1 to 1e8", far<Disc>, false},
    {"at the rim, r(1 + k ulp)", rims},
    {"edge-on", edge_on},
    {"radius 1e-12 and 1e12", tiny_and_huge<Disc>},
    {"directions of length 1e-20 and 1e20", long_and_short_directions<Disc>},
}};

// -------------------------------------------------------------------------------------------------- cones

Cases<Cone> inside(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Cone cone = some_cone(random, random.magnitude(-3, 3));
        const Vec3 origin =
            beside_axis(random, cone, random.magnitude(-8, -0.01), 1 - random.magnitude(-8, 0));
        return SolidCase<Cone>{cone, {origin, random.uniform(0.5, 2) * random.direction()}};
    });
}

Cases<Cone> thin_and_flat(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Cone cone = some_cone(random, random.magnitude(-3, 3), random.magnitude(-8, 8));
        return SolidCase<Cone>{
            cone, towards(random, beside_axis(random, cone), size_of(cone) * random.magnitude(-1, 3))};
    });
}

Cases<Cone> tangent(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Cone cone = some_cone(random, random.magnitude(-3, 3));
        const Vec3 u = cone.b - cone.a, radial = random.perpendicular_to(u);
        const Real s = random.uniform(0.05, 0.95), widening = cone.radius_b - cone.radius_a;
        const Vec3 point = cone.a + s * u + random.nudge() * (cone.radius_a + s * widening) * radial;
        // In the plane that touches the side, and not along the side.
        const Vec3 along = normalize(u + widening * radial), across = normalize(cross(u, radial));
        const Vec3 d = random.uniform(0.5, 2) * (across + random.uniform(-2, 2) * along);
        return SolidCase<Cone>{cone, {point - size_of(cone) * random.magnitude(-1, 1) * d, d}};
    });
}

/// Along the axis, or along the side, or but for some ulps.
Cases<Cone> along(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Cone cone = some_cone(random, random.magnitude(-3, 3));
        const Vec3 u = cone.b - cone.a;
        Vec3 d = random.index(2) == 0 ? u : u + (cone.radius_b - cone.radius_a) * random.perpendicular_to(u);
        d *= random.sign() / length(u);
        if (random.index(3) > 0) d += random.magnitude(-17, -12) * random.direction();
        const Vec3 target = beside_axis(random, cone, random.uniform(0, 1), random.uniform(0, 1.2));
        return SolidCase<Cone>{cone, {target - size_of(cone) * random.magnitude(-1, 1) * d, d}};
    });
}

Cases<Cone> apexes_and_rims(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Cone cone = some_cone(random, random.magnitude(-3, 3));
        const Vec3 target = beside_axis(random, cone, static_cast<Real>(random.index(2)), random.nudge());
        return SolidCase<Cone>{cone, towards(random, target, size_of(cone) * random.magnitude(-1, 2))};
    });
}

constexpr std::array<SolidFamily<Cone>, 8> cones{{
    {"distance over size from 1 to 1e8", far<Cone>},
    {"length over radius from 1e-8 to 1e8", thin_and_flat},
    {"origin inside", inside, false},
    {"nearly tangent rays, at r(1 + k ulp)", tangent},
    {"along the axis and the side, but for some ulps", along},
    {"through apexes and rims", apexes_and_rims},
    {"size 1e-12 and 1e12", tiny_and_huge<Cone>},
    {"directions of length 1e-20 and 1e20", long_and_short_directions<Cone>},
}};

// ------------------------------------------------------------------------------------------------ judge

/// By how much the surface of the shape may be moved: η, and where a cone's side leans, more across the axis.
oracle::Growth allowed(const Cone& cone, Real eta) {
    const Real lean = std::abs(cone.radius_b - cone.radius_a) / length(cone.b - cone.a);
    return {eta * (1 + lean), eta};
}

template <class Shape>
struct Judge {
    const SolidCase<Shape>& item;
    Real eta = band * (length(item.ray.origin - place_of(item.shape)) + 5 * size_of(item.shape));
    oracle::Growth out = allowed(item.shape, eta), in{-out.across, -out.along};

    bool grown_is_met(Interval part) const { return oracle::meets(item.shape, item.ray, part, out); }
    bool shrunk_is_met(Interval part) const { return oracle::meets(item.shape, item.ray, part, in); }

    /// Whether the ray starts outside of all these shapes, or inside of them all; else it may be either.
    bool starts_outside() const { return !grown_is_met({0, 0}); }
    bool starts_inside() const { return shrunk_is_met({0, 0}); }

    /// Whether both answers would be right.
    bool is_undecided() const {
        if (starts_inside()) return false;
        if (!starts_outside()) return true;
        return grown_is_met({0, infinity}) && !shrunk_is_met({0, infinity});
    }

    bool can_be_missed() const { return !starts_inside() && !shrunk_is_met({0, infinity}); }

    /// Whether the line may come in at t, or go out there: not before the greatest shape, nor after the
    /// least.
    bool can_enter(Real t) const {
        const Real slack = band * std::abs(t);
        return grown_is_met({0, t + slack}) && !shrunk_is_met({0, t - slack});
    }
    bool can_leave(Real t) const {
        const Real slack = band * std::abs(t);
        return grown_is_met({t - slack, infinity}) && !shrunk_is_met({t + slack, infinity});
    }

    bool is_right(const std::optional<Hit>& answer) const {
        if (!answer) return can_be_missed();
        if (!(answer->t > 0)) return false;
        if (starts_outside()) return can_enter(answer->t);
        if (starts_inside()) return can_leave(answer->t);
        return can_enter(answer->t) || can_leave(answer->t);
    }

    /// For a ray that starts on the surface and goes inward: a miss is right only where it has, but for
    /// rounding, no way at all inside.
    bool is_exit(const std::optional<Hit>& answer) const {
        return answer ? answer->t > 0 && can_leave(answer->t) : !shrunk_is_met({0, infinity});
    }
};

/// Boxes are decided exactly, but where entry and exit differ by 4u of themselves.
template <>
struct Judge<Box> {
    const SolidCase<Box>& item;
    oracle::ClipTruth exact =
        oracle::judge_clip({item.shape.low, item.shape.high}, item.ray, {-infinity, infinity}, std::nullopt);

    bool is_undecided() const {
        return std::abs(exact.near - exact.far) <=
               4 * unit_roundoff * std::max(std::abs(exact.near), std::abs(exact.far));
    }
    bool is_right(const std::optional<Hit>& answer) const {
        const bool is_ahead = exact.inside && exact.far > 0;
        if (!answer) return !is_ahead || is_undecided();
        const Real t = exact.near > 0 ? exact.near : exact.far;
        return (is_ahead || is_undecided()) && answer->t > 0 &&
               std::abs(answer->t - t) <= 4 * unit_roundoff * t;
    }
    bool is_exit(const std::optional<Hit>& answer) const {
        if (!answer) return !exact.inside || exact.far <= 0;
        return std::abs(answer->t - exact.far) <= 4 * unit_roundoff * std::abs(exact.far);
    }
};

template <>
struct Judge<Disc> {
    const SolidCase<Disc>& item;
    Real eta = band * (length(item.ray.origin - item.shape.center) + item.shape.radius);

    oracle::DiscTruth truth(Real proposed) const {
        return oracle::judge_disc(item.shape, item.ray, proposed);
    }

    /// How much t may be wrong, and how much that moves the point across the disc.
    Real slack(const oracle::DiscTruth& truth) const {
        return band * std::abs(truth.t) + eta / std::abs(truth.slope);
    }
    Real moved(const oracle::DiscTruth& truth) const {
        return eta + slack(truth) * length(item.ray.direction) + band * truth.distance;
    }

    bool is_undecided() const {
        const oracle::DiscTruth exact = truth(0);
        return exact.crosses &&
               (std::abs(exact.t) <= slack(exact) ||
                (exact.t > 0 && std::abs(exact.distance - item.shape.radius) <= moved(exact)));
    }

    bool is_right(const std::optional<Hit>& answer) const {
        const oracle::DiscTruth exact = truth(answer ? answer->t : 0);
        if (!answer)
            return !exact.crosses || exact.t <= slack(exact) ||
                   exact.distance >= item.shape.radius - moved(exact);
        return exact.crosses && answer->t > 0 && std::abs(exact.error) <= slack(exact) &&
               exact.distance <= item.shape.radius + moved(exact);
    }
};

std::string literal(const Box& box) {
    return "Box{" + stability::literal(box.low) + ", " + stability::literal(box.high) + "}";
}
std::string literal(const Disc& disc) {
    return "Disc{" + stability::literal(disc.center) + ", " + stability::literal(disc.normal) + ", " +
           stability::literal(disc.radius) + "}";
}
std::string literal(const Cone& cone) {
    return "Cone{" + stability::literal(cone.a) + ", " + stability::literal(cone.radius_a) + ", " +
           stability::literal(cone.b) + ", " + stability::literal(cone.radius_b) + "}";
}

template <class Shape, class IsRight>
Verdict judge_all(std::span<const SolidCase<Shape>> cases, std::span<const std::optional<Hit>> answers,
                  IsRight is_right) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Judge<Shape> judge{cases[i]};
        if (!is_right(judge, answers[i]))
            count_mismatch(verdict,
                           literal(cases[i].shape) + ", " + stability::literal(cases[i].ray) +
                               "\n  answered: " +
                               (answers[i] ? "a hit at " + stability::literal(answers[i]->t) : "a miss"));
        else if (judge.is_undecided())
            ++verdict.undecided;
    }
    return verdict;
}

template <class Shape>
Verdict judge_hits(std::span<const SolidCase<Shape>> cases, std::span<const std::optional<Hit>> answers) {
    return judge_all(cases, answers, [](const auto& judge, const std::optional<Hit>& answer) {
        return judge.is_right(answer);
    });
}

template <class Shape>
Verdict judge_exits(const LeavingRays<SolidCase<Shape>>& rays, std::span<const std::optional<Hit>> answers) {
    return judge_all<Shape>(rays.cases, answers, [&](const auto& judge, const std::optional<Hit>& answer) {
        return rays.outward ? !answer : judge.is_exit(answer);
    });
}

}  // namespace

std::span<const SolidFamily<Box>> box_families() { return boxes; }
std::span<const SolidFamily<Disc>> disc_families() { return discs; }
std::span<const SolidFamily<Cone>> cone_families() { return cones; }

Verdict judge(std::span<const SolidCase<Box>> cases, std::span<const std::optional<Hit>> answers) {
    return judge_hits(cases, answers);
}
Verdict judge(std::span<const SolidCase<Disc>> cases, std::span<const std::optional<Hit>> answers) {
    return judge_hits(cases, answers);
}
Verdict judge(std::span<const SolidCase<Cone>> cases, std::span<const std::optional<Hit>> answers) {
    return judge_hits(cases, answers);
}

Verdict judge_leaving(const LeavingRays<SolidCase<Box>>& rays, std::span<const std::optional<Hit>> answers) {
    return judge_exits(rays, answers);
}
Verdict judge_leaving(const LeavingRays<SolidCase<Cone>>& rays, std::span<const std::optional<Hit>> answers) {
    return judge_exits(rays, answers);
}

}  // namespace rt::stability

namespace rt::naive {

std::optional<Hit> intersect(const Box& box, const Ray& ray, Interval range) {
    const Vec3 inverse = 1.0 / ray.direction;
    Real enter = -infinity, leave = infinity;
    for (int axis = 0; axis < 3; ++axis) {
        const Real t0 = (box.low[axis] - ray.origin[axis]) * inverse[axis];
        const Real t1 = (box.high[axis] - ray.origin[axis]) * inverse[axis];
        enter = std::max(enter, std::min(t0, t1));
        leave = std::min(leave, std::max(t0, t1));
    }
    if (enter > leave) return std::nullopt;
    if (contains(range, enter)) return Hit{.t = enter};
    return contains(range, leave) ? std::optional(Hit{.t = leave}) : std::nullopt;
}

std::optional<Hit> intersect(const Disc& disc, const Ray& ray, Interval range) {
    const Real toward = dot(ray.direction, disc.normal);
    const Real t = (dot(disc.normal, disc.center) - dot(disc.normal, ray.origin)) / toward;
    const bool is_on = length(point_at(ray, t) - disc.center) <= disc.radius;
    return contains(range, t) && is_on ? std::optional(Hit{.t = t}) : std::nullopt;
}

std::optional<Hit> intersect(const Cone& cone, const Ray& ray, Interval range) {
    const Vec3 axis = normalize(cone.b - cone.a), f = ray.origin - cone.a;
    const Real height = length(cone.b - cone.a), slope = (cone.radius_b - cone.radius_a) / height;
    const Real z = dot(f, axis), vz = dot(ray.direction, axis), r = cone.radius_a + slope * z;
    const Vec3 p = f - z * axis, v = ray.direction - vz * axis;
    const Real a = dot(v, v) - slope * slope * vz * vz, h = dot(p, v) - slope * vz * r, c = dot(p, p) - r * r;
    std::optional<Hit> first;
    const auto offer = [&](Real t, bool is_on) {
        if (is_on && contains(range, t) && (!first || t < first->t)) first = Hit{.t = t};
    };
    if (const Real discriminant = h * h - a * c; discriminant >= 0)
        for (const Real sign : {-1.0, 1.0}) {
            const Real t = (-h + sign * std::sqrt(discriminant)) / a;
            offer(t, 0 <= z + t * vz && z + t * vz <= height);
        }
    const auto cap = [&](Real at, Real radius) {
        const Real t = (at - z) / vz;
        offer(t, length(p + t * v) <= radius);
    };
    cap(0, cone.radius_a);
    cap(height, cone.radius_b);
    return first;
}

}  // namespace rt::naive
