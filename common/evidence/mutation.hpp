// How well the tests of chapters notice mutants of their solutions.
#pragma once

#include "common/evidence/mutants.hpp"
#include "common/workbook/catalogue.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rt {

enum class Fate {
    NotCompiled,  ///< not counted
    Caught,       ///< by a test of its step, or it crashed or did not end there
    CaughtLater,  ///< only by another step's test of the chapter
    Survived
};

struct TriedMutant {
    Mutant mutant;
    std::string file;        ///< of the solution
    std::string equivalent;  ///< the reason why it is listed as right; empty if it is not
    Fate fate = Fate::Survived;
};

/// What came of a chapter's mutants.
struct Mutation {
    const Chapter* chapter = nullptr;
    std::vector<TriedMutant> tried;
    std::vector<std::string> stale;  ///< what is wrong with the list of equivalent mutants, a line each

    int count(Fate fate) const;  ///< of those that are not listed as equivalent
    int equivalent() const;
    /// Caught of those that can be, in [0, 1]; 1 where there are none.
    double score() const;
    std::vector<const TriedMutant*> survivors() const;
};

/// Makes the mutants of a chapter's steps, all for none, or `sample` of them, evenly spread, if it is
/// positive; compiles each in place of its file, and runs a student's tests on it: those of its step, then
/// the chapter's. `survived` is told of each that no test notices and that is not listed as equivalent, one
/// at a time, and must not throw. Nobody else builds meanwhile. Throws InputError for a list of equivalent
/// mutants that cannot be read, and std::runtime_error where the chapter's tests cannot be built, or do not
/// pass on the solution.
Mutation try_mutants(const Project& project, const Chapter& chapter, const std::vector<std::string>& steps,
                     int sample, const std::function<void(const TriedMutant&)>& survived);

}  // namespace rt
