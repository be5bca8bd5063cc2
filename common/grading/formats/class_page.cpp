// The instructor's page: what the template pages/class.mustache shows of a class.
#include "common/grading/formats/formats.hpp"
#include "common/grading/formats/parts.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/console.hpp"
#include "common/terminal/page.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <set>

namespace rt {
namespace {

constexpr std::size_t most_mistakes = 25, most_slowest = 10, most_links = 12;

/// Cells of the table take their colour from these.
std::string_view kind_of(Verdict verdict) {
    return verdict == Verdict::Passed ? "good"
           : is_skipped(verdict)      ? "todo"
           : is_error(verdict)        ? "stop"
                                      : "bad";
}

std::string id_of(std::size_t student) { return fmt::format("student-{}", student + 1); }

PageView link_to(const std::vector<Grade>& grades, std::size_t student) {
    return {{"student", id_of(student)}, {"who", grades[student].submission}};
}

std::string seconds_of(double seconds) { return fmt::format("{:.1f}", seconds); }

std::string megabytes_of(std::int64_t bytes) {
    return fmt::format("{:.0f}", static_cast<double>(bytes) / 1e6);
}

// ---------------------------------------------------------------------------------- steps against students

PageView cell(const GradedStep& step) {
    return {{"points", text_of(step.earned)},
            {"kind", kind_of(step.verdict)},
            {"verdict", name_of(step) + ": " + verdict_line(step)}};
}

PageView rows_of(const std::vector<Grade>& grades) {
    PageView rows = PageView::array();
    for (std::size_t i = 0; i < grades.size(); ++i) {
        PageView cells = PageView::array();
        for (const GradedStep& step : grades[i].steps) cells.push_back(cell(step));
        PageView row = link_to(grades, i);
        row["earned"] = text_of(earned(grades[i]));
        row["seconds"] = seconds_of(grades[i].seconds);
        row["megabytes"] = megabytes_of(grades[i].peak_bytes);
        row["cells"] = cells;
        rows.push_back(row);
    }
    return rows;
}

/// A row a step: how many students have which verdict, and the mean of their points.
PageView steps_of(const std::vector<Grade>& grades) {
    PageView steps = PageView::array();
    for (std::size_t k = 0; !grades.empty() && k < grades.front().steps.size(); ++k) {
        std::map<std::string_view, int> count;
        Points sum;
        for (const Grade& grade : grades) {
            ++count[kind_of(grade.steps[k].verdict)];
            sum += grade.steps[k].earned;
        }
        const GradedStep& step = grades.front().steps[k];
        const double mean = static_cast<double>(sum.hundredths) / 100 / static_cast<double>(grades.size());
        steps.push_back({{"id", step.id},
                         {"title", step.title},
                         {"possible", text_of(step.possible)},
                         {"extra", step.extra},
                         {"mean", fmt::format("{:.2f}", mean)},
                         {"passed", std::to_string(count["good"])},
                         {"failed", std::to_string(count["bad"])},
                         {"stopped", std::to_string(count["stop"])},
                         {"todo", std::to_string(count["todo"])}});
    }
    return steps;
}

// --------------------------------------------------------------------------------- what stands out

PageView links_to(const std::vector<Grade>& grades, const std::vector<std::size_t>& students) {
    PageView links = PageView::array();
    for (std::size_t i = 0; i < std::min(students.size(), most_links); ++i)
        links.push_back(link_to(grades, students[i]));
    return links;
}

/// The check that most fail with, first; hidden ones too.
PageView mistakes_of(const std::vector<Grade>& grades) {
    std::map<std::pair<std::string, std::string>, std::vector<std::size_t>> who;
    for (std::size_t i = 0; i < grades.size(); ++i)
        for (const GradedStep& step : grades[i].steps)
            for (const auto* failure : {&step.failure, &step.hidden_failure})
                if (*failure && !(*failure)->asked.empty()) who[{step.id, (*failure)->asked}].push_back(i);
    std::vector<std::pair<std::pair<std::string, std::string>, std::vector<std::size_t>>> sorted(who.begin(),
                                                                                                 who.end());
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const auto& a, const auto& b) { return a.second.size() > b.second.size(); });
    PageView mistakes = PageView::array();
    for (std::size_t i = 0; i < std::min(sorted.size(), most_mistakes); ++i) {
        const auto& [mistake, students] = sorted[i];
        const std::size_t more = students.size() - std::min(students.size(), most_links);
        mistakes.push_back({{"id", mistake.first},
                            {"asked", mistake.second},
                            {"count", std::to_string(students.size())},
                            {"who_all", links_to(grades, students)},
                            {"more", more == 0 ? "" : fmt::format("and {} more", more)}});
    }
    return mistakes;
}

PageView slowest_of(const std::vector<Grade>& grades) {
    std::vector<std::size_t> order(grades.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return grades[a].seconds > grades[b].seconds; });
    PageView slowest = PageView::array();
    for (std::size_t i = 0; i < std::min(order.size(), most_slowest); ++i) {
        PageView row = link_to(grades, order[i]);
        row["seconds"] = seconds_of(grades[order[i]].seconds);
        row["megabytes"] = megabytes_of(grades[order[i]].peak_bytes);
        slowest.push_back(row);
    }
    return slowest;
}

PageView stopped_of(const std::vector<Grade>& grades) {
    PageView stopped = PageView::array();
    for (std::size_t i = 0; i < grades.size(); ++i)
        for (const GradedStep& step : grades[i].steps) {
            if (!is_error(step.verdict)) continue;
            const auto& failure = step.failure ? step.failure : step.hidden_failure;
            PageView row = link_to(grades, i);
            const bool whole = step.verdict == Verdict::NotTaken;
            row["id"] = whole ? "all" : step.id;
            row["word"] = name_of(step.verdict);
            row["why"] = failure ? failure->said.substr(0, failure->said.find('\n')).substr(0, 200) : "";
            stopped.push_back(row);
            if (whole) break;
        }
    return stopped;
}

// ------------------------------------------------------------------------------------------ each student

PageView step_view(const GradedStep& step) {
    return {{"name", name_of(step)},
            {"word", name_of(step.verdict)},
            {"kind", kind_of(step.verdict)},
            {"points_line", points_line(step)},
            {"why", step.verdict == Verdict::Passed && step.late_percent == 100 ? "" : explained(step)},
            {"picture", step.difference.empty() ? "" : data_url(step.difference)}};
}

PageView students_of(const std::vector<Grade>& grades) {
    PageView students = PageView::array();
    for (std::size_t i = 0; i < grades.size(); ++i) {
        const Grade& grade = grades[i];
        PageView student = link_to(grades, i);
        student["earned"] = text_of(earned(grade));
        student["possible"] = text_of(possible(grade));
        student["submitted"] = grade.submitted ? text_of(*grade.submitted) : "";
        student["graded"] = text_of(grade.graded);
        student["isolation"] = grade.isolation;
        student["digest"] = grade.digest;
        student["seconds"] = seconds_of(grade.seconds);
        student["megabytes"] = megabytes_of(grade.peak_bytes);
        student["steps"] = PageView::array();
        for (const GradedStep& step : grade.steps) student["steps"].push_back(step_view(step));
        students.push_back(student);
    }
    return students;
}

/// The facts of the whole class.
PageView summary_of(const std::vector<Grade>& grades, const std::vector<std::string>& not_marked) {
    Points sum;
    double seconds = 0;
    std::set<std::string> levels;
    for (const Grade& grade : grades) {
        sum += earned(grade);
        seconds += grade.seconds;
        levels.insert(grade.isolation);
    }
    std::string isolation;
    for (const std::string& level : levels) isolation += (isolation.empty() ? "" : "; ") + level;
    const double count = std::max(1.0, static_cast<double>(grades.size()));
    return {{"submissions", counted(static_cast<long long>(grades.size()), "submission")},
            {"mean", fmt::format("{:.1f}", static_cast<double>(sum.hundredths) / 100 / count)},
            {"possible", grades.empty() ? "0" : text_of(possible(grades.front()))},
            {"seconds", duration(seconds)},
            {"each", fmt::format("{:.1f}", seconds / count)},
            {"seed", grades.empty() ? "" : std::to_string(grades.front().seed)},
            {"isolation", isolation},
            {"not_marked", fmt::format("{}", fmt::join(not_marked, ", "))}};
}

}  // namespace

std::string class_page(const std::vector<Grade>& grades, const std::vector<std::string>& not_marked) {
    return page_from("common/grading/pages/class.mustache",
                     {{"title", "The class at a glance"},
                      {"policy",
                       "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; "
                       "img-src data:"},
                      {"summary", summary_of(grades, not_marked)},
                      {"columns", steps_of(grades)},
                      {"rows", rows_of(grades)},
                      {"mistakes", mistakes_of(grades)},
                      {"slowest", slowest_of(grades)},
                      {"stopped", stopped_of(grades)},
                      {"students", students_of(grades)}});
}

}  // namespace rt
