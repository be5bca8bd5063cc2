// What is said of a condition that failed: what came out, and what was expected.
#pragma once

#include <string>
#include <string_view>
#include <utility>

namespace rt::test {

/// What true and false mean in a condition.
struct YesAndNo {
    std::string_view yes = "yes", no = "no";
};

/// Of what may be nothing, "yes" is that it is something.
inline YesAndNo meaning(std::string_view expression) {
    return expression.find(".has_value()") == std::string_view::npos ? YesAndNo{}
                                                                     : YesAndNo{"something", "nothing"};
}

/// Yes and no are words; a number that is only nearly expected is "about" so large.
inline std::string side_in_words(std::string_view side, const YesAndNo& words) {
    if (side == "true") return std::string(words.yes);
    if (side == "false") return std::string(words.no);
    constexpr std::string_view nearly = "Approx( ";
    if (side.starts_with(nearly) && side.ends_with(" )"))
        return "about " + std::string(side.substr(nearly.size(), side.size() - nearly.size() - 2));
    return std::string(side);
}

/// From a condition with its values, "4 == 3", the words "4, expected 3"; tests write what came out on the
/// left. A condition without a comparison says itself what is wrong, or is a yes or a no. `expression` is how
/// it stands in the test.
inline std::string in_words(std::string_view condition, std::string_view expression = "") {
    const YesAndNo truth = meaning(expression);
    constexpr std::pair<std::string_view, std::string_view> operators[] = {
        {"==", "expected "},          {"!=", "expected anything but "}, {"<=", "expected at most "},
        {">=", "expected at least "}, {"<", "expected less than "},     {">", "expected more than "}};
    for (const auto& [sign, words] : operators)
        for (const char space : {' ', '\n'}) {
            const std::string between = space + std::string(sign) + space;
            const auto at = condition.find(between);
            if (at == std::string_view::npos || condition.starts_with('!')) continue;
            return side_in_words(condition.substr(0, at), truth) + ", " + std::string(words) +
                   side_in_words(condition.substr(at + between.size()), truth);
        }
    const std::string yes(truth.yes), no(truth.no);
    if (condition == "true" || condition == "!false") return yes;
    if (condition == "false") return no + ", expected " + yes;
    if (condition == "!true") return yes + ", expected " + no;
    if (condition == "a miss") return "a miss, expected a hit";
    if (condition == "nothing") return "nothing, expected something";
    if (!condition.starts_with('!')) return std::string(condition);
    const std::string_view value = condition.substr(1);
    return std::string(value) + (value.starts_with("hit ") ? ", expected a miss" : ", expected nothing");
}

}  // namespace rt::test
