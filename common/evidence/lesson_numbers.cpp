// Numbers in a chapter's pages against the tables that programs wrote.
#include "common/evidence/lesson_numbers.hpp"

#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/workbook/exercise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <regex>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// The same number in the notation of computers.
std::string plain(std::string text) {
    const std::pair<const char*, const char*> raised[] = {{"⁻", "-"}, {"⁰", "0"}, {"¹", "1"}, {"²", "2"},
                                                          {"³", "3"}, {"⁴", "4"}, {"⁵", "5"}, {"⁶", "6"},
                                                          {"⁷", "7"}, {"⁸", "8"}, {"⁹", "9"}};
    // First where an exponent begins, then its digits.
    for (const auto& [digit, ordinary] : raised)
        replace_all(text, std::string("10") + digit, std::string("10^") + ordinary);
    for (const auto& [digit, ordinary] : raised) replace_all(text, digit, ordinary);
    for (const char* space : {"\u2009", "\u202f", "\u00a0"}) replace_all(text, space, "");
    for (const char* times : {"·", "×", "\\cdot", "\\times", "*"}) replace_all(text, times, "·");
    text = std::regex_replace(text, std::regex(" *· *"), "·");
    text = std::regex_replace(text, std::regex("\\{,\\}"), ",");
    text = std::regex_replace(text, std::regex("10\\^\\{?(-?\\d+)\\}?"), "10^$1");
    replace_all(text, "−", "-");
    return text;
}

/// One in the last digit of "3221", "3,000" or "2.60".
double unit_of(const std::string& digits) {
    const auto point = digits.find('.');
    if (point != std::string::npos) return std::pow(10.0, -double(digits.size() - point - 1));
    std::size_t zeros = 0;
    while (zeros + 2 < digits.size() && digits[digits.size() - 1 - zeros] == '0') ++zeros;
    return std::pow(10.0, double(zeros));
}

std::vector<std::string> split_cells(const std::string& line, char separator) {
    std::vector<std::string> cells{""};
    bool quoted = false;
    for (const char c : line)
        if (c == '"')
            quoted = !quoted;
        else if (c == separator && !quoted)
            cells.emplace_back();
        else
            cells.back() += c;
    return cells;
}

struct Table {
    std::string file;
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

Table read_table(const std::string& file, const fs::path& figures, const fs::path& root) {
    const fs::path path = fs::exists(figures / file) ? figures / file : root / file;
    if (!fs::exists(path)) throw InputError("there is no table " + file);
    Table table{file, {}, {}};
    for (const std::string& line : split_lines(read_file(path)))
        if (table.columns.empty())
            table.columns = split_cells(line, ',');
        else
            table.rows.push_back(split_cells(line, ','));
    return table;
}

std::size_t column(const Table& table, const std::string& name) {
    const auto found = std::ranges::find(table.columns, name);
    if (found == table.columns.end())
        throw InputError(fmt::format("{} has no column '{}'", table.file, name));
    return static_cast<std::size_t>(found - table.columns.begin());
}

/// The same text, or the same words and the same number behind them.
bool same_key(const std::string& written, const std::string& stored) {
    if (written == stored) return true;
    const auto words = [](const std::string& text) {
        const std::string all = plain(text);
        return all.substr(0, all.find_first_of("-.0123456789"));
    };
    const auto a = last_number(written), b = last_number(stored);
    return words(written) == words(stored) && a && b && a->value == b->value &&
           std::isdigit(static_cast<unsigned char>(stored.back()));
}

const std::vector<std::string>& row(const Table& table, const std::string& key, std::size_t among) {
    const auto matches = [&](const std::vector<std::string>& cells) {
        return among < cells.size() && same_key(key, cells[among]);
    };
    const auto count = std::ranges::count_if(table.rows, matches);
    if (count != 1)
        throw InputError(fmt::format("{} has {} rows '{}'; expected one", table.file, count, key));
    return *std::ranges::find_if(table.rows, matches);
}

/// Whether what is written is the table's number, rounded to the digits that are written.
bool agree(const WrittenNumber& written, double stored) {
    return std::abs(written.value - stored) <= 0.5 * written.unit * (1 + 1e-9) + 1e-12 * std::abs(stored);
}

std::string compare(const std::string& written, const std::string& stored, double scale,
                    const std::string& where) {
    const auto number = last_number(written), expected = last_number(stored);
    if (!expected) return number ? fmt::format("'{}' is no number ({})", stored, where) : "";
    if (!number) return fmt::format("there is no number before the mark; expected {} ({})", stored, where);
    if (agree(*number, expected->value * scale)) return "";
    return fmt::format("{} should be {:.6g} ({})", number->value, expected->value * scale, where);
}

using Words = std::vector<std::string>;

/// The words of a mark; what stands in quotes is one word, with its quotes.
Words words_of(const std::string& text) {
    Words words;
    const std::regex word("\"[^\"]*\"|\\S+");
    for (std::sregex_iterator i(text.begin(), text.end(), word), end; i != end; ++i)
        words.push_back(i->str());
    return words;
}

std::string unquoted(const std::string& word) {
    return word.size() > 1 && word.front() == '"' ? word.substr(1, word.size() - 2) : word;
}

/// `FILE "row" "column" * scale`, the last two as needed, and the text before the mark.
std::string check_number(const std::string& before, Words words, const fs::path& figures,
                         const fs::path& root) {
    double scale = 1;
    if (words.size() > 3 && words[words.size() - 2] == "*") {
        scale = std::strtod(words.back().c_str(), nullptr);
        words.resize(words.size() - 2);
    }
    if (words.size() < 2 || words.size() > 3) throw InputError("expected FILE \"row\" \"column\"");
    const Table table = read_table(words[0], figures, root);
    const std::string key = unquoted(words[1]);
    const std::size_t at = words.size() == 3 ? column(table, unquoted(words[2])) : 1;
    const auto& cells = row(table, key, 0);
    if (at >= cells.size()) throw InputError(fmt::format("{} has no number in row '{}'", words[0], key));
    return compare(before, cells[at], scale, fmt::format("{}, {}", words[0], key));
}

/// The cells of a line "| a | b |".
std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells = split_cells(line.substr(1, line.find_last_of('|') - 1), '|');
    for (std::string& cell : cells) {
        cell = std::regex_replace(cell, std::regex("<!--.*?-->|\\*\\*|\\$"), "");
        cell = std::regex_replace(cell, std::regex("^\\s+|\\s+$"), "");
    }
    return cells;
}

struct TiedColumn {
    std::size_t at = 0;  ///< in the page's table
    std::size_t stored = 0;
    double scale = 1;
};

/// `FILE "column" - "column" * 1000 …`: a name, or a dash, for each column of the page's table.
std::vector<TiedColumn> tied_columns(const Words& words, const Table& table) {
    std::vector<TiedColumn> tied;
    std::size_t at = 0;
    for (std::size_t i = 1; i < words.size(); ++i) {
        if (words[i] == "*" && i + 1 < words.size() && !tied.empty()) {
            tied.back().scale = std::strtod(words[++i].c_str(), nullptr);
            continue;
        }
        if (words[i] != "-") tied.push_back({at, column(table, unquoted(words[i])), 1});
        ++at;
    }
    if (tied.size() < 2) throw InputError("expected the names of at least two columns");
    return tied;
}

std::vector<std::string> check_table(const std::vector<std::string>& lines, std::size_t first,
                                     const Words& words, const fs::path& figures, const fs::path& root) {
    const Table table = read_table(words[0], figures, root);
    const std::vector<TiedColumn> tied = tied_columns(words, table);
    std::vector<std::string> wrong;
    if (first + 1 >= lines.size() || !lines[first].starts_with("|"))
        throw InputError("expected a table below the mark");
    for (std::size_t i = first + 2; i < lines.size() && lines[i].starts_with("|"); ++i) {
        const auto cells = cells_of(lines[i]);
        if (tied.back().at >= cells.size()) throw InputError("the table has fewer columns than the mark");
        const auto& stored = row(table, cells[tied[0].at], tied[0].stored);
        for (std::size_t k = 1; k < tied.size(); ++k)
            if (const std::string what = compare(cells[tied[k].at], stored.at(tied[k].stored), tied[k].scale,
                                                 fmt::format("{}, {}", words[0], cells[tied[0].at]));
                !what.empty())
                wrong.push_back(what);
    }
    return wrong;
}

}  // namespace

std::optional<WrittenNumber> last_number(const std::string& text) {
    const std::string all = plain(text);
    const std::regex form("-?(\\d[\\d,]*(?:\\.\\d+)?|\\.\\d+)(?:e([-+]?\\d+)|·10\\^(-?\\d+))?");
    const std::regex power("(?:^|[^\\d.·])(-?)10\\^(-?\\d+)");
    std::optional<WrittenNumber> last;
    std::ptrdiff_t end = -1;
    for (std::sregex_iterator i(all.begin(), all.end(), form), none; i != none; ++i) {
        std::string digits = (*i)[1];
        digits.erase(std::remove(digits.begin(), digits.end(), ','), digits.end());
        const std::string exponent = (*i)[2].matched ? (*i)[2] : (*i)[3];
        const double factor = exponent.empty() ? 1 : std::pow(10.0, std::atoi(exponent.c_str()));
        const double sign = i->str().front() == '-' ? -1 : 1;
        last = WrittenNumber{sign * std::strtod(digits.c_str(), nullptr) * factor, unit_of(digits) * factor};
        end = i->position() + i->length();
    }
    for (std::sregex_iterator i(all.begin(), all.end(), power), none; i != none; ++i)
        if (i->position() + i->length() >= end) {
            const double value = std::pow(10.0, std::atoi((*i)[2].str().c_str()));
            last = WrittenNumber{(*i)[1].length() > 0 ? -value : value, value};
        }
    return last;
}

std::vector<std::string> wrong_numbers(const std::string& page, const std::string& name,
                                       const fs::path& figures, const fs::path& root) {
    std::vector<std::string> wrong;
    const std::regex number("<!-- = (.*?) -->"), table("<!-- table (.*?) -->\\s*");
    const std::vector<std::string> lines = split_lines(page);
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const auto add = [&](const std::string& what) {
            if (!what.empty()) wrong.push_back(fmt::format("{}:{}: {}", name, i + 1, what));
        };
        try {
            std::smatch mark;
            if (std::regex_match(lines[i], mark, table) && mark[1] != "by hand")
                for (const std::string& what : check_table(lines, i + 1, words_of(mark[1]), figures, root))
                    add(what);
            else if (lines[i].find("<!-- table") != std::string::npos && mark.empty())
                add("expected a line <!-- table FILE \"column\" … --> or <!-- table by hand -->");
            std::size_t from = 0, marks = 0;
            for (std::sregex_iterator k(lines[i].begin(), lines[i].end(), number), end; k != end; ++k) {
                const auto at = static_cast<std::size_t>(k->position());
                add(check_number(lines[i].substr(from, at - from), words_of((*k)[1]), figures, root));
                from = at + static_cast<std::size_t>(k->length());
                ++marks;
            }
            for (auto at = lines[i].find("<!-- ="); at != std::string::npos;
                 at = lines[i].find("<!-- =", at + 1))
                --marks;
            if (marks != 0) add("expected <!-- = FILE \"row\" \"column\" --> on one line");
        } catch (const InputError& error) {
            add(error.what());
        }
    }
    return wrong;
}

}  // namespace rt
