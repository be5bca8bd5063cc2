// Steps 10.11 to 10.14: surfaces f(x, y, z) = 0, by interval arithmetic and by sphere tracing.
#include "chapters/10_surfaces/implicit.hpp"
#include "chapters/10_surfaces/sphere_tracing.hpp"
#include "common/math/error.hpp"
#include "common/scene/evaluate.hpp"
#include "tests/10_surfaces/check_span.hpp"
#include "tests/stability/implicits.hpp"
#include "tests/support.hpp"

#include <cmath>

using namespace rt;
using test::ahead;
using test::cases;
using test::Random;

namespace {

Implicit made(const std::string& expression) { return stability::surface_of(expression, 2); }

/// f of x alone, and λ = x: the chord is the x axis from 0 to 1.
struct OnUnit {
    Implicit implicit;
    ImplicitLine line{implicit.f, {Vec3(0), Vec3(1, 0, 0), 0, 1}};
    explicit OnUnit(const std::string& expression) : implicit(made(expression)) {}
};

void check_crossing(const std::string& f, Interval range, Real t, int after, Real error = 0x1p-40) {
    const OnUnit unit(f);
    const std::optional<LineCrossing> crossing = first_crossing(unit.line, range);
    INFO("f = " << f << " for x from 0 to 1, range " << range);
    const LineCrossing expected{t, after};
    INFO("expected a " << expected << "; actual " << crossing);
    REQUIRE(crossing.has_value());
    CHECK(test::near(crossing->t, t, error));
    CHECK(crossing->after == after);
}

void check_no_crossing(const std::string& f, Interval range = ahead) {
    const OnUnit unit(f);
    const std::optional<LineCrossing> crossing = first_crossing(unit.line, range);
    INFO("f = " << f << " for x from 0 to 1, range " << range << "; expected no crossing, actual "
                << crossing);
    CHECK_FALSE(crossing.has_value());
}

/// The next stretch of the pieces, for x from 0 to 1 and so with λ = t = x.
void check_next(const OnUnit& unit, std::vector<Piece>& pieces, Real begin, const Stretch& expected) {
    const auto in_words = [](const Stretch& stretch) {
        const std::string which = stretch.is_whole ? "all of it on side " : "at its right end on side ";
        return "the piece between " + test::show(stretch.piece) + ", " + which + test::show(stretch.side);
    };
    std::string list;
    for (const Piece& piece : pieces) list += (list.empty() ? "" : "; ") + test::show(piece);
    const std::optional<Stretch> actual = next_stretch(unit.line, pieces, begin);
    INFO("f of x from 0 to 1; pieces to look at, the next one last: between " << list);
    INFO("beyond " << test::show(begin) << " expected " << in_words(expected) << "; actual "
                   << (actual ? in_words(*actual) : "nothing"));
    REQUIRE(actual.has_value());
    CHECK(actual->piece.low == expected.piece.low);
    CHECK(actual->piece.high == expected.piece.high);
    CHECK(actual->side == expected.side);
    CHECK(test::or_say(actual->is_whole == expected.is_whole,
                       actual->is_whole ? "a whole piece on one side, but f may be 0 in it"
                                        : "a piece on both sides, but f cannot be 0 in it"));
}

void check_narrowed(const std::string& f, Piece piece, Real root, Real width) {
    const OnUnit unit(f);
    const Piece actual = narrowed(unit.line, piece);
    INFO("f = " << f << " between " << piece << ", root " << test::show(root) << "; actual " << actual);
    CHECK(actual.low <= root);
    CHECK(root <= actual.high);
    CHECK(actual.high - actual.low <= width);
}

void check_hit(const Implicit& implicit, const Ray& ray, Interval range, Real t, Real error = 0x1p-40) {
    const std::optional<Hit> hit = intersect(implicit, ray, range);
    INFO(implicit << "\n" << ray << ", range " << range << "; expected t = " << t << ", actual " << hit);
    REQUIRE(hit.has_value());
    CHECK(test::near(hit->t, t, error));
}

void check_miss(const Implicit& implicit, const Ray& ray, Interval range = ahead) {
    const std::optional<Hit> hit = intersect(implicit, ray, range);
    INFO(implicit << "\n" << ray << ", range " << range << "; expected no hit, actual " << hit);
    CHECK_FALSE(hit.has_value());
}

void check_spans(const Implicit& implicit, const Ray& ray, const std::vector<Span>& expected) {
    const std::vector<Span> actual = inside(implicit, ray);
    INFO(implicit << "\n" << ray << "\nexpected " << expected << "\nactual   " << actual);
    REQUIRE(actual.size() == expected.size());
    for (std::size_t i = 0; i < actual.size(); ++i)
        test::check_span(actual[i], expected[i], 0x1p-40, 0x1p-40);
}

void check_traced(const Implicit& implicit, Real lipschitz, const Ray& ray, Interval range, Real tolerance,
                  Real t, Real error = 0x1p-40) {
    const std::optional<Hit> hit = sphere_trace(implicit, lipschitz, ray, range, tolerance);
    INFO(implicit << "\n"
                  << ray << ", range " << range << ", lipschitz " << lipschitz << ", tolerance "
                  << tolerance);
    INFO("expected t = " << t << ", actual " << hit);
    REQUIRE(hit.has_value());
    CHECK(test::near(hit->t, t, error));
}

void check_not_traced(const Implicit& implicit, Real lipschitz, const Ray& ray, Interval range,
                      Real tolerance) {
    const std::optional<Hit> hit = sphere_trace(implicit, lipschitz, ray, range, tolerance);
    INFO(implicit << "\n"
                  << ray << ", range " << range << ", lipschitz " << lipschitz << ", tolerance "
                  << tolerance);
    INFO("expected no hit, actual " << hit);
    CHECK_FALSE(hit.has_value());
}

const Implicit ball = made("x^2+y^2+z^2-1");

}  // namespace

// ---------------------------------------------------------------------------------------------------- 10.11
// to 10.13

TEST_CASE("the worked example: the stretches of x² − x + 2/9 from 0 to 1", "[10.11]") {
    // By hand, in the lesson: f is 2/9 at 0, 5/144 at ¼, −7/576 at ⅜.
    const OnUnit unit("x^2-x+2/9");
    std::vector<Piece> pieces{{0, 1}};
    check_next(unit, pieces, 0, {{0, 0.25}, 1, false});
    CHECK(pieces.size() == 2);
    check_next(unit, pieces, 0, {{0.25, 0.375}, -1, false});
}

TEST_CASE("where f cannot be 0, all of the piece is on one side", "[10.11]") {
    std::vector<Piece> pieces{{0, 1}};
    check_next(OnUnit("x+1"), pieces, 0, {{0, 1}, 1, true});
    pieces = {{0, 1}};
    check_next(OnUnit("x-2"), pieces, 0, {{0, 1}, -1, true});
    pieces = {{0.5, 0.75}};
    check_next(OnUnit("x^2+1/1000"), pieces, 0, {{0.5, 0.75}, 1, true});
    CHECK(pieces.size() == 0);
}

TEST_CASE("pieces that end before the beginning are skipped, and none is cut there", "[10.11]") {
    const OnUnit unit("x-3/8");
    std::vector<Piece> pieces{{0.5, 1}, {0.25, 0.5}, {0, 0.25}};
    check_next(unit, pieces, 0.25, {{0.25, 0.5}, 1, false});
    pieces = {{0.5, 1}, {0.25, 0.5}, {0, 0.25}};
    check_next(unit, pieces, 0.3, {{0.25, 0.5}, 1, false});
    pieces = {{0.5, 1}, {0.25, 0.5}};
    check_next(unit, pieces, 0.75, {{0.5, 1}, 1, true});
    pieces = {{0, 1}};
    const std::optional<Stretch> none = next_stretch(unit.line, pieces, 1);
    INFO("f = x - 3/8, of the chord from 0 to 1 what is beyond 1: expected nothing");
    CHECK_FALSE(none.has_value());
}

TEST_CASE("an empty list has no next piece", "[10.11]") {
    std::vector<Piece> pieces;
    const std::optional<Stretch> none = next_stretch(OnUnit("x").line, pieces, 0);
    INFO("expected nothing of an empty list of pieces");
    CHECK_FALSE(none.has_value());
}

TEST_CASE("where f touches 0, a piece is divided until it tells nothing more, and not further", "[10.11]") {
    // Near the double root ⅓, f is known but for 2⁻⁵⁴, and so nothing is known within about 2⁻²⁷ of it.
    const OnUnit unit("x^2-2/3*x+1/9");
    std::vector<Piece> pieces{{0, 1}};
    for (std::optional<Stretch> next = next_stretch(unit.line, pieces, 0); next;
         next = next_stretch(unit.line, pieces, 0)) {
        const Real length = next->piece.high - next->piece.low;
        INFO("f = x^2 - 2/3 x + 1/9: the piece between " << next->piece << " is " << test::show(length)
                                                         << " long");
        CHECK(length > 0x1p-31);
    }
}

TEST_CASE("the worked example: the root ⅓ between ¼ and ⅜ is narrowed", "[10.12]") {
    check_narrowed("x^2-x+2/9", {0.25, 0.375}, 1.0 / 3, 0x1p-48);
}

TEST_CASE("the worked example: the crossings of x² − x + 2/9", "[10.13]") {
    check_crossing("x^2-x+2/9", ahead, 1.0 / 3, -1);
    check_crossing("x^2-x+2/9", {0.5, infinity}, 2.0 / 3, 1);
}

TEST_CASE("the first of three crossings, where the line goes in", "[10.13]") {
    // f = −(x − ¼)(x − ½)(x − ⅞) is positive up to ¼, negative from there, positive from ½, negative from ⅞.
    check_crossing("-(x-1/4)*(x-1/2)*(x-7/8)", ahead, 0.25, -1);
}

TEST_CASE("a crossing where the line goes out", "[10.13]") { check_crossing("x-3/8", ahead, 0.375, 1); }

TEST_CASE("a crossing before the range is left out, and the next one found", "[10.13]") {
    check_crossing("-(x-1/4)*(x-1/2)*(x-7/8)", {0.25, infinity}, 0.5, 1);
    check_crossing("-(x-1/4)*(x-1/2)*(x-7/8)", {0.3, infinity}, 0.5, 1);
    check_crossing("-(x-1/4)*(x-1/2)*(x-7/8)", {0.75, infinity}, 0.875, -1);
    check_no_crossing("-(x-1/4)*(x-1/2)*(x-7/8)", {0.9, infinity});
    check_crossing("(x-3/10)*(x-9/20)", {0.31, infinity}, 0.45, 1);
}

TEST_CASE("a crossing behind the range is none", "[10.13]") {
    check_no_crossing("x-3/8", {0, 0.25});
    check_crossing("x-3/8", {0, 0.5}, 0.375, 1);
}

TEST_CASE("f without a root", "[10.13]") {
    check_no_crossing("x^2+1/1000");
    check_no_crossing("x+1");
    check_no_crossing("sin(x)-2");
}

TEST_CASE("where f only touches 0, the line does not go in", "[10.13]") {
    check_no_crossing("(x-1/3)^2");
    check_no_crossing("-(x-1/2)^2");
}

TEST_CASE("two roots close to each other are both found", "[10.13]") {
    // At 1/2 − 1/1024 and 1/2 + 1/1024, between equal steps of 1/100 as a program would take them that knows
    // no better.
    check_crossing("(x-1/2)^2-1/1048576", ahead, 0.5 - 0x1p-10, -1);
    check_crossing("(x-1/2)^2-1/1048576", {0.5, infinity}, 0.5 + 0x1p-10, 1);
}

TEST_CASE("a threefold root is a crossing", "[10.13]") {
    // f is (x − ⅓)³, which rounding cannot tell from 0 within 1e-5.
    check_crossing("x^3-x^2+x/3-1/27", ahead, 1.0 / 3, 1, 1e-4);
    check_crossing("(x-1/2)^3", ahead, 0.5, 1);
}

TEST_CASE("a root where the pieces are divided", "[10.13]") {
    check_crossing("x-1/2", ahead, 0.5, 1);
    check_crossing("1/4-x", ahead, 0.25, -1);
    check_crossing("x*(x-1/2)+x/7-1/14", ahead, 0.5, 1);
}

TEST_CASE("where f jumps from one sign to the other there is a surface", "[10.13]") {
    check_crossing("1/(x-1/3)", ahead, 1.0 / 3, 1);
}

TEST_CASE("where f has no value is outside", "[10.13]") {
    // Negative from ¼ on, where the root begins to have a value.
    check_crossing("sqrt(x-1/4)-1", ahead, 0.25, -1);
    check_no_crossing("sqrt(-1-x)-1");
    // The same where what is made of the root has bounds of its own.
    check_crossing("sin(sqrt(x-1/4))-2", ahead, 0.25, -1);
    check_crossing("max(sqrt(x-1/4)-3,-2)", ahead, 0.25, -1);
    check_crossing("-abs(log(x-1/4))-1", ahead, 0.25, -1);
}

TEST_CASE("where f is 0 all along, and its slope has no bound, there is no crossing", "[10.13]") {
    check_miss(made("x*sqrt(abs(y))"), {{-3, 0, 0}, {1, 0, 0}});
    check_miss(made("sqrt(abs(y))"), {{-3, 0, 0}, {1, 0, 0}});
}

TEST_CASE("a surface is there also where f has no bound at the middle of the chord", "[10.13]") {
    // There x is 0, and the power has no slope; or f itself has a pole.
    check_hit(made("abs(x)^(2/3)+abs(y)^(2/3)+abs(z)^(2/3)-1"), {{3, 0.125, 0.125}, {-1, 0, 0}}, ahead,
              3 - std::sqrt(0.125));
    check_hit(made("1-1/(4*(x^2+y^2+z^2))"), {{3, 0, 0}, {-1, 0, 0}}, ahead, 2.5);
    check_hit(made("1-1/(4*(x^2+y^2+z^2))"), {{3, 0, 0}, {-1, 0, 0}}, {2.75, infinity}, 3.5);
}

TEST_CASE("corners of abs, min and max", "[10.13]") {
    check_crossing("abs(x-1/2)-1/8", ahead, 0.375, -1);
    check_crossing("abs(x-1/2)-1/8", {0.5, infinity}, 0.625, 1);
    check_crossing("min(x-1/4,3/4-x)", ahead, 0.25, 1);
    check_crossing("min(x-1/4,3/4-x)", {0.5, infinity}, 0.75, -1);
    check_crossing("max(x-3/4,1/4-x)", ahead, 0.25, -1);
}

TEST_CASE("Newton's method leaves a piece as narrow as rounding allows", "[10.12]") {
    check_narrowed("x-3/8", {0, 1}, 0.375, 0x1p-48);
    check_narrowed("x^3+x-1", {0, 1}, 0.6823278038280193, 0x1p-48);
    check_narrowed("3/8-x", {0.25, 0.5}, 0.375, 0x1p-48);
}

TEST_CASE("where Newton's step leads beyond the piece, the rest of the piece is kept", "[10.12]") {
    // At the middle, ½, f is 0.113…, and its slope is somewhere from 1/64 to 3 + 1/64: the root is in −6.8 …
    // 0.46.
    check_narrowed("x^3+x/64-5/256", {0, 1}, 0.25, 0x1p-46);
}

TEST_CASE("a piece in which f also has a minimum is narrowed", "[10.12]") {
    // f goes down to x = 3/8 and then up through 0 at 3/4: its slope is not of one sign from 1/4 to 1.
    check_narrowed("(x-3/8)^2-9/64", {0.25, 1}, 0.75, 0x1p-46);
}

TEST_CASE("a ball by its equation", "[10.13]") {
    check_hit(ball, {{-3, 0, 0}, {1, 0, 0}}, ahead, 2);
    check_hit(ball, {{-3, 0, 0}, {2, 0, 0}}, ahead, 1);
    check_hit(ball, {{-3, 0, 0}, {1, 0, 0}}, {2.5, infinity}, 4);
    check_hit(ball, {{0, 0, 0}, {0, 1, 0}}, ahead, 1);
    check_hit(ball, {{0, 0.6, 5}, {0, 0, -1}}, ahead, 4.2);
    check_miss(ball, {{-3, 1.001, 0}, {1, 0, 0}});
    check_miss(ball, {{-3, 0, 0}, {-1, 0, 0}});
    check_miss(ball, {{-3, 0, 0}, {1, 0, 0}}, {0, 1.9});
}

TEST_CASE("what is beyond the box does not belong to the surface, and nor does the box", "[10.13]") {
    const Implicit half{{Vec3(-2, 0, -2), Vec3(2)}, ball.f};  // the upper half of a ball, open below
    check_hit(half, {{0, 5, 0}, {0, -1, 0}}, ahead, 4);
    check_hit(half, {{0, -5, 0}, {0, 1, 0}}, ahead, 6);
    check_miss(half, {{-5, -0.5, 0}, {1, 0, 0}});
}

TEST_CASE("a ray that begins on the surface does not hit it there", "[10.13]") {
    check_miss(ball, {{1, 0, 0}, {1, 0, 0}});
    check_hit(ball, {{1, 0, 0}, {-1, 0, 0}}, ahead, 2);
}

TEST_CASE("from 1e8 away", "[10.13]") {
    check_hit(ball, {{-1e8, 0.5, 0}, {1, 0, 0}}, ahead, 1e8 - std::sqrt(0.75), 1e-7);
    check_miss(ball, {{-1e8, 1.0001, 0}, {1, 0, 0}});
}

TEST_CASE("a direction of another length, by a power of two, has the same hits, to the bit", "[10.13]") {
    Random random(10901);
    const Implicit heart = stability::surface_named("the heart");
    int hits = 0;
    for (int i = 0; i < cases(300); ++i) {
        const Vec3 target = random.in_cube();
        const Ray ray{target + random.magnitude(0, 2) * random.direction(), random.direction()};
        const Ray here{ray.origin, target - ray.origin};
        const std::optional<Hit> one = intersect(heart, here, ahead);
        hits += one.has_value();
        for (const int k : {-40, 3, 40}) {
            const Ray shorter{here.origin, std::ldexp(1.0, -k) * here.direction};
            const std::optional<Hit> other = intersect(heart, shorter, ahead);
            INFO(here << ": " << one << "\nby 2^" << k << " shorter: " << other);
            REQUIRE(one.has_value() == other.has_value());
            if (one) CHECK(other->t == std::ldexp(one->t, k));
        }
    }
    CHECK(hits > cases(300) / 4);
}

TEST_CASE("the range decides which hit is found, not where it is", "[10.13]") {
    Random random(10902);
    const Implicit tangle = stability::surface_named("a tangle cube");
    int found = 0, further = 0;
    for (int i = 0; i < cases(500); ++i) {
        const Vec3 origin = 8.0 * random.direction();
        const Ray ray{origin, 2.0 * random.in_cube() - origin};
        const std::optional<Hit> hit = intersect(tangle, ray, ahead);
        if (!hit) continue;
        ++found;
        const std::optional<Hit> again = intersect(tangle, ray, {hit->t * 0.99, hit->t});
        INFO(ray << "\nhit " << hit << ", asked again for up to it " << again);
        REQUIRE(again.has_value());
        CHECK(again->t == hit->t);
        // All ends of what is inside, which come from other ranges.
        Interval rest{hit->t, infinity};
        for (const Span& span : inside(tangle, ray))
            for (const Hit& end : {Hit{.t = span.enter, .element = span.enter_face},
                                   Hit{.t = span.leave, .element = span.leave_face}}) {
                if (end.element != surface_face || end.t <= rest.min + 0x1p-30) continue;
                const std::optional<Hit> next = intersect(tangle, ray, rest);
                INFO("beyond " << rest.min << " expected " << end.t << ", actual " << next);
                REQUIRE(next.has_value());
                CHECK(test::near(next->t, end.t, 0x1p-40));
                rest.min = next->t;
                ++further;
            }
        const std::optional<Hit> none = intersect(tangle, ray, rest);
        INFO("beyond the last one, at " << rest.min << ": " << none);
        CHECK_FALSE(none.has_value());
    }
    CHECK(found > cases(500) / 10);
    CHECK(further > cases(500) / 10);
}

TEST_CASE("the parts of a line that are in the solid", "[10.13]") {
    const Implicit half{{Vec3(-2, 0, -2), Vec3(2)}, ball.f};
    check_spans(half, {{0, -5, 0}, {0, 1, 0}}, {{5, 6, 2, surface_face}});  // by the box's bottom
    check_spans(half, {{-5, 0.6, 0}, {1, 0, 0}}, {{4.2, 5.8, surface_face, surface_face}});
    check_spans(half, {{-5, 1.5, 0}, {1, 0, 0}}, {});
    check_spans(made("x*(x-1)*(x+1)"), {{0, 0, 0}, {1, 0, 0}},
                {{-2, -1, 0, surface_face}, {0, 1, surface_face, surface_face}});
}

TEST_CASE("the point is on the surface, and the normal leads outward", "[10.13]") {
    const Ray ray{{-3, 0, 0}, {1, 0, 0}};
    const Surface surface = surface_at(ball, ray, {.t = 2, .element = surface_face});
    CHECK(test::near(surface.point, Vec3(-1, 0, 0), 0x1p-50));
    CHECK(test::near(surface.normal, Vec3(-1, 0, 0), 0x1p-50));
    CHECK(max_component(surface.error) < 0x1p-45);
    const Surface inner = surface_at(ball, ray, {.t = 4, .element = surface_face});
    CHECK(test::near(inner.normal, Vec3(1, 0, 0), 0x1p-50));
}

TEST_CASE("at the tip of a cone the normal is along the ray, outward", "[10.13]") {
    const Implicit cone = made("x^2+y^2-z^2");
    const Ray ray{{-1, 0, 0}, {1, 0, 0}};
    const Surface surface = surface_at(cone, ray, {.t = 1, .element = surface_face});
    CHECK(test::near(surface.normal, Vec3(-1, 0, 0), 0x1p-50));
    CHECK(test::is_finite(surface.error));
}

TEST_CASE("along a line in the surface, short pieces tell that there is no more to know", "[10.13]") {
    // Without that, the first hit of such a ray would take 2²⁵ pieces.
    for (const char* f : {"x^2+y^2-z^2-1", "(x^2+y^2-z^2-1)*(x+y*z+5)"}) {
        const Implicit surface = made(f);
        const Ray ray{{1, -5, -5}, {0, 1, 1}};
        const std::optional<Chord> part = chord(surface.box, ray, ahead);
        REQUIRE(part.has_value());
        INFO(f);
        const ImplicitLine line{surface.f, *part};
        constexpr int pieces = 1 << 20;
        for (int i = 0; i < pieces; i += 4099) {
            const Piece piece{Real(i) / pieces, Real(i + 1) / pieces};
            const Certain certain = enclose(line, piece);
            INFO("λ from " << piece.low << " to " << piece.high << ": slope from " << certain.slope.low
                           << " to " << certain.slope.high);
            CHECK(is_blurred(piece, certain));
        }
    }
    check_miss(made("x^2+y^2-z^2-1"), {{1, -5, -5}, {0, 1, 1}});
}

// --------------------------------------------------------------------------------------------------- 10.14

TEST_CASE("where |f| is the distance, one step leads to the surface", "[10.14]") {
    const Implicit wall = made("x-1");
    check_traced(wall, 1, {{-2, 0, 0}, {1, 0, 0}}, ahead, 0x1p-50, 3);
    check_traced(wall, 1, {{-2, 0, 0}, {0.25, 0, 0}}, ahead, 0x1p-50, 12);
    check_traced(wall, 1, {{1.5, 0, 0}, {-1, 0, 0}}, ahead, 0x1p-50, 0.5);
}

TEST_CASE("steps are |f| over the Lipschitz bound", "[10.14]") {
    // With twice the bound that it needs, each step covers half of what is left: from 3 away it stops at
    // 3·2^-k, as soon as half of that is no more than the tolerance.
    const Implicit wall = made("x-1");
    check_traced(wall, 2, {{-2, 0, 0}, {1, 0, 0}}, ahead, 0.1, 3 - 3.0 / 16);
    check_traced(wall, 2, {{-2, 0, 0}, {2, 0, 0}}, ahead, 0.1, 1.5 - 3.0 / 32);
    check_traced(made("4*x-4"), 8, {{-2, 0, 0}, {1, 0, 0}}, ahead, 0.1, 3 - 3.0 / 16);
}

TEST_CASE("a ray beside the surface leaves the box", "[10.14]") {
    check_not_traced(ball, 7, {{-3, 1.5, 0}, {1, 0, 0}}, ahead, 1e-6);
    check_not_traced(ball, 7, {{-3, 0, 0}, {-1, 0, 0}}, ahead, 1e-6);
    check_not_traced(ball, 7, {{-3, 5, 0}, {1, 0, 0}}, ahead, 1e-6);
}

TEST_CASE("sphere tracing begins and ends where the range does", "[10.14]") {
    check_not_traced(ball, 7, {{-3, 0, 0}, {1, 0, 0}}, {0, 1.5}, 1e-6);
    check_not_traced(ball, 7, {{-3, 0, 0}, {1, 0, 0}}, {4.5, infinity}, 1e-6);
    check_traced(ball, 7, {{-3, 0, 0}, {1, 0, 0}}, {2.5, infinity}, 1e-9, 4, 1e-7);
}

TEST_CASE("a range that begins below 0 begins at 0", "[10.14]") {
    check_not_traced(ball, 7, {{1.5, 0, 0}, {1, 0, 0}}, {-5, infinity}, 1e-6);
    check_traced(ball, 7, {{0, 0, 0}, {1, 0, 0}}, {-5, infinity}, 1e-9, 1, 1e-7);
}

TEST_CASE("a ray that begins on the surface hits it where it begins", "[10.14]") {
    check_traced(made("x-1"), 1, {{1, 0, 0}, {1, 0, 0}}, ahead, 0x1p-50, 0);
}

TEST_CASE("without a tolerance sphere tracing goes on until a step changes nothing", "[10.14]") {
    check_traced(ball, 7, {{-3, 0, 0}, {1, 0, 0}}, ahead, 0, 2, 0x1p-44);
}

TEST_CASE("where f has no value the trace ends", "[10.14]") {
    check_not_traced(made("sqrt(-1-x)"), 1, {{0, 0, 0}, {1, 0, 0}}, ahead, 1e-6);
}

TEST_CASE("sphere tracing never steps over a crossing", "[10.14]") {
    Random random(101001);
    const Implicit torus = stability::surface_named("a torus");
    const Real lipschitz = lipschitz_bound(torus), tolerance = 1e-4;
    int both = 0;
    for (int i = 0; i < cases(300); ++i) {
        const Vec3 origin = 5.0 * random.direction();
        const Ray ray{origin, 1.5 * random.in_cube() - origin};
        const std::optional<Hit> exact = intersect(torus, ray, ahead);
        const std::optional<Hit> traced = sphere_trace(torus, lipschitz, ray, ahead, tolerance);
        INFO(ray << "\nby intervals " << exact << ", by spheres " << traced);
        if (exact) REQUIRE(traced.has_value());
        if (exact) CHECK(traced->t <= exact->t + 0x1p-30);
        both += exact && traced;
        if (!traced) continue;
        const Real value = value_at(*torus.f, point_at(ray, traced->t));
        INFO("f is " << value << " there, and may be " << lipschitz * tolerance);
        CHECK(std::abs(value) <= lipschitz * tolerance * (1 + 0x1p-20));
    }
    CHECK(both > cases(300) / 10);
}

TEST_CASE("the Lipschitz bound is one, and not much more", "[10.14]") {
    CHECK(lipschitz_bound(made("3*x-4*z")) >= 5);
    CHECK(lipschitz_bound(made("3*x-4*z")) < 5.001);
    CHECK(lipschitz_bound(ball) >= 2 * std::sqrt(12.0));
    CHECK(lipschitz_bound(ball) < 7);
    CHECK(lipschitz_bound(made("sqrt(x)")) == infinity);
}
