// Single triangles for chapter 3: families of extreme cases and their judges.
#include "tests/stability/triangles.hpp"

#include "common/math/error.hpp"
#include "tests/oracle/polygon.hpp"
#include "tests/oracle/triangle.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt::stability {
namespace {

using test::many;
using test::Random;

// 4 ulp, as a relative error: an ulp is at most 2u.
constexpr Real band = 8 * unit_roundoff;

// --------------------------------------------------------------------------------------------- families

/// `size` long and `size / aspect` high, with a corner at `place`, turned at random.
Triangle some_triangle(Random& random, const Vec3& place, Real size, Real aspect) {
    const Vec3 along = random.direction();
    const Vec3 across = random.perpendicular_to(along);
    return {place, place + size * along, place + size * (random.uniform(0, 1) * along + across / aspect)};
}

/// A point of the plane: inside, a little outside, or close to an edge.
Vec3 some_target(Random& random, const Triangle& triangle) {
    Real b = random.uniform(-0.1, 1), c = random.uniform(-0.1, 1 - b);
    if (random.index(4) == 0) b = (random.index(2) == 0 ? -1 : 1) * random.magnitude(-18, -4);
    if (random.index(8) == 0) c = 1 - b;
    return triangle.a + b * (triangle.b - triangle.a) + c * (triangle.c - triangle.a);
}

TriangleCase aimed(Random& random, const Triangle& triangle, const Vec3& origin) {
    const Vec3 to_target = some_target(random, triangle) - origin;
    return {triangle, {origin, to_target * (random.uniform(0.5, 2) / length(to_target))}};
}

std::vector<TriangleCase> slivers(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Triangle triangle = some_triangle(random, random.in_cube(), 1, random.magnitude(0, 8));
        return aimed(random, triangle, triangle.a + random.magnitude(-1, 2) * random.direction());
    });
}

std::vector<TriangleCase> tiny_and_huge(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real size = random.uniform(1, 2) * (random.index(2) == 0 ? 1e20 : 1e-20);
        const Triangle triangle =
            some_triangle(random, size * random.in_cube(), size, random.magnitude(0, 2));
        const Vec3 origin = triangle.a + size * random.magnitude(-1, 3) * random.direction();
        return aimed(random, triangle, origin);
    });
}

std::vector<TriangleCase> edge_on(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Triangle triangle = some_triangle(random, random.in_cube(), 1, random.magnitude(0, 2));
        const Vec3 normal = normalize(cross(triangle.b - triangle.a, triangle.c - triangle.a));
        const Vec3 grazing = random.perpendicular_to(normal) + random.magnitude(-17, -4) * normal;
        const Vec3 origin = some_target(random, triangle) - random.magnitude(-1, 2) * grazing;
        return TriangleCase{triangle, {origin, random.uniform(0.5, 2) * grazing}};
    });
}

std::vector<TriangleCase> far(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Vec3 place = Vec3(148376, 1234, -223423) + Real(10) * random.in_cube();
        const Triangle triangle =
            some_triangle(random, place, random.magnitude(-4, 2), random.magnitude(0, 2));
        if (random.index(2) == 0) return aimed(random, triangle, random.in_cube());
        return aimed(random, triangle, triangle.a + random.magnitude(-1, 3) * random.direction());
    });
}

std::vector<TriangleCase> without_area(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        // Whole numbers times a power of two: corners on one line are so exactly.
        const auto whole = [&](int bits) {
            return Vec3(std::floor(std::ldexp(random.uniform(-1, 1), bits)),
                        std::floor(std::ldexp(random.uniform(-1, 1), bits)),
                        std::floor(std::ldexp(random.uniform(-1, 1), bits)));
        };
        const Real size = std::ldexp(Real(1), static_cast<int>(random.index(133)) - 66);
        const Vec3 place = whole(20), step = whole(20);
        std::array<Vec3, 3> corners;
        for (Vec3& corner : corners) corner = size * (place + std::floor(random.uniform(-1000, 1000)) * step);
        const std::size_t kind = random.index(5);
        if (kind < 3) corners[kind] = corners[(kind + 1) % 3];
        if (kind == 3) corners.fill(corners[0]);
        const Triangle triangle{corners[0], corners[1], corners[2]};
        const Vec3 origin = triangle.a + size * random.magnitude(3, 9) * random.direction();
        return aimed(random, triangle, origin);
    });
}

/// The same triangle six times, once for each order of its corners, and the same ray.
template <class Make>
std::vector<TriangleCase> in_every_order(std::size_t count, std::uint64_t seed, Make make) {
    Random random(seed);
    std::vector<TriangleCase> cases;
    cases.reserve(count + 5);
    while (cases.size() < count) {
        const TriangleCase made = make(random);
        std::array<std::size_t, 3> order{0, 1, 2};
        const std::array<Vec3, 3> corners{made.triangle.a, made.triangle.b, made.triangle.c};
        do {
            cases.push_back({{corners[order[0]], corners[order[1]], corners[order[2]]}, made.ray});
        } while (std::next_permutation(order.begin(), order.end()));
    }
    cases.resize(count);
    return cases;
}

}  // namespace

std::vector<TriangleCase> needles(std::size_t count, std::uint64_t seed) {
    return in_every_order(count, seed, [](Random& random) {
        const Vec3 tip = random.in_cube();
        const Vec3 blunt = tip + random.direction();
        const Triangle triangle{tip, blunt, blunt + random.magnitude(-15, -8) * random.direction()};
        return aimed(random, triangle, tip + random.magnitude(-1, 2) * random.direction());
    });
}

namespace {

/// Whole numbers below 1000, so that rays pass exactly through corners and points of edges.
std::vector<TriangleCase> integers(std::size_t count, std::uint64_t seed) {
    return in_every_order(count, seed, [](Random& random) {
        const auto whole = [&](Real limit) {
            return Vec3(std::floor(random.uniform(-limit, limit)), std::floor(random.uniform(-limit, limit)),
                        std::floor(random.uniform(-limit, limit)));
        };
        const Vec3 a = whole(500), step = whole(30);
        // Every whole multiple of the step up to the end is a point of the edge from a to b.
        const Real steps = std::floor(random.uniform(1, 16));
        const Vec3 target = a + std::floor(random.uniform(0, steps + 1)) * step;
        const Vec3 origin = whole(1000);
        return TriangleCase{{a, a + steps * step, whole(500)}, {origin, target - origin}};
    });
}

constexpr std::array<TriangleFamily, 7> families{{
    {"slivers of aspect up to 1e8", "1 over the cosine to the normal, times 1 to 10", slivers},
    {"edges of length 1e-20 and 1e20", "1 over the cosine to the normal, times 1 to 10", tiny_and_huge},
    {"seen nearly edge-on, cosines from 1e-17 to 1e-4", "1e4 to 1e17", edge_on},
    {"far from the origin, at (148376, 1234, -223423)", "1 over the cosine to the normal, times 1 to 1000",
     far},
    {"triangles without area", "none: every answer but a miss is wrong", without_area},
    {"needles, in every order of the corners", "1 over the cosine to the normal, times 1 to 10", needles},
    {"whole numbers, rays exactly at edges and corners, in every order", "1 over the cosine to the normal",
     integers, true},
}};

// ------------------------------------------------------------------------------------------------ judge

std::string text(const TriangleCase& item) { return literal(item.triangle) + ", " + literal(item.ray); }

/// How much the three volumes of `oracle::TriangleTruth` can change when each corner moves by `band` times
/// its distance from the origin, seen along the ray.
Vec3 volume_bounds(const TriangleCase& item) {
    const Vec3 d = item.ray.direction;
    const Vec3 size = glm::abs(d);
    const int z = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    struct Seen {
        Real aside, moved;  // distance from the ray in the plane that the shear keeps; how far it may move
    };
    const auto seen = [&](const Vec3& corner) {
        const Vec3 p = corner - item.ray.origin;
        return Seen{length(p - (p[z] / d[z]) * d), band * length(p)};
    };
    const auto bound = [&](const Seen& p, const Seen& q) {
        return size[z] * (p.aside * q.moved + q.aside * p.moved + p.moved * q.moved);
    };
    const Seen a = seen(item.triangle.a), b = seen(item.triangle.b), c = seen(item.triangle.c);
    return {bound(b, c), bound(c, a), bound(a, b)};
}

struct Judgement {
    oracle::TriangleTruth truth;
    bool surely_hit = false, surely_missed = false;
    Real allowed = 0;  ///< 8κu|t|
    Vec3 bounds{0};    ///< of the volumes
};

Judgement judge_one(const TriangleCase& item, Real proposed) {
    Judgement result;
    result.truth = oracle::judge_triangle(item.triangle, item.ray, proposed);
    const oracle::TriangleTruth& truth = result.truth;
    if (truth.degenerate) {
        result.surely_missed = true;
        return result;
    }
    result.bounds = volume_bounds(item);
    // Signs are exact, and so is the decision that they make; only the sign of t may be rounding.
    const Vec3 volumes = truth.sum < 0 ? -truth.volumes : truth.volumes;
    const bool inside = truth.sum != 0 && std::min({volumes.x, volumes.y, volumes.z}) >= 0;
    const auto& [a, b, c] = item.triangle;
    const Vec3& o = item.ray.origin;
    const Real reach = std::max({length(a - o), length(b - o), length(c - o)});
    const Real normal = length(cross(b - a, c - a));
    // Divided by |sum| in the end, so that a sum of zero allows anything.
    result.allowed =
        band * (reach + std::abs(truth.t) * length(item.ray.direction)) * (normal / std::abs(truth.sum));
    if (truth.sum == 0) result.allowed = infinity;
    result.surely_hit = inside && truth.t > result.allowed;
    result.surely_missed = !inside || truth.t < -result.allowed;
    return result;
}

}  // namespace

std::span<const TriangleFamily> triangle_families() { return families; }

Verdict judge(std::span<const TriangleCase> cases, std::span<const std::optional<Hit>> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const std::optional<Hit>& hit = answers[i];
        const Judgement exact = judge_one(cases[i], hit ? hit->t : 0);
        const oracle::TriangleTruth& truth = exact.truth;
        if (!exact.surely_hit && !exact.surely_missed) ++verdict.undecided;
        // Written only where something is wrong: there are hundreds of thousands of right answers.
        const auto complain = [&] {
            const std::string answer =
                hit ? "a hit at " + literal(hit->t) + " with the weights of b and c " + literal(hit->uv)
                    : "a miss";
            count_mismatch(verdict, text(cases[i]) + "\n  right: " +
                                        (truth.degenerate ? "a miss, it has no area"
                                         : truth.hit      ? "a hit at " + literal(truth.t)
                                                     : "a miss of the plane's point at " + literal(truth.t)) +
                                        "\n  answered: " + answer);
        };
        if (!hit) {
            if (exact.surely_hit) complain();
            continue;
        }
        const Real error = exact.allowed < infinity ? std::abs(truth.error) / exact.allowed : 0;
        if (exact.surely_missed || !(hit->t > 0 && std::isfinite(hit->t) && error <= 1)) {
            complain();
            continue;
        }
        remember(verdict, error, [&] { return text(cases[i]); });
        // The weights of the same triangle with its corners moved as far as for hit or miss. Where that can
        // change the area by half, they may be anything.
        const Vec3& bounds = exact.bounds;
        const Real moved = bounds.x + bounds.y + bounds.z;
        if (moved > std::abs(truth.sum) / 2) continue;
        const Vec2 exact_weights(truth.volumes.y / truth.sum, truth.volumes.z / truth.sum);
        const Real slack = 2 * moved / std::abs(truth.sum) + band;
        const Vec2 off = glm::abs(hit->uv - exact_weights);
        if (!(off.x <= slack && off.y <= slack)) complain();
    }
    return verdict;
}

// ---------------------------------------------------------------------------------------------- weights

std::vector<WeightCase> weight_cases(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const auto whole = [&](int bits) {
            return Vec3(std::floor(std::ldexp(random.uniform(-1, 1), bits)),
                        std::floor(std::ldexp(random.uniform(-1, 1), bits)),
                        std::floor(std::ldexp(random.uniform(-1, 1), bits)));
        };
        // Sixteenths of whole numbers need 4 bits more; all in all fewer than 53.
        const Real stretch = std::ldexp(Real(1), static_cast<int>(random.index(28)));
        WeightCase item;
        do {
            const Vec3 along = whole(8) * stretch, across = whole(8);
            const Vec3 place = whole(18);
            item.triangle = {place, place + Real(16) * along,
                             place + std::floor(random.uniform(0, 17)) * along + across};
        } while (cross(item.triangle.b - item.triangle.a, item.triangle.c - item.triangle.a) == Vec3(0));
        const Real b = std::floor(random.uniform(-2, 19)), c = std::floor(random.uniform(-2, 19 - b));
        item.weights = Vec3(16 - b - c, b, c) / Real(16);
        const Vec3& w = item.weights;
        item.point = w.x * item.triangle.a + w.y * item.triangle.b + w.z * item.triangle.c;
        return item;
    });
}

Verdict judge(std::span<const WeightCase> cases, std::span<const std::optional<Vec3>> answers,
              WeightsFrom method) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const WeightCase& item = cases[i];
        const auto& [a, b, c] = item.triangle;
        const Real longest = std::max({length(b - a), length(c - b), length(a - c)});
        const Real condition = longest * longest / length(cross(b - a, c - a));
        // Weights above 1 scale the answer, and so its error.
        const Vec3 size = glm::abs(item.weights);
        const Real amplified = method == WeightsFrom::DotProducts ? condition * condition : condition;
        if (band * amplified >= 1) continue;
        const Real allowed = band * amplified * std::max({Real(1), size.x, size.y, size.z});
        Real error = infinity;
        if (answers[i]) {
            const Vec3 off = glm::abs(*answers[i] - item.weights);
            // Adding keeps a NaN, which the maximum would lose.
            error = (off.x + off.y + off.z) / (3 * allowed);
            if (error <= 1) error = max_component(off) / allowed;
        }
        const auto write = [&] { return literal(item.triangle) + ", point " + literal(item.point); };
        if (!(error <= 1))
            count_mismatch(verdict, write() + "\n  right: " + literal(item.weights) +
                                        "\n  answered: " + (answers[i] ? literal(*answers[i]) : "no area"));
        else
            remember(verdict, error, write);
    }
    return verdict;
}

// ------------------------------------------------------------------------------------------------ turns

std::vector<TurnCase> turn_cases(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const Real size = random.magnitude(-20, 20);
        Vec2 p = size * Vec2(random.uniform(-1, 1), random.uniform(-1, 1));
        if (random.index(4) == 0) {
            // Short numbers, so that their multiples are exactly parallel.
            p = Vec2(std::floor(random.uniform(-1e6, 1e6)), std::floor(random.uniform(-1e6, 1e6)));
            return TurnCase{p, std::floor(random.uniform(-1e6, 1e6)) * p};
        }
        return TurnCase{p, random.uniform(-2, 2) * p};
    });
}

Verdict judge(std::span<const TurnCase> cases, std::span<const Real> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const auto& [p, q] = cases[i];
        const int right = oracle::orientation(Vec2(0), p, q);
        const Real answer = answers[i];
        if ((answer > 0) - (answer < 0) != right || std::isnan(answer))
            count_mismatch(verdict, literal(p) + ", " + literal(q) + "\n  right: " +
                                        (right > 0   ? "positive"
                                         : right < 0 ? "negative"
                                                     : "zero") +
                                        "\n  answered: " + literal(answer));
    }
    return verdict;
}

// ------------------------------------------------------------------------------------------------ tiles

std::vector<TilesCase> tiles_cases(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        // A lattice of 3 × 3 cells in some plane; its corners are rounded once, for all tiles alike.
        const Vec3 place = random.magnitude(-2, 3) * random.in_cube();
        const Vec3 along = random.direction(), across = random.perpendicular_to(along);
        const auto corner = [&](std::size_t i, std::size_t k) {
            return place + static_cast<Real>(i) * along + static_cast<Real>(k) * across;
        };
        TilesCase item;
        const std::size_t notch = random.index(2);
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 3; ++k) {
                if (i == 1 && k <= 1 && notch == 0) continue;  // these are parts of an L
                Polygon tile{{corner(i, k), corner(i + 1, k), corner(i + 1, k + 1), corner(i, k + 1)}};
                if (i == 0 && k == 0 && notch == 0)  // an L: this cell and the two that were left out
                    tile = {{corner(0, 0), corner(1, 0), corner(2, 0), corner(2, 1), corner(2, 2),
                             corner(1, 2), corner(1, 1), corner(0, 1)}};
                item.tiles.push_back(std::move(tile));
            }
        // Inside of the whole: a corner, or a point of an edge of the middle cell.
        const Vec3 p = corner(1 + random.index(2), 1), q = corner(1 + random.index(2), 2);
        const Vec3 target = p + (random.index(4) == 0 ? 0 : random.uniform(0, 1)) * (q - p);
        const Vec3 normal = cross(along, across);
        const Vec3 slant = random.uniform(-1, 1) * along + random.uniform(-1, 1) * across;
        const Vec3 origin = target + random.magnitude(-1, 2) * (normal + slant);
        item.ray = {origin, random.uniform(0.5, 2) * (target - origin)};
        return item;
    });
}

std::size_t tiles_hit(const TilesCase& item,
                      std::optional<Hit> (*intersect)(const Polygon&, const Ray&, Interval)) {
    return static_cast<std::size_t>(std::count_if(
        item.tiles.begin(), item.tiles.end(),
        [&](const Polygon& tile) { return intersect(tile, item.ray, Interval{}).has_value(); }));
}

Verdict judge(std::span<const TilesCase> cases, std::span<const std::size_t> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        if (answers[i] == 1) continue;
        std::string tiles;
        for (const Polygon& tile : cases[i].tiles) {
            tiles += "\n  {";
            for (const Vec3& vertex : tile.vertices) tiles += literal(vertex) + ", ";
            tiles += "}";
        }
        count_mismatch(verdict, literal(cases[i].ray) + tiles +
                                    "\n  right: one of these polygons is hit\n  answered: " +
                                    std::to_string(answers[i]));
    }
    return verdict;
}

// ---------------------------------------------------------------------------------------------- normals

Verdict judge_normals(std::span<const TriangleCase> cases, std::span<const Vec3> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const Triangle& triangle = cases[i].triangle;
        const Vec3 right = oracle::unit_normal(triangle);
        const Real error = length(answers[i] - right) / (128 * unit_roundoff);
        if (right == Vec3(0) ? answers[i] == Vec3(0) : error <= 1)
            remember(verdict, error, [&] { return literal(triangle); });
        else
            count_mismatch(verdict, literal(triangle) + "\n  right: " + literal(right) +
                                        "\n  answered: " + literal(answers[i]));
    }
    return verdict;
}

// --------------------------------------------------------------------------------------------- polygons

std::vector<OutlineCase> outline_cases(std::size_t count, std::uint64_t seed) {
    return many(count, seed, [](Random& random) {
        const bool short_numbers = random.index(2) == 0;
        const Vec2 place(random.uniform(-100, 100), random.uniform(-100, 100));
        const auto some_point = [&] {
            const Vec2 p(random.uniform(-8, 8), random.uniform(-8, 8));
            return short_numbers ? glm::floor(p) : place + p;
        };
        OutlineCase item;
        item.whole.resize(4 + random.index(9));
        for (Vec2& corner : item.whole) corner = some_point();
        const std::size_t n = item.whole.size();
        const std::size_t from = random.index(n), to = from + 2 + random.index(n - 3);
        for (std::size_t i = from; i <= to; ++i) item.left.push_back(item.whole[i % n]);
        for (std::size_t i = to; i <= from + n; ++i) item.right.push_back(item.whole[i % n]);

        const Vec2 &p = item.left.front(), &q = item.left.back();
        switch (random.index(4)) {
            case 0:
                item.point = some_point();
                break;
            case 1:
                item.point = p + random.uniform(0, 1) * (q - p);
                break;  // on the cut, but for rounding
            case 2:
                item.point = p + Real(0.5) * (q - p);
                break;  // exactly, if the numbers are short
            default:
                item.point = item.whole[random.index(n)];
                break;  // on a corner
        }
        // Off the cut, at the same height as a corner.
        if (random.index(8) == 0) item.point.x += random.uniform(-4, 4);
        return item;
    });
}

Verdict judge(std::span<const OutlineCase> cases, std::span<const OutlineAnswer> answers) {
    Verdict verdict;
    verdict.cases = cases.size();
    for (std::size_t i = 0; i < cases.size(); ++i) {
        const OutlineCase& item = cases[i];
        const OutlineAnswer& answer = answers[i];
        const auto write = [&] {
            std::string outline;
            for (const Vec2& corner : item.whole) outline += (outline.empty() ? "{" : ", ") + literal(corner);
            return outline + "}, point " + literal(item.point);
        };
        // How near the point is to an edge, and the greatest coordinate.
        Real nearest = infinity, size = 0;
        for (std::size_t k = 0; k < item.whole.size(); ++k) {
            const Vec2 p = item.whole[k], edge = item.whole[(k + 1) % item.whole.size()] - p;
            const Real square = dot(edge, edge);
            const Real along =
                square > 0 ? std::clamp(dot(item.point - p, edge) / square, Real(0), Real(1)) : 0;
            nearest = std::min(nearest, length(item.point - (p + along * edge)));
            size = std::max({size, std::abs(p.x), std::abs(p.y)});
        }
        const bool decided = nearest > band * size;
        if (!decided) ++verdict.undecided;
        if (answer.whole != (answer.left != answer.right))
            count_mismatch(verdict, write() + "\n  in a part once too often or too seldom: whole " +
                                        std::to_string(answer.whole) + ", parts " +
                                        std::to_string(answer.left) + " and " + std::to_string(answer.right));
        else if (decided &&
                 answer.whole != (oracle::place_in_polygon(item.whole, item.point) == oracle::Place::Inside))
            count_mismatch(verdict, write() + "\n  answered: " + (answer.whole ? "inside" : "outside"));
    }
    return verdict;
}

}  // namespace rt::stability
