// What the readers of scene and mesh files share: whole files, lines, words and numbers.
// Nothing here depends on the locale or allocates memory for each word.
#include "common/scene/text.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/math/printable.hpp"
#include "common/scene/suggest.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace rt {

namespace {

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

/// Whether the '#' at `at` belongs to NaN or infinity as Microsoft's compilers print them: `1.#QNAN`,
/// `-1.#IND`.
bool is_in_number(std::string_view word, const char* at) {
    const char* const end = word.data() + word.size();
    return at - word.data() >= 2 && at[-1] == '.' && at[-2] >= '0' && at[-2] <= '9' && end - at >= 2 &&
           at[1] >= 'A' && at[1] <= 'Z';
}

/// `; did you mean 'x'?` for a path that does not exist, from the names beside it.
std::string similar_file(const std::filesystem::path& path) {
    std::vector<std::string> names;
    std::error_code ignored;
    const std::filesystem::path directory = path.has_parent_path() ? path.parent_path() : ".";
    for (std::filesystem::directory_iterator entry(directory, ignored), end; !ignored && entry != end;
         entry.increment(ignored))
        names.push_back(entry->path().filename().string());
    std::sort(names.begin(), names.end());
    const std::vector<std::string_view> candidates(names.begin(), names.end());
    return did_you_mean(path.filename().string(), candidates);
}

}  // namespace

ParsedNumber parse_number(std::string_view word) {
    const char* begin = word.data();
    const char* const end = begin + word.size();
    if (begin != end && *begin == '+') ++begin;
    if (begin == end || (begin != word.data() && *begin == '-')) return {0, "is not a number"};

    Real value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error == std::errc::invalid_argument) return {0, "is not a number"};
    if (stop != end && *stop == '#') return {0, "is not a finite number"};  // as split_words has kept it
    if (stop != end)
        return {0, *stop == ',' ? "is not a number: decimals are written with a point" : "is not a number"};
    if (error == std::errc::result_out_of_range) return {0, "is beyond the numbers that a double can hold"};
    if (!std::isfinite(value)) return {0, "is not a finite number"};
    return {value, {}};
}

std::string quoted(std::string_view word) {
    constexpr std::size_t longest = 40;
    const std::string_view front = beginning(word, longest);
    std::string text = "'";
    for (const char c : front) text += is_control(c) ? '?' : c;
    return text + (front.size() < word.size() ? "…'" : "'");
}

std::string shown(Real value) {
    std::array<char, 32> text{};
    const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), result.ptr};
}

const char* split_words(std::string_view line, std::vector<std::string_view>& words) {
    words.clear();
    const char* at = line.data();
    const char* const end = at + line.size();
    while (true) {
        while (at != end && is_blank(*at)) ++at;
        const char* const begin = at;
        while (at != end && !is_blank(*at) && (*at != '#' || is_in_number({begin, end}, at))) ++at;
        if (at == begin) return nullptr;
        words.emplace_back(begin, static_cast<std::size_t>(at - begin));
        if (at != end && *at == '#') return at;
    }
}

std::string_view take_line(std::string_view& text) {
    const char* const begin = text.data();
    const char* const end = begin + text.size();
    const char* at = begin;
    while (at != end && *at != '\n' && *at != '\r') ++at;
    const std::string_view line(begin, static_cast<std::size_t>(at - begin));
    if (at != end && *at == '\r' && at + 1 != end && at[1] == '\n') ++at;
    if (at != end) ++at;
    text.remove_prefix(static_cast<std::size_t>(at - begin));
    return line;
}

void check_is_text(std::string_view text, const std::string& name) {
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        throw InputError(at_place(name, 1, 1, "the file is in UTF-16; save it as UTF-8"));
    const std::size_t nul = text.find('\0');
    if (nul == std::string_view::npos) return;
    int line_number = 0;
    std::string_view line, rest = text.substr(0, nul + 1);
    for (; !rest.empty(); ++line_number) line = take_line(rest);
    throw InputError(at_place(name, line_number, line.size(), "a zero byte: this is not a text file"));
}

std::string read_text(const std::filesystem::path& path, const std::string& name) {
    std::error_code error;
    const std::filesystem::file_status status = std::filesystem::status(path, error);
    if (status.type() == std::filesystem::file_type::not_found)
        throw InputError(name + ": there is no such file" + similar_file(path));
    if (std::filesystem::is_directory(status)) throw InputError(name + ": is a directory, not a file");

    return read_file(path);
}

std::string_view without_bom(std::string_view text) {
    return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

}  // namespace rt
