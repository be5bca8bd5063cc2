// The Sobol' sequence, scrambled.
#include "chapters/12_distribution/sobol.hpp"

#include "chapters/12_distribution/samples.hpp"
#include "common/math/mixed.hpp"
#include "common/math/todo.hpp"

namespace rt {
namespace {

/// A row of Joe & Kuo's table: a primitive polynomial of this degree, the coefficients inside of it as bits,
/// and the first direction numbers, m_k for m_k/2^k.
struct Polynomial {
    int degree;
    std::uint32_t inside;
    std::array<std::uint32_t, 6> m;
};

// From new-joe-kuo-6.21201, © 2008 Frances Y. Kuo and Stephen Joe, whose licence is at the end of LICENSE:
// dimensions 1 to 15, counted from 0.
constexpr std::array<Polynomial, sobol_dimensions - 1> polynomials{{{1, 0, {1}},
                                                                    {2, 1, {1, 3}},
                                                                    {3, 1, {1, 3, 1}},
                                                                    {3, 2, {1, 1, 1}},
                                                                    {4, 1, {1, 1, 3, 3}},
                                                                    {4, 4, {1, 3, 5, 13}},
                                                                    {5, 2, {1, 1, 5, 5, 17}},
                                                                    {5, 4, {1, 1, 5, 5, 5}},
                                                                    {5, 7, {1, 1, 7, 11, 19}},
                                                                    {5, 11, {1, 1, 5, 1, 1}},
                                                                    {5, 13, {1, 1, 1, 3, 11}},
                                                                    {5, 14, {1, 3, 5, 5, 31}},
                                                                    {6, 1, {1, 3, 3, 9, 7, 49}},
                                                                    {6, 13, {1, 1, 1, 15, 21, 21}},
                                                                    {6, 16, {1, 3, 1, 13, 27, 49}}}};

using Directions = std::array<std::uint32_t, 32>;

/// Of each dimension. Dimension 0 has the bits of the index in reverse; the others follow from their first
/// numbers by the recurrence of their polynomial.
constexpr std::array<Directions, sobol_dimensions> make_directions() {
    std::array<Directions, sobol_dimensions> all{};
    for (std::size_t k = 0; k < 32; ++k) all[0][k] = 0x80000000u >> k;
    for (std::size_t dimension = 1; dimension < sobol_dimensions; ++dimension) {
        const Polynomial& p = polynomials[dimension - 1];
        const auto degree = static_cast<std::size_t>(p.degree);
        Directions& v = all[dimension];
        for (std::size_t k = 0; k < degree; ++k) v[k] = p.m[k] << (31 - k);
        for (std::size_t k = degree; k < 32; ++k) {
            v[k] = v[k - degree] ^ v[k - degree] >> degree;
            for (std::size_t j = 1; j < degree; ++j)
                if (p.inside >> (degree - 1 - j) & 1) v[k] ^= v[k - j];
        }
    }
    return all;
}

constexpr std::array<Directions, sobol_dimensions> directions = make_directions();

}  // namespace

std::array<std::uint32_t, 32> sobol_directions(std::uint32_t dimension) { return directions[dimension]; }

std::uint32_t sobol_bits(std::uint32_t index, std::uint32_t dimension) {
    // 12.3  Combine the direction numbers of the bits that are 1 in `index`.
    return todo("12.3");
}

std::uint32_t owen_scrambled(std::uint32_t bits, std::uint64_t key) {
    // 12.4  Flip each bit, or leave it, as the key's coin for the bits above it says.
    return todo("12.4");
}

Vec2 sobol_point(std::uint32_t index, std::uint64_t key) {
    // 12.5  The point of the shuffled sequence, with each coordinate scrambled by coins of its own.
    return todo("12.5");
}

std::uint32_t pixel_start(std::uint32_t x, std::uint32_t y, std::uint32_t count, std::uint64_t key) {
    // 12.5  The first index of the pixel, in a Z-order whose quarters are in an order of their own
    // in each square.
    return todo("12.5");
}

}  // namespace rt
