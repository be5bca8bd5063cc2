// Surfaces f(x, y, z) = 0 of any f, found for certain: interval arithmetic says where no root can be.
// ε is the unit roundoff of `Real`.
#pragma once

#include "chapters/10_surfaces/chord.hpp"
#include "common/math/dual.hpp"
#include "common/scene/shapes.hpp"
#include "common/world/bounds.hpp"

#include <vector>

namespace rt {

/// f along a chord.
struct ImplicitLine {
    SharedFormula f;
    Chord chord;
};

/// A part of a chord, by its λ.
struct Piece {
    Real low = 0, high = 1;
};

/// What is certain of f on a piece: its values, its slopes by λ, and its value at the middle. Where f has no
/// value at all, `value` is empty; where it has none at some points, or no slope, all of that is everything.
struct Certain {
    Enclosure value, slope, middle;
};

/// Given. The value is what two enclosures have in common: f of the piece, and by the mean value theorem f of
/// its middle + its slope times the way from there. On short pieces where the slope may be 0 that is done for
/// the slope, too.
Certain enclose(const ImplicitLine& line, Piece piece);

/// Given. The sign of f: −1 inside, 1 outside; 0 where that is open. Where f has no value is outside.
int side_of(const Enclosure& value);
int side_at(const ImplicitLine& line, Real lambda);

/// Given. Whether a piece tells nothing more when it is divided: it is narrower than 2⁻⁶⁰, or there is no
/// number between its ends; or its slope makes less of a difference to f than rounding does; or, where the
/// slope has no bound, the values of all of it are hardly wider than that of its middle. Where f has no bound
/// at the middle, as at a pole, that says nothing of the rest: then a piece is blurred if it is shorter than
/// 2⁻¹⁰.
bool is_blurred(Piece piece, const Certain& certain);

/// Given. The piece without the quarters before and behind the crossing in it, as far as the sides at a
/// quarter and at three quarters are certain; itself where they tell nothing.
Piece quartered(const ImplicitLine& line, Piece piece);

/// A piece of which enough is known.
struct Stretch {
    Piece piece;
    int side = 0;           ///< at its right end: −1 inside, 1 outside, 0 where rounding hides it
    bool is_whole = false;  ///< whether all of the piece is on that side
};

/// [10.11] The next piece, from left to right, that need not be divided, or nothing when there is none left
/// (Mitchell 1990). It is taken from the list of pieces that are still to be looked at, the leftmost last;
/// and so are those before it: pieces that end at or before the ray's t = begin are left out, and any of
/// which too little is known is replaced by its halves. Enough is known
/// - where f cannot be 0: then all of the piece is on one side;
/// - where the slope of f cannot be 0, or the piece is blurred: then the side at its right end tells what has
///   happened.
std::optional<Stretch> next_stretch(const ImplicitLine& line, std::vector<Piece>& pieces, Real begin);

/// [10.12] A smaller piece with the same crossing, by Newton's method for intervals (Moore 1966): where the
/// slope cannot be 0, the root is in m − f(m)/slope, m being the middle; where it may be, the piece is
/// `quartered`. Repeated as long as that makes it narrower by a fifth at least.
Piece narrowed(const ImplicitLine& line, Piece piece);

/// Where a line crosses the surface.
struct LineCrossing {
    Real t = 0;     ///< of the ray
    int after = 0;  ///< the side behind it: −1 where the line goes in
};

/// [10.13] The first crossing whose t is in (range.min, range.max], or nothing. Where a certain side follows
/// on the opposite one, there is a crossing, at the middle of what `narrowed` makes of the part between them.
/// Which pieces there are depends on the line alone, not on the range.
std::optional<LineCrossing> first_crossing(const ImplicitLine& line, Interval range);

/// Given. Nearest hit with the surface in (range.min, range.max], or nothing; a range that begins below 0
/// begins at 0.
///
/// The answer is that of a line moved by 4ε·(|origin| + the box's greatest coordinate); and of that line no
/// crossing is missed: where f is less than 0 for certain at one point and more at a later one, there is a
/// hit between. (Also where f jumps from one to the other, as 1/x does; and where it has no value it counts
/// as positive.) What rounding hides is left out: where f touches 0, or goes through it and back, and remains
/// within three times the bound of its rounding error, there may be no hit, or two. A surface on which the
/// ray begins, within that bound, is none of its hits.
///
/// `Hit::element` is `surface_face`.
std::optional<Hit> intersect(const Implicit& implicit, const Ray& ray, Interval range);

/// Given, for solids that are made of others. The parts of the line where f ≤ 0 in the box, in order. They
/// are closed by the box's faces; those of a line that remains within rounding of the surface are left out.
std::vector<Span> inside(const Implicit& implicit, const Ray& ray);

/// Given. The surface at a hit: the point, moved onto the surface, and the unit normal, along the gradient,
/// outward: to where f increases. Where there is no gradient, as at the tip of a cone, the normal is along
/// the ray, to its outer side. The error is as `surface_around` says. Where the hit is on one of the box's
/// faces, the surface is the box's.
Surface surface_at(const Implicit& implicit, const Ray& ray, const Hit& hit);

/// The box. Given.
Bounds bounds_of(const Implicit& implicit);

}  // namespace rt
