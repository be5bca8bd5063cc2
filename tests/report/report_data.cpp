// Program `report_data`: measures what `course report` shows, and writes it as JSON.
//   report_data [--quick] -o FILE [kernels] [pictures] [filters] [blurs] [povray] [grids] [searches]
//   [stability]
#include "common/image/file.hpp"
#include "common/math/stopwatch.hpp"
#include "common/terminal/console.hpp"
#include "tests/report/blurs.hpp"
#include "tests/report/families.hpp"
#include "tests/report/filters.hpp"
#include "tests/report/grids.hpp"
#include "tests/report/hierarchies.hpp"
#include "tests/report/kernels.hpp"
#include "tests/report/pictures.hpp"
#include "tests/report/povray_times.hpp"
#include "tests/support.hpp"

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace rt::report {
namespace {

using Json = nlohmann::ordered_json;

/// JSON has no infinities.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json to_json(const PowerLaw& law) {
    return {{"slope", number(law.slope)},
            {"low", number(law.low)},
            {"high", number(law.high)},
            {"intercept", number(law.intercept)},
            {"points", law.points}};
}

Json to_json(const Kernels& kernels) {
    Json families = Json::array(), rows = Json::array(), maps = Json::array();
    for (const KernelFamily& family : kernels.families)
        families.push_back({{"shape", family.shape}, {"words", family.words}, {"cases", family.cases}});
    for (const KernelRow& row : kernels.rows)
        rows.push_back({{"shape", row.shape},
                        {"method", row.method},
                        {"number", row.number},
                        {"ns", row.ns},
                        {"error_max", number(row.error_max)},
                        {"error_9999", number(row.error_9999)},
                        {"error_median", number(row.error_median)},
                        {"cases", row.cases},
                        {"wrong", row.wrong},
                        {"undecided", row.undecided},
                        {"course", row.course},
                        {"color", row.look.color},
                        {"look", row.look.name}});
    for (const DigitsMap& map : kernels.maps) {
        Json digits = Json::array();
        for (const double d : map.digits) digits.push_back(number(d));
        maps.push_back({{"method", map.method},
                        {"distance", map.distance},
                        {"tangency", map.tangency},
                        {"digits", digits}});
    }
    return {{"families", families}, {"rows", rows}, {"maps", maps}};
}

Json to_json(const PictureCurve& curve) {
    Json points = Json::array();
    for (const PicturePoint& point : curve.points)
        points.push_back({{"asked", point.asked},
                          {"samples", point.samples},
                          {"seconds", point.seconds},
                          {"error", point.error},
                          {"estimate", point.estimate},
                          {"ratio_low", point.ratio_low},
                          {"ratio_high", point.ratio_high},
                          {"rays", point.rays}});
    return {{"method", curve.method},
            {"by_samples", to_json(curve.by_samples)},
            {"by_seconds", to_json(curve.by_seconds)},
            {"theory", curve.theory},
            {"stopped", curve.stopped},
            {"points", points}};
}

Json to_json(const std::vector<PictureScene>& scenes) {
    Json list = Json::array();
    for (const PictureScene& scene : scenes) {
        Json curves = Json::array();
        for (const PictureCurve& curve : scene.curves) curves.push_back(to_json(curve));
        list.push_back({{"name", scene.name},
                        {"title", scene.title},
                        {"chapter", scene.chapter},
                        {"width", scene.width},
                        {"height", scene.height},
                        {"analytic", scene.analytic},
                        {"truth_error", scene.truth_error},
                        {"truth_samples", scene.truth_samples},
                        {"best", scene.best},
                        {"curves", curves}});
    }
    return list;
}

Json to_json(const Grids& grids) {
    Json points = Json::array();
    for (const GridPoint& point : grids.points)
        points.push_back({{"triangles", point.triangles},
                          {"build_seconds", point.build_seconds},
                          {"grid_ns", point.grid_ns},
                          {"brute_ns", point.brute_ns},
                          {"cells", point.cells},
                          {"asked", point.asked},
                          {"bytes", point.bytes},
                          {"break_even", point.break_even},
                          {"rays", point.rays},
                          {"brute_rays", point.brute_rays},
                          {"different", point.different}});
    return {{"points", points},
            {"build", to_json(grids.build)},
            {"grid_ray", to_json(grids.grid_ray)},
            {"brute_ray", to_json(grids.brute_ray)},
            {"asked", to_json(grids.asked)},
            {"break_even", to_json(grids.break_even)}};
}

Json to_json(const std::vector<SearchPoint>& points) {
    Json list = Json::array();
    for (const SearchPoint& point : points)
        list.push_back({{"scene", point.scene},
                        {"way", point.way},
                        {"triangles", point.triangles},
                        {"build_seconds", point.build_seconds},
                        {"ns", point.ns},
                        {"nodes", point.nodes},
                        {"asked", point.asked},
                        {"bytes", point.bytes},
                        {"break_even", point.break_even},
                        {"predicted", point.predicted},
                        {"paid", point.paid},
                        {"compared", point.compared},
                        {"different", point.different}});
    return list;
}

Json to_json(const stability::Verdict& verdict) {
    return {{"cases", verdict.cases},           {"undecided", verdict.undecided},
            {"wrong", verdict.mismatches},      {"worst", number(verdict.worst)},
            {"worst_case", verdict.worst_case}, {"first_wrong", verdict.plainest_mismatch}};
}

Json to_json(const std::vector<FamilyRow>& rows) {
    Json list = Json::array();
    for (const FamilyRow& row : rows)
        list.push_back({{"chapter", row.chapter},
                        {"question", row.question},
                        {"family", row.family},
                        {"condition", row.condition},
                        {"demand", row.demand},
                        {"textbook", row.textbook},
                        {"stable", to_json(row.stable)},
                        {"naive", to_json(row.naive)}});
    return list;
}

/// Measures one part with its progress on standard error; keeps how long it took.
template <class Measure>
void measure(Json& data, const std::string& name, const std::string& label, Measure part) {
    Progress progress(label);
    const Stopwatch watch;
    data[name] = to_json(part([&](double done) { progress.update(done); }));
    data["seconds"][name] = watch.seconds();
}

int run(std::vector<std::string> arguments) {
    const auto take = [&](const std::string& word) {
        const auto at = std::find(arguments.begin(), arguments.end(), word);
        if (at == arguments.end()) return false;
        arguments.erase(at);
        return true;
    };
    const bool quick = take("--quick");
    const auto option = std::find(arguments.begin(), arguments.end(), "-o");
    if (option == arguments.end() || option + 1 == arguments.end()) {
        fmt::print(stderr,
                   "report_data: expected [--quick] -o FILE [kernels] [pictures] [filters] [blurs] "
                   "[povray] [grids] [searches] [stability]\n");
        return 2;
    }
    const std::string file = *(option + 1);
    arguments.erase(option, option + 2);

    Json data{{"quick", quick}, {"seconds", Json::object()}};
    if (take("kernels"))
        measure(data, "kernels", "kernels", [&](const Told& told) {
            return measure_kernels(quick ? quick_kernels : KernelOptions{}, told);
        });
    if (take("pictures"))
        measure(data, "pictures", "pictures", [&](const Told& told) {
            return measure_pictures(test::repository(), quick ? quick_pictures() : PictureOptions{}, told);
        });
    if (take("filters"))
        measure(data, "filters", "texture filters", [&](const Told& told) {
            return measure_filters(test::repository(), quick ? quick_filters() : FilterOptions{}, told);
        });
    if (take("blurs")) {
        const BlursOptions options = quick ? quick_blurs() : BlursOptions{};
        measure(data, "blurs", "blurs",
                [&](const Told& told) { return measure_blurs(test::repository(), options, told); });
        measure(data, "blurs_compared", "ways to blur",
                [&](const Told& told) { return compare_blurs(test::repository(), options, told); });
    }
    if (take("povray") && has_povray())
        measure(data, "povray", "POV-Ray", [&](const Told& told) {
            return measure_povray(test::repository(), test::scratch_directory(),
                                  quick ? quick_povray() : PovrayOptions{}, told);
        });
    if (take("grids"))
        measure(data, "grids", "grids", [&](const Told& told) {
            return measure_grids(quick ? quick_grids() : GridsOptions{}, told);
        });
    if (take("searches"))
        measure(data, "searches", "searches", [&](const Told& told) {
            return measure_searches(quick ? quick_searches() : SearchesOptions{}, told);
        });
    if (take("stability"))
        measure(data, "stability", "stability", [&](const Told& told) {
            return measure_families(quick ? quick_families : FamiliesOptions{}, told);
        });
    if (!arguments.empty()) {
        fmt::print(stderr, "report_data: there is nothing called '{}' to measure\n", arguments.front());
        return 2;
    }
    write_file(file, data.dump(1) + "\n");
    return 0;
}

}  // namespace
}  // namespace rt::report

int main(int argc, char** argv) {
    try {
        return rt::report::run({argv + 1, argv + argc});
    } catch (const std::exception& error) {
        fmt::print(stderr, "report_data: {}\n", error.what());
        return 1;
    }
}
