// How values are written in the messages of failing tests: `show(value)`, which CHECK, INFO and CAPTURE use
// by themselves (tests/catch.hpp). One header for all the tests, because a type must print alike in all of
// them.
#pragma once

#include "chapters/02_spheres/quadratic.hpp"
#include "chapters/05_lighting/lighting.hpp"
#include "chapters/06_shadows/shadow.hpp"
#include "chapters/07_recursion/radiance.hpp"
#include "chapters/08_antialiasing/estimate.hpp"
#include "chapters/08_antialiasing/film.hpp"
#include "chapters/09_grids/walk.hpp"
#include "chapters/10_surfaces/cone.hpp"
#include "chapters/10_surfaces/implicit.hpp"
#include "chapters/10_surfaces/torus.hpp"
#include "chapters/13_hierarchies/split.hpp"
#include "chapters/13_hierarchies/walk.hpp"
#include "common/world/bounding_volumes.hpp"
#include "common/world/world.hpp"

#include <charconv>
#include <cmath>
#include <concepts>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <variant>
#include <vector>

namespace rt {
// Of samples.hpp, which stays out: its Random is another than the tests'.
struct PixelSample;
struct Stratum;
}  // namespace rt

namespace rt::test {

// Templates take no argument that would have to be converted: a whole number is not shown as a Real, nor
// a cell as a point.

/// The fewest digits that tell the number from every other one: 0.1, 1e-20, -0.
template <std::same_as<Real> Number>
std::string show(Number x) {
    if (std::isnan(x)) return "nan";
    char digits[32];
    return {digits, std::to_chars(digits, digits + sizeof digits, x).ptr};
}

std::string show(std::integral auto number) { return std::to_string(number); }

/// A size such as a tolerance, of which three digits say enough: 8.88e-16.
inline std::string show_size(Real size) {
    char digits[32];
    std::snprintf(digits, sizeof digits, "%.3g", size);
    return digits;
}

/// (1, 2.5, -3)
template <int N, class T, glm::qualifier Q>
std::string show(const glm::vec<N, T, Q>& v) {
    std::string text = "(";
    for (int i = 0; i < N; ++i) text += (i > 0 ? ", " : "") + show(v[i]);
    return text + ")";
}

/// Row by row, as on paper.
template <int Columns, int Rows, glm::qualifier Q>
std::string show(const glm::mat<Columns, Rows, Real, Q>& m) {
    std::string text;
    for (int r = 0; r < Rows; ++r) {
        text += "\n  |";
        for (int c = 0; c < Columns; ++c) text += " " + show(m[c][r]);
        text += " |";
    }
    return text;
}

/// (0, inf]
inline std::string show(const Interval& range) {
    return "(" + show(range.min) + ", " + show(range.max) + "]";
}

inline std::string show(const Ray& ray) {
    return "ray from " + show(ray.origin) + " along " + show(ray.direction);
}

// Shapes, and what a ray finds out about them.

inline std::string show(const Plane& plane) {
    return "plane through " + show(plane.point) + " with normal " + show(plane.normal);
}

inline std::string show(const Sphere& sphere) {
    return "sphere around " + show(sphere.center) + " of radius " + show(sphere.radius);
}

inline std::string show(const Triangle& t) {
    return "triangle " + show(t.a) + ", " + show(t.b) + ", " + show(t.c);
}

inline std::string show(const Polygon& polygon) {
    std::string text = "polygon";
    for (const Vec3& vertex : polygon.vertices) text += " " + show(vertex);
    return text;
}

inline std::string show(const Box& box) { return "box from " + show(box.low) + " to " + show(box.high); }

inline std::string show(const Disc& disc) {
    return "disc around " + show(disc.center) + " with normal " + show(disc.normal) + " and radius " +
           show(disc.radius);
}

inline std::string show(const Cone& cone) {
    return "cone from " + show(cone.a) + ", radius " + show(cone.radius_a) + ", to " + show(cone.b) +
           ", radius " + show(cone.radius_b);
}

inline std::string show(const OpenCone& open) { return "open " + show(open.cone); }

inline std::string show(const Implicit& implicit) {
    return implicit.f->text + " = 0 in a " + show(implicit.box);
}

inline std::string show(const Quadric& q) {
    return "quadric of " + show(q.squares) + ", " + show(q.mixed) + ", " + show(q.linear) + ", " +
           show(q.constant) + " in a " + show(q.box);
}

inline std::string show(const Enclosure& a) { return "[" + show(a.low) + ", " + show(a.high) + "]"; }

inline std::string show(const Piece& piece) { return show(piece.low) + " and " + show(piece.high); }

inline std::string show(const LineCrossing& crossing) {
    return "crossing at " + show(crossing.t) + " to the " + (crossing.after < 0 ? "inside" : "outside");
}

inline std::string show(const Span& span) {
    return "inside from " + show(span.enter) + " (face " + show(span.enter_face) + ") to " +
           show(span.leave) + " (face " + show(span.leave_face) + ")";
}

inline std::string show(const ConeLine& line) {
    return "tau from t = " + show(line.from) + ": |" + show(line.e) + " + tau " + show(line.m) +
           "| against " + show(line.alpha) + " + tau " + show(line.beta) + ", along the axis at " +
           show(line.along) + " + tau " + show(line.along_step) + ", a = " + show(line.a);
}

inline std::string show(const Torus& torus) {
    return "torus around " + show(torus.center) + " with axis " + show(torus.axis) + ", ring " +
           show(torus.ring) + " and tube " + show(torus.tube);
}

inline std::string show(const TorusSpans& spans) {
    std::string text;
    for (std::size_t i = 0; i < static_cast<std::size_t>(spans.count); ++i)
        text += (i == 0 ? "inside from " : " and from ") + show(spans.spans[i].enter) + " to " +
                show(spans.spans[i].leave);
    return text.empty() ? "nowhere inside" : text;
}

inline std::string show(const TorusLine& line) {
    return "from + tau/speed with from = " + show(line.from) + ", speed = " + show(line.speed) +
           "; q = " + show(line.q) + ", e = " + show(line.e) + ", n = " + show(line.n);
}

/// t^4 - 2t^2 + 1
inline std::string show(const Polynomial& p) {
    const char* powers[] = {"", "t", "t^2", "t^3", "t^4"};
    std::string text;
    for (std::size_t i = 5; i-- > 0;) {
        if (p.a[i] == 0) continue;
        const Real size = text.empty() ? p.a[i] : std::abs(p.a[i]);
        if (!text.empty()) text += p.a[i] < 0 ? " - " : " + ";
        text += (size == 1 && i > 0 ? "" : show(size)) + powers[i];
    }
    return text.empty() ? "0" : text;
}

inline std::string show(const SignChanges& changes) {
    std::string text;
    for (std::size_t i = 0; i < static_cast<std::size_t>(changes.count); ++i)
        text += " " + show(changes.t[i]);
    return changes.count == 0 ? "no change of sign" : "changes of sign at" + text;
}

/// A template, so that a type which converts to SetOperation, such as a JSON value, does not come here.
template <std::same_as<SetOperation> Operation>
std::string show(Operation operation) {
    switch (operation) {
        case SetOperation::Union:
            return "union";
        case SetOperation::Intersection:
            return "intersection";
        case SetOperation::Difference:
            return "difference";
    }
    return "no operation";
}

inline std::string show(const Transform& transform) { return "transform" + show(transform.to_world); }

inline std::string show(const Bounds& bounds) { return show(Box{bounds.low, bounds.high}); }

inline std::string show(const BoundingSphere& sphere) { return show(Sphere{sphere.center, sphere.radius}); }

inline std::string show(const OrientedBox& box) {
    return "box around " + show(box.center) + " of halves " + show(box.half) + " along " + show(box.axes[0]) +
           ", " + show(box.axes[1]) + ", " + show(box.axes[2]);
}

inline std::string show(const BoundingEllipsoid& ellipsoid) {
    return "ellipsoid around " + show(ellipsoid.center) + ", longest " + show(ellipsoid.longest) +
           ", to the unit sphere by" + show(ellipsoid.to_unit);
}

inline std::string show(const Spin& spin) {
    return "spin by " + show(spin.angle) + " about the line through " + show(spin.center) + " along " +
           show(spin.axis);
}

inline std::string show(const Roots& roots) {
    if (roots.count == 0) return "no roots";
    if (roots.count == 1) return "one root: t0 = " + show(roots.t0) + ", t1 = " + show(roots.t1);
    return show(roots.count) + " roots: t0 = " + show(roots.t0) + ", t1 = " + show(roots.t1);
}

/// Only what was set: a plane's hit has no uv.
inline std::string show(const Hit& hit) {
    std::string text = "hit of number " + show(hit.primitive) + " at t = " + show(hit.t);
    if (hit.uv != Vec2(0)) text += ", uv " + show(hit.uv);
    if (hit.element != 0) text += ", element " + show(hit.element);
    return text;
}

inline std::string show(const Surface& surface) {
    std::string text = "surface at " + show(surface.point) + " +- " + show(surface.error) + ", normal " +
                       show(surface.normal);
    if (surface.shading_normal != surface.normal) text += ", shading normal " + show(surface.shading_normal);
    if (surface.uv != Vec2(0)) text += ", uv " + show(surface.uv);
    return text;
}

// The camera, light, and the tree of rays.

inline std::string show(const CameraFrame& frame) {
    return "u = " + show(frame.u) + "\nv = " + show(frame.v) + "\nw = " + show(frame.w);
}

inline std::string show(const PointLight& light) {
    return "point light at " + show(light.position) + ", colour " + show(light.color) + ", attenuation " +
           show(light.attenuation);
}

inline std::string show(const DirectionalLight& light) {
    return "light from " + show(light.direction) + ", colour " + show(light.color);
}

inline std::string show(const LightSample& sample) {
    return "direction " + show(sample.direction) + ", distance " + show(sample.distance) + ", colour " +
           show(sample.color);
}

inline std::string show(const ShadowRay& shadow) {
    return "shadow " + show(shadow.ray) + " in " + show(shadow.range);
}

inline std::string show(const Branch& branch) {
    const char* kinds[] = {"camera", "mirrored", "refracted"};
    return std::string(kinds[static_cast<int>(branch.kind)]) + " " + show(branch.ray) + ", weight " +
           show(branch.weight) + ", depth " + show(branch.depth);
}

// Samples, grids and hierarchies.

template <std::same_as<PixelSample> Sample>
std::string show(const Sample& sample) {
    return "sample at " + show(sample.at) + " that weighs " + show(sample.weight);
}

template <std::same_as<Stratum> Part>
std::string show(const Part& part) {
    return "stratum from " + show(part.low) + " to " + show(part.high);
}

inline std::string show(const FilmPixel& pixel) {
    return "sum " + show(pixel.sum) + " (lost " + show(pixel.lost) + "), weight " + show(pixel.weight) +
           " (lost " + show(pixel.lost_weight) + ")";
}

inline std::string show(const Estimate& estimate) {
    return "mean " + show(estimate.mean) + " +- " + show(estimate.standard_error);
}

inline std::string show(const GridShape& shape) {
    return "grid of " + show(shape.cells) + " cells in the " + show(shape.box);
}

inline std::string show(const CellVisit& visit) {
    return "cell " + show(visit.cell) + " in " + show(visit.t);
}

inline std::string show(const NodeVisit& visit) {
    return "node " + show(visit.node) + " in " + show(visit.t);
}

inline std::string show(const ChildVisits& met) {
    if (met.count <= 0) return "no child";
    return show(met.visits[0]) + (met.count > 1 ? ", then " + show(met.visits[1]) : "");
}

inline std::string show(const Bin& bin) {
    return bin.count == 0 ? "nothing" : show(bin.count) + " in a " + show(bin.box);
}

inline std::string show(const Cut& cut) {
    return cut.at == 0 ? "no cut" : "cut after bin " + show(cut.at) + " that costs " + show(cut.cost);
}

inline std::string show(const SearchCounts& counts) {
    return show(counts.cells) + " cells, " + show(counts.shapes) + " shapes";
}

// How far a value is from what was expected.

/// Which words tell how two vectors differ.
enum class Kind { Place, Direction, Color };

/// Equal but for a billionth: what this does not tell apart, no eye does.
inline bool alike(Real a, Real b) { return std::abs(a - b) <= 1e-9 * std::abs(b); }

/// "2 times too much", "the sign is wrong": a simple ratio says more than a difference; else nothing.
inline std::string ratio_in_words(Real actual, Real expected) {
    if (expected == 0 || !std::isfinite(actual) || !std::isfinite(expected)) return "";
    if (alike(actual, -expected)) return "the sign is wrong";
    for (int k = 2; k <= 10; ++k) {
        if (alike(actual, k * expected)) return show(k) + " times too much";
        if (alike(k * actual, expected)) return show(k) + " times too little";
    }
    return "";
}

/// "off by 0.8: the sign is wrong"
inline std::string off_by(Real actual, Real expected, Kind = Kind::Place) {
    if (std::isnan(actual)) return "not a number";
    if (std::isinf(actual) || std::isinf(expected)) return "";
    const std::string ratio = ratio_in_words(actual, expected);
    return "off by " + show_size(std::abs(actual - expected)) + (ratio.empty() ? "" : ": " + ratio);
}

/// "41° off", "the opposite way", "of length 0.5", or nothing where neither angle nor length says it.
inline std::string turned(const Vec3& actual, const Vec3& expected) {
    const Real size = glm::length(actual), wanted = glm::length(expected);
    if (!(size > 0 && wanted > 0) || std::isinf(size)) return "";
    const Real angle = std::atan2(glm::length(glm::cross(actual, expected)), glm::dot(actual, expected));
    std::string text;
    if (angle > 1e-6) text = pi - angle < 1e-6 ? "the opposite way" : show_size(angle * 180 / pi) + "° off";
    if (std::abs(size / wanted - 1) > 1e-6)
        text += (text.empty() ? "the right way, but of length " : ", and of length ") + show_size(size) +
                ", not " + show_size(wanted);
    return text;
}

/// The coordinate that is farthest off, by how much, and where it is as simple as that, why.
template <int N>
std::string off_by(const glm::vec<N, Real>& actual, const glm::vec<N, Real>& expected,
                   Kind kind = Kind::Place) {
    if constexpr (N == 3)
        if (kind == Kind::Direction)
            if (const std::string text = turned(actual, expected); !text.empty()) return text;
    const char* const channels[] = {"the red channel", "the green channel", "the blue channel", "alpha"};
    const char* const axes[] = {"x", "y", "z", "w"};
    const char* const* names = kind == Kind::Color ? channels : axes;
    int worst = 0;
    bool mirrored = true;
    std::string wrong_signs;
    for (int i = 0; i < N; ++i) {
        const Real off = std::abs(actual[i] - expected[i]);
        if (std::isnan(actual[i])) return std::string(names[i]) + " is not a number";
        if (std::isnan(off)) return "";
        if (off > std::abs(actual[worst] - expected[worst])) worst = i;
        mirrored = mirrored && (alike(actual[i], expected[i]) || alike(actual[i], -expected[i]));
        if (expected[i] != 0 && alike(actual[i], -expected[i]))
            wrong_signs += (wrong_signs.empty() ? "" : " and ") + std::string(names[i]);
    }
    if (mirrored && !wrong_signs.empty()) return "the sign of " + wrong_signs + " is wrong";
    if (std::isinf(actual[worst]) || std::isinf(expected[worst])) return "";
    // A ratio means something only if all have the same.
    bool scaled = true;
    for (int i = 0; i < N; ++i)
        scaled = scaled && alike(actual[i] * expected[worst], actual[worst] * expected[i]);
    const std::string ratio = scaled ? ratio_in_words(actual[worst], expected[worst]) : "";
    return std::string(names[worst]) + " is off by " + show_size(std::abs(actual[worst] - expected[worst])) +
           (ratio.empty() ? "" : ": " + ratio);
}

/// What `near` answers: as a condition true or false, and in a message all that was compared.
template <class Value>
struct Nearness {
    Value actual;
    Value expected;
    Real bound = 0;
    bool near = false;
    Kind kind = Kind::Place;
    operator bool() const { return near; }
};

/// Whether `actual` is within `bound` of `expected`, a vector in each coordinate; false for NaN.
inline Nearness<Real> near(Real actual, Real expected, Real bound) {
    return {actual, expected, bound, actual == expected || std::abs(actual - expected) <= bound};
}
inline Nearness<Vec2> near(const Vec2& actual, const Vec2& expected, Real bound) {
    return {actual, expected, bound, glm::all(glm::lessThanEqual(glm::abs(actual - expected), Vec2(bound)))};
}
inline Nearness<Vec3> near(const Vec3& actual, const Vec3& expected, Real bound, Kind kind = Kind::Place) {
    return {actual, expected, bound, glm::all(glm::lessThanEqual(glm::abs(actual - expected), Vec3(bound))),
            kind};
}

/// The same of directions and of colours, whose differences are told as such.
inline Nearness<Vec3> near_direction(const Vec3& actual, const Vec3& expected, Real bound) {
    return near(actual, expected, bound, Kind::Direction);
}
inline Nearness<Vec3> near_color(const Vec3& actual, const Vec3& expected, Real bound) {
    return near(actual, expected, bound, Kind::Color);
}

/// Whether two searches have found the same: nothing, or the same shape at the same distance.
inline Nearness<std::optional<Hit>> same_hit(const std::optional<Hit>& actual,
                                             const std::optional<Hit>& expected) {
    const bool same = actual.has_value() == expected.has_value() &&
                      (!actual || (actual->t == expected->t && actual->primitive == expected->primitive));
    return {actual, expected, 0, same};
}

/// A condition that a message tells in words: where it does not hold, `wrong` says what is so instead.
struct Told {
    bool holds = false;
    std::string wrong;
    operator bool() const { return holds; }
};
inline Told or_say(bool holds, std::string wrong) { return {holds, std::move(wrong)}; }

inline std::string show(const Told& told) { return told.wrong; }

inline std::string show(const std::optional<Hit>& hit) { return hit ? show(*hit) : "a miss"; }

template <class Value>
std::string show(const Nearness<Value>& nearness) {
    std::string text = show(nearness.actual) + ", expected " + show(nearness.expected) +
                       (nearness.bound > 0 ? " +- " + show_size(nearness.bound) : "");
    if constexpr (requires { off_by(nearness.actual, nearness.expected, nearness.kind); })
        if (const std::string off = off_by(nearness.actual, nearness.expected, nearness.kind);
            !off.empty() && !nearness.near)
            text += "\n" + off;
    return text;
}

/// What `show` knows: all of the above, and what holds it.
template <class T>
inline constexpr bool is_shown = requires(const T& value) {
    show(value);
};
template <class T>
inline constexpr bool is_shown<std::optional<T>> = is_shown<T>;
template <class... T>
inline constexpr bool is_shown<std::variant<T...>> = (is_shown<T> && ...);
template <class T>
inline constexpr bool is_shown<std::vector<T>> = is_shown<T>;
template <class T>
concept Shown = is_shown<T>;

template <Shown T>
std::string show(const std::optional<T>& maybe);
template <Shown... T>
std::string show(const std::variant<T...>& one);
template <Shown T>
std::string show(const std::vector<T>& list);

template <Shown T>
std::string show(const std::optional<T>& maybe) {
    return maybe ? show(*maybe) : "nothing";
}

template <Shown... T>
std::string show(const std::variant<T...>& one) {
    return std::visit([](const auto& value) { return show(value); }, one);
}

/// {1, 2, 3}
template <Shown T>
std::string show(const std::vector<T>& list) {
    std::string text = "{";
    for (std::size_t i = 0; i < list.size(); ++i) text += (i > 0 ? ", " : "") + show(list[i]);
    return text + "}";
}

/// Text from parts, as a stream takes them, but with values as `show` writes them.
class Text {
public:
    template <class T>
    Text& operator<<(const T& part) {
        if constexpr (Shown<T> && !std::same_as<T, char> && !std::same_as<T, bool>)
            text += show(part);
        else
            text += streamed(part);
        return *this;
    }
    const std::string& str() const { return text; }

private:
    template <class T>
    static std::string streamed(const T& part) {
        std::ostringstream out;
        out << part;
        return out.str();
    }
    std::string text;
};

}  // namespace rt::test
