// What an instructor wants of marks: points, parts of them, late work, extra credit, and what students see
// when.
#include "common/grading/rubric.hpp"

#include "common/terminal/json_source.hpp"
#include "common/terminal/project.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rt {
namespace {

Credit credit_from(const JsonValue& value) {
    const std::string word = value.text();
    if (word != "all" && word != "part") value.fail("expected \"all\" or \"part\"");
    return word == "all" ? Credit::All : Credit::Part;
}

Moment date_from(const JsonValue& value) {
    const std::optional<Moment> moment = moment_of(value.text());
    if (!moment)
        value.fail("expected a time with its distance from UTC, such as \"2027-03-01T23:59:00+01:00\"");
    return *moment;
}

std::vector<std::string> checks_from(const JsonValue& value) {
    std::vector<std::string> checks;
    for (const JsonValue& item : value.items()) {
        checks.push_back(item.text());
        if (checks.back().empty()) item.fail("expected a check's name, or a tag such as \"[stability]\"");
    }
    return checks;
}

void read_step(const JsonValue& value, StepRubric& step) {
    value.only({"points", "credit", "extra", "hidden"});
    if (value.has("points")) step.points = whole_points(value.at("points").whole(0, most_points));
    if (value.has("credit")) step.credit = credit_from(value.at("credit"));
    if (value.has("extra")) step.extra = value.at("extra").boolean();
    if (value.has("hidden"))
        for (const std::string& check : checks_from(value.at("hidden"))) step.hidden.push_back(check);
}

/// What holds for every step first, then what each says of its own.
void read_steps(const JsonValue& root, Rubric& rubric) {
    for (auto& [id, step] : rubric.steps) {
        if (root.has("credit")) step.credit = credit_from(root.at("credit"));
        if (root.has("hidden")) step.hidden = checks_from(root.at("hidden"));
    }
    if (!root.has("steps")) return;
    for (const auto& [id, value] : root.at("steps").members()) {
        const auto found = rubric.steps.find(id);
        if (found == rubric.steps.end()) value.fail("there is no such step");
        read_step(value, found->second);
    }
}

std::vector<LateRule> late_from(const JsonValue& value) {
    std::vector<LateRule> rules;
    for (const JsonValue& item : value.items()) {
        item.only({"hours", "percent"});
        const LateRule rule{item.at("hours").whole(1, 24 * 365),
                            static_cast<int>(item.at("percent").whole(0, 100))};
        if (!rules.empty() && rule.hours <= rules.back().hours)
            item.at("hours").fail("expected more hours than in the rule before");
        if (!rules.empty() && rule.percent > rules.back().percent)
            item.at("percent").fail("expected no more per cent than in the rule before");
        rules.push_back(rule);
    }
    return rules;
}

void read_dates(const JsonValue& root, const std::vector<Chapter>& chapters, Rubric& rubric) {
    // One without the other would be late work that nothing happens to, or rules that nothing falls under.
    if (root.has("due") != root.has("late"))
        root.at(root.has("due") ? "due" : "late").fail("needs 'due' and 'late' both");
    if (root.has("due")) {
        for (const auto& [number, value] : root.at("due").members()) {
            const bool known = std::any_of(
                chapters.begin(), chapters.end(),
                [&, &wanted = number](const Chapter& chapter) { return chapter.number == wanted; });
            if (!known) value.fail("there is no such chapter");
            rubric.due[number] = date_from(value);
        }
        rubric.late = late_from(root.at("late"));
    }
    if (!root.has("shown_from")) return;
    const JsonValue shown = root.at("shown_from");
    shown.only({"marks", "hidden"});
    if (shown.has("marks")) rubric.marks_from = date_from(shown.at("marks"));
    if (shown.has("hidden")) rubric.hidden_from = date_from(shown.at("hidden"));
}

}  // namespace

Rubric default_rubric(const std::vector<Chapter>& chapters) {
    Rubric rubric;
    for (const Chapter& chapter : chapters)
        for (const Step& step : chapter.steps) {
            rubric.steps[step.id].points = whole_points(step.points);
            rubric.steps[step.id].extra = step.optional;
        }
    return rubric;
}

Rubric read_rubric(const std::string& file, const std::string& text, const std::vector<Chapter>& chapters) {
    const JsonSource source = parse_json(file, text);
    const JsonValue root = root_of(source);
    root.only({"version", "credit", "hidden", "steps", "due", "late", "shown_from"});
    root.at("version").whole(1, 1);
    Rubric rubric = default_rubric(chapters);
    read_steps(root, rubric);
    read_dates(root, chapters, rubric);
    return rubric;
}

std::string digest_of(const Rubric& rubric) {
    std::string all;
    for (const auto& [id, step] : rubric.steps) {
        all +=
            fmt::format("{} {} {} {}\n", id, step.points.hundredths, step.credit == Credit::Part, step.extra);
        for (const std::string& check : step.hidden) all += "hidden " + check + "\n";
    }
    for (const auto& [chapter, due] : rubric.due) all += fmt::format("due {} {}\n", chapter, text_of(due));
    for (const LateRule& rule : rubric.late) all += fmt::format("late {} {}\n", rule.hours, rule.percent);
    return fingerprint(all);
}

int late_percent(const Rubric& rubric, const std::string& chapter, const std::optional<Moment>& submitted) {
    const auto due = rubric.due.find(chapter);
    if (due == rubric.due.end() || !submitted || *submitted <= due->second) return 100;
    for (const LateRule& rule : rubric.late)
        if (*submitted - due->second <= std::chrono::hours(rule.hours)) return rule.percent;
    return 0;
}

}  // namespace rt
