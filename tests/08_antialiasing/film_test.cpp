// Steps 08.6 to 08.8: filters, and sums that keep what rounding takes away.
#include "chapters/08_antialiasing/film.hpp"

#include "common/math/error.hpp"
#include "tests/catch.hpp"
#include "tests/support.hpp"

#include <algorithm>
#include <cmath>

using namespace rt;
using rt::test::cases;
using rt::test::near;

namespace {

constexpr Real u = unit_roundoff;

const Filter box{FilterKind::Box, 0.5}, tent{FilterKind::Tent, 1}, gaussian{FilterKind::Gaussian, 1.5},
    mitchell{FilterKind::Mitchell, 2};
const Filter all_filters[] = {box, tent, gaussian, mitchell};

std::string name_of(const Filter& filter) {
    const char* const names[] = {"box", "tent", "Gaussian filter", "Mitchell filter"};
    return names[static_cast<std::size_t>(filter.kind)];
}

/// One factor of a separable filter: the weight at (x, 0) without the factor of y = 0.
Real factor(const Filter& filter, Real x) {
    return filter_weight(filter, {x, 0}) / std::sqrt(filter_weight(filter, {0, 0}));
}

bool same(const FilmPixel& a, const FilmPixel& b) {
    return a.sum == b.sum && a.lost == b.lost && a.weight == b.weight && a.lost_weight == b.lost_weight;
}

/// The cubic of the paper, from its formula (8), for any B and C: zero from |x| = 2 on.
Real cubic(Real x, Real B, Real C) {
    x = std::abs(x);
    const Real x2 = x * x, x3 = x * x * x;
    if (x < 1) return ((12 - 9 * B - 6 * C) * x3 + (-18 + 12 * B + 6 * C) * x2 + (6 - 2 * B)) / 6;
    if (x < 2)
        return ((-B - 6 * C) * x3 + (6 * B + 30 * C) * x2 + (-12 * B - 48 * C) * x + (8 * B + 24 * C)) / 6;
    return 0;
}

/// Random samples all over and around a picture, some of them on edges and in the middles of pixels.
std::vector<FilmSample> random_film_samples(test::Random& random, int count) {
    std::vector<FilmSample> samples;
    for (int i = 0; i < count; ++i) {
        Vec2 at(random.uniform(-2, 9), random.uniform(-2, 8));
        if (random.index(4) == 0) at.x = std::floor(2 * at.x) / 2;
        if (random.index(4) == 0) at.y = std::floor(2 * at.y) / 2;
        samples.push_back({at, random.in_cube(), random.uniform(0, 1)});
    }
    return samples;
}

/// n × n samples in the middles of the cells of each pixel of a picture.
std::vector<FilmSample> even_samples(int width, int height, int n, const Vec3& color) {
    std::vector<FilmSample> samples;
    for (int y = 0; y < height * n; ++y) {
        for (int x = 0; x < width * n; ++x)
            samples.push_back({(Vec2(x, y) + Vec2(0.5)) / Real(n), color, Real(1) / (n * n)});
    }
    return samples;
}

void check_weight(const Filter& filter, const Vec2& offset, Real expected, Real bound = 0) {
    INFO("the " << name_of(filter) << " of radius " << filter.radius << " at " << offset
                << " from the pixel's centre");
    CHECK(near(filter_weight(filter, offset), expected, bound));
}

bool in(const Tile& tile, int x, int y) { return tile.x0 <= x && x < tile.x1 && tile.y0 <= y && y < tile.y1; }

std::string in_words(const Tile& tile) {
    return "columns from " + std::to_string(tile.x0) + " to before " + std::to_string(tile.x1) +
           ", rows from " + std::to_string(tile.y0) + " to before " + std::to_string(tile.y1);
}

void check_reached(const Vec2& at, const Filter& filter, const Tile& area, const Tile& expected) {
    const Tile reached = pixels_reached(at, filter, area);
    INFO("which pixels a sample at " << at << " reaches under the " << name_of(filter) << " of radius "
                                     << filter.radius << "; of the area of " << in_words(area));
    const bool same = reached.x0 == expected.x0 && reached.y0 == expected.y0 && reached.x1 == expected.x1 &&
                      reached.y1 == expected.y1;
    CHECK(test::or_say(same, in_words(reached) + "\nexpected " + in_words(expected)));
}

void check_color(const FilmPixel& pixel, const Vec3& expected, const char* samples) {
    INFO(samples << "\nthe colour of the film's pixel: " << pixel);
    CHECK(test::near_color(color_of(pixel), expected, 0));
}

}  // namespace

// 08.6 ---------------------------------------------------------------------------------------------------

TEST_CASE("the box counts alike all that lie within it", "[08.6]") {
    check_weight(box, {0, 0}, 1);
    check_weight(box, {0.25, -0.4}, 1);
    check_weight(box, {0.5, -0.5}, 1);
    check_weight(box, {0.5000001, 0}, 0);
    check_weight(box, {0, -0.5000001}, 0);
    check_weight({FilterKind::Box, 3}, {2.5, 2}, 1);
}

TEST_CASE("the tent falls evenly to its end", "[08.6]") {
    check_weight(tent, {0, 0}, 1);
    check_weight(tent, {0.5, 0}, 0.5);
    check_weight(tent, {0, -0.75}, 0.25);
    check_weight(tent, {0.5, 0.5}, 0.25);
    check_weight(tent, {1, 0}, 0);
    check_weight({FilterKind::Tent, 2}, {1, 0}, 0.5);
}

TEST_CASE("the Gaussian is a bell that reaches 0 at its end", "[08.6]") {
    // e^-4.5 = 0.0111090 and e^-0.5 = 0.6065307; σ is a third of the radius.
    const Real top = 0.9888910034617577, at_s = 0.5954216631743912;
    check_weight(gaussian, {0, 0}, top * top, 8 * u);
    check_weight(gaussian, {0.5, 0}, at_s * top, 8 * u);
    check_weight(gaussian, {-0.5, 0.5}, at_s * at_s, 8 * u);
    check_weight({FilterKind::Gaussian, 6}, {2, 0}, at_s * top, 8 * u);
    check_weight(gaussian, {1.5, 0}, 0, 8 * u);
}

TEST_CASE("Mitchell's filter is 8/9 at its top and 1/18 halfway, then negative", "[08.6]") {
    const Real top = 8. / 9;
    check_weight(mitchell, {0, 0}, top * top, 4 * u);
    check_weight(mitchell, {1, 0}, top / 18, 4 * u);
    check_weight(mitchell, {-1, 1}, 1. / 18 / 18, 4 * u);
    // (2 − 3/2)² · (8 − 21/2)/18 = −5/144.
    check_weight(mitchell, {0, 1.5}, -top * 5 / 144, 4 * u);
    check_weight(mitchell, {2, 0}, 0, 4 * u);
    check_weight({FilterKind::Mitchell, 1}, {0, 0.75}, -top * 5 / 144, 4 * u);
}

TEST_CASE("Mitchell's filter is the paper's cubic with B = C = 1/3", "[08.6]") {
    test::Random random(851);
    for (int i = 0; i < cases(2000); ++i) {
        const Real radius = random.uniform(0.5, 4);
        const Vec2 offset(random.uniform(-1.2, 1.2) * radius, random.uniform(-1.2, 1.2) * radius);
        const Real expected =
            cubic(2 * offset.x / radius, 1. / 3, 1. / 3) * cubic(2 * offset.y / radius, 1. / 3, 1. / 3);
        const Real actual = filter_weight({FilterKind::Mitchell, radius}, offset);
        INFO("Mitchell's filter of radius " << radius << " at " << offset << " from the pixel's centre");
        // Terms of the paper's form reach 20/3 · 2 and cancel to 0; a few roundings of each.
        REQUIRE(near(actual, expected, 64 * u));
    }
}

TEST_CASE("filters are symmetric, products of what they do along each axis, and 0 outside", "[08.6]") {
    test::Random random(852);
    for (int i = 0; i < cases(2000); ++i) {
        const std::size_t kind = random.index(4);
        const Filter filter{all_filters[kind].kind, random.uniform(0.5, 4)};
        const Vec2 offset(random.uniform(-1.5, 1.5) * filter.radius,
                          random.uniform(-1.5, 1.5) * filter.radius);
        const Real weight = filter_weight(filter, offset);
        INFO("the " << name_of(filter) << " of radius " << filter.radius << " weighs " << weight << " at "
                    << offset);
        const bool outside = std::max(std::abs(offset.x), std::abs(offset.y)) > filter.radius;
        const bool symmetric = weight == filter_weight(filter, {-offset.x, offset.y}) &&
                               weight == filter_weight(filter, {offset.x, -offset.y}) &&
                               weight == filter_weight(filter, {offset.y, offset.x});
        REQUIRE(test::or_say(symmetric, "mirrored, or with x and y exchanged, it weighs something else"));
        INFO("expected 0 outside of the radius, else the product of what it does along x and along y");
        REQUIRE(near(weight, outside ? 0 : factor(filter, offset.x) * factor(filter, offset.y),
                     outside ? 0 : 16 * u));
    }
}

TEST_CASE("filters other than the box have no steps, not even at their ends", "[08.6]") {
    for (const Filter& filter : {tent, gaussian, mitchell}) {
        INFO("the " << name_of(filter) << ": the step between places a thousandth of the radius apart");
        const Real h = filter.radius / 1000;
        for (int i = -1100; i <= 1100; ++i) {
            const Real step = filter_weight(filter, {(i + 1) * h, 0.1}) - filter_weight(filter, {i * h, 0.1});
            // None is steeper than 2/radius: the Gaussian 1.82, Mitchell's cubic 1.28.
            if (!(std::abs(step) <= 2 * h / filter.radius)) REQUIRE(std::abs(step) <= 2 * h / filter.radius);
        }
    }
}

TEST_CASE("tents and Mitchell's filters of neighbouring pixels share each sample out completely", "[08.6]") {
    test::Random random(853);
    for (int i = 0; i < cases(1000); ++i) {
        const Vec2 at(random.uniform(0, 1), random.uniform(0, 1));
        Real of_tents = 0, of_mitchells = 0, least = 0;
        for (int y = -3; y <= 3; ++y) {
            for (int x = -3; x <= 3; ++x) {
                of_tents += filter_weight(tent, at + Vec2(x, y));
                of_mitchells += filter_weight(mitchell, at + Vec2(x, y));
                least = std::min(least, filter_weight(mitchell, at + Vec2(x, y)));
            }
        }
        INFO("a sample at "
             << at
             << ": the sum of its weights in all pixels around, by tents and by Mitchell's filter, and "
                "Mitchell's least weight");
        // 16 weights that are not 0, each below 1 and with about four roundings.
        REQUIRE(near(of_tents, 1, 64 * u));
        REQUIRE(near(of_mitchells, 1, 64 * u));
        REQUIRE(least < 0);
    }
}

// 08.7 ---------------------------------------------------------------------------------------------------

TEST_CASE("a film pixel's colour is the weighted mean, and black before the first sample", "[08.7]") {
    check_color(FilmPixel{}, Vec3(0), "no samples");
    FilmPixel pixel = add(FilmPixel{}, {1, 0, 4}, 1);
    check_color(pixel, {1, 0, 4}, "(1, 0, 4), weight 1");
    pixel = add(pixel, {0, 2, 0}, 3);
    {
        INFO("the sum of the weights 1 and 3");
        CHECK(pixel.weight == 4);
    }
    check_color(pixel, {0.25, 1.5, 1}, "(1, 0, 4), weight 1, and (0, 2, 0), weight 3");
    check_color(add(FilmPixel{}, {1, 2, 3}, 0), Vec3(0), "(1, 2, 3), weight 0");
}

TEST_CASE("what is small beside the sum is not lost, and neither is what is great", "[08.7]") {
    FilmPixel pixel;
    for (const Real term : {1e16, 1., 1., -1e16}) pixel = add(pixel, Vec3(term), 1);
    check_color(pixel, Vec3(0.5), "1e16, 1, 1 and -1e16 in each channel, weight 1 each");
    // Here each term is greater than the sum that it is added to, until the last takes it away.
    pixel = FilmPixel{};
    for (const Real term : {1., 1e16, 1., -1e16}) pixel = add(pixel, Vec3(1, term, -term), 0.5);
    check_color(pixel, {1, 0.5, -0.5}, "(1, x, -x) with x = 1, 1e16, 1 and -1e16, weight 0.5 each");
}

TEST_CASE("a million samples are summed up as well as one", "[08.7]") {
    const int n = cases(1'000'000);
    FilmPixel pixel;
    Real naive = 0;
    for (int i = 0; i < n; ++i) {
        pixel = add(pixel, {0.1, 0.7, 1}, 0.3);
        naive += 0.3 * 0.1;
    }
    // 0.3 · 0.1 is rounded once, and the same each time. Then the sum is rounded a few times in all, not n.
    const Real bound = 4 * u;
    const Vec3 color = color_of(pixel);
    INFO(
        n << " samples of colour (0.1, 0.7, 1) and weight 0.3: red, green, blue, and the sum of the weights");
    CHECK(near(color.x, 0.1, bound * 0.1));
    CHECK(near(color.y, 0.7, bound * 0.7));
    CHECK(near(color.z, 1, bound));
    CHECK(near(pixel.weight + pixel.lost_weight, 0.3 * n, bound * 0.3 * n));
    // Sums without compensation fail this test, by far.
    CHECK(!near(naive / (0.3 * n), 0.1, 1000 * bound * 0.1));
}

TEST_CASE("merged sums are as good as one", "[08.7]") {
    FilmPixel a, b, whole;
    for (const Real term : {1e16, 1., 3., 1e-3}) {
        a = add(a, Vec3(term, 1, 0), 1);
        whole = add(whole, Vec3(term, 1, 0), 1);
    }
    for (const Real term : {5., -1e16, 1., 1e-3}) {
        b = add(b, Vec3(term, 0, 1), 2);
        whole = add(whole, Vec3(term, 0, 1), 2);
    }
    // (1e16 + 4.001) + 2 (6.001 − 1e16) = 16.003 − 1e16; then with 1e16 more.
    INFO("four samples of weight 1 in film a, four of weight 2 in film b: a with b, b with a, all in one");
    for (const FilmPixel& both : {merge(a, b), merge(b, a), whole}) {
        CHECK(both.weight == 12);
        const FilmPixel rest = add(both, Vec3(1e16, 0, 0), 1);
        CHECK(near(color_of(rest) * 13., Vec3(16.003, 4, 8), 1e-14 * 16));
    }
    // Neither is weight lost: here the 1 of each film beside its 1e16.
    const FilmPixel heavy = add(add(FilmPixel{}, Vec3(0), 1e16), Vec3(0), 1), both = merge(heavy, heavy);
    CHECK((both.weight - 2e16) + both.lost_weight == 2);
}

// 08.8 ---------------------------------------------------------------------------------------------------

TEST_CASE("a sample at (2.25, 1.5) reaches the columns 1 and 2 under a tent", "[08.8]") {
    const Vec2 at(2.25, 1.5);
    // Columns 1 and 2, whose centres are 0.75 and 0.25 away. The rows 0 and 2 are just as far as the tent
    // reaches.
    check_reached(at, tent, {0, 0, 4, 3}, {1, 0, 3, 3});
    check_reached(at, tent, {0, 1, 2, 2}, {1, 1, 2, 2});
    check_reached(at, tent, {2, 1, 4, 3}, {2, 1, 3, 3});
    // A box of a pixel's size reaches one pixel, and where samples lie just between pixels, both.
    check_reached({2.25, 1.375}, box, {0, 0, 4, 3}, {2, 1, 3, 2});
    check_reached({2, 1}, box, {0, 0, 4, 3}, {1, 0, 3, 2});
    check_reached({2.25, 1.375}, mitchell, {0, 0, 9, 9}, {0, 0, 4, 3});
    check_reached({5.625, 5.25}, gaussian, {0, 0, 9, 9}, {4, 4, 7, 7});
}

TEST_CASE("a sample that is far from the area reaches none of its pixels", "[08.8]") {
    const Tile area{2, 3, 6, 5};
    for (const Vec2& at : {Vec2(0.25, 4), Vec2(7.75, 4), Vec2(4, 1.25), Vec2(4, 6.75), Vec2(-1e30, 4)}) {
        const Tile reached = pixels_reached(at, tent, area);
        INFO("a sample at "
             << at << " under a tent of radius 1, of an area from column 2 up to column 5 and from row "
             << "3 up to row 4: " << in_words(reached));
        CHECK(test::or_say(reached.x0 >= reached.x1 || reached.y0 >= reached.y1, "it reaches some pixels"));
    }
}

TEST_CASE("the pixels that a sample reaches are those whose centres are near enough", "[08.8]") {
    test::Random random(863);
    for (int i = 0; i < cases(500); ++i) {
        const Filter filter{FilterKind::Tent, random.uniform(0.3, 3)};
        const Vec2 at(random.uniform(-3, 12), random.uniform(-3, 12));
        const Tile area{1, 2, 9, 8};
        const Tile reached = pixels_reached(at, filter, area);
        INFO("a sample at " << at << ", a filter of radius " << filter.radius
                            << ", columns 1 to 8 and rows 2 to 7: " << in_words(reached));
        for (int y = -4; y < 14; ++y) {
            for (int x = -4; x < 14; ++x) {
                const Vec2 away = glm::abs(at - Vec2(x + 0.5, y + 0.5));
                const bool wanted = in(area, x, y) && std::max(away.x, away.y) <= filter.radius;
                if (wanted == in(reached, x, y)) continue;
                INFO("the pixel (" << x << ", " << y << "), whose centre is " << away << " away");
                REQUIRE(test::or_say(!wanted, "it is reached, but left out"));
                REQUIRE(test::or_say(wanted, "it is not reached, or outside of the area"));
            }
        }
    }
}

TEST_CASE("a sample goes to the pixels that it reaches, and only to those", "[08.8]") {
    // 3/4 to the pixel (2, 1), whose centre is at 2.5; 1/4 to the pixel (1, 1).
    const FilmSample one{{2.25, 1.5}, {8, 4, 2}, 0.5};
    const std::vector<FilmPixel> film = film_of({&one, 1}, tent, {0, 0, 4, 3});
    REQUIRE(film.size() == 12);
    for (std::size_t i = 0; i < film.size(); ++i) {
        const Real weight = i == 6 ? 0.75 : i == 5 ? 0.25 : 0;
        const Vec2 center(Real(i % 4) + 0.5, Real(i / 4) + 0.5);
        INFO("a sample at " << one.at << " that stands for " << one.weight
                            << " of a pixel, under a tent of radius 1; the pixel around " << center << ": "
                            << film[i]);
        CHECK(near(film[i].weight, 0.5 * weight, 4 * u));
        CHECK(near(film[i].sum, 0.5 * weight * Vec3(8, 4, 2), 16 * u));
    }
}

TEST_CASE("an empty area has no sums, and a film without samples is black", "[08.8]") {
    const FilmSample one{{2.25, 1.5}, {8, 4, 2}, 0.5};
    INFO("how many pixels there are of an area without width, of one without height, and of 2 x 2");
    CHECK(film_of({&one, 1}, tent, {2, 1, 2, 3}).size() == 0);
    CHECK(film_of({&one, 1}, tent, {2, 3, 5, 3}).size() == 0);
    CHECK(film_of({&one, 1}, tent, {3, 0, 1, 2}).size() == 0);
    CHECK(film_of({&one, 1}, tent, {0, 3, 2, 1}).size() == 0);
    const std::vector<FilmPixel> film = film_of({}, mitchell, {2, 1, 4, 3});
    REQUIRE(film.size() == 4);
    for (const FilmPixel& pixel : film) CHECK(color_of(pixel) == Vec3(0));
}

TEST_CASE("a film is what asking each pixel about each sample makes, to the bit", "[08.8]") {
    test::Random random(861);
    for (int i = 0; i < cases(40); ++i) {
        const std::vector<FilmSample> samples = random_film_samples(random, 60);
        const std::size_t kind = random.index(4);
        Filter filter = all_filters[kind];
        if (random.index(2) == 0) filter.radius = random.uniform(0.3, 3);
        const int x0 = static_cast<int>(random.index(3)), y0 = static_cast<int>(random.index(3));
        const Tile area{x0, y0, x0 + 1 + static_cast<int>(random.index(5)),
                        y0 + 1 + static_cast<int>(random.index(4))};
        const std::vector<FilmPixel> film = film_of(samples, filter, area);
        REQUIRE(film.size() == static_cast<std::size_t>((area.x1 - area.x0) * (area.y1 - area.y0)));
        auto actual = film.begin();
        for (int y = area.y0; y < area.y1; ++y) {
            for (int x = area.x0; x < area.x1; ++x, ++actual) {
                const Vec2 center(x + 0.5, y + 0.5);
                FilmPixel expected;
                for (const auto& sample : samples) {
                    const Real weight = filter_weight(filter, sample.at - center);
                    if (weight != 0) expected = add(expected, sample.color, sample.weight * weight);
                }
                if (same(*actual, expected)) continue;
                INFO("60 samples under the " << name_of(filter) << " of radius " << filter.radius
                                             << ", pixel (" << x << ", " << y << "): " << *actual
                                             << "\nexpected " << expected);
                REQUIRE(test::or_say(same(*actual, expected), "they are not the same to the bit"));
            }
        }
    }
}

TEST_CASE("one colour stays that colour under every filter, up to the picture's border", "[08.8]") {
    const Vec3 color(0.1, 0.7, 1);
    for (std::size_t kind = 0; kind < 4; ++kind) {
        for (const int n : {1, 2, 3}) {
            const std::vector<FilmPixel> film =
                film_of(even_samples(7, 6, n, color), all_filters[kind], {0, 0, 7, 6});
            REQUIRE(film.size() == 42);
            for (std::size_t i = 0; i < film.size(); ++i) {
                INFO("the " << name_of(all_filters[kind]) << ", " << n << " × " << n
                            << " samples of one colour, pixel (" << i % 7 << ", " << i / 7 << ")");
                // Negative weights make the sum of |weights| up to 1.6 times that of the weights; each
                // product is rounded twice.
                REQUIRE(test::near_color(color_of(film[i]), color, 8 * u));
            }
        }
    }
}

TEST_CASE("films of two tiles merge to the film of the picture", "[08.8]") {
    test::Random random(862);
    const std::vector<FilmSample> samples = random_film_samples(random, 200);
    const Tile picture{0, 0, 7, 6};
    std::vector<FilmSample> left, right;
    for (const FilmSample& sample : samples) (sample.at.x < 3 ? left : right).push_back(sample);
    for (const Filter& filter : all_filters) {
        const std::vector<FilmPixel> whole = film_of(samples, filter, picture),
                                     a = film_of(left, filter, picture), b = film_of(right, filter, picture);
        INFO("under the " << name_of(filter) << ": how many pixels each film has");
        REQUIRE(whole.size() == 42);
        REQUIRE(a.size() == 42);
        REQUIRE(b.size() == 42);
        for (std::size_t i = 0; i < whole.size(); ++i) {
            const FilmPixel both = merge(a[i], b[i]);
            // Each true sum is within a few u² of the exact one, and no sum is above 200.
            INFO("pixel " << i
                          << " of 42, merged from two films; expected that of one film: sum, and weight");
            REQUIRE(near(both.sum + both.lost, whole[i].sum + whole[i].lost, 800 * u));
            REQUIRE(near(both.weight, whole[i].weight, 800 * u));
        }
    }
}
