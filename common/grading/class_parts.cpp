// A class marked in parts, at once or on several machines, and put together again.
#include "common/grading/class_parts.hpp"

#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/terminal/project.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <set>

namespace rt {

namespace {

constexpr int most_parts = 100'000;

/// The number from 1 on that is all of the text, or 0.
int number_in(std::string_view text) {
    int number = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() && stop == text.data() + text.size() ? std::max(number, 0) : 0;
}

std::string list_of(std::vector<std::string> names) {
    std::sort(names.begin(), names.end());
    return fingerprint(fmt::format("{}", fmt::join(names, "/")));  // no name has a slash in it
}

[[noreturn]] void refuse(const std::string& line) { throw InputError(printable(line)); }

/// "01.1, 01.2".
std::string steps_of(const Grade& grade) {
    std::vector<std::string> ids;
    for (const GradedStep& step : grade.steps) ids.push_back(step.id);
    return fmt::format("{}", fmt::join(ids, ", "));
}

/// What makes these two grades no grades of one class, or nothing.
std::string difference(const Grade& a, const Grade& b) {
    if (a.rubric != b.rubric) return "with another rubric";
    if (a.seed != b.seed) return "with another seed";
    if (a.isolation != b.isolation)
        return fmt::format("at another level of isolation ({}, not {})", b.isolation, a.isolation);
    if (steps_of(a) != steps_of(b)) return "with other steps";
    return "";
}

/// Refuses files that are not all the parts of one class.
void require_all_parts(const std::vector<GradesFile>& files) {
    const auto is_part = [](const GradesFile& file) { return file.part.has_value(); };
    const auto first = std::find_if(files.begin(), files.end(), is_part);
    if (first == files.end()) return;
    const auto about = [](const GradesFile& file) {
        if (!file.part) return file.name + " is no part of a class";
        return fmt::format("{} is part {} of {}", file.name, file.part->number, file.part->count);
    };
    std::map<int, const GradesFile*> there;
    for (const GradesFile& file : files) {
        if (!file.part || file.part->count != first->part->count)
            refuse(fmt::format("{}, and {}", about(file), about(*first)));
        if (file.part->list != first->part->list)
            refuse(fmt::format("{} is a part of other submissions than {}", file.name, first->name));
        const auto [other, is_new] = there.try_emplace(file.part->number, &file);
        if (!is_new) refuse(fmt::format("{}, and so is {}", about(*other->second), file.name));
    }
    std::vector<int> missing;
    for (int number = 1; number <= first->part->count && missing.size() < 10; ++number)
        if (!there.contains(number)) missing.push_back(number);
    if (!missing.empty())
        refuse(fmt::format("{}, and there is no part {}", about(*first), fmt::join(missing, ", ")));
}

}  // namespace

ClassPart part_named(std::string_view text, const std::vector<std::string>& names) {
    const auto slash = text.find('/');
    const int number = number_in(text.substr(0, slash));
    const int count = slash == std::string_view::npos ? 0 : number_in(text.substr(slash + 1));
    if (number < 1 || number > count || count > most_parts)
        refuse(fmt::format("there is no part '{}' of a class; the second of seven is 2/7", text));
    return {number, count, list_of(names)};
}

bool is_in(const ClassPart& part, std::size_t position) {
    return position % static_cast<std::size_t>(part.count) == static_cast<std::size_t>(part.number - 1);
}

std::vector<Grade> merged(const std::vector<GradesFile>& files) {
    require_all_parts(files);
    std::vector<std::pair<const Grade*, const std::string*>> all;
    for (const GradesFile& file : files)
        for (const Grade& grade : file.grades) all.emplace_back(&grade, &file.name);
    std::stable_sort(all.begin(), all.end(),
                     [](const auto& a, const auto& b) { return a.first->submission < b.first->submission; });

    std::vector<Grade> grades;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Grade& grade = *all[i].first;
        const auto& [first, first_file] = all[0];
        const std::string subject = fmt::format("{}: the submission '{}'", *all[i].second, grade.submission);
        if (i > 0 && all[i - 1].first->submission == grade.submission) {
            const std::string& other = *all[i - 1].second;
            refuse(subject + (other == *all[i].second ? " is there twice" : " is also in " + other));
        }
        if (const std::string other = difference(*first, grade); !other.empty())
            refuse(fmt::format("{} was marked {} than '{}' in {}", subject, other, first->submission,
                               *first_file));
        grades.push_back(grade);
    }
    return grades;
}

std::vector<std::string> not_marked_in(const std::vector<GradesFile>& files) {
    std::set<std::string> names;
    for (const GradesFile& file : files) names.insert(file.not_marked.begin(), file.not_marked.end());
    for (const GradesFile& file : files)
        for (const Grade& grade : file.grades) names.erase(grade.submission);
    return {names.begin(), names.end()};
}

}  // namespace rt
