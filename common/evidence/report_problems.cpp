// What of the report's data breaks a demand.
#include "common/evidence/report.hpp"

#include <fmt/format.h>

namespace rt {
namespace {

using Problems = std::vector<std::string>;

std::string text(const ReportData& value) { return value; }
long long number(const ReportData& value) { return value; }

void add_kernels(Problems& problems, const ReportData& kernels) {
    for (const auto& row : kernels.at("rows"))
        if (row.at("course") && (row.at("wrong") > 0 || row.at("error_max") > 8))
            problems.push_back(fmt::format(
                "the course's {} is wrong in {} of {} cases, and off by up to {:.3g} κu; 8 are allowed",
                text(row.at("shape")), number(row.at("wrong")), number(row.at("cases")),
                row.at("error_max").get<double>()));
}

/// The error of a curve's first point, or its last.
double first_error(const ReportData& curve) { return curve.at("points").front().at("error"); }
double last_error(const ReportData& curve) { return curve.at("points").back().at("error"); }

/// Of one sample each, what is filtered more is less wrong than four texels; more samples help everybody.
void add_filters(Problems& problems, const ReportData& scenes) {
    for (const auto& scene : scenes) {
        double bilinear = 0;
        for (const auto& curve : scene.at("curves"))
            if (curve.at("method") == "bilinear") bilinear = first_error(curve);
        for (const auto& curve : scene.at("curves")) {
            const std::string method = curve.at("method");
            if ((method == "trilinear" || method == "anisotropic") && !(first_error(curve) < bilinear))
                problems.push_back(fmt::format(
                    "textures by {}: one sample a pixel is wrong by {:.3g}, and a bilinear one by {:.3g}",
                    method, first_error(curve), bilinear));
            if (!(last_error(curve) < first_error(curve)))
                problems.push_back(fmt::format(
                    "textures by {}: {} samples a pixel are wrong by {:.3g}, and one by {:.3g}", method,
                    number(curve.at("points").back().at("asked")), last_error(curve), first_error(curve)));
        }
    }
}

/// Renders of what blurs know how wrong they are, within a factor 1.5, whatever the sampler.
void add_blurs(Problems& problems, const ReportData& scenes) {
    for (const auto& scene : scenes)
        for (const auto& curve : scene.at("curves"))
            for (const auto& point : curve.at("points")) {
                const double error = point.at("error"), stated = point.at("estimate");
                if (!(error <= 1.5 * stated && stated <= 1.5 * error))
                    problems.push_back(
                        fmt::format("{}, {}, {} samples a pixel: wrong by {:.3g}, and the renders say {:.3g}",
                                    text(scene.at("title")), text(curve.at("method")),
                                    number(point.at("asked")), error, stated));
            }
}

void add_grids(Problems& problems, const ReportData& grids) {
    for (const auto& point : grids.at("points"))
        if (point.at("different") > 0)
            problems.push_back(
                fmt::format("a grid over {:.0f} triangles answers {} of {} rays differently from brute force",
                            point.at("triangles").get<double>(), number(point.at("different")),
                            number(point.at("brute_rays"))));
}

void add_searches(Problems& problems, const ReportData& searches) {
    for (const auto& point : searches)
        if (point.at("different") > 0)
            problems.push_back(fmt::format("{}, {}: {} of {} rays are answered differently from brute force",
                                           text(point.at("scene")), text(point.at("way")),
                                           number(point.at("different")), number(point.at("compared"))));
}

void add_stability(Problems& problems, const ReportData& rows) {
    for (const auto& row : rows) {
        const auto& stable = row.at("stable");
        if (stable.at("wrong") > 0)
            problems.push_back(fmt::format("chapter {}, {}, {}: {} of {} cases are wrong; the plainest: {}",
                                           text(row.at("chapter")), text(row.at("question")),
                                           text(row.at("family")), number(stable.at("wrong")),
                                           number(stable.at("cases")), text(stable.at("first_wrong"))));
    }
}

void add_leave_out(Problems& problems, const ReportData& rows) {
    for (const auto& row : rows) {
        const auto& counts = row.at("instructions");
        if (row.at("judged") && counts.at("general") > counts.at("limit"))
            problems.push_back(fmt::format("a scene without {} takes {} instructions; {} are allowed",
                                           text(row.at("feature")), number(counts.at("general")),
                                           number(counts.at("limit"))));
    }
}

}  // namespace

std::vector<std::string> report_problems(const ReportData& data) {
    Problems problems;
    if (data.contains("kernels")) add_kernels(problems, data.at("kernels"));
    if (data.contains("filters")) add_filters(problems, data.at("filters"));
    if (data.contains("blurs")) add_blurs(problems, data.at("blurs"));
    if (data.contains("grids")) add_grids(problems, data.at("grids"));
    if (data.contains("searches")) add_searches(problems, data.at("searches"));
    if (data.contains("stability")) add_stability(problems, data.at("stability"));
    if (data.contains("leave_out")) add_leave_out(problems, data.at("leave_out"));
    return problems;
}

}  // namespace rt
