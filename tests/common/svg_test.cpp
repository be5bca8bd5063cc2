// The writer of SVG pictures.
#include "common/image/svg.hpp"

#include "tests/catch.hpp"

#include <array>
#include <string>

using namespace rt;

namespace {

bool has(const Svg& svg, const std::string& part) { return to_string(svg).find(part) != std::string::npos; }

}  // namespace

TEST_CASE("numbers are short, and never a negative zero", "[svg]") {
    CHECK(decimal(2) == "2");
    CHECK(decimal(100) == "100");
    CHECK(decimal(0.1 + 0.2) == "0.3");
    CHECK(decimal(-1.255) == "-1.25");  // the double next to -1.255 is nearer to 0
    CHECK(decimal(-0.001) == "0");
    CHECK(decimal(1234.5678, 0) == "1235");
    CHECK(decimal(0.00012, 5) == "0.00012");
}

TEST_CASE("a drawing is opaque white and has its size", "[svg]") {
    const std::string file = to_string(Svg{.width = 30, .height = 20});
    CHECK(file.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"30\" height=\"20\""));
    CHECK(file.find("<rect width=\"30\" height=\"20\" fill=\"#ffffff\"/>") != std::string::npos);
    CHECK(file.ends_with("</svg>\n"));
}

TEST_CASE("shapes carry their places and styles", "[svg]") {
    Svg svg;
    line(svg, {1, 2}, {3, 4.5}, {.stroke = "#0072b2", .dash = "4 3"});
    CHECK(has(svg,
              "<line x1=\"1\" y1=\"2\" x2=\"3\" y2=\"4.5\" stroke=\"#0072b2\" fill=\"none\" "
              "stroke-width=\"1.5\" stroke-dasharray=\"4 3\"/>"));
    const std::array<Vec2, 3> corners{Vec2(0, 0), Vec2(10, 0), Vec2(0, 10)};
    polygon(svg, corners, {.stroke = "none", .fill = "red", .opacity = 0.5});
    CHECK(has(svg, "<polygon points=\"0,0 10,0 0,10\" stroke=\"none\" fill=\"red\" opacity=\"0.5\""));
}

TEST_CASE("an arrow of no length draws nothing", "[svg]") {
    Svg svg;
    arrow(svg, {5, 5}, {5, 5});
    CHECK(svg.body.empty());
    arrow(svg, {5, 5}, {25, 5});
    CHECK(has(svg, "<line x1=\"5\" y1=\"5\""));
    CHECK(has(svg, "<polygon points=\"25,5 "));
}

TEST_CASE("an arc runs counterclockwise as seen, y being down", "[svg]") {
    Svg svg;
    arc(svg, {0, 0}, 10, 0, pi / 2);
    CHECK(has(svg, "d=\"M10 0A10 10 0 0 0 0 -10\""));
}

TEST_CASE("words are escaped", "[svg]") {
    Svg svg;
    text(svg, {0, 0}, "a < b & c > d");
    CHECK(has(svg, ">a &lt; b &amp; c &gt; d</text>"));
}
