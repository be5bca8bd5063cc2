// The report's page: short explanations, figures that name their command, and tables.
#include "common/terminal/console.hpp"
#include "common/pictures/page.hpp"
#include "common/evidence/report_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rt {

std::string number_text(const ReportData& number) {
    if (!number.is_number()) return "–";
    const double x = number;
    if (x == 0) return "0";
    const int exponent = static_cast<int>(std::floor(std::log10(std::abs(x))));
    if (number.is_number_integer() || (exponent >= 3 && exponent < 9)) {
        // Groups of three digits, a thin space between them.
        std::string text = fmt::format("{:.0f}", std::abs(x));
        for (std::size_t at = text.size(); at > 3;) text.insert(at -= 3, "\u2009");
        return (x < 0 ? "−" : "") + text;
    }
    if (exponent >= -3 && exponent < 3) {
        std::string text = fmt::format("{:.{}f}", x, std::max(0, 2 - exponent));
        return text.starts_with('-') ? "−" + text.substr(1) : text;
    }
    std::string raised;
    constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    for (const char c : fmt::format("{}", exponent)) raised += c == '-' ? "⁻" : digits[c - '0'];
    return fmt::format("{:.1f}\u2009·\u200910{}", x / std::pow(10, exponent), raised);
}

namespace {

std::string words(const ReportData& text) { return html(std::string(text)); }

/// A table that scrolls in a box of its own; cells are HTML, the first of each row is its name.
std::string table(std::string_view label, const std::vector<std::string>& heads,
                  const std::vector<std::vector<std::string>>& rows) {
    std::string text = fmt::format(
        "<div class=\"card scroll\" tabindex=\"0\" role=\"region\" aria-label=\"{0}\">\n<table>\n<caption>{0}"
        "</caption>\n<thead><tr>",
        html(label));
    for (const std::string& head : heads) text += "<th scope=\"col\">" + head + "</th>";
    text += "</tr></thead>\n<tbody>\n";
    for (const std::vector<std::string>& row : rows) {
        text += "<tr><th scope=\"row\">" + row.front() + "</th>";
        for (std::size_t i = 1; i < row.size(); ++i) text += "<td>" + row[i] + "</td>";
        text += "</tr>\n";
    }
    return text + "</tbody>\n</table>\n</div>\n";
}

std::string link(const std::string& file) { return fmt::format("<a href=\"{0}\">{0}</a>", html(file)); }

struct Page {
    const ReportData& data;
    const std::vector<ReportPlot>& plots;
    const std::string& command;

    /// The plot with this name; `caption` is HTML.
    std::string plot(const std::string& name, const std::string& caption) const {
        const auto at = std::ranges::find(plots, name, &ReportPlot::name);
        if (at == plots.end()) return "";
        return fmt::format(
            "<figure class=\"card plot\"><div class=\"scroll\" tabindex=\"0\" role=\"region\" "
            "aria-label=\"{1}\"><img "
            "src=\"{0}.svg\" alt=\"{1}\" width=\"{2}\" height=\"{3}\"></div>\n<figcaption>{4} <span "
            "class=\"made\">Made "
            "by <code>{5}</code> from {6} with {7}.</span></figcaption></figure>\n",
            html(name), html(at->alt), at->width, at->height, caption, html(command), link(at->table),
            link(name + ".gp"));
    }
    std::string kernels() const;
    std::string pictures() const;
    std::string grids() const;
    std::string stability() const;
    std::string leave_out() const;
    std::string honesty() const;
    std::string machine() const;
};

std::string Page::machine() const {
    const ReportData& here = data.at("machine");
    const std::string measured = data.contains("seconds") ? [&] {
        double sum = 0;
        for (const auto& part : data.at("seconds")) sum += part.get<double>();
        return duration(sum);
    }() : std::string("–");
    return html_facts({{"command", command},
                       {"processor", here.at("processor")},
                       {"cores", number_text(here.at("cores"))},
                       {"compiler", here.at("compiler")},
                       {"load when it began", number_text(here.at("load"))},
                       {"time of measuring", measured}});
}

std::string Page::kernels() const {
    const ReportData& measured = data.at("kernels");
    std::string text =
        "<h2 id=\"kernels\">One intersection: error against time</h2>\n"
        "<p>Each point is a method of finding t, where a ray meets a sphere or a triangle. To the right is "
        "slower, "
        "up is more wrong: the corner at the lower left is where one wants to be. Dots are the greatest "
        "error, crosses "
        "the one that only 1 case in 10 000 exceeds, and the line reaches down to the median. The unit is "
        "κu|t|: what "
        "rounding the data alone, by a relative u = 2⁻⁵³, does to t. Methods are judged by exact "
        "arithmetic.</p>\n"
        "<div class=\"plots\">\n" +
        plot("kernels_sphere", fmt::format("Spheres: {}.", words(measured.at("sphere_family")))) +
        plot("kernels_triangle", fmt::format("Triangles: {}.", words(measured.at("triangle_family")))) +
        "</div>\n";
    const auto& rows = measured.at("rows");
    for (const auto* shape : {"sphere", "triangle"}) {
        std::vector<std::vector<std::string>> cells;
        for (const auto& row : rows) {
            if (row.at("shape") != shape) continue;
            const std::string name = words(row.at("method"));
            cells.push_back({row.at("course") ? "<strong>" + name + "</strong>, the course's" : name,
                             words(row.at("number")), number_text(row.at("ns")),
                             number_text(row.at("error_median")), number_text(row.at("error_9999")),
                             number_text(row.at("error_max")), number_text(row.at("wrong")),
                             number_text(row.at("undecided"))});
        }
        text += table(fmt::format("{} cases with a {}", number_text(rows.front().at("cases")), shape),
                      {"method", "numbers", "ns a call", "median error, κu", "99.99 %", "greatest",
                       "wrong hit or miss", "undecided"},
                      cells);
    }
    text +=
        "<p>A call goes through a pointer to a function, for all methods alike. A hit or miss is wrong where "
        "moving the "
        "data by 4 ulp could not excuse it. Intervals never lie: where they can't decide they say so, and "
        "their error "
        "is half the width of what they promise. More digits do not save the textbook formula for spheres: "
        "it wants "
        "twice as many as the answer has.</p>\n"
        "<h3>Where digits are lost</h3>\n" +
        plot("kernels_map",
             "Correct decimal digits of t, the worst of some rays a cell. To the right the sphere is farther "
             "away, "
             "downwards the ray comes nearer to its rim. Grey: 4 ulp of the data decide between hit and "
             "miss. On the "
             "right is what rounding the data alone would leave.");
    return text;
}

std::string Page::pictures() const {
    std::string text =
        "<h2 id=\"pictures\">Pictures: error against time</h2>\n"
        "<p>The same for whole pictures: CPU time of a render on one thread, and the root mean square of its "
        "error over all pixels and channels, linear. The numbers are exponents of the number of samples, "
        "with "
        "their 95 % confidence, and in brackets the theory's.</p>\n"
        "<ul class=\"notes\">\n"
        "<li>Random samples err by n<sup>−1/2</sup>, whatever the picture.</li>\n"
        "<li>Jittered ones err by n<sup>−3/4</sup> on edges and by 1/n where the picture is smooth; most "
        "pictures are in between.</li>\n"
        "<li>Regular ones err by 1/n where it is smooth. On edges nobody promises anything: the same pattern "
        "falls on each edge in its own way, and the curve is no straight line.</li>\n"
        "<li>Poisson disk samples are made for the picture, 64 patterns for all its pixels; the time "
        "includes "
        "that.</li>\n"
        "<li>Adaptive sampling changes the factor and not the exponent. Its curve looks steeper because the "
        "part of the samples that it spends on looking around becomes smaller.</li>\n"
        "</ul>\n<div class=\"plots\">\n";
    for (const auto& scene : data.at("pictures")) {
        const std::string truth =
            scene.at("analytic")
                ? "The truth is a formula."
                : fmt::format(
                      "The truth is a render of {} samples a pixel with a standard error of {}, {:.0f} times "
                      "better than the best point.",
                      number_text(scene.at("truth_samples")), number_text(scene.at("truth_error")),
                      scene.at("best").get<double>() / scene.at("truth_error").get<double>());
        std::string stopped;
        for (const auto& curve : scene.at("curves"))
            if (const std::string by = curve.at("stopped"); !by.empty() && !by.starts_with("nothing"))
                stopped += fmt::format(" The curve of {} becomes flat: what stops it is {}.",
                                       words(curve.at("method")), html(by));
        text += plot("pictures_" + std::string(scene.at("name")),
                     fmt::format("{} (chapter {}, {} × {} pixels). {}{}", words(scene.at("title")),
                                 words(scene.at("chapter")), scene.at("width").get<int>(),
                                 scene.at("height").get<int>(), truth, stopped));
    }
    text += "</div>\n";
    std::vector<std::vector<std::string>> cells;
    const auto law = [](const ReportData& fit) {
        return fmt::format("{} [{}, {}]", number_text(fit.at("slope")), number_text(fit.at("low")),
                           number_text(fit.at("high")));
    };
    for (const auto& scene : data.at("pictures"))
        for (const auto& curve : scene.at("curves")) {
            if (curve.at("points").size() < 2) continue;
            cells.push_back({words(scene.at("title")), words(curve.at("method")),
                             curve.at("theory") == 0 ? "–" : number_text(curve.at("theory")),
                             law(curve.at("by_samples")), law(curve.at("by_seconds")),
                             words(curve.at("stopped"))});
        }
    text += table("Exponents of the error, with their 95 % confidence intervals",
                  {"scene", "method", "theory", "against samples", "against seconds", "what stops the curve"},
                  cells);
    return text + honesty();
}

std::string Page::honesty() const {
    struct Band {
        std::string method;
        int points = 0, within = 0;
        double low = 1e9, high = 0;
    };
    std::vector<Band> bands;
    for (const auto& scene : data.at("pictures"))
        for (const auto& curve : scene.at("curves"))
            for (const auto& point : curve.at("points")) {
                const double estimate = point.at("estimate");
                if (!(estimate > 0)) continue;
                const double ratio = point.at("error").get<double>() / estimate;
                auto at = std::ranges::find(bands, std::string(curve.at("method")), &Band::method);
                if (at == bands.end()) at = bands.insert(at, Band{curve.at("method"), 0, 0, 1e9, 0});
                ++at->points;
                at->within += ratio >= 1 / 1.5 && ratio <= 1.5;
                at->low = std::min(at->low, ratio);
                at->high = std::max(at->high, ratio);
            }
    std::vector<std::vector<std::string>> cells;
    for (const Band& band : bands)
        cells.push_back({html(band.method), fmt::format("{} of {}", band.within, band.points),
                         number_text(band.low), number_text(band.high)});
    return "<h3>Does a render know how wrong it is?</h3>\n"
           "<p>Each render of several samples a pixel estimates its own error from independent patterns. "
           "Below is the "
           "true error over that estimate, all scenes and all numbers of samples together; the demand is a "
           "factor "
           "1.5.</p>\n<div class=\"plots\">\n" +
           plot("honesty",
                "True over estimated error; a point is one scene, one method and one number of samples, all "
                "repeats together. Points at the lower rim lie below it.") +
           table("True over estimated error", {"method", "within 1.5", "least", "greatest"}, cells) +
           "</div>\n";
}

std::string Page::grids() const {
    const ReportData& measured = data.at("grids");
    std::string text =
        "<h2 id=\"grids\">Grids: what building one costs, and when it pays</h2>\n"
        "<p>A dented ball of ever more triangles, and rays at it from all sides; one thread. Every answer of "
        "the grid was "
        "compared with that of asking every triangle, to the bit, for as many rays as that is "
        "affordable.</p>\n"
        "<div class=\"plots\">\n" +
        plot("grids_rays",
             "Rays a second with a grid and without, and how the time of a ray grows with the number N of "
             "triangles.") +
        plot("grids_build",
             "Time to build, and (right axis) the number of rays from which on building and tracing is "
             "faster than asking every triangle.") +
        "</div>\n";
    std::vector<std::vector<std::string>> cells;
    for (const auto& point : measured.at("points"))
        cells.push_back({number_text(static_cast<long long>(point.at("triangles").get<double>())),
                         number_text(point.at("build_seconds").get<double>() * 1e3),
                         number_text(point.at("grid_ns")), number_text(point.at("brute_ns")),
                         number_text(point.at("brute_ns").get<double>() / point.at("grid_ns").get<double>()),
                         number_text(static_cast<long long>(point.at("break_even").get<double>())),
                         number_text(point.at("cells")), number_text(point.at("asked")),
                         number_text(point.at("bytes")),
                         fmt::format("{} of {}", number_text(point.at("different")),
                                     number_text(point.at("brute_rays")))});
    return text +
           table("Grids over a dented ball",
                 {"triangles", "build, ms", "ns a ray", "without grid", "times faster", "pays from, rays",
                  "cells a ray", "triangles asked a ray", "bytes a triangle", "answers that differ"},
                 cells);
}

std::string Page::stability() const {
    std::string text =
        "<h2 id=\"stability\">Stability: families made to break a method</h2>\n"
        "<p>Random cases at the edge of what numbers can hold, judged by exact arithmetic. <em>Too "
        "close</em> are cases "
        "where 4 ulp of the data decide, so that both answers are right. <em>Worst</em> is the greatest "
        "error of all, in "
        "units of the demand: 1 would just be allowed. The textbook's method is asked a tenth of the cases, "
        "and has to "
        "fail somewhere: else the families show nothing.</p>\n";
    std::string chapter, details;
    std::vector<std::vector<std::string>> cells;
    const auto finish = [&] {
        if (cells.empty()) return;
        text += table(
            "Chapter " + chapter,
            {"family", "question", "cases", "too close", "wrong", "worst", "demand", "textbook wrong", "of"},
            cells);
        if (!details.empty())
            text += "<details><summary>Worst cases of chapter " + chapter +
                    ", as hexadecimal floats</summary>\n<dl class=\"cases\">\n" + details +
                    "</dl></details>\n";
        cells.clear();
        details.clear();
    };
    for (const auto& row : data.at("stability")) {
        if (row.at("chapter") != chapter) finish();
        chapter = row.at("chapter");
        const auto &stable = row.at("stable"), &naive = row.at("naive");
        const bool measured = !std::string(row.at("demand")).empty();
        cells.push_back({words(row.at("family")), words(row.at("question")), number_text(stable.at("cases")),
                         number_text(stable.at("undecided")),
                         html_verdict(stable.at("wrong") == 0, number_text(stable.at("wrong"))),
                         measured ? number_text(stable.at("worst")) : "–",
                         measured ? words(row.at("demand")) : "right", number_text(naive.at("wrong")),
                         number_text(naive.at("cases"))});
        if (!std::string(stable.at("worst_case")).empty())
            details +=
                fmt::format("<div><dt>{}, {}</dt><dd><code>{}</code></dd></div>\n", words(row.at("question")),
                            words(row.at("family")), words(stable.at("worst_case")));
    }
    finish();
    return text + fmt::format(
                      "<p class=\"quiet\">Made by <code>{}</code>; all of it, condition numbers and textbook "
                      "methods too, is in {}.</p>\n",
                      html(command), link("stability.csv"));
}

std::string Page::leave_out() const {
    std::string text =
        "<h2 id=\"leave-out\">What a scene does not need</h2>\n"
        "<p>For each feature a scene that does without it is drawn by the course's renderer and by one "
        "written by hand for "
        "just that scene; valgrind counts their instructions. Allowed are 1 % more, or 8 instructions a ray, "
        "whichever "
        "is more.</p>\n" +
        plot("leave_out", "Instructions over those of the minimal renderer; the red bar is what is allowed.");
    std::vector<std::vector<std::string>> cells;
    for (const auto& row : data.at("leave_out")) {
        const auto &counts = row.at("instructions"), &rays = row.at("rays").at("minimal");
        double all = 0;
        for (const auto& kind : rays) all += kind.get<double>();
        const double general = counts.at("general"), minimal = counts.at("minimal");
        const bool good = counts.at("general") <= counts.at("limit");
        cells.push_back({words(row.at("feature")), number_text(general / all), number_text(minimal / all),
                         row.at("judged") ? html_verdict(good, fmt::format("{:.4f}", general / minimal))
                                          : fmt::format("{:.4f}, not judged", general / minimal),
                         fmt::format("{:.4f}", counts.at("limit").get<double>() / minimal),
                         fmt::format("{:.2f}", counts.at("with_feature").get<double>() / general),
                         number_text(row.at("bytes").at("general")),
                         number_text(row.at("bytes").at("with_feature"))});
    }
    return text + table("A scene without …",
                        {"feature", "instructions a ray", "minimal renderer", "ratio", "allowed",
                         "times more with it", "bytes of the world", "with it"},
                        cells);
}

}  // namespace

std::string report_page(const ReportData& data, const std::vector<ReportPlot>& plots,
                        const std::string& command) {
    const Page page{data, plots, command};
    std::string links, body;
    const auto add = [&](const char* key, const char* id, const char* name,
                         std::string (Page::*part)() const) {
        if (!data.contains(key)) return;
        links += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", id, name);
        body += "<section>\n" + (page.*part)() + "</section>\n";
    };
    add("kernels", "kernels", "One intersection", &Page::kernels);
    add("pictures", "pictures", "Pictures", &Page::pictures);
    add("grids", "grids", "Grids", &Page::grids);
    add("stability", "stability", "Stability", &Page::stability);
    add("leave_out", "leave-out", "Leaving out", &Page::leave_out);

    const auto& problems = data.at("problems");
    std::string verdict = "<p>" +
                          html_verdict(problems.empty(), problems.empty() ? "every demand is met"
                                                                          : "some demands are not met") +
                          "</p>\n";
    if (!problems.empty()) {
        verdict += "<ul>\n";
        for (const auto& problem : problems) verdict += "<li class=\"problem\">" + words(problem) + "</li>\n";
        verdict += "</ul>\n";
    }
    const std::string quick =
        data.at("quick").get<bool>()
            ? "<p class=\"quiet\">A quick report: fewer cases, smaller pictures, smaller grids. Without "
              "<code>--quick</code> it takes about five minutes and is to be trusted more.</p>\n"
            : "";
    return html_page("Measured: a ray tracing course",
                     "<header>\n<h1>How wrong, how long, and where it breaks</h1>\n"
                     "<p class=\"quiet\">Measurements of the ray tracing course, all from one run on one "
                     "machine.</p>\n" +
                         quick + verdict + page.machine() + "<nav aria-label=\"Parts\"><ul>\n" + links +
                         "</ul></nav>\n</header>\n<main>\n" + body + "</main>\n");
}

}  // namespace rt
