// The exact judge of affine maps.
#include "tests/oracle/matrix.hpp"

#include "tests/oracle/exact.hpp"

namespace rt::oracle {
namespace {

using Vec = ExactVec3<Exact>;

Vec row(const Mat4& m, int r) { return Vec(Vec3(m[0][r], m[1][r], m[2][r])); }
Vec column(const Mat4& m, int c) { return Vec(Vec3(m[c])); }

}  // namespace

InverseTruth judge_inverse(const Mat4& m, const Mat4& proposed) {
    InverseTruth truth;
    const Vec x = column(m, 0), y = column(m, 1), z = column(m, 2);
    const Vec rows[3] = {cross(y, z), cross(z, x), cross(x, y)};
    const Exact determinant = dot(x, rows[0]);
    truth.singular = CGAL::is_zero(determinant);
    if (truth.singular) return truth;

    const Real scale = CGAL::to_double(determinant);
    for (int r = 0; r < 3; ++r) {
        const Vec& adjugate = rows[r];
        const Exact* elements[3] = {&adjugate.x, &adjugate.y, &adjugate.z};
        for (int c = 0; c < 3; ++c) {
            truth.inverse[c][r] = CGAL::to_double(*elements[c]) / scale;
            const Exact one(r == c ? 1 : 0);
            truth.right[c][r] = CGAL::to_double(dot(row(m, r), column(proposed, c)) - one);
            truth.left[c][r] = CGAL::to_double(dot(row(proposed, r), column(m, c)) - one);
        }
        truth.translation[r] = CGAL::to_double(dot(row(m, r), column(proposed, 3)) + Exact(m[3][r]));
    }
    return truth;
}

Real judge_normal(const Mat4& m, const Vec3& normal, const Vec3& tangent) {
    const Vec t(tangent);
    return CGAL::to_double(dot(Vec(normal), Vec(dot(row(m, 0), t), dot(row(m, 1), t), dot(row(m, 2), t))));
}

}  // namespace rt::oracle
