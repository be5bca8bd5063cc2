// Affine maps: matrices, their stack, their inverse, and what they do to points, vectors, normals and rays.
#include "chapters/04_transforms/transform.hpp"

#include "common/math/error.hpp"

#include <algorithm>
#include <cmath>

namespace rt {

Mat4 translation(const Vec3& by) {
    // [exercise 04.1] Start from the identity, Mat4(1). GLM's matrices are written column by column:
    // m[3] is the last column, where a translation stands.
    Mat4 m(1);
    m[3] = Vec4(by, 1);
    return m;
    // [/exercise]
}

Mat4 scaling(const Vec3& by) {
    // [exercise 04.1] The factors stand on the diagonal: m[0][0], m[1][1], m[2][2].
    Mat4 m(1);
    m[0][0] = by.x;
    m[1][1] = by.y;
    m[2][2] = by.z;
    return m;
    // [/exercise]
}

Mat4 rotation(const Vec3& axis, Real angle) {
    // [exercise 04.2] Rodrigues: with the unit axis k, c = cos(angle) and s = sin(angle), the matrix is
    // c·I + (1 − c)·k·kᵀ + s·[k]×, where [k]× is the matrix with [k]× v = k × v. The axis may be tiny or
    // huge: divide by its greatest coordinate before you make it a unit vector.
    const Vec3 size = glm::abs(axis);
    const Vec3 k = normalize(axis / std::max({size.x, size.y, size.z}));
    const Real c = std::cos(angle), s = std::sin(angle);
    Mat4 m(1);
    m[0] = Vec4(c + (1 - c) * k.x * k.x, (1 - c) * k.y * k.x + s * k.z, (1 - c) * k.z * k.x - s * k.y, 0);
    m[1] = Vec4((1 - c) * k.x * k.y - s * k.z, c + (1 - c) * k.y * k.y, (1 - c) * k.z * k.y + s * k.x, 0);
    m[2] = Vec4((1 - c) * k.x * k.z + s * k.y, (1 - c) * k.y * k.z - s * k.x, c + (1 - c) * k.z * k.z, 0);
    return m;
    // [/exercise]
}

Mat4 matrix(const TransformStep& step) {
    if (const auto* translate = std::get_if<Translate>(&step)) return translation(translate->by);
    if (const auto* rotate = std::get_if<Rotate>(&step)) return rotation(rotate->axis, rotate->angle);
    return scaling(std::get<Scale>(step).by);
}

std::vector<Mat4> compose(std::span<const TransformNode> nodes) {
    // [exercise 04.3] For each node in order: its matrix is that of its parent (the identity where parent
    // is −1) times matrix(node.step). Parents come first, so theirs is there already.
    std::vector<Mat4> matrices;
    matrices.reserve(nodes.size());
    for (const TransformNode& node : nodes) {
        const Mat4 parent = node.parent < 0 ? Mat4(1) : matrices[static_cast<std::size_t>(node.parent)];
        matrices.push_back(parent * matrix(node.step));
    }
    return matrices;
    // [/exercise]
}

std::optional<Mat4> inverse(const Mat4& m) {
    // [exercise 04.4] Gauss–Jordan elimination on the linear part (the upper left 3×3), applied to the
    // identity at the same time. Before you start, divide each row by its greatest |element|, and choose
    // as pivot the greatest |element| left in the column. No pivot means singular: return nothing. The
    // translation of the inverse is −L⁻¹·t. Return nothing as well if any number is not finite.
    Real a[3][6];
    for (int r = 0; r < 3; ++r) {
        Real greatest = 0;
        for (int c = 0; c < 3; ++c) greatest = std::max(greatest, std::abs(m[c][r]));
        if (!(greatest > 0) || !std::isfinite(greatest)) return std::nullopt;
        for (int c = 0; c < 3; ++c) {
            a[r][c] = m[c][r] / greatest;
            a[r][3 + c] = r == c ? 1 / greatest : 0;
        }
    }
    for (int column = 0; column < 3; ++column) {
        int pivot = column;
        for (int r = column + 1; r < 3; ++r)
            if (std::abs(a[r][column]) > std::abs(a[pivot][column])) pivot = r;
        std::swap(a[column], a[pivot]);
        const Real divisor = a[column][column];
        // What elimination leaves of a singular matrix is rounding error, a few units in the last place
        // of rows that were scaled to 1.
        if (!(std::abs(divisor) > gamma(8))) return std::nullopt;
        for (Real& x : a[column]) x /= divisor;
        for (int r = 0; r < 3; ++r) {
            if (r == column) continue;
            const Real factor = a[r][column];
            for (int c = 0; c < 6; ++c) a[r][c] -= factor * a[column][c];
        }
    }
    Mat4 result(1);
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) result[c][r] = a[r][3 + c];
        result[3][r] = -(a[r][3] * m[3][0] + a[r][4] * m[3][1] + a[r][5] * m[3][2]);
        for (int c = 0; c < 4; ++c)
            if (!std::isfinite(result[c][r])) return std::nullopt;
    }
    return result;
    // [/exercise]
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
    // [exercise 04.5] The transpose of the inverse's linear part, times n: each coordinate is the dot
    // product of one column of `inverse` with n.
    return Vec3(dot(Vec3(inverse[0]), n), dot(Vec3(inverse[1]), n), dot(Vec3(inverse[2]), n));
    // [/exercise]
}

Ray to_local(const Transform& transform, const Ray& ray) {
    // [exercise 04.5] Origin as a point, direction as a vector, both by the inverse; time stays. Do not
    // make the direction a unit vector: then t is the same number in both spaces.
    return {transform_point(transform.to_local, ray.origin), transform_vector(transform.to_local, ray.direction),
            ray.time};
    // [/exercise]
}

Surface to_world(const Transform& transform, const Surface& local) {
    const Mat4& m = transform.to_world;
    const auto magnitude = [](const Mat4& a, const Vec3& p) {
        return glm::abs(Vec3(a[0])) * p.x + glm::abs(Vec3(a[1])) * p.y + glm::abs(Vec3(a[2])) * p.z;
    };
    Surface world = local;
    world.point = transform_point(m, local.point);
    // Chapter 6 derives this bound: the local error enlarged by M, the rounding of M·p, and that of the
    // way back, which the next ray that starts here will take through the inverse.
    const Vec3 back = gamma(4) * (magnitude(transform.to_local, glm::abs(world.point)) + glm::abs(Vec3(transform.to_local[3])));
    world.error = (1 + gamma(3)) * magnitude(m, local.error + back) +
                  gamma(4) * (magnitude(m, glm::abs(local.point)) + glm::abs(Vec3(m[3])));
    world.normal = normalize(transform_normal(transform.to_local, local.normal));
    world.shading_normal = normalize(transform_normal(transform.to_local, local.shading_normal));
    return world;
}

}  // namespace rt
