// Every test of the project, part by part: what `course test` runs.
#pragma once

#include "common/workbook/catalogue.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace rt {

/// What a part of the tests has found.
struct SelfTest {
    std::string name;
    int passed = 0;
    int failed = 0;
    double seconds = 0;
    std::vector<std::string> problems;  ///< one a failure; the first line says it all

    /// Counts one test; `problem` is what is wrong if it is not good.
    void expect(bool good, const std::string& problem);
    /// Adds what another part has found.
    void add(const SelfTest& other);
};

/// Builds programs; those that cannot be built are failures of the part, the others are returned.
std::vector<std::string> built(const Project& project, const std::vector<std::string>& programs,
                               SelfTest& part);

/// Builds programs, and lets expect(i, result) judge the i-th, side by side with others and in any order;
/// those that cannot be built are failures of the part, to which the results are added in the programs'
/// order.
void judge_built(const Project& project, const std::vector<std::string>& programs, SelfTest& part,
                 const std::function<void(std::size_t, SelfTest&)>& expect);

/// All tests of one program, which is built. Plain tests must come before families of extreme cases.
void test_program(const Project& project, const std::string& name, bool quick, SelfTest& part);

/// Known mistakes: each must be caught by the tests of its step, or if `quick` the first of each step. A
/// chapter must have two.
void test_mistakes(const Project& project, const std::vector<Chapter>& chapters, bool quick, SelfTest& part);

/// Right variants: every step must pass however it is written; if `quick` only the first variant of each
/// step. A step must have two.
void test_variants(const Project& project, const std::vector<Chapter>& chapters, bool quick, SelfTest& part);

/// Exercises as a student gets them: nothing is started, and they are what their solutions generate.
void test_exercises(const Project& project, const std::vector<Chapter>& chapters, SelfTest& part);

/// The shell scripts in tests/program: the whole program from outside. Each is one test.
void test_scripts(const Project& project, SelfTest& part);

}  // namespace rt
