// Where a student's code was when it ended, from what addr2line says of a back trace.
#include "common/workbook/back_trace.hpp"
#include "tests/catch.hpp"

using namespace rt;

namespace {

const Project project{"/home/ada/rays", "/home/ada/rays/build"};

}  // namespace

TEST_CASE("of a back trace the student's functions are told, the innermost first") {
    const auto frames = student_frames(project,
                                       "0x000000000001a2b3\n"
                                       "std::vector<int, std::allocator<int> >::operator[](unsigned long)\n"
                                       "/usr/include/c++/12/bits/stl_vector.h:1123\n"
                                       "rt::(anonymous namespace)::cells_of(rt::Grid const&)\n"
                                       "/home/ada/rays/chapters/09_grids/build.cpp:31 (discriminator 2)\n"
                                       "0x000000000001a2c0\n"
                                       "rt::refine(rt::Grid const&)::{lambda(int)#1}::operator()(int) const\n"
                                       "/home/ada/rays/chapters/09_grids/build.cpp:40\n"
                                       "0x0000000000020000\n"
                                       "rt::test::run()\n"
                                       "/home/ada/rays/tests/09_grids/build_test.cpp:12\n"
                                       "0x0000000000030000\n"
                                       "??\n"
                                       "??:0\n");
    REQUIRE(frames.size() == 2);
    CHECK(frames[0].function == "cells_of");
    CHECK(frames[0].file == "chapters/09_grids/build.cpp");
    CHECK(frames[0].line == 31);
    CHECK(frames[1].function == "refine");
    CHECK(frames[1].line == 40);
    CHECK(frames_in_words(frames) == "in cells_of, chapters/09_grids/build.cpp:31");
    CHECK(frames_in_words({}).empty());
}

TEST_CASE("many calls of one function at once are an endless recursion, some are not") {
    const Frame inner{"radiance", "chapters/07_recursion/trace.cpp", 12};
    CHECK(frames_in_words(std::vector<Frame>(10, inner)) ==
          "in radiance, chapters/07_recursion/trace.cpp:12");
    CHECK(frames_in_words(std::vector<Frame>(200, inner)) ==
          "radiance called itself without end, chapters/07_recursion/trace.cpp:12");
}

TEST_CASE("what the standard library has found is told in words") {
    const std::string before =
        "one\n/usr/include/c++/12/bits/stl_vector.h:1123: operator[](size_type): Assertion ";
    CHECK(broken_rule(before + "'__n < this->size()' failed.\n") == "an index is out of range");
    CHECK(broken_rule("/usr/include/c++/12/array:208: constexpr …: Assertion '__n < this->size()' failed.") ==
          "an index is out of range");
    CHECK(broken_rule(before + "'!this->empty()' failed.\n") == "the first or last of nothing was asked for");
    CHECK(broken_rule(before + "'this->_M_is_engaged()' failed.\n") ==
          "the value of an empty optional was asked for");
    CHECK(broken_rule(before + "'__x > 0' failed.\n") ==
          "the standard library says Assertion '__x > 0' failed.");
    CHECK(broken_rule("one\ntwo\n").empty());
}

TEST_CASE("of a program that has no such file nothing is told") {
    CHECK(stopped_in_words(project, "/no/such/program", {"1a2b"}).empty());
    CHECK(stopped_in_words(project, "/no/such/program", {}).empty());
}
