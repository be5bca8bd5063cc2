// Surfaces that end at their box, and so enclose nothing.
#include "common/scene/cut_open.hpp"

#include "common/scene/evaluate.hpp"

#include <array>
#include <cstddef>
#include <vector>

namespace rt {
namespace {

constexpr std::size_t most_pieces = 1024;

struct Halves {
    Enclosure low, high;
};
Halves halves_of(const Enclosure& a) {
    const Real middle = a.low + (a.high - a.low) / 2;
    return {{a.low, middle}, {middle, a.high}};
}

/// f is of enclosures of x, y and z. The pieces of a face are looked at from large to small.
template <class F>
std::optional<Vec3> cut_open(const Box& box, const F& f) {
    const Real beyond = 0x1p-40 * size_of(box.high - box.low);
    for (int face = 0; face < 6; ++face) {
        const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
        const Real place = face % 2 == 1 ? box.high[axis] : box.low[axis];
        const Enclosure across =
            face % 2 == 1 ? Enclosure{place, place + beyond} : Enclosure{place - beyond, place};
        const auto value = [&](const Enclosure& at_u, const Enclosure& at_v) {
            std::array<Enclosure, 3> p{across, across, across};
            p[static_cast<std::size_t>(u)] = at_u, p[static_cast<std::size_t>(v)] = at_v;
            return f(p[0], p[1], p[2]);
        };
        struct Piece {
            Enclosure u, v;
        };
        std::vector<Piece> pieces{{{box.low[u], box.high[u]}, {box.low[v], box.high[v]}}};
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const Piece piece = pieces[i];
            const Enclosure all = value(piece.u, piece.v);
            if (is_empty(all) || all.low > 0) continue;
            const Halves by_u = halves_of(piece.u), by_v = halves_of(piece.v);
            const Real middle_u = by_u.low.high, middle_v = by_v.low.high;
            if (sign_of(value({middle_u, middle_u}, {middle_v, middle_v})) < 0) {
                Vec3 point(place);
                point[u] = middle_u, point[v] = middle_v;
                return point;
            }
            if (pieces.size() + 4 > most_pieces) continue;
            for (const Enclosure& half_u : {by_u.low, by_u.high})
                for (const Enclosure& half_v : {by_v.low, by_v.high}) pieces.push_back({half_u, half_v});
        }
    }
    return std::nullopt;
}

template <class Shape>
std::optional<Vec3> opening(const Shape&) {
    return std::nullopt;
}
std::optional<Vec3> opening(const Implicit& implicit) {
    return cut_open(implicit.box, [&](const Enclosure& x, const Enclosure& y, const Enclosure& z) {
        return evaluate(*implicit.f, x, y, z);
    });
}
std::optional<Vec3> opening(const Quadric& q) {
    return cut_open(q.box, [&](const Enclosure& x, const Enclosure& y, const Enclosure& z) {
        return q.squares.x * power(x, 2) + q.squares.y * power(y, 2) + q.squares.z * power(z, 2) +
               q.mixed.x * (x * y) + q.mixed.y * (x * z) + q.mixed.z * (y * z) + q.linear.x * x +
               q.linear.y * y + q.linear.z * z + Enclosure{q.constant, q.constant};
    });
}

}  // namespace

std::optional<Vec3> cut_open(const FileShape& shape) {
    return std::visit([](const auto& one) { return opening(one); }, shape);
}

}  // namespace rt
