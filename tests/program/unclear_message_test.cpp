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
    CHECK(unclear(message("a ray at a sphere", "no, expected yes")) == "");
    CHECK(unclear(message("", "4, expected 3")) == "does not say what was asked");
    CHECK(unclear(message("", "4, expected 3\noff by 1")) == "does not say what was asked");
    CHECK(unclear(message("a ray", "{?}, expected {?}")) == "shows a value as {?}");
    CHECK(unclear(message("a ray from {0x1.8p+3}", "a miss")) == "shows hexadecimal digits");
    CHECK(unclear(message("t := 3", "a miss")) == "names a variable of the test, not what it is");
    CHECK(unclear(message("a ray at a sphere", "{ true }")) == "says true or false, not what that means");
}
