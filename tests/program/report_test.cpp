// The report's tables, plots and page, from measurements that are made up here.
#include "common/evidence/report.hpp"
#include "common/commands/commands.hpp"
#include "common/math/input_error.hpp"
#include "tests/catch.hpp"

#include <algorithm>

using namespace rt;

namespace {

ReportData family(int wrong) {
    return {{"chapter", "02"},
            {"question", "nearest hit, from \"outside\""},
            {"family", "far & tiny"},
            {"condition", "2"},
            {"demand", "8κu"},
            {"textbook", "formula"},
            {"stable",
             {{"cases", 10000},
              {"undecided", 3},
              {"wrong", wrong},
              {"worst", 0.25},
              {"worst_case", "Sphere{1}"},
              {"first_wrong", wrong > 0 ? "Sphere{0x1.8p+0}" : ""}}},
            {"naive",
             {{"cases", 1000},
              {"undecided", 0},
              {"wrong", 700},
              {"worst", nullptr},
              {"worst_case", ""},
              {"first_wrong", "Sphere{0x1p-1}"}}}};
}

ReportData feature(int general, bool judged) {
    return {
        {"feature", "shadow rays"},
        {"judged", judged},
        {"instructions", {{"general", general}, {"minimal", 1000}, {"limit", 1010}, {"with_feature", 3000}}},
        {"rays",
         {{"general", {{"camera", 9}, {"shadow", 1}, {"reflection", 0}, {"refraction", 0}}},
          {"minimal", {{"camera", 9}, {"shadow", 1}, {"reflection", 0}, {"refraction", 0}}}}},
        {"bytes", {{"general", 100}, {"with_feature", 200}}}};
}

ReportData filter(const char* name, double one, double many) {
    const auto point = [](int samples, double error) -> ReportData {
        return {{"asked", samples}, {"samples", samples}, {"seconds", 0.001 * samples},
                {"error", error},   {"estimate", 0},      {"ratio_low", 0},
                {"ratio_high", 0}};
    };
    const ReportData law{
        {"slope", -0.5}, {"low", nullptr}, {"high", nullptr}, {"intercept", 0}, {"points", 2}};
    return {{"method", name}, {"by_samples", law}, {"by_seconds", law},
            {"theory", 0},    {"stopped", ""},     {"points", {point(1, one), point(16, many)}}};
}

/// Pictures of a floor by four texels, and by footprints that are so wrong with one sample and with many.
ReportData floor_by_filters(double one, double many) {
    return ReportData::array(
        {{{"name", "horizon"},
          {"title", "Bricks to the horizon"},
          {"chapter", "11"},
          {"width", 40},
          {"height", 30},
          {"analytic", false},
          {"truth_error", 0.0001},
          {"truth_samples", 4096},
          {"best", many},
          {"curves", {filter("bilinear", 0.04, 0.01), filter("anisotropic", one, many)}}}});
}

ReportData some_data(int wrong, int instructions, bool judged = true) {
    ReportData data{
        {"quick", true},
        {"machine", {{"processor", "abacus"}, {"cores", 1}, {"compiler", "g++"}, {"load", nullptr}}},
        {"stability", ReportData::array({family(wrong)})},
        {"leave_out", ReportData::array({feature(instructions, judged)})}};
    data["problems"] = report_problems(data);
    return data;
}

}  // namespace

TEST_CASE("numbers are written with three digits, groups, and powers of ten") {
    CHECK(number_text(0) == "0");
    CHECK(number_text(0.5) == "0.500");
    CHECK(number_text(-1.234) == "−1.23");
    CHECK(number_text(12345.6) == "12\u2009346");
    CHECK(number_text(1234567) == "1\u2009234\u2009567");
    CHECK(number_text(1.24e-5) == "1.2\u2009·\u200910⁻⁵");
    CHECK(number_text(2.08e12) == "2.1\u2009·\u200910¹²");
    CHECK(number_text(nullptr) == "–");
}

TEST_CASE("tables quote what has commas or quotes, and leave out what is no number") {
    const std::vector<ReportFile> tables = report_tables(some_data(0, 1000));
    REQUIRE(tables.size() == 2);
    CHECK(tables[0].name == "stability.csv");
    CHECK(tables[0].content.ends_with(
        "02,\"nearest hit, from \"\"outside\"\"\",far & tiny,2,8κu,10000,3,0,0.25,"
        "Sphere{1},,formula,1000,700,Sphere{0x1p-1}\n"));
    CHECK(tables[1].name == "leave_out.csv");
    CHECK(tables[1].content.ends_with("shadow rays,1000,1000,1.0,1010,3000,9,1,0,0,100,200,true\n"));
}

TEST_CASE("a wrong case and a scene that pays too much are problems, and what is only shown is none") {
    CHECK(report_problems(some_data(0, 1010)).empty());
    CHECK(report_problems(some_data(0, 1011, false)).empty());
    const std::vector<std::string> problems = report_problems(some_data(2, 1011));
    REQUIRE(problems.size() == 2);
    CHECK(problems[0].find("2 of 10000 cases are wrong; the plainest: Sphere{0x1.8p+0}") !=
          std::string::npos);
    CHECK(problems[1] == "a scene without shadow rays takes 1011 instructions; 1010 are allowed");
}

TEST_CASE("a filter that is no better than four texels, and samples that do not help, are problems") {
    CHECK(report_problems({{"filters", floor_by_filters(0.015, 0.01)}}).empty());
    const std::vector<std::string> no_better = report_problems({{"filters", floor_by_filters(0.04, 0.01)}});
    REQUIRE(no_better.size() == 1);
    CHECK(no_better[0] ==
          "textures by anisotropic: one sample a pixel is wrong by 0.04, and a bilinear one by 0.04");
    const std::vector<std::string> no_help = report_problems({{"filters", floor_by_filters(0.015, 0.015)}});
    REQUIRE(no_help.size() == 1);
    CHECK(no_help[0] == "textures by anisotropic: 16 samples a pixel are wrong by 0.015, and one by 0.015");
}

TEST_CASE("texture filters have a plot, a table and a part of the page") {
    ReportData data = some_data(0, 1000);
    data["filters"] = floor_by_filters(0.015, 0.01);
    CHECK(report_tables(data)[0].name == "filters.csv");
    CHECK(report_tables(data)[0].content.ends_with("horizon,anisotropic,16,16,0.016,0.01,0,0,0\n"));
    const std::vector<ReportPlot> plots = report_plots(data);
    CHECK(plots[0].name == "filters_horizon");
    CHECK(plots[0].script.find("'filters.csv'") != std::string::npos);
    const std::string page = report_page(data, plots, "./course report error-time");
    for (const char* text : {"id=\"filters\"", "src=\"filters_horizon.svg\"", "<a href=\"filters.csv\">"}) {
        INFO(text);
        CHECK(page.find(text) != std::string::npos);
    }
}

namespace {

/// A curve of two points that says so much of its own error.
ReportData blur(const char* name, double one, double many, double stated) {
    ReportData curve = filter(name, one, many);
    for (ReportData& point : curve.at("points")) point["estimate"] = stated, point["rays"] = 40;
    return curve;
}

ReportData blurred_picture(const char* name, const std::vector<ReportData>& curves) {
    ReportData scene = floor_by_filters(0.015, 0.01).at(0);
    scene["name"] = name, scene["title"] = name, scene["curves"] = curves;
    return scene;
}

}  // namespace

TEST_CASE("pictures of what blurs that do not know how wrong they are are problems") {
    const auto problems = [](double stated) {
        return report_problems(
            {{"blurs", ReportData::array({blurred_picture("fog", {blur("sobol", 0.02, 0.02, stated)})})}});
    };
    CHECK(problems(0.02).empty());
    CHECK(problems(0.0299).empty());
    REQUIRE(problems(0.0301).size() == 2);
    CHECK(problems(0.0134).empty());
    REQUIRE(problems(0.0133).size() == 2);
    CHECK(problems(0.0133)[1] == "fog, sobol, 16 samples a pixel: wrong by 0.02, and the renders say 0.0133");
}

TEST_CASE("blurs have plots, tables and a part of the page, and times to equal error") {
    ReportData data = some_data(0, 1000);
    data["blurs"] = ReportData::array({blurred_picture("fog", {blur("sobol", 0.04, 0.01, 0.02)})});
    // In a millisecond a sample: the first is at .01 after 16 ms, the second between .02 and .005 after 4 ms,
    // the last never.
    data["blurs_compared"] = ReportData::array(
        {blurred_picture("two_lamps", {blur("one", 0.04, 0.01, 0), blur("all", 0.02, 0.005, 0),
                                       blur("none", 0.04, 0.02, 0)})});
    const auto tables = report_tables(data);
    CHECK(tables[0].name == "blurs.csv");
    CHECK(tables[0].content.ends_with("fog,sobol,16,16,0.016,0.01,0.02,0,0,40\n"));
    const std::vector<ReportPlot> plots = report_plots(data);
    CHECK(plots[0].name == "blurs_fog");
    CHECK(plots[1].name == "blurs_compared_two_lamps");
    const auto shows = [&](const char* text) {
        const std::string page = report_page(data, plots, "./course report error-time");
        INFO(text);
        CHECK(page.find(text) != std::string::npos);
    };
    shows("id=\"blurs\"");
    shows("src=\"blurs_fog.svg\"");
    shows("<td>one</td><td>0.0100</td><td>16.0</td><td>1.00</td>");
    shows("<td>all</td><td>0.0100</td><td>4.00</td><td>0.250</td>");
    shows("<td>none</td><td>0.0100</td><td>not reached</td><td>–</td><td>0.0200</td>");
    shows("POV-Ray is not installed.");
    data["povray"] = data["blurs_compared"];
    shows("of ours");
}

TEST_CASE("the page shows the parts that were measured, names its command and links its data") {
    const ReportData data = some_data(0, 1000);
    const std::vector<ReportPlot> plots = report_plots(data);
    const std::string page = report_page(data, plots, "./course report stability");
    const auto shows = [&](const char* text) { return page.find(text) != std::string::npos; };
    CHECK(shows("<code>./course report stability</code>"));
    CHECK(shows("<a href=\"stability.csv\">"));
    CHECK(shows("<a href=\"leave_out.csv\">"));
    CHECK(shows("src=\"leave_out.svg\""));
    CHECK(shows("far &amp; tiny"));
    CHECK(shows("every demand is met"));
    CHECK_FALSE(shows("id=\"pictures\""));
    CHECK_FALSE(shows("http"));
    const std::string bad = report_page(some_data(2, 1000), plots, "./course report");
    CHECK(bad.find("some demands are not met") != std::string::npos);
}

TEST_CASE("a plot's script reads the table beside it and writes its own picture") {
    for (const ReportPlot& plot : report_plots(some_data(0, 1000))) {
        CHECK(plot.script.find("\nname = '" + plot.name + "'\n") != std::string::npos);
        CHECK(plot.script.find("\nset output name.'.svg'\n") != std::string::npos);
        CHECK(plot.script.find("'" + plot.table + "'") != std::string::npos);
        CHECK_FALSE(plot.alt.empty());
    }
}

TEST_CASE("a plot follows the reader's preference for light or dark") {
    const std::string svg = svg_for_light_and_dark("<svg>\n<title>Gnuplot</title>\n</svg>\n");
    CHECK(svg.find("prefers-color-scheme: dark") < svg.find("<title>"));
}

TEST_CASE("a report that does not exist is refused, with the names of those that do") {
    CHECK_THROWS_WITH(run_report({.what = "speed", .output = {}}),
                      "there is no report 'speed'; there are error-time, stability and leave-out");
}
