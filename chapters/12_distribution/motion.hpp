// Motion blur: when light comes in, and how a ray sees what moves meanwhile.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/lens.hpp"
#include "common/world/bounds.hpp"
#include "common/world/spin.hpp"

namespace rt {

/// [12.8] The time, in [0, 1], until which the part `random` of all the light has come in. `random` is in
/// [0, 1).
///
/// Light comes in in proportion to how far the shutter is open: that grows evenly from 0 to 1 during
/// shutter.opening, stays 1, and falls evenly to 0 during shutter.closing, which ends at time 1. Either may
/// be 0, and both together 1. With `random` uniform, times come as often as light does at them (inversion of
/// the distribution, von Neumann 1947, in Eckhardt 1987). The light until the time returned is the part
/// `random` of all, within gamma(32).
Real shutter_time(const Shutter& shutter, Real random);

/// [12.9] The ray as a thing sees it that moves by `motion`, in world units, from where it stands at time 0
/// evenly to where it is at time 1: seen from there everything else moves backwards, also the ray's origin.
///
/// So the thing need not move: what the ray hits of it, as it stood at time 0, is hit at the same t as the
/// ray hits the thing where it is at ray.time. Direction and time are the ray's to the bit; each coordinate
/// of the origin is off by at most gamma(2) of |ray.origin| + |motion| along that axis, short of underflow.
Ray seen_while_moving(const Ray& ray, const Vec3& motion);

/// [12.9] A box around all places of a thing that has the box `bounds` at time 0 and moves by `motion`, which
/// is finite.
///
/// It surely contains p + t·motion, exactly, for all points p of `bounds` and all t from 0 to 1: its faces
/// are rounded outwards. None of them is farther out than it must be by more than 4 neighbouring numbers. An
/// empty box, with low > high along some axis, is returned as it is; faces at infinity stay there.
///
/// (What seen_while_moving rounds depends on how far away the ray starts; like all that a ray rounds, that is
/// for the margin of the grid.)
Bounds bounds_while_moving(const Bounds& bounds, const Vec3& motion);

/// [12.21] The ray as a thing sees it that turns by `spin`: seen from there everything else turns the other
/// way, the ray's origin and direction alike. The time is the ray's to the bit.
///
/// So the thing need not turn: what the ray hits of it, as it stood at time 0, is hit at the same t as the
/// ray hits the thing where it is at ray.time. Where ray.time · spin.angle is 0, it is the ray itself, to the
/// bit but for the sign of a zero. Else, with the angle ray.time · spin.angle as it is rounded to a Real,
/// each coordinate of the origin is off by at most gamma(64) of |ray.origin| + |spin.center|, and of the
/// direction by gamma(64) of |ray.direction|, short of underflow.
Ray seen_while_turning(const Ray& ray, const Spin& spin);

/// [12.22] The least and the greatest of x·cos θ + y·sin θ for all θ from 0 to `angle`, which is finite and
/// may be negative, and more than one turn. Both within gamma(16) of |x| + |y|, short of underflow.
Interval arc_range(Real x, Real y, Real angle);

/// [12.22] A box around all places of a thing that has the box `bounds` at time 0 and turns by `spin`. Both
/// are finite, or the box is empty, with low > high along some axis; then it is returned as it is.
///
/// It surely contains the whole arcs of the box's corners, from 0 to spin.angle, as exact arithmetic has
/// them, short of underflow: its faces are moved outwards by more than rounding can be wrong. None of them is
/// farther out than the arcs reach by more than gamma(256) of |spin.center| + r, where r is how far the
/// farthest corner is from spin.center.
///
/// (What contains the corners at any time contains the whole box then. A round thing may need less. If all of
/// it moves besides, bounds_while_moving of this box is around it, and often larger than need be: it has room
/// for each angle of the turn at each part of the way.)
Bounds bounds_while_turning(const Bounds& bounds, const Spin& spin);

}  // namespace rt
