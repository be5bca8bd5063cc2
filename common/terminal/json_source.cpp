// JSON that somebody wrote, read strictly: what is wrong is one line with its place and the keys that lead
// there.
#include "common/terminal/json_source.hpp"

#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

namespace rt {

using nlohmann::json;

namespace {

/// Nothing of ours is nested deeper than 6; this keeps whoever walks through a text off the stack's end.
constexpr int deepest = 32;

/// Some editors write it in front of UTF-8; it is no part of the text.
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

/// "file:line:column: what", for a place in bytes from the text's beginning.
[[noreturn]] void fail_at(const JsonSource& source, std::size_t offset, std::string_view what) {
    const std::string_view before = std::string_view(source.text).substr(0, offset);
    const auto newline = before.rfind('\n');
    const std::string_view line = newline == std::string_view::npos ? before : before.substr(newline + 1);
    throw InputError(
        printable(at_place(source.name, 1 + std::count(before.begin(), before.end(), '\n'),
                           1 + std::ranges::count(line, false, continues_utf8), std::string(what))));
}

/// The library reads JSON and forgets where each value stood. This goes through a text that is known to be
/// JSON, so it needs no care for any other, and tells the place of every value, and of keys that an object
/// has twice.
struct JsonWalk {
    std::string_view text;
    std::function<void(const std::string&path, std::size_t offset)> value_at, repeated_at;
    std::size_t at = 0;
    std::string path{};

    void skip_space() { at = std::min(text.find_first_not_of(" \t\r\n", at), text.size()); }

    /// The string that begins here, with its quotes, as it is written.
    std::string_view string() {
        const std::size_t begin = at++;
        while (text[at] != '"') at += text[at] == '\\' ? 2 : 1;
        ++at;
        return text.substr(begin, at - begin);
    }

    std::string key() {
        const std::string_view written = string();
        const bool plain = written.find('\\') == std::string_view::npos;
        return plain ? std::string(written.substr(1, written.size() - 2))
                     : json::parse(written).get<std::string>();
    }

    void inside(const std::string& name, std::size_t offset, bool repeated) {
        const std::size_t length = path.size();
        path += (path.empty() ? "" : "/") + name;
        if (repeated) repeated_at(path, offset);
        value();
        path.resize(length);
    }

    void members() {
        std::set<std::string> keys;
        for (++at, skip_space(); text[at] != '}'; skip_space()) {
            if (text[at] == ',') ++at;
            skip_space();
            const std::size_t begin = at;
            const auto [name, is_new] = keys.insert(key());
            skip_space();
            ++at;  // the colon
            inside(*name, begin, !is_new);
        }
        ++at;
    }

    void items() {
        int index = 0;
        for (++at, skip_space(); text[at] != ']'; skip_space()) {
            if (text[at] == ',') ++at;
            inside(std::to_string(index++), at, false);
        }
        ++at;
    }

    void value() {
        skip_space();
        value_at(path, at);
        if (text[at] == '{') {
            members();
        } else if (text[at] == '[') {
            items();
        } else if (text[at] == '"') {
            string();
        } else {
            at = std::min(text.find_first_of(" \t\r\n,]}", at), text.size());
        }
    }
};

JsonWalk walk_through(const JsonSource& source) {
    const auto nothing = [](const std::string&, std::size_t) {};
    return {source.text, nothing, nothing};
}

void refuse_repeated_keys(const JsonSource& source) {
    JsonWalk walk = walk_through(source);
    walk.repeated_at = [&](const std::string& path, std::size_t offset) {
        fail_at(source, offset, path + ": is there twice");
    };
    walk.value();
}

std::size_t offset_of(const JsonSource& source, const std::string& wanted) {
    std::size_t found = 0;
    JsonWalk walk = walk_through(source);
    walk.value_at = [&](const std::string& path, std::size_t offset) {
        if (path == wanted) found = offset;
    };
    walk.value();
    return found;
}

/// What the library says of a text that is not JSON, without its own number of the error and the place.
std::string reason_of(const json::parse_error& error) {
    const std::string text = error.what();
    const std::string_view before = "syntax error ";
    const auto begin = text.find(before);
    return begin == std::string::npos ? "is not JSON" : "is not JSON: " + text.substr(begin + before.size());
}

}  // namespace

JsonSource parse_json(std::string name, std::string text) {
    JsonSource source{std::move(name), std::move(text), {}};
    if (source.text.starts_with(byte_order_mark)) source.text.erase(0, byte_order_mark.size());
    const auto not_too_deep = [&](int depth, json::parse_event_t, json&) {
        if (depth > deepest) throw InputError(source.name + ": values are nested too deep");
        return true;
    };
    try {
        source.root = json::parse(source.text, not_too_deep);
    } catch (const json::parse_error& error) {
        // The library counts the byte that it did not expect from 1.
        fail_at(source, std::min(error.byte > 0 ? error.byte - 1 : 0, source.text.size()), reason_of(error));
    } catch (const json::out_of_range&) {
        throw InputError(source.name + ": a number is too large");
    }
    refuse_repeated_keys(source);
    return source;
}

JsonValue root_of(const JsonSource& source) { return {&source, &source.root, ""}; }

void JsonValue::fail(std::string_view what) const {
    fail_at(*source, offset_of(*source, path), fmt::format("{}: {}", path.empty() ? "the file" : path, what));
}

bool JsonValue::has(std::string_view key) const {
    return value->is_object() && value->contains(std::string(key));
}

JsonValue JsonValue::at(std::string_view key) const {
    if (!value->is_object()) fail("expected an object");
    const auto found = value->find(std::string(key));
    if (found == value->end()) fail(fmt::format("'{}' is missing", key));
    return {source, &*found, path + (path.empty() ? "" : "/") + std::string(key)};
}

std::vector<std::pair<std::string, JsonValue>> JsonValue::members() const {
    if (!value->is_object()) fail("expected an object");
    std::vector<std::pair<std::string, JsonValue>> all;
    for (const auto& [key, member] : value->items()) all.emplace_back(key, at(key));
    return all;
}

std::vector<JsonValue> JsonValue::items() const {
    if (!value->is_array()) fail("expected a list");
    std::vector<JsonValue> all;
    for (std::size_t i = 0; i < value->size(); ++i)
        all.push_back({source, &(*value)[i], path + (path.empty() ? "" : "/") + std::to_string(i)});
    return all;
}

void JsonValue::only(const std::vector<std::string_view>& keys) const {
    if (!value->is_object()) fail("expected an object");
    for (const auto& [key, member] : value->items())
        if (std::find(keys.begin(), keys.end(), key) == keys.end())
            at(key).fail(fmt::format("is not known; there are {}", fmt::join(keys, ", ")));
}

std::string JsonValue::text() const {
    if (!value->is_string()) fail("expected a text");
    return value->get<std::string>();
}

bool JsonValue::boolean() const {
    if (!value->is_boolean()) fail("expected true or false");
    return value->get<bool>();
}

std::int64_t JsonValue::whole(std::int64_t least, std::int64_t greatest) const {
    const bool fits = value->is_number_integer() &&
                      !(value->is_number_unsigned() && value->get<std::uint64_t>() > std::uint64_t{1} << 62);
    if (!fits || value->get<std::int64_t>() < least || value->get<std::int64_t>() > greatest)
        fail(fmt::format("expected a whole number from {} to {}", least, greatest));
    return value->get<std::int64_t>();
}

std::uint64_t JsonValue::unsigned_whole() const {
    if (!value->is_number_unsigned()) fail("expected a whole number that is not negative");
    return value->get<std::uint64_t>();
}

double JsonValue::number(double least, double greatest) const {
    const bool fits = value->is_number() && value->get<double>() >= least && value->get<double>() <= greatest;
    if (!fits) fail(fmt::format("expected a number from {:g} to {:g}", least, greatest));
    return value->get<double>();
}

}  // namespace rt
