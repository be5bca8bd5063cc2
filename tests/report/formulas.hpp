// Textbook and stable intersections over any kind of number: float, double, long double, double-double.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rt::report {

/// The unevaluated sum of two doubles, some 106 bits (Dekker 1971; Hida, Li & Bailey 2001).
struct DoubleDouble {
    double high = 0, low = 0;

    DoubleDouble() = default;
    DoubleDouble(double value) : high(value) {}  // NOLINT: numbers convert
    DoubleDouble(double sum, double error) : high(sum + error), low(error - (high - sum)) {}
    explicit operator double() const { return high + low; }

    friend DoubleDouble operator-(const DoubleDouble& a) { return {-a.high, -a.low}; }
    friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
        const DoubleDouble s = two_sum(a.high, b.high), t = two_sum(a.low, b.low);
        const DoubleDouble once(s.high, s.low + t.high);
        return {once.high, once.low + t.low};
    }
    friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }
    friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
        const double p = a.high * b.high;
        return {p, std::fma(a.high, b.high, -p) + (a.high * b.low + a.low * b.high)};
    }
    friend DoubleDouble operator/(const DoubleDouble& a, const DoubleDouble& b) {
        const double q1 = a.high / b.high;
        const DoubleDouble rest = a - b * q1;
        const double q2 = rest.high / b.high;
        return DoubleDouble(q1, q2) + (rest - b * q2).high / b.high;
    }
    friend bool operator<(const DoubleDouble& a, const DoubleDouble& b) {
        return a.high < b.high || (a.high == b.high && a.low < b.low);
    }
    friend bool operator>(const DoubleDouble& a, const DoubleDouble& b) { return b < a; }
    friend bool operator==(const DoubleDouble& a, const DoubleDouble& b) {
        return a.high == b.high && a.low == b.low;
    }
    friend DoubleDouble sqrt(const DoubleDouble& a) {
        if (!(a.high > 0)) return {};
        const double root = std::sqrt(a.high);
        return {root, (a - DoubleDouble(root) * root).high / (2 * root)};
    }

private:
    static DoubleDouble two_sum(double a, double b) {
        const double s = a + b, part = s - a;
        DoubleDouble result;
        result.high = s;
        result.low = (a - (s - part)) + (b - part);
        return result;
    }
};

template <class Number>
struct Vector {
    Number x, y, z;

    Vector(const Number& x_, const Number& y_, const Number& z_) : x(x_), y(y_), z(z_) {}
    explicit Vector(const Vec3& v)
        : x(static_cast<Number>(v.x)), y(static_cast<Number>(v.y)), z(static_cast<Number>(v.z)) {}

    friend Vector operator-(const Vector& p, const Vector& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
    friend Vector operator*(const Number& s, const Vector& v) { return {s * v.x, s * v.y, s * v.z}; }
    friend Number dot(const Vector& p, const Vector& q) { return p.x * q.x + p.y * q.y + p.z * q.z; }
    friend Vector cross(const Vector& p, const Vector& q) {
        return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
    }
};

/// What a method says of a case: whether there is a hit, and where.
struct Answer {
    enum class Kind { Miss, Hit, Unknown };
    Kind kind = Kind::Miss;
    Real t = 0;
    Real radius = 0;  ///< of the interval around t, for methods that give one

    bool is_hit() const { return kind == Kind::Hit; }
};

template <class Number>
Answer hit_at(const Number& t) {
    return {Answer::Kind::Hit, static_cast<Real>(t), 0};
}

/// (−b − √(b² − 4ac)) / 2a.
template <class Number>
Answer textbook_sphere(const Sphere& sphere, const Ray& ray) {
    using std::sqrt;
    const Vector<Number> d(ray.direction);
    const Vector<Number> f = Vector<Number>(ray.origin) - Vector<Number>(sphere.center);
    const Number r = static_cast<Number>(sphere.radius), two = static_cast<Number>(2);
    const Number a = dot(d, d), b = two * dot(f, d), c = dot(f, f) - r * r;
    const Number discriminant = b * b - two * two * a * c;
    if (discriminant < Number(0)) return {};
    return hit_at((-b - sqrt(discriminant)) / (two * a));
}

/// As solutions/02_spheres: the discriminant from the perpendicular, the root without cancellation.
template <class Number>
Answer stable_sphere(const Sphere& sphere, const Ray& ray) {
    using std::sqrt;
    const Vector<Number> d(ray.direction);
    const Vector<Number> f = Vector<Number>(ray.origin) - Vector<Number>(sphere.center);
    const Number a = dot(d, d), h = dot(f, d);
    const Vector<Number> w = f - (h / a) * d;
    const Number r = static_cast<Number>(sphere.radius), r2 = r * r;
    const Number discriminant = a * (r2 - dot(w, w));
    if (discriminant < Number(0)) return {};
    const Number root = sqrt(discriminant);
    return hit_at(h < Number(0) ? (dot(f, f) - r2) / (root - h) : -(h + root) / a);
}

/// Möller & Trumbore (1997), without their constant: only a determinant of zero is parallel.
template <class Number>
Answer textbook_triangle(const Triangle& triangle, const Ray& ray) {
    const Vector<Number> a(triangle.a), d(ray.direction);
    const Vector<Number> to_b = Vector<Number>(triangle.b) - a, to_c = Vector<Number>(triangle.c) - a;
    const Vector<Number> p = cross(d, to_c);
    const Number determinant = dot(to_b, p), zero(0), one(1);
    if (determinant == zero) return {};
    const Vector<Number> from_a = Vector<Number>(ray.origin) - a;
    const Number u = dot(from_a, p) / determinant;
    if (u < zero || u > one) return {};
    const Vector<Number> q = cross(from_a, to_b);
    const Number v = dot(d, q) / determinant;
    if (v < zero || u + v > one) return {};
    return hit_at(dot(to_c, q) / determinant);
}

/// Woop, Benthin & Wald (2013) without the exact sign that solutions/03_triangles adds.
template <class Number>
Answer watertight_triangle(const Triangle& triangle, const Ray& ray) {
    const Vec3 size = abs(ray.direction);
    const int z = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int x = (z + 1) % 3, y = (z + 2) % 3;
    const auto number = [](Real value) { return static_cast<Number>(value); };
    const Number dz = number(ray.direction[z]);
    const Number sx = -number(ray.direction[x]) / dz, sy = -number(ray.direction[y]) / dz;
    const auto seen = [&](const Vec3& corner) {
        const Number pz = number(corner[z]) - number(ray.origin[z]);
        return Vector<Number>(number(corner[x]) - number(ray.origin[x]) + sx * pz,
                              number(corner[y]) - number(ray.origin[y]) + sy * pz, pz);
    };
    const Vector<Number> a = seen(triangle.a), b = seen(triangle.b), c = seen(triangle.c);
    const Number u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
    if (std::min({u, v, w}) < Number(0) && std::max({u, v, w}) > Number(0)) return {};
    const Number sum = u + v + w;
    if (sum == Number(0)) return {};
    return hit_at((u * a.z + v * b.z + w * c.z) / sum / dz);
}

}  // namespace rt::report
