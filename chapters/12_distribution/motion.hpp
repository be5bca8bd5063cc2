// Motion blur: when light comes in, and how a ray sees what moves meanwhile.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/lens.hpp"
#include "common/world/bounds.hpp"

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

}  // namespace rt
