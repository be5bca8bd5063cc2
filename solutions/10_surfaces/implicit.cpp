// Surfaces f(x, y, z) = 0 of any f, found for certain: interval arithmetic says where no root can be.
#include "chapters/10_surfaces/implicit.hpp"

#include "chapters/10_surfaces/surface_around.hpp"
#include "common/math/error.hpp"
#include "common/scene/evaluate.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace rt {
namespace {

constexpr Real middle_of(Piece piece) { return piece.low + (piece.high - piece.low) / 2; }

/// f at the points start + λ·way.
Enclosure enclose(const Formula& f, const Vec3& start, const Vec3& way, const Enclosure& lambda) {
    const auto at = [&](int i) { return Enclosure{start[i], start[i]} + way[i] * lambda; };
    return evaluate(f, at(0), at(1), at(2));
}

using Sloped = Dual<Enclosure, 1>;

/// f with its slope by λ.
Sloped with_slope(const Formula& f, const Chord& chord, const Enclosure& lambda) {
    const auto at = [&](int i) {
        const Real start = chord.start[i], way = chord.way[i];
        return Sloped{Enclosure{start, start} + way * lambda, {Enclosure{way, way}}};
    };
    return evaluate(f, at(0), at(1), at(2));
}

/// How fast the slope changes.
Enclosure bend(const Formula& f, const Chord& chord, const Enclosure& lambda) {
    const auto at = [&](int i) {
        const Real start = chord.start[i], way = chord.way[i];
        const Sloped along{Enclosure{way, way}, {Enclosure{0, 0}}};
        return Dual<Sloped, 1>{{Enclosure{start, start} + way * lambda, {along.value}}, {along}};
    };
    return evaluate(f, at(0), at(1), at(2)).slope[0].slope[0];
}

/// Pieces as short as this whose slope may be 0 are near a touch, or along a line in the surface; or, if f
/// has no bound at their middles, at a pole.
constexpr Real short_piece = 0x1p-10;

}  // namespace

Certain enclose(const ImplicitLine& line, Piece piece) {
    const auto& [f, chord] = line;
    const Enclosure lambda{piece.low, piece.high};
    const Real m = middle_of(piece);
    const Enclosure from_middle = lambda - Enclosure{m, m};
    const Sloped both = with_slope(*f, chord, lambda);
    Certain certain{both.value, both.slope[0], enclose(*f, chord.start, chord.way, {m, m})};
    // By the mean value theorem.
    const auto sharpen = [&](Enclosure& enclosure, const Enclosure& middle, const Enclosure& slope) {
        if (width_of(slope) < infinity && !is_empty(both.value))
            enclosure = intersection(enclosure, middle + slope * from_middle);
    };
    if (piece.high - piece.low < short_piece && contains(certain.slope, 0))
        sharpen(certain.slope, with_slope(*f, chord, {m, m}).slope[0], bend(*f, chord, lambda));
    sharpen(certain.value, certain.middle, certain.slope);
    return certain;
}

int side_of(const Enclosure& value) { return is_empty(value) ? 1 : sign_of(value); }

int side_at(const ImplicitLine& line, Real lambda) {
    return side_of(enclose(*line.f, line.chord.start, line.chord.way, {lambda, lambda}));
}

bool is_blurred(Piece piece, const Certain& certain) {
    const Real m = middle_of(piece), length = piece.high - piece.low;
    const Real slope = width_of(certain.slope), middle = width_of(certain.middle);
    if (length < 0x1p-60 || !(piece.low < m && m < piece.high)) return true;
    if (!(middle < infinity)) return length < short_piece;
    return slope * length <= middle || (slope == infinity && width_of(certain.value) <= 2 * middle);
}

Piece quartered(const ImplicitLine& line, Piece piece) {
    const Real quarter = (piece.high - piece.low) / 4;
    const int before = side_at(line, piece.low);
    Piece rest = piece;
    for (const Real lambda : {piece.low + quarter, piece.high - quarter}) {
        const int side = side_at(line, lambda);
        if (side == 0 || before == 0) continue;
        if (side != before) return {rest.low, lambda};
        rest.low = lambda;
    }
    return rest;
}

std::optional<Stretch> next_stretch(const ImplicitLine& line, std::vector<Piece>& pieces, Real begin) {
    // [exercise 10.11] Take pieces from the end of the list, and return the first of which enough is known,
    // with its side. Skip those that end at or before t = begin. Any other piece of which too little is known
    // is replaced in the list by its halves.
    while (!pieces.empty()) {
        const Piece piece = pieces.back();
        pieces.pop_back();
        if (line.chord.t_at(piece.high) <= begin) continue;
        const Certain f = enclose(line, piece);
        const int side = side_of(f.value);
        if (side != 0) return Stretch{piece, side, true};
        const bool is_known = !contains(f.slope, 0) || is_blurred(piece, f);
        if (is_known) return Stretch{piece, side_at(line, piece.high), false};
        pieces.push_back({middle_of(piece), piece.high});
        pieces.push_back({piece.low, middle_of(piece)});
    }
    return std::nullopt;
    // [/exercise]
}

Piece narrowed(const ImplicitLine& line, Piece piece) {
    // [exercise 10.12] Return the piece after as many steps as make it narrower by a fifth at least: Newton's
    // where the slope of f cannot be 0 on it, `quartered` where it can.
    for (;;) {
        const Certain f = enclose(line, piece);
        const Real m = middle_of(piece);
        Piece next;
        if (contains(f.slope, 0)) {
            next = quartered(line, piece);
        } else {
            const Enclosure root = Enclosure{m, m} - f.middle / f.slope;
            next = {std::max(piece.low, root.low), std::min(piece.high, root.high)};
        }
        if (!(next.low <= next.high && next.high - next.low < 0.8 * (piece.high - piece.low))) return piece;
        piece = next;
    }
    // [/exercise]
}

std::optional<LineCrossing> first_crossing(const ImplicitLine& line, Interval range) {
    // [exercise 10.13] Return the first crossing of the chord, {0, 1}, that is in the range, or nothing.
    // There is one wherever a certain side follows on the opposite one.
    std::vector<Piece> pieces{{0, 1}};
    Real edge = 0;
    int before = 0;
    while (line.chord.t_at(edge) <= range.max) {
        const std::optional<Stretch> next = next_stretch(line, pieces, range.min);
        if (!next) break;
        const auto& [piece, after, is_whole] = *next;
        if (before == 0 && !is_whole) before = side_at(line, edge = piece.low);
        if (after == 0) continue;
        if (before * after < 0) {
            const Piece where = narrowed(line, {edge, is_whole ? piece.low : piece.high});
            const Real t = line.chord.t_at(middle_of(where));
            if (contains(range, t)) return LineCrossing{t, after};
        }
        before = after;
        edge = piece.high;
    }
    return std::nullopt;
    // [/exercise]
}

std::optional<Hit> intersect(const Implicit& implicit, const Ray& ray, Interval range) {
    const std::optional<Chord> part = chord(implicit.box, ray, {0, infinity});
    if (!part) return std::nullopt;
    const std::optional<LineCrossing> crossing = first_crossing({lent(implicit.f), *part}, range);
    return crossing ? std::optional(Hit{.t = crossing->t, .element = surface_face}) : std::nullopt;
}

std::vector<Span> inside(const Implicit& implicit, const Ray& ray) {
    constexpr Interval whole{-infinity, infinity};
    std::vector<Span> spans;
    const std::optional<Span> box = inside(implicit.box, ray);
    const std::optional<Chord> part = box ? chord(*box, ray, whole) : std::nullopt;
    if (!part) return spans;
    const ImplicitLine line{lent(implicit.f), *part};
    std::optional<LineCrossing> crossing = first_crossing(line, whole);
    // Where the line comes into the box within rounding of the surface, what follows tells the side.
    int side = side_at(line, 0);
    if (side == 0) side = crossing ? -crossing->after : side_at(line, 0.5);
    Span span = *box;
    // As long as there is a further one, and not the same again.
    for (Real last = -infinity; crossing && crossing->t > last;
         crossing = first_crossing(line, {last, infinity})) {
        last = crossing->t;
        if (crossing->after < 0)
            span = {crossing->t, box->leave, surface_face, box->leave_face};
        else if (side < 0)
            spans.push_back({span.enter, crossing->t, span.enter_face, surface_face});
        side = crossing->after;
    }
    if (side < 0) spans.push_back(span);
    return spans;
}

Surface surface_at(const Implicit& implicit, const Ray& ray, const Hit& hit) {
    if (hit.element != surface_face) return surface_at(implicit.box, ray, hit);
    const Box& box = implicit.box;
    const Formula& f = *implicit.f;
    const auto value = [&](const Vec3& there) { return value_at(f, there); };
    const auto gradient = [&](const Vec3& there) { return gradient_at(f, there); };
    const Vec3 p = polished(point_in(box, ray, hit.t), box, 3, value, gradient);
    const auto side = [&](const Vec3& n, Real low, Real high) {
        return side_of(enclose({lent(implicit.f), {p, n, 0, 1}}, {low, high}).value);
    };
    return surface_around(p, gradient(p), ray, box, side);
}

Bounds bounds_of(const Implicit& implicit) { return {implicit.box.low, implicit.box.high}; }

}  // namespace rt
