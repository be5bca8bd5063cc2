// A page of Markdown as HTML, by pandoc.
#include "common/book/fragment.hpp"

#include "common/image/temporary_file.hpp"
#include "common/image/whole_file.hpp"
#include "common/math/input_error.hpp"
#include "common/terminal/json_text.hpp"
#include "common/terminal/process.hpp"
#include "common/workbook/exercise.hpp"
#include "common/workbook/solutions.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>
#include <stdexcept>

namespace rt {

namespace fs = std::filesystem;

namespace {

/// What the filter (pages/book.lua) has to know. Pandoc takes texts for Markdown: paths stand as code.
std::string metadata(const Project& project, const BookPage& page, const std::vector<BookPage>& pages) {
    const auto code = [](const std::string& text) { return "`" + text + "`"; };
    nlohmann::ordered_json names = nlohmann::ordered_json::object();
    for (const BookPage& other : pages) names[other.source.string()] = code(other.file);
    return json_text(nlohmann::ordered_json{
        {"source", code(page.source.string())}, {"root", code(project.root.string())}, {"pages", names}});
}

std::string run_pandoc(const Project& project, const BookPage& page, const fs::path& facts) {
    ProcessOptions options;
    options.output_limit = std::size_t{64} << 20;
    options.merge_errors = false;
    const ProcessResult result = run_process(
        {"pandoc", "--fail-if-warnings", "--from", "gfm+tex_math_dollars", "--to", "html5", "--mathml",
         "--metadata-file", facts.string(), "--lua-filter",
         (project.root / "common/book/pages/book.lua").string(), (project.root / page.source).string()},
        options);
    if (result.exit_code == 127)
        throw InputError("pandoc is missing; install it: sudo apt-get install pandoc");
    if (!succeeded(result))
        throw std::runtime_error(fmt::format("pandoc failed on {}", page.source.string()));
    return result.output;
}

/// Takes away the last comment, in which the filter has noted "picture PATH", "file PATH" and "missing PATH".
/// A handout has not all that lessons refer to.
void read_wanted(const Project& project, const BookPage& page, Fragment& fragment) {
    const std::size_t comment = fragment.html.rfind("<!-- wanted");
    const std::string notes = fragment.html.substr(comment);
    fragment.html.resize(comment);
    for (const std::string& line : split_lines(notes)) {
        const std::string path = line.substr(line.find(' ') + 1);
        if (line.starts_with("picture ")) fragment.pictures.insert(path);
        if (line.starts_with("file ")) fragment.files.insert(path);
        if (line.starts_with("missing ") && has_solutions(project))
            throw InputError(fmt::format("{} refers to {}, which is not there", page.source.string(), path));
    }
}

std::vector<BookSection> sections_of(const std::string& html) {
    static const std::regex heading("<h2 id=\"([^\"]*)\">([^]*?)</h2>");
    std::vector<BookSection> sections;
    std::size_t body = 0;
    for (std::sregex_iterator i(html.begin(), html.end(), heading), end; i != end; ++i) {
        const auto at = static_cast<std::size_t>(i->position());
        if (!sections.empty()) sections.back().body = html.substr(body, at - body);
        sections.push_back({(*i)[1], (*i)[2], ""});
        body = at + static_cast<std::size_t>(i->length());
    }
    if (!sections.empty()) sections.back().body = html.substr(body);
    return sections;
}

/// Parentheses grow with what they enclose only where the formula says so; pandoc 2 lets all of them grow,
/// and that leaves gaps beside them.
std::string with_plain_parentheses(const std::string& html) {
    std::string text;
    std::size_t at = 0;
    for (auto begin = html.find("<math"); begin != std::string::npos; begin = html.find("<math", at)) {
        const std::string end_tag = "</math>";
        const std::size_t end = html.find(end_tag, begin) + end_tag.size();
        std::string formula = html.substr(begin, end - begin);
        if (formula.find("\\left") == std::string::npos)
            replace_all(formula, "stretchy=\"true\"", "stretchy=\"false\"");
        text += html.substr(at, begin - at) + formula;
        at = end;
    }
    return text + html.substr(at);
}

}  // namespace

Fragment fragment_of(const Project& project, const BookPage& page, const std::vector<BookPage>& pages) {
    make_directories(project.build);
    const TemporaryFile facts(project.build);
    write_file(facts.path, metadata(project, page, pages));
    Fragment fragment;
    fragment.html = with_plain_parentheses(run_pandoc(project, page, facts.path));
    read_wanted(project, page, fragment);
    fragment.sections = sections_of(fragment.html);
    return fragment;
}

std::string searchable(const std::string& html) {
    std::string text;
    bool in_tag = false;
    // Formulas stand there twice, the second time as LaTeX.
    for (const char c : std::regex_replace(html, std::regex("<annotation[^]*?</annotation>"), "")) {
        if (c == '<') in_tag = true;
        if (!in_tag) text += c == '\n' ? ' ' : c;
        if (c == '>') in_tag = false;
    }
    for (const auto& [entity, letter] :
         {std::pair("&lt;", "<"), std::pair("&gt;", ">"), std::pair("&quot;", "\""), std::pair("&amp;", "&")})
        replace_all(text, entity, letter);
    std::string single;
    for (const char c : text)
        if (c != ' ' || (!single.empty() && single.back() != ' ')) single += c;
    return single;
}

std::string among_others(const std::string& html, const BookPage& page, const std::vector<BookPage>& pages) {
    const std::string prefix = fs::path(page.file).stem().string() + "-";
    std::string text = html;
    replace_all(text, "href=\"#", "href=\"#" + prefix);
    replace_all(text, " id=\"", " id=\"" + prefix);
    for (const BookPage& other : pages) {
        const std::string stem = fs::path(other.file).stem().string();
        replace_all(text, "href=\"" + other.file + "#", "href=\"#" + stem + "-");
        replace_all(text, "href=\"" + other.file + "\"", "href=\"#" + stem + "\"");
    }
    return fmt::format("<section class=\"page\" id=\"{}\">\n{}</section>\n",
                       fs::path(page.file).stem().string(), text);
}

}  // namespace rt
