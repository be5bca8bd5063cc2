// Affine maps: matrices, their stack, their inverse, and what they do to points, vectors, normals and rays.
#include "chapters/04_transforms/transform.hpp"

#include "chapters/03_triangles/triangle.hpp"
#include "common/math/error.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Mat4 translation(const Vec3& by) {
    // [exercise 04.1] The matrix that moves points by `by` and leaves directions alone.
    Mat4 m(1);
    m[3] = Vec4(by, 1);
    return m;
    // [/exercise]
}

Mat4 scaling(const Vec3& by) {
    // [exercise 04.1] The matrix that multiplies each coordinate by its factor.
    Mat4 m(1);
    m[0][0] = by.x;
    m[1][1] = by.y;
    m[2][2] = by.z;
    return m;
    // [/exercise]
}

Mat4 rotation(const Vec3& axis, Real angle) {
    // [exercise 04.2] The rotation by `angle` radians, by the formula of Rodrigues. The axis may be tiny or
    // huge.
    const Vec3 k = unit_vector(axis);
    const Real c = std::cos(angle), s = std::sin(angle);
    Mat4 m(1);
    for (int i = 0; i < 3; ++i) {
        Vec3 e(0);
        e[i] = 1;
        m[i] = Vec4(c * e + (1 - c) * (k[i] * k) + s * cross(k, e), 0);
    }
    return m;
    // [/exercise]
}

Mat4 matrix(const TransformStep& step) {
    if (const auto* translate = std::get_if<Translate>(&step)) return translation(translate->by);
    if (const auto* rotate = std::get_if<Rotate>(&step)) return rotation(rotate->axis, rotate->angle);
    return scaling(std::get<Scale>(step).by);
}

std::vector<Mat4> compose(std::span<const TransformNode> nodes) {
    // [exercise 04.3] The matrix of each node, in their order. Where `parent` is −1 there is none;
    // matrix(node.step) is that of a node's own step.
    std::vector<Mat4> matrices;
    matrices.reserve(nodes.size());
    for (const TransformNode& node : nodes) {
        const Mat4 parent = node.parent < 0 ? Mat4(1) : matrices[static_cast<std::size_t>(node.parent)];
        matrices.push_back(parent * matrix(node.step));
    }
    return matrices;
    // [/exercise]
}

namespace {

/// The element of E = I − M·X in the given row and column of the linear parts, computed with twice the digits
/// (Ogita, Rump & Oishi 2005): what is left of 1 − 1 is not rounding error.
Real missing(const Mat4& m, const Mat4& x, int row, int column) {
    Real sum = row == column ? 1 : 0, lost = 0;
    for (int k = 0; k < 3; ++k) {
        const Real product = -m[k][row] * x[column][k];
        const Real next = sum + product, added = next - sum;
        lost += std::fma(-m[k][row], x[column][k], -product) + ((product - added) + (sum - (next - added)));
        sum = next;
    }
    return sum + lost;
}

/// The inverse of `m` from a rough one, linear parts only, or nothing if `rough` is not rough but wrong.
/// Newton's step X + X·E squares what is missing (Schulz 1933), so six of them make the last bits right. That
/// ‖E‖ is less than 1 in the end proves that M is not singular.
std::optional<Mat4> refined(const Mat4& m, const Mat4& rough) {
    Mat4 x = rough;
    for (int step = 0; step < 6; ++step) {
        Mat3 rest;
        for (int c = 0; c < 3; ++c)
            for (int r = 0; r < 3; ++r) rest[c][r] = missing(m, x, r, c);
        const Mat3 more = Mat3(x) * rest;
        for (int c = 0; c < 3; ++c) x[c] += Vec4(more[c], 0);
    }
    for (int r = 0; r < 3; ++r) {
        Real row_sum = 0;
        for (int c = 0; c < 3; ++c) row_sum += std::abs(missing(m, x, r, c));
        // A NaN fails this too.
        if (!(row_sum < 0.5)) return std::nullopt;
    }
    return x;
}

}  // namespace

std::optional<Mat4> inverse(const Mat4& m) {
    // Rows are scaled by powers of two, which rounds nothing, so that the greatest element of each is in [1,
    // 2): then a matrix of millimetres is as good as one of light years.
    Mat4 scaled(1);
    Vec3 factor(1);
    for (int r = 0; r < 3; ++r) {
        const Real greatest = size_of({m[0][r], m[1][r], m[2][r]});
        if (!(greatest > 0) || !std::isfinite(greatest)) return std::nullopt;
        factor[r] = std::ldexp(Real(1), -std::ilogb(greatest));
        for (int c = 0; c < 3; ++c) scaled[c][r] = m[c][r] * factor[r];
    }

    Mat4 rough(1);
    // [exercise 04.4] Put the inverse of the upper left 3×3 of `scaled` into that of `rough`, by Gauss–Jordan
    // elimination. The pivot of a column is the greatest |element| that is left in it; where that is 0 the
    // matrix is singular: return nothing.
    Real a[3][6] = {};
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) a[r][c] = scaled[c][r];
        a[r][3 + r] = 1;
    }
    for (int column = 0; column < 3; ++column) {
        int pivot = column;
        for (int r = column + 1; r < 3; ++r)
            if (std::abs(a[r][column]) > std::abs(a[pivot][column])) pivot = r;
        std::swap(a[column], a[pivot]);
        const Real divisor = a[column][column];
        if (divisor == 0) return std::nullopt;
        for (Real& x : a[column]) x /= divisor;
        for (int r = 0; r < 3; ++r) {
            if (r == column) continue;
            const Real times = a[r][column];
            for (int c = 0; c < 6; ++c) a[r][c] -= times * a[column][c];
        }
    }
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) rough[c][r] = a[r][3 + c];
    // [/exercise]

    const std::optional<Mat4> fine = refined(scaled, rough);
    if (!fine) return std::nullopt;
    Mat4 result(1);
    // [exercise 04.4] `fine` is the inverse of `scaled`, right to the last bits. Make it the inverse of `m`:
    // undo the factors of the rows, then add the translation that undoes that of `m`.
    for (int c = 0; c < 3; ++c) result[c] = (*fine)[c] * factor[c];
    result[3] = Vec4(-(Mat3(result) * Vec3(m[3])), 1);
    // [/exercise]
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 3; ++r)
            if (!std::isfinite(result[c][r])) return std::nullopt;
    return result;
}

Vec3 transform_point(const Mat4& m, const Vec3& p) {
    // [exercise 04.5] M·(p, 1), without its fourth coordinate.
    return Vec3(m[0]) * p.x + Vec3(m[1]) * p.y + Vec3(m[2]) * p.z + Vec3(m[3]);
    // [/exercise]
}

Vec3 transform_vector(const Mat4& m, const Vec3& v) {
    // [exercise 04.5] M·(v, 0): the translation does not act.
    return Vec3(m[0]) * v.x + Vec3(m[1]) * v.y + Vec3(m[2]) * v.z;
    // [/exercise]
}

Vec3 transform_normal(const Mat4& inverse, const Vec3& n) {
    // [exercise 04.5] The transpose of the inverse's linear part, times n.
    return Vec3(dot(Vec3(inverse[0]), n), dot(Vec3(inverse[1]), n), dot(Vec3(inverse[2]), n));
    // [/exercise]
}

Ray to_local(const Transform& transform, const Ray& ray) {
    // [exercise 04.5] The ray in local space, at the same time; t must mean the same point in both spaces.
    return {transform_point(transform.to_local, ray.origin),
            transform_vector(transform.to_local, ray.direction), ray.time};
    // [/exercise]
}

std::optional<Mat4> nearest_rotation(const Mat4& m) {
    // [exercise 04.7] The rotation that is left of the linear part when its stretch is taken away. The
    // translation stays. Nothing where there is no inverse.
    Mat3 x(m);
    for (int step = 0; step < 60; ++step) {
        const std::optional<Mat4> undone = inverse(Mat4(x));
        if (!undone) return std::nullopt;
        x = 0.5 * (x + glm::transpose(Mat3(*undone)));
    }
    Mat4 result(x);
    result[3] = m[3];
    return result;
    // [/exercise]
}

Surface to_world(const Transform& transform, const Surface& local) {
    const Mat4& m = transform.to_world;
    const Mat4& back = transform.to_local;
    // Σ |a|·p, what the rounding of a·p is measured by.
    const auto magnitude = [](const Mat4& a, const Vec3& p) {
        return abs(Vec3(a[0])) * p.x + abs(Vec3(a[1])) * p.y + abs(Vec3(a[2])) * p.z;
    };
    Surface world = local;
    world.point = transform_point(m, local.point);
    world.normal = unit_vector(transform_normal(back, local.normal));
    world.shading_normal = unit_vector(transform_normal(back, local.shading_normal));
    // Given; chapter 6 needs it. A ray that starts here goes back through the inverse. Where does it arrive?
    // Beside the local point by what can be seen now, and by the rounding of this way back and of that one,
    // gamma(4) each.
    const Vec3 way_back = abs(transform_point(back, world.point) - local.point) +
                          gamma(8) * (magnitude(back, abs(world.point)) + abs(Vec3(back[3])));
    // All that is wrong locally is wrong in the world by |M| as much; the way here was rounded too.
    world.error = (1 + gamma(4)) * magnitude(m, local.error + way_back) +
                  gamma(4) * (magnitude(m, abs(local.point)) + abs(Vec3(m[3])));
    return world;
}

}  // namespace rt
