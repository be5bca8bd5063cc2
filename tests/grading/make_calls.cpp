// make_calls HEADER... -o DIRECTORY: reads the functions that headers declare and writes, for each of them,
//   calls_NN.cpp  the function as the judge of chapter NN links it: it asks a worker;
//   calls.cpp     the same for the headers that are no chapter's, which all judges link;
//   answers.cpp   the row of the worker's table that calls the real one.
// Headers are written as the contracts are: in namespace rt, functions declared in plain statements. What is
// defined there (structs, templates, inline functions) is the same for both ends and needs no call. A
// statement that it does not know is an error with its place.
#include <algorithm>
#include <cctype>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

struct Function {
    std::string result, name;
    std::vector<std::string> types;  ///< of the parameters
};

/// The text with comments and preprocessor lines blanked out, so that places stay.
std::string without_comments(std::string text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool line =
            text.compare(i, 2, "//") == 0 || (text[i] == '#' && (i == 0 || text[i - 1] == '\n'));
        const bool block = text.compare(i, 2, "/*") == 0;
        if (!line && !block) continue;
        const std::size_t end = line ? text.find('\n', i) : text.find("*/", i) + 2;
        for (; i < std::min(end, text.size()); ++i)
            if (text[i] != '\n') text[i] = ' ';
    }
    return text;
}

std::string folded(std::string_view text) {
    std::istringstream words{std::string(text)};
    std::string word, all;
    while (words >> word) all += (all.empty() ? "" : " ") + word;
    return all;
}

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

/// Cuts at commas that are in no brackets.
std::vector<std::string> parameters_of(std::string_view text) {
    std::vector<std::string> all;
    int depth = 0;
    std::string one;
    for (const char c : text) {
        if (c == '(' || c == '<' || c == '{') ++depth;
        if (c == ')' || c == '>' || c == '}') --depth;
        if (c == ',' && depth == 0) {
            all.push_back(folded(one));
            one.clear();
        } else {
            one += c;
        }
    }
    if (!folded(one).empty()) all.push_back(folded(one));
    return all;
}

/// "const GridOptions& options = {}" is a const GridOptions&.
std::string type_of(std::string parameter) {
    parameter = folded(parameter.substr(0, parameter.find('=')));
    std::size_t name = parameter.size();
    while (name > 0 && is_word(parameter[name - 1])) --name;
    // A single word, or one that belongs to the type, is no name.
    const bool has_name = name > 0 && name < parameter.size() && parameter[name - 1] != ':' &&
                          folded(parameter.substr(0, name)) != "const";
    return has_name ? folded(parameter.substr(0, name)) : parameter;
}

class Header {
public:
    explicit Header(const std::string& file) : name(file) {
        std::ifstream in(file, std::ios::binary);
        if (!in) throw std::runtime_error(file + ": cannot be read");
        text = without_comments({std::istreambuf_iterator<char>(in), {}});
    }

    std::vector<Function> functions() {
        std::vector<Function> all;
        at = text.find("namespace rt {");
        if (at == std::string::npos) throw error("there is no namespace rt");
        at += std::string_view("namespace rt {").size();
        while (skip_blanks(), text[at] != '}') {
            const std::size_t begin = at;
            const std::size_t end = end_of_statement();
            const std::string statement = folded(std::string_view(text).substr(begin, end - begin));
            if (!is_definition(statement)) all.push_back(function(statement, begin));
            at = end + 1;
        }
        return all;
    }

private:
    std::runtime_error error(const std::string& what) const {
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n');
        return std::runtime_error(name + ":" + std::to_string(line) + ": " + what);
    }

    void skip_blanks() {
        while (at < text.size() && std::isspace(static_cast<unsigned char>(text[at])) != 0) ++at;
        if (at == text.size()) throw error("the namespace does not end");
    }

    /// Of the statement that begins here: its ';', or the '}' of a body that no ';' follows.
    std::size_t end_of_statement() const {
        int depth = 0;
        for (std::size_t i = at; i < text.size(); ++i) {
            if (text[i] == '{' || text[i] == '(') ++depth;
            if (text[i] == '}' || text[i] == ')') --depth;
            if (depth < 0) break;
            if (depth == 0 && text[i] == ';') return i;
            if (depth == 0 && text[i] == '}' && !is_constraint(i)) {
                const std::size_t next = text.find_first_not_of(" \n", i + 1);
                // The value of a variable and the fields of a struct end with a ';'.
                if (next == std::string::npos || text[next] != ';') return i;
            }
        }
        throw error("a statement does not end");
    }

    /// Whether the '}' is that of `requires requires(…) { … }`, after which the declaration goes on.
    bool is_constraint(std::size_t end) const {
        const std::size_t word = text.rfind("requires(", end);
        if (word == std::string::npos || word < at) return false;
        const std::size_t body = text.find('{', word);
        return text.find('}', body) == end;
    }

    /// What both ends have as it is.
    static bool is_definition(const std::string& statement) {
        const std::string_view begins[] = {"struct ",   "enum ",   "using ", "template ",
                                           "template<", "inline ", "class ", "constexpr "};
        return std::any_of(std::begin(begins), std::end(begins),
                           [&](std::string_view word) { return statement.starts_with(word); });
    }

    Function function(const std::string& statement, std::size_t place) {
        at = place;
        const std::size_t open = statement.find('(');
        if (open == std::string::npos || statement.back() != ')')
            throw error("this is no function, nor what make_calls knows: " + statement);
        std::size_t begin = open;
        while (begin > 0 && is_word(statement[begin - 1])) --begin;
        Function found{folded(statement.substr(0, begin)), statement.substr(begin, open - begin), {}};
        if (found.result.empty() || found.name.empty())
            throw error("the function has no result or no name: " + statement);
        for (const std::string& parameter :
             parameters_of(std::string_view(statement).substr(open + 1, statement.size() - open - 2)))
            found.types.push_back(type_of(parameter));
        return found;
    }

    std::string name, text;
    std::size_t at = 0;
};

std::string signature(const Function& f, bool with_names) {
    std::string all;
    for (std::size_t i = 0; i < f.types.size(); ++i)
        all += (i > 0 ? ", " : "") + f.types[i] + (with_names ? " a" + std::to_string(i) : "");
    return all;
}

void write(const std::string& file, const std::string& text) {
    std::ofstream out(file, std::ios::binary);
    if (!(out << text << std::flush)) throw std::runtime_error(file + ": cannot be written");
}

/// "_02" of "chapters/02_spheres/sphere.hpp", nothing of a header that is no chapter's.
std::string chapter_of(const std::string& header) {
    const std::string_view top = "chapters/";
    return header.starts_with(top) ? "_" + header.substr(top.size(), 2) : "";
}

void make(const std::vector<std::string>& headers, const std::string& directory) {
    const std::string made = "// Made by make_calls from the contracts.\n";
    std::string all_includes, answers;
    std::map<std::string, std::string> includes, calls;  // by chapter
    int count = 0;
    for (const std::string& header : headers) {
        const std::string include = "#include \"" + header + "\"\n";
        all_includes += include;
        includes[chapter_of(header)] += include;
        for (const Function& f : Header(header).functions()) {
            const std::string number = std::to_string(count++);
            std::string arguments = number + ", \"" + f.name + "\"";
            for (std::size_t i = 0; i < f.types.size(); ++i) arguments += ", a" + std::to_string(i);
            calls[chapter_of(header)] += f.result + " " + f.name + "(" + signature(f, true) +
                                         ") {\n    return grading::call<" + f.result + ">(" + arguments +
                                         ");\n}\n";
            answers += "    AnswerOf<static_cast<" + f.result + " (*)(" + signature(f, false) +
                       ")>(&rt::" + f.name + ")>::answer,\n";
        }
    }
    for (const auto& [chapter, functions] : calls)
        write(directory + "/calls" + chapter + ".cpp",
              made + includes[chapter] + "#include \"tests/grading/judge.hpp\"\n\nnamespace rt {\n" +
                  functions + "}  // namespace rt\n");
    write(directory + "/answers.cpp", made + all_includes +
                                          "#include \"tests/grading/worker.hpp\"\n\n"
                                          "namespace rt::grading {\nnamespace {\nconst Answer table[] = {\n" +
                                          answers +
                                          "};\n}\nconst std::span<const Answer> answers = table;\n"
                                          "}  // namespace rt::grading\n");
}

}  // namespace

int main(int argc, char** argv) {
    try {
        std::vector<std::string> headers(argv + 1, argv + argc);
        if (headers.size() < 3 || headers[headers.size() - 2] != "-o")
            throw std::runtime_error("usage: make_calls HEADER... -o DIRECTORY");
        const std::string directory = headers.back();
        headers.resize(headers.size() - 2);
        make(headers, directory);
    } catch (const std::exception& error) {
        std::cerr << error.what() << '\n';
        return 2;
    }
}
