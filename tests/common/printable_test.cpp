// Text from outside as it may be shown: UTF-8 and nothing that steers a terminal.
#include "common/math/printable.hpp"
#include "tests/catch.hpp"

using namespace rt;

TEST_CASE("text that is UTF-8 is shown as it is") {
    for (const std::string text : {"", "plain", "naïve — 10 × 10 µm", "日本語", "\xF0\x9F\x8C\x8D",
                                   "\xF4\x8F\xBF\xBF", "\xEF\xBF\xBF", "\xC2\xA0"}) {
        CHECK(is_utf8(text));
        CHECK(printable(text) == text);
    }
}

TEST_CASE("bytes that are not UTF-8 are shown by their numbers") {
    struct Case {
        std::string text, shown;
    };
    for (const Case& c : std::vector<Case>{
             {"caf\xe9", "caf\\xe9"},                       // Latin-1
             {"\x80", "\\x80"},                             // continues nothing
             {"\xc3", "\\xc3"},                             // cut off
             {"\xe2\x82!", "\\xe2\\x82!"},                  // cut off by a letter
             {"\xc0\xaf", "\\xc0\\xaf"},                    // '/' in two bytes
             {"\xe0\x9f\xbf", "\\xe0\\x9f\\xbf"},           // longer than needed
             {"\xed\xa0\x80", "\\xed\\xa0\\x80"},           // half of a pair of UTF-16
             {"\xf0\x8f\xbf\xbf", "\\xf0\\x8f\\xbf\\xbf"},  // longer than needed
             {"\xf4\x90\x80\x80", "\\xf4\\x90\\x80\\x80"},  // beyond U+10FFFF
             {"\xff\xfe", "\\xff\\xfe"},
             {"é\xe9é", "é\\xe9é"},
         }) {
        CHECK_FALSE(is_utf8(c.text));
        for (const Keep keep : {Keep::Nothing, Keep::Lines, Keep::Controls})
            CHECK(printable(c.text, keep) == c.shown);
    }
}

TEST_CASE("what would steer a terminal is shown by its number") {
    const std::string text =
        std::string("a\x1b[2J\r\x7f\0b", 9) + "\xc2\x9b" + "\n\tc";  // U+009B is another escape
    const std::string escaped = "a\\x1b[2J\\x0d\\x7f\\x00b\\xc2\\x9b";
    CHECK(printable(text) == escaped + "\\n\\tc");
    CHECK(printable(text, Keep::Lines) == escaped + "\n\tc");
    CHECK(printable(text, Keep::Controls) == text);
}

TEST_CASE("the beginning of a text ends with a whole character") {
    CHECK(beginning("aé", 9) == "aé");
    CHECK(beginning("aé", 3) == "aé");
    CHECK(beginning("aé", 2) == "a");
    CHECK(beginning("é", 1).empty());
    CHECK(beginning("\x80\x80", 1).empty());
    CHECK(beginning("a", 0).empty());
}
