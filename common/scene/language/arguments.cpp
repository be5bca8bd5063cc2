// Numbers and choices, and what is said of those that are none.
#include "common/scene/language/arguments.hpp"

#include "common/scene/elsewhere.hpp"
#include "common/scene/range.hpp"
#include "common/scene/suggest.hpp"
#include "common/scene/text.hpp"

#include <cmath>

namespace rt::language {

namespace {

void require_whole(const Parser& parser, std::size_t i, Real value) {
    if (value != std::floor(value))
        fail(parser, parser.words[i], quoted(parser.words[i]) + " is not a whole number" + expected(parser));
}

Vec3 limited3(const Parser& parser, std::size_t i, const char* nouns) {
    const Vec3 value = vec3(parser, i);
    for (int k = 0; k < 3; ++k)
        if (std::abs(value[k]) > largest_number)
            fail(parser, parser.words[i + static_cast<std::size_t>(k)],
                 std::string(nouns) + " beyond " + shown(largest_number) + " are not possible, and this is " +
                     shown(value[k]));
    return value;
}

}  // namespace

Real number(const Parser& parser, std::size_t i) {
    const ParsedNumber parsed = parse_number(parser.words[i]);
    if (!parsed.problem.empty())
        fail(parser, parser.words[i],
             quoted(parser.words[i]) + " " + std::string(parsed.problem) + expected(parser));
    return parsed.value;
}

Real positive(const Parser& parser, std::size_t i, const char* noun) {
    const Real value = number(parser, i);
    if (!(value > 0))
        fail(parser, parser.words[i], std::string(noun) + " must be greater than 0, not " + shown(value));
    return value;
}

Real not_negative(const Parser& parser, std::size_t i, const char* noun) {
    const Real value = number(parser, i);
    if (!(value >= 0))
        fail(parser, parser.words[i], std::string(noun) + " must not be negative, but is " + shown(value));
    return value;
}

Real sized(const Parser& parser, std::size_t i, const char* noun) {
    const Real value = positive(parser, i, noun);
    if (value < smallest_size || value > largest_number)
        fail(parser, parser.words[i],
             std::string(noun) + " must be from " + shown(smallest_size) + " to " + shown(largest_number) +
                 ", not " + shown(value));
    return value;
}

Real whole(const Parser& parser, std::size_t i, const char* noun, Real low, Real high) {
    const Real value = number(parser, i);
    require_whole(parser, i, value);
    if (value < low || value > high)
        fail(parser, parser.words[i],
             std::string(noun) + " must be from " + shown(low) + " to " + shown(high) + ", not " +
                 shown(value));
    return value;
}

Real whole_setting(const Parser& parser, const char* noun, Real low, Real high) {
    try {
        return whole(parser, 1, noun, low, high);
    } catch (const InputError& error) {
        // What is not a number at all is wrong everywhere.
        if (!parse_number(parser.words[1]).problem.empty()) throw;
        throw UnknownValue(error.what());
    }
}

std::uint32_t index(const Parser& parser, std::size_t i, std::size_t count, const std::string& noun) {
    const Real value = number(parser, i);
    require_whole(parser, i, value);
    const std::string_view word = parser.words[i];
    if (count == 0) fail(parser, word, "index " + shown(value) + ": no " + noun + " stands before this line");
    if (value < 0 || value >= static_cast<Real>(count))
        fail(parser, word,
             "index " + shown(value) + " is out of range: 0 to " + std::to_string(count - 1) +
                 " stand before this line");
    return static_cast<std::uint32_t>(value);
}

Vec3 vec3(const Parser& parser, std::size_t i) {
    const Real x = number(parser, i), y = number(parser, i + 1), z = number(parser, i + 2);
    return {x, y, z};
}

Vec3 not_negative3(const Parser& parser, std::size_t i, const char* noun) {
    const Real x = not_negative(parser, i, noun), y = not_negative(parser, i + 1, noun),
               z = not_negative(parser, i + 2, noun);
    return {x, y, z};
}

Vec3 direction(const Parser& parser, std::size_t i, const char* noun) {
    const Vec3 value = vec3(parser, i);
    if (value == Vec3(0)) fail(parser, parser.words[i], std::string(noun) + " must not be 0 0 0");
    return value;
}

Vec3 place3(const Parser& parser, std::size_t i) { return limited3(parser, i, "coordinates"); }

Vec3 color(const Parser& parser, std::size_t i) { return limited3(parser, i, "colours"); }

void fail_choice(const Parser& parser, std::size_t i, std::span<const std::string_view> names) {
    const std::string_view command = parser.words[0], word = parser.words[i];
    std::string meaning = meaning_elsewhere(command, word);
    if (meaning.empty()) meaning = did_you_mean(word, names);
    throw UnknownValue(
        message_at(parser, word.data(),
                   quoted(word) + " is not a known " + std::string(command) + meaning + expected(parser)));
}

}  // namespace rt::language
