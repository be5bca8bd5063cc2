// What students read about their class: the course's name, who teaches it, and when chapters are due.
#include "common/handout/class_facts.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/pattern.hpp"

#include <algorithm>
#include <chrono>

namespace rt {

namespace {

/// A text of one line. It goes into a page, between the bars of a table's row, and into a commit.
std::string line_of_text(const JsonValue& value) {
    std::string text = value.text();
    if (text.empty() || text != printable(text) || text.find_first_of("|<>") != std::string::npos)
        value.fail("expected a text of one line without | < >");
    return text;
}

bool is_day(int year, int month, int day) { return (std::chrono::year(year) / month / day).ok(); }

std::string date_of(const JsonValue& value) {
    std::string text = value.text();
    const auto parts = parts_of(text, "(\\d{4})-(\\d\\d)-(\\d\\d)( ([01]\\d|2[0-3]):[0-5]\\d)?");
    if (!parts || !is_day(std::stoi(parts->at(1)), std::stoi(parts->at(2)), std::stoi(parts->at(3))))
        value.fail("expected a day such as 2027-02-15, or with a time, 2027-02-15 23:59");
    return text;
}

}  // namespace

ClassFacts class_facts(const JsonValue& value) {
    value.only({"course", "instructor", "due"});
    ClassFacts facts;
    if (value.has("course")) facts.course = line_of_text(value.at("course"));
    if (value.has("instructor")) facts.instructor = line_of_text(value.at("instructor"));
    if (!value.has("due")) return facts;
    for (const auto& [number, date] : value.at("due").members()) {
        if (!parts_of(number, "\\d\\d")) date.fail("expected a chapter's number as key, such as 02");
        facts.due[number] = date_of(date);
    }
    return facts;
}

ClassFacts read_class_facts(const std::filesystem::path& file, const std::vector<Chapter>& chapters) {
    const JsonSource source = parse_json(file.string(), read_file(file));
    const JsonValue root = root_of(source);
    const ClassFacts facts = class_facts(root);
    for (const auto& [number, date] : facts.due)
        if (std::ranges::find(chapters, number, &Chapter::number) == chapters.end())
            root.at("due").at(number).fail("there is no such chapter");
    return facts;
}

nlohmann::ordered_json to_json(const ClassFacts& facts) {
    auto value = nlohmann::ordered_json::object();
    if (!facts.course.empty()) value["course"] = facts.course;
    if (!facts.instructor.empty()) value["instructor"] = facts.instructor;
    if (!facts.due.empty()) value["due"] = facts.due;
    return value;
}

}  // namespace rt
