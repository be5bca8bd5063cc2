// Exact numbers, and vectors of them or of other rings: for the oracle's own .cpp files, in which CGAL stays.
#pragma once

#include "common/math/vec.hpp"

#include <CGAL/Mpzf.h>
#ifndef CGAL_HAS_MPZF
#include <CGAL/Gmpzf.h>
#endif

namespace rt::oracle {

/// Whole numbers times a power of two: every double is one, and so are sums and products.
#ifdef CGAL_HAS_MPZF
using Exact = CGAL::Mpzf;
#else
using Exact = CGAL::Gmpzf;
#endif

template <class Number>
struct ExactVec3 {
    Number x, y, z;

    ExactVec3(const Number& x_, const Number& y_, const Number& z_) : x(x_), y(y_), z(z_) {}
    explicit ExactVec3(const Vec3& v) : x(v.x), y(v.y), z(v.z) {}

    friend ExactVec3 operator-(const ExactVec3& p, const ExactVec3& q) {
        return {p.x - q.x, p.y - q.y, p.z - q.z};
    }
    friend Number dot(const ExactVec3& p, const ExactVec3& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
    friend ExactVec3 cross(const ExactVec3& p, const ExactVec3& q) {
        return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
    }
};

}  // namespace rt::oracle
