// What the terminal shows: times, counts and the progress line.
#include "common/terminal/console.hpp"
#include "common/math/counted.hpp"
#include "tests/catch.hpp"

using namespace rt;

TEST_CASE("durations read as a person says them") {
    CHECK(duration(0.04) == "0.0 s");
    CHECK(duration(1.26) == "1.3 s");
    CHECK(duration(9.96) == "10 s");
    CHECK(duration(59.4) == "59 s");
    CHECK(duration(59.6) == "1 min 0 s");
    CHECK(duration(185) == "3 min 5 s");
    CHECK(duration(3725) == "1 h 2 min");
}

TEST_CASE("one thing is singular") {
    CHECK(counted(1, "test") == "1 test");
    CHECK(counted(0, "test") == "0 tests");
    CHECK(counted(3, "test") == "3 tests");
    CHECK(counted(1, "matrix", "matrices") == "1 matrix");
    CHECK(counted(2, "matrix", "matrices") == "2 matrices");
}

TEST_CASE("the progress line says how much is done and how long the rest takes") {
    const std::string line = progress_line("scene.png", 0.25, 2, 80);
    CHECK(line.starts_with("scene.png "));
    CHECK(line.find(" 25 %") != std::string::npos);
    CHECK(line.ends_with("6.0 s left"));
}

TEST_CASE("the progress line promises nothing before it knows, and stays in its bounds") {
    CHECK(progress_line("x", 0, 5, 80).find("left") == std::string::npos);
    CHECK(progress_line("x", 2, 5, 80).find("100 %") != std::string::npos);
    CHECK_NOTHROW(progress_line("a long label in a narrow terminal", 0.5, 5, 10));
}

TEST_CASE("a stream that is no terminal has no colour") {
    std::FILE* file = std::tmpfile();
    REQUIRE(file);
    CHECK(paint("text", Tone::Bad, file) == "text");
    std::fclose(file);
}
