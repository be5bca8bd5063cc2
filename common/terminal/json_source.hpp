// JSON that somebody wrote, read strictly: what is wrong is one line with its place and the keys that lead
// there.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rt {

/// A JSON text that is known to be one.
struct JsonSource {
    std::string name;  ///< of the file, for messages
    std::string text;
    nlohmann::json root;
};

/// Throws InputError, with the file's name, line and column, for what is not JSON, for a key that an object
/// has twice, and for values that are nested deeper than anything of ours.
JsonSource parse_json(std::string name, std::string text);

/// A value of a source, which must outlive it. What does not hold of the value is an InputError such as
/// "grading.json:5:17: steps/02.4/points: expected a whole number from 0 to 1000". Columns count characters.
struct JsonValue {
    const JsonSource* source = nullptr;
    const nlohmann::json* value = nullptr;
    std::string path;  ///< keys and indices that lead to it, "steps/02.4/points"; empty for the whole

    [[noreturn]] void fail(std::string_view what) const;

    bool has(std::string_view key) const;  ///< false also for what is no object
    JsonValue at(std::string_view key) const;
    std::vector<std::pair<std::string, JsonValue>> members() const;
    std::vector<JsonValue> items() const;
    /// Refuses every key that is not one of these.
    void only(const std::vector<std::string_view>& keys) const;

    std::string text() const;
    bool boolean() const;
    std::int64_t whole(std::int64_t least, std::int64_t greatest) const;
    std::uint64_t unsigned_whole() const;
    double number(double least, double greatest) const;
};

JsonValue root_of(const JsonSource& source);

}  // namespace rt
