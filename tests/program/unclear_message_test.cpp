// Which messages of failed tests are written for a student.
#include "common/evidence/unclear_message.hpp"
#include "tests/catch.hpp"

using namespace rt;

namespace {

std::string message(const std::string& asked, const std::string& came_out) {
    return "a ray hits\n" + asked + (asked.empty() ? "" : "\n") + "came out: " + came_out +
           "\ntests/02_spheres/x_test.cpp:3: near(t, 0x1p-3, true)";
}

}  // namespace

TEST_CASE("a message says in words what was asked and what came out") {
    CHECK(unclear(message("a ray at a sphere: t of the hit", "4, expected 3\noff by 1")) == "");
    CHECK(unclear(message("a ray", "{?}, expected {?}")) == "shows a value as {?}");
    CHECK(unclear(message("a ray from {0x1.8p+3}", "a miss")) == "shows hexadecimal digits");
    CHECK(unclear(message("t := 3", "a miss")) == "names a variable of the test, not what it is");
    CHECK(unclear(message("a ray at a sphere", "{ true }")) == "says true or false, not what that means");
    CHECK(unclear(message("a ray at a sphere", "no, expected yes")) ==
          "answers yes or no, not what is wrong");
    CHECK(unclear(message("a ray at a sphere", "nothing, expected something")) == "");
}

TEST_CASE("a message says with words what was asked: numbers, and what was expected, are not enough") {
    const std::string silent = "does not say what was asked";
    CHECK(unclear(message("", "4, expected 3")) == silent);
    CHECK(unclear(message("", "4, expected 3\noff by 1")) == silent);
    CHECK(unclear(message("(0.5, 1e-20, nan)", "4, expected 3")) == silent);
    CHECK(unclear(message("expected 3", "4, expected 3")) == silent);
    CHECK(unclear(message("expected (1, 2)\nthat is 3", "4, expected 3")) == silent);
    CHECK(unclear(message("expected (1, 2)\nthe root of 9", "4, expected 3")) == "");
}

TEST_CASE("an exception, or a failure in a test's own words, is what came out, not what was asked") {
    const std::string silent = "does not say what was asked";
    CHECK(unclear(message("", "the exception std::bad_alloc")) == silent);
    CHECK(unclear(message("a ray at a sphere", "the exception std::bad_alloc")) == "");
    CHECK(unclear(message("", "no exception")) == silent);
    CHECK(unclear(message("", "a ray leaked out of the ice")) == silent);
}

TEST_CASE("what came out never reads like what was expected") {
    const std::string alike = "shows two different values alike";
    const auto of = [](const std::string& came_out) { return unclear(message("a root", came_out)); };
    CHECK(of("0, expected 0") == alike);
    CHECK(of("0, expected 0 +- 1e-16\noff by 1e-12") == alike);
    CHECK(of("(1, 0.5), expected (1.0, 0.50)") == alike);
    CHECK(of("1, expected at most 1") == alike);
    CHECK(of("1.0, expected less than 1") == alike);
    CHECK(of("1, expected less than 1") == "");
    CHECK(of("a miss, expected anything but a miss") == "");
    CHECK(of("10, expected 1") == "");
    CHECK(of("1.05, expected 1.5") == "");
    CHECK(of("-0, expected 0") == "");
}
