// What a judge says of a batch of answers, and the tally of a chapter.
#include "tests/stability/verdict.hpp"

#include <cstdio>
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
    if (total.first_mismatch.empty()) total.first_mismatch = batch.first_mismatch;
}

void count_mismatch(Verdict& verdict, const std::string& what) {
    if (verdict.mismatches++ == 0) verdict.first_mismatch = what;
}

std::string describe(const Verdict& verdict) {
    char demand[32];
    std::snprintf(demand, sizeof demand, "%.3g", verdict.worst);
    std::string text = std::to_string(verdict.cases) + " cases, " + std::to_string(verdict.mismatches) +
                       " wrong, " + std::to_string(verdict.undecided) +
                       " too close to call; greatest error of the right ones: " + demand +
                       " of what is allowed";
    if (!verdict.worst_case.empty()) text += ", at\n  " + verdict.worst_case;
    if (!verdict.first_mismatch.empty()) text += "\nfirst wrong case:\n  " + verdict.first_mismatch;
    return text;
}

std::string literal(Real x) {
    char text[40];
    std::snprintf(text, sizeof text, "%a", x);
    return text;
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
