// The exact judge of lines and tori: Sturm's theorem behind a plain header.
// Every input must be finite but the part of a line.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"

#include <memory>

namespace rt::oracle {

/// A line, and a torus whose tube has been made thicker by `growth`, or thinner: what has shrunk to nothing
/// is not there.
class LineAndTorus {
public:
    LineAndTorus(const Torus& torus, const Ray& ray, Real growth = 0);
    ~LineAndTorus();

    /// Whether some point of the line with part.min ≤ t ≤ part.max is inside, or all of them are; the torus
    /// is closed. Both ends may be infinite. A part that ends before it begins has no points.
    bool meets(Interval part) const;
    bool covers(Interval part) const;

    /// Newton's step from t to the surface, without rounding but of its result: how much t is too little, if
    /// it is nearly right.
    Real step_from(Real t) const;

private:
    struct Numbers;
    std::unique_ptr<const Numbers> numbers;
};

}  // namespace rt::oracle
