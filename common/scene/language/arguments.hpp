// Reading the arguments of a command: numbers within their ranges, vectors, indices, words of a choice.
// Arguments count from 1. What is wrong throws InputError with the place of the word.
#pragma once

#include "common/scene/language/parser.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rt::language {

// Numbers. `noun` begins a message: "the radius must be greater than 0".

Real number(const Parser& parser, std::size_t i);
Real positive(const Parser& parser, std::size_t i, const char* noun);
Real not_negative(const Parser& parser, std::size_t i, const char* noun);

/// A positive number that is neither too small nor too large: from `smallest_size` to `largest_number`.
Real sized(const Parser& parser, std::size_t i, const char* noun);

/// A whole number in [low, high]; existing scenes also write them as `5.0`.
Real whole(const Parser& parser, std::size_t i, const char* noun, Real low, Real high);

/// The same for the first argument of a setting that other programs give other ranges, as in `maxdepth -1`:
/// UnknownValue where it is out of range.
Real whole_setting(const Parser& parser, const char* noun, Real low, Real high);

/// Index into a list of `noun` commands of which `count` have been given so far.
std::uint32_t index(const Parser& parser, std::size_t i, std::size_t count, const std::string& noun);

// Vectors: three arguments from the i-th on.

Vec3 vec3(const Parser& parser, std::size_t i);
Vec3 not_negative3(const Parser& parser, std::size_t i, const char* noun);

/// Of any length but 0.
Vec3 direction(const Parser& parser, std::size_t i, const char* noun);

/// A point of the world or a colour; no coordinate is beyond `largest_number`, so that nothing computed from
/// it leaves the range of Real. (What a transform still moves is checked after that.)
Vec3 place3(const Parser& parser, std::size_t i);
Vec3 color(const Parser& parser, std::size_t i);

// Choices: an array of rows that have a `name` and a `value`.

/// The plainest such row.
template <class Value>
struct Word {
    std::string_view name;
    Value value;
};

inline constexpr Word<bool> on_or_off[] = {{"on", true}, {"off", false}};

/// The names as the reference lists them: `on|off`.
template <class Row, std::size_t N>
std::string alternatives(const Row (&rows)[N]) {
    std::string text;
    for (const Row& row : rows) text.append(text.empty() ? "" : "|").append(row.name);
    return text;
}

/// Throws UnknownValue with a suggestion: argument i is none of the names.
[[noreturn]] void fail_choice(const Parser& parser, std::size_t i, std::span<const std::string_view> names);

/// The value of the row that argument i names.
template <class Row, std::size_t N>
auto choice(const Parser& parser, const Row (&rows)[N], std::size_t i = 1) {
    std::vector<std::string_view> names;
    for (const Row& row : rows) {
        if (row.name == parser.words[i]) return row.value;
        names.push_back(row.name);
    }
    fail_choice(parser, i, names);
}

}  // namespace rt::language
