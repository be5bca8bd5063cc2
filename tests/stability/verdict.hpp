// What a judge says of a batch of answers, and the tally of a chapter.
// Cases are written with all the digits that they need, so that they can be pasted into a test and run again.
#pragma once

#include "common/math/ray.hpp"
#include "common/scene/shapes.hpp"

#include <cstddef>
#include <string>

namespace rt::stability {

/// A case is wrong where the answer breaks the family's demand, undecided where the data lie so close to the
/// border between two answers that moving them by 4 ulp crosses it: there both answers are right.
struct Verdict {
    std::size_t cases = 0;
    std::size_t undecided = 0;
    std::size_t mismatches = 0;
    Real worst = 0;                 ///< greatest error of the answers that are right, in units of the demand
    std::string worst_case;         ///< which case that was
    std::string plainest_mismatch;  ///< the wrong case that is shortest to write, what is right and what was
                                    ///< answered; or empty
};

/// Adds the verdict on a further batch.
void add(Verdict& total, const Verdict& batch);

/// Counts a wrong answer; `what` says which case it was, what is right and what was answered.
void count_mismatch(Verdict& verdict, const std::string& what);

/// Keeps `what` if it is shorter than the wrong case that was kept so far: short numbers are plain ones.
void keep_plainest(Verdict& verdict, const std::string& what);

/// Remembers the greatest error so far; `write()` says which case it was.
template <class Write>
void remember(Verdict& verdict, Real error, Write write) {
    if (!(error > verdict.worst)) return;
    verdict.worst = error;
    verdict.worst_case = write();
}

/// A few lines for a person: counts, and the worst case or the plainest mismatch.
std::string describe(const Verdict& verdict);

/// A number, a vector, a ray or a shape as a C++ literal that is read back as the same numbers.
std::string literal(Real x);
std::string literal(const Vec2& v);
std::string literal(const Vec3& v);
std::string literal(const Ray& ray);
std::string literal(const Sphere& sphere);
std::string literal(const Triangle& triangle);

/// Counts the cases of one chapter, and prints one line about them when the program ends, on standard error.
struct Tally {
    explicit Tally(std::string name) : chapter(std::move(name)) {}
    ~Tally();
    Tally(const Tally&) = delete;
    Tally& operator=(const Tally&) = delete;

    std::string chapter;
    Verdict stable;  ///< the implementation under test
    Verdict naive;   ///< the textbook method, which has to fail
    bool print = false;
};

}  // namespace rt::stability
