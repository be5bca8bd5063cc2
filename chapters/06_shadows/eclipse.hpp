// How much of a round lamp a round thing hides: shadows with soft edges, without more rays. An optional step.
#pragma once

#include "common/math/vec.hpp"

namespace rt {

/// [06.5] Which part of a disc of radius `sun` is hidden by a disc of radius `moon` in front of it, the
/// centres `apart`, all in the same unit, as the angles in the sky are while they are small: a share of the
/// sun's area, in [0, 1]. The radii are from 1e-30 to 1e30, and `apart` is from 0 to
/// 1e30.
Real eclipsed(Real sun, Real moon, Real apart);

}  // namespace rt
