// What a judge says of a batch of answers, and the tally of a chapter.
#include "tests/stability/verdict.hpp"

#include "tests/show.hpp"

#include <cmath>
#include <iostream>

namespace rt::stability {

void add(Verdict& total, const Verdict& batch) {
    total.cases += batch.cases;
    total.undecided += batch.undecided;
    total.mismatches += batch.mismatches;
    if (batch.worst > total.worst) {
        total.worst = batch.worst;
        total.worst_case = batch.worst_case;
    }
    keep_plainest(total, batch.plainest_mismatch);
}

void keep_plainest(Verdict& verdict, const std::string& what) {
    std::string& plainest = verdict.plainest_mismatch;
    if (!what.empty() && (plainest.empty() || what.size() < plainest.size())) plainest = what;
}

void count_mismatch(Verdict& verdict, const std::string& what) {
    ++verdict.mismatches;
    keep_plainest(verdict, what);
}

std::string describe(const Verdict& verdict) {
    if (verdict.mismatches > 0)
        return std::to_string(verdict.mismatches) + " of " + std::to_string(verdict.cases) +
               " cases are wrong; the plainest of them:\n  " + verdict.plainest_mismatch;
    std::string text =
        std::to_string(verdict.cases) + " cases, none wrong, " + std::to_string(verdict.undecided) +
        " too close to call; greatest error: " + test::show_size(verdict.worst) + " of what is allowed";
    if (!verdict.worst_case.empty()) text += ", at\n  " + verdict.worst_case;
    return text;
}

std::string literal(Real x) {
    if (x == 0 && std::signbit(x)) return "-0.0";
    return test::show(x);
}

std::string literal(const Vec2& v) { return "{" + literal(v.x) + ", " + literal(v.y) + "}"; }

std::string literal(const Vec3& v) {
    return "{" + literal(v.x) + ", " + literal(v.y) + ", " + literal(v.z) + "}";
}

std::string literal(const Ray& ray) {
    return "Ray{" + literal(ray.origin) + ", " + literal(ray.direction) + "}";
}

std::string literal(const Sphere& sphere) {
    return "Sphere{" + literal(sphere.center) + ", " + literal(sphere.radius) + "}";
}

std::string literal(const Triangle& triangle) {
    return "Triangle{" + literal(triangle.a) + ", " + literal(triangle.b) + ", " + literal(triangle.c) + "}";
}

Tally::~Tally() {
    if (!print) return;
    std::cerr << chapter << ": " << stable.cases << " cases judged by exact arithmetic, " << stable.mismatches
              << " mismatches; textbook methods: " << naive.mismatches << " mismatches in " << naive.cases
              << '\n';
}

}  // namespace rt::stability
