// What students read about their class: the course's name, who teaches it, and when chapters are due.
#pragma once

#include "common/terminal/json_source.hpp"
#include "common/workbook/catalogue.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rt {

struct ClassFacts {
    std::string course;                      ///< its name; may be empty
    std::string instructor;                  ///< may be empty
    std::map<std::string, std::string> due;  ///< "2027-02-15" or "2027-02-15 23:59" by chapter, "02"
};

/// Reads what `to_json` makes: {"course": …, "instructor": …, "due": {"02": "2027-02-15"}}, all of which may
/// be left out. Throws InputError, with the place, for unknown keys, texts that are empty or of more than one
/// line, what is no chapter's number, and days that the calendar does not have.
ClassFacts class_facts(const JsonValue& value);

/// The same from a file. Throws InputError, also for a date of none of these chapters.
ClassFacts read_class_facts(const std::filesystem::path& file, const std::vector<Chapter>& chapters);

nlohmann::ordered_json to_json(const ClassFacts& facts);

}  // namespace rt
